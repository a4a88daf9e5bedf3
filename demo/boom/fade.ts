import { Mesh, type Material, type Object3D } from 'three';

/** Opacity of each material without fading. */
const whole = new WeakMap<Material, number>();

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
  const full = whole.get(material) ?? material.opacity;
  if (material.opacity === full * opacity) return;
  if (!whole.has(material)) {
    whole.set(material, full);
    // Hashed away, not blended: limbs before limbs need no sorting, and depth stays.
    material.alphaHash = true;
    material.needsUpdate = true;
  }
  material.opacity = full * opacity;
}
