import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PlaneGeometry,
  SphereGeometry,
  TorusKnotGeometry,
  Triangle,
  Vector3,
} from 'three';

/** A scene to draw, and the same as bare triangles. */
export interface AxisScene {
  name: string;
  root: Group;
  /** World corners, float64: nine numbers a triangle. */
  triangles: Float64Array;
}

/** Numbers of 0..1 from a seed (mulberry32). */
export function seeded(seed: number): () => number {
  let a = seed >>> 0;
  return () => {
    a = (a + 0x6d2b79f5) >>> 0;
    let t = Math.imul(a ^ (a >>> 15), a | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** The three scenes of the paper's mode; metres, about a character's size. */
export function axisScenes(): AxisScene[] {
  return [
    scene('turned, mirrored and sheared boxes', boxes()),
    scene('stairs, columns and a corner, a kilometre out', room()),
    scene('terrain with a ball and a knot', terrain()),
  ];
}

function scene(name: string, root: Group): AxisScene {
  root.updateMatrixWorld(true);
  return { name, root, triangles: collectTriangles(root) };
}

/** World triangles of all meshes below `root`, in float64; matrices must be up to date. */
export function collectTriangles(root: Object3D): Float64Array {
  const numbers: number[] = [];
  const corner = new Vector3();
  root.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const geometry = object.geometry as BufferGeometry;
    const { position } = geometry.attributes;
    const count = geometry.index?.count ?? position!.count;
    for (let i = 0; i < count; i++) {
      corner.fromBufferAttribute(position!, geometry.index?.getX(i) ?? i);
      corner.applyMatrix4(object.matrixWorld);
      numbers.push(corner.x, corner.y, corner.z);
    }
  });
  return Float64Array.from(numbers);
}

/**
 * Places for the sphere: something lies within about rMax of each, and nothing so near that the near plane cuts it.
 * Insides of solids are among them: both sides are drawn.
 */
export function axisPoses(
  triangles: Float64Array,
  rMax: number,
  count: number,
  seed: number,
): Vector3[] {
  const random = seeded(seed);
  const poses: Vector3[] = [];
  const triangle = new Triangle();
  const nearest = new Vector3();
  while (poses.length < count) {
    const from = 9 * Math.floor((random() * triangles.length) / 9);
    setTriangle(triangle, triangles, from);
    const u = Math.sqrt(random());
    const v = random();
    const pose = triangle.a
      .clone()
      .multiplyScalar(1 - u)
      .addScaledVector(triangle.b, u * (1 - v))
      .addScaledVector(triangle.c, u * v);
    const offset = new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).normalize();
    pose.addScaledVector(offset, rMax * (0.2 + 0.85 * random()));
    let distance = Infinity;
    for (let i = 0; i < triangles.length; i += 9) {
      setTriangle(triangle, triangles, i);
      distance = Math.min(distance, triangle.closestPointToPoint(pose, nearest).distanceTo(pose));
    }
    if (distance > 0.05 * rMax) poses.push(pose);
  }
  return poses;
}

function setTriangle(triangle: Triangle, numbers: Float64Array, from: number): void {
  triangle.a.fromArray(numbers, from);
  triangle.b.fromArray(numbers, from + 3);
  triangle.c.fromArray(numbers, from + 6);
}

const material = new MeshBasicMaterial();

function mesh(parent: Object3D, geometry: BufferGeometry): Mesh {
  const made = new Mesh(geometry, material);
  parent.add(made);
  return made;
}

function boxes(): Group {
  const root = new Group();
  const random = seeded(11);
  const geometry = new BoxGeometry(1, 1, 1);
  // A turned child of an unevenly scaled parent is sheared.
  const parents = [
    [1, 1, 1],
    [-1, 1, 1],
    [1.5, 0.5, -0.8],
  ].map(([x, y, z], i) => {
    const parent = new Group();
    parent.scale.set(x!, y!, z!);
    parent.rotation.set(0.3 * i, 0.7 * i, -0.2 * i);
    root.add(parent);
    return parent;
  });
  for (let i = 0; i < 24; i++) {
    const box = mesh(parents[i % 3]!, geometry);
    box.position.set(4 * random() - 2, 4 * random() - 2, 4 * random() - 2);
    box.rotation.set(6 * random(), 6 * random(), 6 * random());
    box.scale.set(0.1 + random(), 0.1 + random(), (i % 2 ? -1 : 1) * (0.1 + random()));
  }
  return root;
}

function room(): Group {
  const root = new Group();
  root.position.set(1000.3, -50.7, 300.1);
  root.rotation.y = 0.4;
  const block = new BoxGeometry(1, 1, 1);
  for (let i = 0; i < 6; i++) {
    const step = mesh(root, block);
    step.scale.set(2, 0.15 * (i + 1), 0.3);
    step.position.set(0, 0.075 * (i + 1), -0.3 * i);
  }
  const column = new CylinderGeometry(0.12, 0.15, 2.5, 12);
  for (let i = 0; i < 4; i++) mesh(root, column).position.set(1.4, 1.25, -0.6 * i);
  const floor = mesh(root, new PlaneGeometry(6, 6));
  floor.rotation.x = -Math.PI / 2;
  const wall = mesh(root, new PlaneGeometry(6, 3));
  wall.position.set(0, 1.5, -2.2);
  const side = mesh(root, new PlaneGeometry(6, 3));
  side.position.set(-1.2, 1.5, 0);
  side.rotation.y = Math.PI / 2;
  return root;
}

function terrain(): Group {
  const root = new Group();
  const ground = new PlaneGeometry(6, 6, 24, 24).rotateX(-Math.PI / 2);
  const { position } = ground.attributes;
  for (let i = 0; i < position!.count; i++) {
    const x = position!.getX(i);
    const z = position!.getZ(i);
    position!.setY(
      i,
      0.35 * Math.sin(2.1 * x) * Math.cos(1.7 * z) + 0.08 * Math.sin(7 * x + 5 * z),
    );
  }
  mesh(root, ground);
  mesh(root, new SphereGeometry(0.5, 16, 12)).position.set(0.8, 0.7, 0.3);
  const knot = mesh(root, new TorusKnotGeometry(0.4, 0.12, 48, 8));
  knot.position.set(-1, 0.8, -0.5);
  knot.scale.set(1.2, 0.7, 1);
  return root;
}
