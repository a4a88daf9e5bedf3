/**
 * Scenes as ray functions in plain float64: the oracle that knows nothing of the package. Both sides of everything are
 * solid to a ray, as the collider draws them.
 */

/** Distance along a unit direction to the first surface, metres; Infinity for none. World space. */
export type Shape = (
  ox: number,
  oy: number,
  oz: number,
  dx: number,
  dy: number,
  dz: number,
) => number;

/** An endless plane of points p with n · p = offset; n need not be of unit length. */
export function plane(nx: number, ny: number, nz: number, offset: number): Shape {
  return (ox, oy, oz, dx, dy, dz) => {
    const t = (offset - (nx * ox + ny * oy + nz * oz)) / (nx * dx + ny * dy + nz * dz);
    return t > 0 ? t : Infinity;
  };
}

/** A box by its corners; from inside, the wall that is left through. */
export function box(
  minX: number,
  minY: number,
  minZ: number,
  maxX: number,
  maxY: number,
  maxZ: number,
): Shape {
  return (ox, oy, oz, dx, dy, dz) => {
    const ax = (minX - ox) / dx;
    const bx = (maxX - ox) / dx;
    const ay = (minY - oy) / dy;
    const by = (maxY - oy) / dy;
    const az = (minZ - oz) / dz;
    const bz = (maxZ - oz) / dz;
    const enter = Math.max(Math.min(ax, bx), Math.min(ay, by), Math.min(az, bz));
    const leave = Math.min(Math.max(ax, bx), Math.max(ay, by), Math.max(az, bz));
    if (!(leave >= enter) || leave <= 0) return Infinity;
    return enter > 0 ? enter : leave;
  };
}

/** A ball's surface. */
export function ball(cx: number, cy: number, cz: number, radius: number): Shape {
  return (ox, oy, oz, dx, dy, dz) => {
    const x = ox - cx;
    const y = oy - cy;
    const z = oz - cz;
    const b = x * dx + y * dy + z * dz;
    const root = b * b - (x * x + y * y + z * z - radius * radius);
    if (root < 0) return Infinity;
    const near = -b - Math.sqrt(root);
    if (near > 0) return near;
    const far = -b + Math.sqrt(root);
    return far > 0 ? far : Infinity;
  };
}

/** The nearest of several. */
export function union(...shapes: Shape[]): Shape {
  return (ox, oy, oz, dx, dy, dz) => {
    let nearest = Infinity;
    for (let i = 0; i < shapes.length; i++) {
      const t = shapes[i]!(ox, oy, oz, dx, dy, dz);
      if (t < nearest) nearest = t;
    }
    return nearest;
  };
}

/** The floor y = height. */
export const floor = (height = 0): Shape => plane(0, 1, 0, height);

/** A floor that rises toward +X by `angle` radians, through the origin. */
export const ramp = (angle: number): Shape => plane(-Math.sin(angle), Math.cos(angle), 0, 0);

/** Two walls x = ±width/2. */
export const corridor = (width: number): Shape =>
  union(plane(1, 0, 0, -width / 2), plane(1, 0, 0, width / 2));

/** Steps up toward +X, the first riser at x = 0, each a box down to y = -1. */
export function stairs(count: number, rise: number, tread: number): Shape {
  const steps: Shape[] = [];
  for (let i = 0; i < count; i++) {
    steps.push(box(i * tread, -1, -50, count * tread + 50, (i + 1) * rise, 50));
  }
  return union(...steps);
}
