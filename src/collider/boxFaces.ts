import type {
  BufferAttribute,
  BufferGeometry,
  InterleavedBufferAttribute,
  Matrix4,
  Vector3,
} from 'three';
import { FACES } from '../cube/faces.js';
import { versionOf } from './TriangleIndex.js';
import { verticesOf } from './verticesOf.js';

/** Vertices around which a box is found in no time. */
const FEW = 4096;
/** So much nearer than it is, as a part of the reach, is what stands on a face's edge: it is drawn in both. */
const SLACK = 1e-4;

interface LocalBox {
  readonly position: BufferAttribute | InterleavedBufferAttribute;
  readonly version: number;
  /** Least x, y, z and greatest, or null where the processor has no vertices. */
  readonly box: Float64Array | null;
}

const boxes = /* @__PURE__ */ new WeakMap<BufferGeometry, LocalBox>();

/**
 * The box around a geometry's vertices, in its own space: least x, y, z and greatest. Ours, as nobody tells three when
 * `boundingBox` is of vertices that were edited since.
 *
 * @returns null where it would take long to find, or cannot be
 */
export function boxOf(geometry: BufferGeometry): Float64Array | null {
  const position = geometry.attributes.position as LocalBox['position'];
  let known = boxes.get(geometry);
  if (known?.position !== position || known.version !== versionOf(position)) {
    known = { position, version: versionOf(position), box: measure(geometry) };
    boxes.set(geometry, known);
  }
  return known.box;
}

function measure(geometry: BufferGeometry): Float64Array | null {
  const { count } = geometry.attributes.position!;
  const vertices = count > FEW ? null : verticesOf(geometry);
  if (vertices === null) return null;
  const { array, stride, offset, factor } = vertices;
  const box = new Float64Array(6);
  for (let axis = 0; axis < 3; axis++) {
    let least = Infinity;
    let most = -Infinity;
    for (let i = 0, at = offset + axis; i < count; i++, at += stride) {
      const value = array[at]!;
      if (value < least) least = value;
      if (value > most) most = value;
      // Not a number: who knows where it is drawn.
      if (!(value - value === 0)) return null;
    }
    box[axis] = least * factor;
    box[axis + 3] = most * factor;
  }
  return box;
}

/** The box's middle from the cubemap's centre, how far it extends from there, and its half edges as columns: world axes. */
const middle = new Float64Array(3);
const extents = new Float64Array(3);
const halves = new Float64Array(9);
/** Where each face looks, to its right and up: the axis, and its sign for `forward`. */
const AXES = /* @__PURE__ */ FACES.map(({ forward }) => {
  const axis = forward.findIndex((value) => value !== 0);
  return { axis, sign: forward[axis]!, others: [0, 1, 2].filter((other) => other !== axis) };
});

/**
 * A bit for each face whose pyramid, cut off at `far` along its axis, a box may reach into; 0 if it is out of reach. It
 * tells more than a sphere of what is long or flat: a floor is not above.
 *
 * @param box least x, y, z and greatest, in the space that `matrix` brings to the world's
 * @param center of the cubemap, world space
 * @param far metres
 */
export function facesOfBox(
  box: ArrayLike<number>,
  { elements }: Matrix4,
  center: Vector3,
  far: number,
): number {
  const slack = SLACK * far;
  for (let row = 0; row < 3; row++) {
    let place = elements[12 + row]! - center.getComponent(row);
    let extent = 0;
    for (let axis = 0; axis < 3; axis++) {
      const along = elements[4 * axis + row]!;
      const half = (along * (box[axis + 3]! - box[axis]!)) / 2;
      place += (along * (box[axis + 3]! + box[axis]!)) / 2;
      halves[3 * axis + row] = half;
      extent += Math.abs(half);
    }
    middle[row] = place;
    extents[row] = extent;
    if (Math.abs(place) - extent > far + slack) return 0;
  }
  let mask = 0;
  for (let face = 0; face < 6; face++) {
    const { axis, sign, others } = AXES[face]!;
    if (sign * middle[axis]! + extents[axis]! < -slack) continue;
    if (meets(axis, sign, others[0]!, slack) && meets(axis, sign, others[1]!, slack))
      mask |= 1 << face;
  }
  return mask;
}

/** Does the box reach past both planes at 45° between an axis, that way, and another? */
function meets(axis: number, sign: number, other: number, slack: number): boolean {
  let sum = 0;
  let difference = 0;
  for (let k = 0; k < 9; k += 3) {
    sum += Math.abs(halves[k + axis]! + halves[k + other]!);
    difference += Math.abs(halves[k + axis]! - halves[k + other]!);
  }
  const forward = sign * middle[axis]! + slack;
  const aside = sign * middle[other]!;
  return forward + aside + sum >= 0 && forward - aside + difference >= 0;
}
