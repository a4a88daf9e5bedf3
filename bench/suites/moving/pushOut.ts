import { Box3, Line3, Matrix4, type Object3D, Vector3 } from 'three';
import { Capsule } from 'three/addons/math/Capsule.js';
import { Octree } from 'three/addons/math/Octree.js';
import type { ExtendedTriangle } from 'three-mesh-bvh';
import { SHAPE } from '../../rivals/shape.js';
import type { MovingRival } from './MovingCase.js';

/** A frame's sub-steps, of both examples. */
export const SUB_STEPS = 5;

/** What of three-mesh-bvh can be asked for the triangles in a box. */
interface Cast {
  shapecast(callbacks: {
    intersectsBounds: (box: Box3) => boolean;
    intersectsTriangle: (triangle: ExtendedTriangle) => void;
  }): boolean;
}

const axis = new Line3();
const bounds = new Box3();
const inverse = new Matrix4();
const onTriangle = new Vector3();
const onAxis = new Vector3();

/** The capsule's box, world space. */
export function capsuleBox(foot: Vector3, target: Box3): Box3 {
  const { radius, height } = SHAPE;
  target.min.set(foot.x - radius, foot.y, foot.z - radius);
  target.max.set(foot.x + radius, foot.y + height, foot.z + radius);
  return target;
}

/**
 * One sub-step of three-mesh-bvh's example characterMovement, in an object's own space: the capsule is pushed out of one
 * triangle after the other.
 *
 * @param object not scaled
 */
export function pushOut(bvh: Cast, object: Object3D, foot: Vector3): void {
  const { radius, height } = SHAPE;
  inverse.copy(object.matrixWorld).invert();
  axis.start.copy(foot).y += height - radius;
  axis.end.copy(foot).y += radius;
  axis.applyMatrix4(inverse);
  bounds.makeEmpty().expandByPoint(axis.start).expandByPoint(axis.end).expandByScalar(radius);
  bvh.shapecast({
    intersectsBounds: (box) => box.intersectsBox(bounds),
    intersectsTriangle: (triangle) => {
      const distance = triangle.closestPointToSegment(axis, onTriangle, onAxis);
      if (distance >= radius) return;
      const out = onAxis.sub(onTriangle).normalize();
      axis.start.addScaledVector(out, radius - distance);
      axis.end.addScaledVector(out, radius - distance);
    },
  });
}

/** three's `Octree`, which can but be built anew: of meshes as they are drawn just now. */
export function rebuiltOctree(foot: Vector3, posed: () => Object3D[]): MovingRival {
  const { radius, height } = SHAPE;
  const capsule = new Capsule(
    new Vector3(foot.x, foot.y + radius, foot.z),
    new Vector3(foot.x, foot.y + height - radius, foot.z),
    radius,
  );
  return {
    name: 'Octree',
    note: 'rebuilt in each frame',
    frame() {
      const octree = new Octree();
      for (const mesh of posed()) octree.fromGraphNode(mesh);
      for (let i = 0; i < SUB_STEPS; i++) octree.capsuleIntersect(capsule);
    },
    dispose() {
      // nothing but memory
    },
  };
}
