import { Mesh, type Material, type Object3D } from 'three';

/** Each material as it is without fading. */
const whole = new WeakMap<Material, { opacity: number; transparent: boolean }>();

/**
 * Lets an avatar be seen through, as the camera comes near.
 *
 * @param opacity 0 to 1, for all materials of it and below it
 */
export function fade(avatar: Object3D, opacity: number): void {
  if (!avatar.visible) return;
  avatar.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    const materials: Material[] = Array.isArray(part.material) ? part.material : [part.material];
    for (const material of materials) fadeMaterial(material, opacity);
  });
}

function fadeMaterial(material: Material, opacity: number): void {
  if (!whole.has(material))
    whole.set(material, { opacity: material.opacity, transparent: material.transparent });
  const own = whole.get(material)!;
  if (material.opacity === own.opacity * opacity) return;
  material.opacity = own.opacity * opacity;
  const transparent = own.transparent || opacity < 1;
  if (material.transparent === transparent) return;
  // Another program, made once; depth is written still, so that what lies behind a limb stays hidden.
  material.transparent = transparent;
  material.needsUpdate = true;
}
