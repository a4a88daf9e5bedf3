import RAPIER from '@dimforge/rapier3d-compat';
import { Box3, BoxGeometry, Mesh, MeshBasicMaterial, Scene, Vector3 } from 'three';
import { MeshBVH, ObjectBVH } from 'three-mesh-bvh';
import { SHAPE } from '../../rivals/shape.js';
import { FRAME } from '../pace.js';
import { floor } from './floor.js';
import type { MovingCase, MovingRival } from './MovingCase.js';
import { capsuleBox, pushOut, rebuiltOctree, SUB_STEPS } from './pushOut.js';

/** Metres: of an edge, and from one to the next. */
const EDGE = 0.5;
const APART = 1;
/** Gap of Rapier's controller, metres: the value of its guide. */
const OFFSET = 0.01;

/** Boxes that turn and rise each by itself, in ranks around the character. */
export function boxes(count: number): MovingCase {
  const geometry = new BoxGeometry(EDGE, EDGE, EDGE);
  const meshes: Mesh[] = [];
  const edge = Math.ceil(Math.sqrt(count + 1));
  for (let i = 0; meshes.length < count; i++) {
    const x = APART * ((i % edge) - Math.floor(edge / 2));
    const z = APART * (Math.floor(i / edge) - Math.floor(edge / 2));
    if (x === 0 && z === 0) continue;
    const mesh = new Mesh(geometry, new MeshBasicMaterial());
    mesh.position.set(x, 0, z);
    meshes.push(mesh);
  }
  const scene = new Scene().add(floor(), ...meshes);
  const foot = new Vector3(0, 0.05, 0);
  scene.updateMatrixWorld();
  return {
    name: `${count} moving boxes`,
    scene,
    foot,
    move(frame) {
      meshes.forEach((mesh, i) => {
        mesh.rotation.y = 0.02 * frame + i;
        mesh.position.y = 0.8 + 0.3 * Math.sin(0.05 * frame + i);
      });
    },
    rivals: () => [
      kinematic(meshes, foot),
      refitted(meshes, foot),
      rebuiltOctree(foot, () => [scene]),
    ],
    cannot: {},
  };
}

/** A body each, told every frame where it goes. */
function kinematic(meshes: Mesh[], foot: Vector3): MovingRival {
  const world = new RAPIER.World({ x: 0, y: -SHAPE.gravity, z: 0 });
  world.timestep = FRAME;
  world.createCollider(RAPIER.ColliderDesc.cuboid(20, 0.5, 20).setTranslation(0, -0.5, 0));
  const half = EDGE / 2;
  const bodies = meshes.map(({ position: { x, y, z } }) => {
    const desc = RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(x, y, z);
    const body = world.createRigidBody(desc);
    world.createCollider(RAPIER.ColliderDesc.cuboid(half, half, half), body);
    return body;
  });
  const { radius, height } = SHAPE;
  const body = world.createRigidBody(
    RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(
      foot.x,
      foot.y + height / 2,
      foot.z,
    ),
  );
  const capsule = world.createCollider(
    RAPIER.ColliderDesc.capsule(height / 2 - radius, radius),
    body,
  );
  const controller = world.createCharacterController(OFFSET);
  controller.enableAutostep(0.4, 0.2, true);
  controller.enableSnapToGround(0.4);
  return {
    name: 'Rapier',
    frame() {
      for (const [i, { position, quaternion }] of meshes.entries()) {
        bodies[i]!.setNextKinematicTranslation(position);
        bodies[i]!.setNextKinematicRotation(quaternion);
      }
      controller.computeColliderMovement(capsule, {
        x: 0,
        y: -SHAPE.gravity * FRAME * FRAME,
        z: 0,
      });
      const travel = controller.computedMovement();
      const { x, y, z } = body.translation();
      body.setNextKinematicTranslation({ x: x + travel.x, y: y + travel.y, z: z + travel.z });
      world.step();
    },
    dispose: () => world.free(),
  };
}

/** A tree over the objects, refitted; within reach, that of their geometry, in each one's own space. */
function refitted(meshes: Mesh[], foot: Vector3): MovingRival {
  const bvh = new MeshBVH(meshes[0]!.geometry, { indirect: true });
  const objects = new ObjectBVH(meshes);
  const box = capsuleBox(foot, new Box3());
  return {
    name: 'three-mesh-bvh',
    frame() {
      objects.refit();
      for (let i = 0; i < SUB_STEPS; i++) {
        objects.shapecast({
          intersectsBounds: (bounds) => bounds.intersectsBox(box),
          intersectsObject: (object) => pushOut(bvh, object, foot),
        });
      }
    },
    dispose() {
      // nothing but memory
    },
  };
}
