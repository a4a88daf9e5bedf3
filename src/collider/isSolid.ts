import type { Material } from 'three';

/** Drawn, and not see-through: transparent materials are solid only where an alpha test cuts them out. */
export function isSolid(material: Material | null | undefined): boolean {
  if (!material || !material.visible || !material.depthWrite) return false;
  return !material.transparent || material.alphaTest > 0;
}
