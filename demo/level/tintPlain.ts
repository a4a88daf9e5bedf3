import { Mesh, MeshStandardMaterial, type Object3D } from 'three';

/** Paler than this, of each channel, linear: what exporters write where nobody chose a colour. */
const PALE = 0.55;
/** More between two channels is a colour. */
const COLOURED = 0.12;
/** In place of it, linear: against the pale sky its lit and its shaded faces part. */
const GROUND = [0.43, 0.38, 0.31] as const;

/** Gives what has no texture, no colours of its own and hardly a colour, one in which it can be told apart. */
export function tintPlain(root: Object3D): void {
  root.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    for (const material of [object.material].flat()) {
      if (!(material instanceof MeshStandardMaterial) || !isPlain(material)) continue;
      material.color.setRGB(...GROUND);
    }
  });
}

function isPlain({ map, vertexColors, emissiveMap, color }: MeshStandardMaterial): boolean {
  if (map !== null || emissiveMap !== null || vertexColors) return false;
  const channels = [color.r, color.g, color.b];
  const [least, most] = [Math.min(...channels), Math.max(...channels)];
  return least > PALE && most - least < COLOURED;
}
