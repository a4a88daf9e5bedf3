import {
  type Light,
  type Material,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  type PointLight,
} from 'three';
import { mirrorSky } from './skyLight.js';

/** More lights than this of a file's own make each pixel dear. */
const MOST_LIGHTS = 6;
const SKY = /^sky[\s_.-]*(box|dome|sphere)?([\s_.-]*\d+)?$/i;

/**
 * Makes a file's objects part of the scene: they throw shadows and take them; a sky that came along is no obstacle; the
 * sun is ours.
 *
 * @param anisotropy samples along the slant of a floor seen at a low angle, cut to what the GPU has; they double the
 *   time of a frame on a software GPU.
 */
export function prepare(root: Object3D, anisotropy = 8): void {
  const lights: Light[] = [];
  const materials = new Set<Material>();
  root.traverse((object) => {
    if ((object as Light).isLight) lights.push(object as Light);
    if (!(object instanceof Mesh)) return;
    const sky = SKY.test(object.name);
    if (sky) object.userData.collider = false;
    object.castShadow = object.receiveShadow = !sky;
    for (const material of [object.material as Material | Material[]].flat())
      materials.add(material);
  });
  for (const material of materials)
    if (material instanceof MeshStandardMaterial && material.map)
      material.map.anisotropy = anisotropy;
  mirrorSky(materials);
  const bulbs = lights.filter((light) => (light as PointLight).distance !== undefined);
  bulbs.sort((a, b) => b.intensity - a.intensity);
  for (const light of lights)
    if (!bulbs.slice(0, MOST_LIGHTS).includes(light)) light.visible = false;
}
