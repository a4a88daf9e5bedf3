import { BoxGeometry, DoubleSide, Mesh, MeshStandardMaterial, Scene, Vector3 } from 'three';

/** A scene of rotated, scaled and mirrored boxes around `center`, which lies inside the largest. */
export function boxesAround(center: Vector3): { scene: Scene; meshes: Mesh[] } {
  const scene = new Scene();
  const add = (
    size: [number, number, number],
    offset: [number, number, number],
    rotation: [number, number, number],
    scale: [number, number, number] = [1, 1, 1],
  ) => {
    const mesh = new Mesh(new BoxGeometry(...size), new MeshStandardMaterial({ side: DoubleSide }));
    mesh.position.copy(center).add(new Vector3(...offset));
    mesh.rotation.set(...rotation);
    mesh.scale.set(...scale);
    scene.add(mesh);
    return mesh;
  };
  const meshes = [
    add([4, 3, 5], [0.3, 0.2, -0.4], [0.3, 0.5, 0.2]),
    add([0.8, 0.8, 0.8], [0.9, -0.3, 0.7], [0.7, 0.1, 0.4]),
    add([0.5, 0.9, 0.5], [-0.8, 0.5, -0.2], [0.2, 0.9, 0.4], [-1, 1, 1]),
    add([0.3, 0.3, 0.3], [0.2, 0.9, -0.9], [1.1, 0.4, 0.9], [1.5, -0.4, 2]),
  ];
  scene.updateMatrixWorld();
  return { scene, meshes };
}
