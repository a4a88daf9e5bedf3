/** The six faces of the cubemap in the order every array of this package uses. */
export const FACE_NAMES = ['+X', '-X', '+Y', '-Y', '+Z', '-Z'] as const;

/** Name of a face of the cube. */
export type FaceName = (typeof FACE_NAMES)[number];

/** One face: three orthonormal world axes. `right` = `forward` × `up`, as a camera has it. */
export interface Face {
  readonly name: FaceName;
  /** The paper's name for this side. */
  readonly side: 'right' | 'left' | 'top' | 'bottom' | 'back' | 'front';
  /** Outward axis: where the face's camera looks (its -Z). */
  readonly forward: readonly [number, number, number];
  /** Along growing texel x. */
  readonly right: readonly [number, number, number];
  /** Along growing texel y (rows count upward, as GL reads them). */
  readonly up: readonly [number, number, number];
}

/**
 * The faces with the axes of the paper's matrices (3)-(8): world Y is up on the four sides, +Z on the top face,
 * -Z on the bottom one. All six are right-handed, so no winding is flipped.
 */
export const FACES: readonly Face[] = [
  { name: '+X', side: 'right', forward: [1, 0, 0], right: [0, 0, 1], up: [0, 1, 0] },
  { name: '-X', side: 'left', forward: [-1, 0, 0], right: [0, 0, -1], up: [0, 1, 0] },
  { name: '+Y', side: 'top', forward: [0, 1, 0], right: [1, 0, 0], up: [0, 0, 1] },
  { name: '-Y', side: 'bottom', forward: [0, -1, 0], right: [1, 0, 0], up: [0, 0, -1] },
  { name: '+Z', side: 'back', forward: [0, 0, 1], right: [-1, 0, 0], up: [0, 1, 0] },
  { name: '-Z', side: 'front', forward: [0, 0, -1], right: [1, 0, 0], up: [0, 1, 0] },
];

/** Of each face `forward`, `right` and `up`, 3 numbers each. */
export const FACE_VECTORS: readonly Float64Array[] = /* @__PURE__ */ FACES.map(
  ({ forward, right, up }) => new Float64Array([...forward, ...right, ...up]),
);

/**
 * The same in whole numbers, 6 a face, for loops over texels: which of x, y, z (0 to 2) `forward`, `right` and `up` lie
 * along, and the sign of each.
 */
export const FACE_AXES = /* @__PURE__ */ Int8Array.from(
  /* @__PURE__ */ FACES.flatMap(({ forward, right, up }) => {
    const axes = [forward, right, up];
    const along = axes.map((axis) => axis.findIndex((part) => part !== 0));
    return [...along, ...along.map((axis, i) => axes[i]![axis]!)];
  }),
);

/** The index of a face in `FACES`, by name of its axis. */
export const FACE = { PX: 0, NX: 1, PY: 2, NY: 3, PZ: 4, NZ: 5 } as const;
