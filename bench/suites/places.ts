import { Box3, BufferGeometry, Mesh, MeshBasicMaterial, Scene, Sphere, Vector3 } from 'three';
import { terrain } from '../../test/support/terrain.js';
import { loadWalkLevel } from '../walk/level.js';

/** Metres: a level as wide as a football field is long. */
const SIZE = 100;
/** Of the places that walks in a level begin at. */
const SEED = 7;

/** Where contestants walk. */
export interface Place {
  name: string;
  triangles: number;
  /** As loaded, for those who draw. */
  scene: Scene;
  /** All that is solid, world space, for those who build. */
  geometry: BufferGeometry;
  /** The foot at the beginning of a walk; it may have to fall a little. */
  start(walk: number): Vector3;
  /** Height of the lowest vertex. */
  lowest: number;
}

/** Triangles by name. */
export const SIZES: Record<string, number> = {
  '10k triangles': 10_000,
  '100k triangles': 100_000,
  '1M triangles': 1_000_000,
  '5M triangles': 5_000_000,
};

/** Waves of a hundred metres, in one mesh. */
export function terrainPlace(name: string, triangles: number): Place {
  const geometry = terrain(Math.round(Math.sqrt(triangles / 2)), SIZE);
  // As a loader knows them from the file, without a look at the vertices.
  geometry.boundingBox = new Box3(new Vector3(-50, -1.1, -50), new Vector3(50, 1.1, 50));
  geometry.boundingSphere = geometry.boundingBox.getBoundingSphere(new Sphere());
  return {
    name,
    triangles: geometry.index!.count / 3,
    scene: new Scene().add(new Mesh(geometry, new MeshBasicMaterial())),
    geometry,
    // Above a place where it is level.
    start: () => new Vector3(0.571, 1, 0),
    lowest: -1.1,
  };
}

export async function levelPlace({ name, url }: { name: string; url: string }): Promise<Place> {
  const level = await loadWalkLevel(url);
  const places = level.places(SEED);
  const { triangles, scene, geometry, lowest } = level;
  return { name, triangles, scene, geometry, start: (walk) => places.at(walk), lowest };
}

/** The same triangles in a geometry that nobody has seen yet. */
export function fresh(geometry: BufferGeometry): BufferGeometry {
  const copy = new BufferGeometry().setIndex(geometry.index);
  copy.attributes = { ...geometry.attributes };
  copy.boundingBox = geometry.boundingBox;
  copy.boundingSphere = geometry.boundingSphere;
  return copy;
}
