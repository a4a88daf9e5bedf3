import { Box3, DoubleSide, Line3, Ray, Vector3, type BufferGeometry } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { SHAPE } from './shape.js';

/** Beyond this gap it no longer asks how far the next surface is, metres. */
const FARTHEST_GAP = 0.5;

/**
 * Says the truth about an upright capsule among triangles: three-mesh-bvh's exact distance between the capsule's axis
 * and the triangles. It knows nothing of cubemaps, and judges every walker alike.
 */
export class Judge {
  readonly bvh: MeshBVH;
  readonly #axis = new Line3();
  readonly #axisBox = new Box3();
  readonly #ray = new Ray();
  readonly #end = new Vector3();

  /** @param geometry all that is solid, world space */
  constructor(geometry: BufferGeometry) {
    // Its own order of the triangles is kept beside the index, so the walkers may have the geometry as it was.
    this.bvh = new MeshBVH(geometry, { indirect: true });
  }

  /**
   * How deep the capsule that stands on `foot` (its lowest point) is in the nearest triangle, metres: its radius less
   * the distance from its axis. Negative is a gap; at most 0.5 m of it is told.
   */
  penetration(foot: Vector3, radius: number = SHAPE.radius, height: number = SHAPE.height): number {
    this.#axis.start.copy(foot).y += radius;
    this.#axis.end.copy(foot).y += height - radius;
    // An upright axis is its own bounding box, so the distance of the boxes is the exact bound.
    const axis = this.#axisBox.setFromPoints([this.#axis.start, this.#axis.end]);
    let nearest = radius + FARTHEST_GAP;
    this.bvh.shapecast({
      boundsTraverseOrder: (box) => distanceOf(box, axis),
      intersectsBounds: (box) => distanceOf(box, axis) < nearest,
      intersectsTriangle: (triangle) => {
        nearest = Math.min(nearest, triangle.closestPointToSegment(this.#axis));
      },
    });
    return radius - nearest;
  }

  /** Whether a triangle, either side of it, lies across the way from `from` to `to`, `up` metres above both. */
  crossed(from: Vector3, to: Vector3, up: number): boolean {
    const { origin, direction } = this.#ray;
    origin.copy(from).y += up;
    this.#end.copy(to).y += up;
    const length = direction.subVectors(this.#end, origin).length();
    if (length === 0) return false;
    direction.divideScalar(length);
    return this.bvh.raycastFirst(this.#ray, DoubleSide, 0, length) !== null;
  }

  /** The first surface below `point`, not more than `reach` metres down: its height, and how far up it faces (1: flat). */
  floorBelow(point: Vector3, reach: number): { height: number; up: number } | null {
    this.#ray.origin.copy(point);
    this.#ray.direction.set(0, -1, 0);
    const hit = this.bvh.raycastFirst(this.#ray, DoubleSide, 0, reach);
    return hit ? { height: hit.point.y, up: Math.abs(hit.face!.normal.y) } : null;
  }
}

/** Between two boxes, metres; 0 if they touch. */
function distanceOf(a: Box3, b: Box3): number {
  const x = Math.max(0, a.min.x - b.max.x, b.min.x - a.max.x);
  const y = Math.max(0, a.min.y - b.max.y, b.min.y - a.max.y);
  const z = Math.max(0, a.min.z - b.max.z, b.min.z - a.max.z);
  return Math.sqrt(x * x + y * y + z * z);
}
