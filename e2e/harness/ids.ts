import {
  BatchedMesh,
  BoxGeometry,
  DoubleSide,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  Quaternion,
  Raycaster,
  Scene,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from 'three';
import { CubeCollider, type CubeColliderOptions, type SurfaceField } from 'three-cube-collider';

const both = { side: DoubleSide };

/** Three meshes that share a material, one of two materials, and eleven instances, all around the origin. */
function makeScene() {
  const shared = new MeshStandardMaterial(both);
  const floor = new Mesh(new PlaneGeometry(8, 8), shared);
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -1;
  const ball = new Mesh(new SphereGeometry(0.6, 48, 32), shared);
  ball.position.set(1.2, 0.3, 0.6);
  const crate = new Mesh(
    new BoxGeometry(0.9, 0.9, 0.9),
    Array.from({ length: 6 }, (_, i) => (i % 2 ? shared : new MeshBasicMaterial(both))),
  );
  crate.position.set(-1.3, 0.1, -0.4);
  crate.rotation.set(0.4, 0.7, 0.2);
  const posts = new InstancedMesh(new BoxGeometry(0.25, 1.6, 0.25), shared, 11);
  for (let i = 0; i < posts.count; i++) {
    const angle = (2 * Math.PI * i) / posts.count;
    posts.setMatrixAt(
      i,
      new Matrix4().compose(
        new Vector3(2 * Math.cos(angle), 0.2 * (i % 3), 2 * Math.sin(angle)),
        new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), i),
        new Vector3(1, 1, 1 + (i % 2)),
      ),
    );
  }
  posts.position.y = 0.1;
  // Neighbours in this order share a program, a material and faces: only their numbers differ.
  const scene = new Scene().add(floor, ball, crate, posts);
  scene.updateMatrixWorld();
  return { scene, floor, ball, crate, posts };
}

/** Texels of a field that agree with three's Raycaster in object and instance, and how many of each it tells. */
function judge(field: SurfaceField, scene: Scene, near: number) {
  const ray = new Raycaster();
  const direction = new Vector3();
  const report = { texels: field.count, agreed: 0, instances: [] as number[], objects: 0 };
  const objects = new Set<unknown>();
  const instances = new Set<number>();
  for (let texel = 0; texel < field.count; texel++) {
    direction.fromArray(field.direction, 3 * texel).normalize();
    ray.set(field.center, direction);
    const hit = ray
      .intersectObjects(scene.children, false)
      .find(({ distance }) => distance > near && distance < field.far);
    const number = field.object[texel]!;
    const object = number === 0 ? null : field.objects[number - 1];
    const instance = field.instance[texel]!;
    if (object === (hit?.object ?? null) && instance === (hit?.instanceId ?? 0)) report.agreed++;
    if (object) objects.add(object);
    if (object instanceof InstancedMesh) instances.add(instance);
  }
  report.objects = objects.size;
  report.instances = [...instances].sort((a, b) => a - b);
  return report;
}

const cases = {
  /** Every texel of one cubemap. */
  async texels(options: CubeColliderOptions) {
    const renderer = new WebGLRenderer();
    const { scene } = makeScene();
    const collider = new CubeCollider({ far: 6, ...options });
    const field = (await collider.updateAsync(renderer, scene))!;
    const report = { ...judge(field, scene, collider.near), format: collider.format };
    collider.dispose();
    renderer.dispose();
    return report;
  },

  /** Two draws in flight, of other objects at other places, then the newer read: it must bring its own table. */
  async inFlight(options: CubeColliderOptions) {
    const renderer = new WebGLRenderer();
    const { scene, floor, ball } = makeScene();
    const collider = new CubeCollider({ far: 6, slack: 6, maxAge: 60, ...options });
    await collider.updateAsync(renderer, scene);
    const kept = collider.field!;
    const before = [...kept.objects];
    collider.update(renderer, scene);
    scene.remove(floor);
    ball.position.x = 1.1;
    collider.update(renderer, scene);
    // After the draw: the field must bring what was, not what is.
    ball.position.x = 3;
    scene.updateMatrixWorld();
    const { reads } = collider.stats;
    while (collider.stats.reads === reads) await new Promise((resolve) => setTimeout(resolve, 5));
    const field = collider.field!;
    const place = field.objects.indexOf(ball);
    ball.position.x = 1.1;
    scene.updateMatrixWorld();
    const report = {
      ...judge(field, scene, collider.near),
      drawnAt: field.matrices[place]!.elements[12],
      hasFloor: field.objects.includes(floor),
      keptWhole:
        kept.objects.length === before.length && before.every((o, i) => o === kept.objects[i]),
    };
    collider.dispose();
    renderer.dispose();
    return report;
  },

  /** What is toward +X and -X of a batch with more instances than 16 bits tell apart: its name, and its number. */
  limits(options: CubeColliderOptions) {
    const renderer = new WebGLRenderer();
    const collider = new CubeCollider({ far: 2, readback: 'sync', ...options });
    const box = new BoxGeometry();
    const batch = new BatchedMesh(70_000, 24, 36, new MeshBasicMaterial());
    batch.name = 'batch';
    const geometry = batch.addGeometry(box);
    const away = new Matrix4().makeTranslation(0, 90, 0);
    for (let i = 0; i < 70_000; i++) batch.setMatrixAt(batch.addInstance(geometry), away);
    batch.setMatrixAt(69_999, new Matrix4().makeTranslation(1.5, 0, 0));
    batch.setMatrixAt(4096, new Matrix4().makeTranslation(-1.5, 0, 0));
    collider.update(renderer, new Scene().add(batch));
    const { resolution: n, object, objects, instance } = collider.field!;
    const seen = [0, 1].map((face) => {
      const texel = face * n * n + (n / 2) * n + n / 2;
      return [objects[object[texel]! - 1]?.name, instance[texel]!];
    });
    const { drawCalls } = collider.stats;
    collider.dispose();
    renderer.dispose();
    return { seen, drawCalls };
  },

  /** The reach: set between draws, in flight, and seen in a field. */
  async reach(options: CubeColliderOptions) {
    const renderer = new WebGLRenderer();
    const scene = new Scene().add(
      new Mesh(new BoxGeometry(4, 4, 4), new MeshBasicMaterial({ side: DoubleSide })),
    );
    const collider = new CubeCollider({ readback: 'sync', ...options });
    const seen: [number, number, number][] = [];
    const look = () => {
      collider.update(renderer, scene);
      const { far, distance } = collider.field!;
      const hits = [...distance].filter((d) => d < Infinity);
      const wall = collider.field!.distance[collider.resolution ** 2 / 2 + collider.resolution / 2];
      seen.push([far, hits.length / distance.length, wall!]);
    };
    look();
    collider.far = 4;
    const untilDrawn = collider.field!.far;
    look();
    collider.far = 2.5;
    look();
    const { autoFar } = collider;
    collider.dispose();
    renderer.dispose();
    return { seen, untilDrawn, autoFar };
  },
};

export type IdCases = typeof cases;

export default function ids({ name, args }: { name: keyof IdCases; args: CubeColliderOptions }) {
  return cases[name](args);
}
