import { type BufferGeometry, type Material, type Object3D, Texture } from 'three';

/** What of three's objects holds something on the GPU. */
type Held = Object3D & {
  geometry?: BufferGeometry;
  material?: Material | Material[];
  skeleton?: { dispose(): void };
  dispose?: () => void;
};

/** Takes an object out of its scene and frees all that it and what is below it hold, on the GPU and as decoded pictures. */
export function disposeOf(root: Object3D): void {
  root.removeFromParent();
  const textures = new Set<Texture>();
  root.traverse((object) => {
    const held = object as Held;
    held.geometry?.dispose();
    for (const material of [held.material ?? []].flat()) {
      texturesOf(material, textures);
      material.dispose();
    }
    held.skeleton?.dispose();
    // Instances, batches, and lights with shadows have textures and buffers of their own.
    held.dispose?.();
  });
  for (const texture of textures) {
    texture.dispose();
    // The material of three's shadows still holds the last map that it drew with, and would upload it again.
    texture.version = 0;
    const picture: unknown = texture.source.data;
    if (typeof ImageBitmap !== 'undefined' && picture instanceof ImageBitmap) picture.close();
  }
}

/** Adds the maps of a material, and those among its uniforms. */
function texturesOf(material: Material, into: Set<Texture>): void {
  const { uniforms = {} } = material as { uniforms?: Record<string, { value: unknown }> };
  const values = [...Object.values(material), ...Object.values(uniforms).map((each) => each.value)];
  for (const value of values) if (value instanceof Texture) into.add(value);
}
