import type { Solid } from './Solid.js';
import { Ball, Box, Cylinder, Plane } from './solids.js';

/** Parts of worlds: metres, +Y up, stairs and ramps rising toward +X from x = 0. */

/** The endless floor y = height. */
export const ground = (height = 0): Plane => new Plane('ground').at(0, height, 0);

/** A box by two corners. */
export function block(
  [minX, minY, minZ]: readonly [number, number, number],
  [maxX, maxY, maxZ]: readonly [number, number, number],
  name = 'block',
): Box {
  const half = [(maxX - minX) / 2, (maxY - minY) / 2, (maxZ - minZ) / 2] as const;
  return new Box(...half, name).at(minX + half[0], minY + half[1], minZ + half[2]);
}

/** A wall with its middle at (x, z), its normal `yaw` from +X toward -Z; 10 m high from y = -5. */
export const wall = (x: number, z = 0, yaw = 0, thickness = 0.01, length = 40): Box =>
  new Box(thickness / 2, 5, length / 2, 'wall').at(x, 0, z).turn({ yaw });

/** A kerb: everything beyond x = at is higher, its edge turned by `yaw` about (at, 0). */
export function kerb(height: number, at = 0, yaw = 0): Box {
  return new Box(20, (height + 1) / 2, 20, 'kerb')
    .at(at + 20 * Math.cos(yaw), (height - 1) / 2, -20 * Math.sin(yaw))
    .turn({ yaw });
}

/** Steps up toward +X, the first riser at x = 0, and a landing. */
export function stairs(
  count: number,
  rise: number,
  tread: number,
  width = 6,
  landing = 10,
): Solid[] {
  return Array.from({ length: count }, (_, i) =>
    block(
      [i * tread, -1, -width / 2],
      [i === count - 1 ? count * tread + landing : (i + 1) * tread, (i + 1) * rise, width / 2],
      `step ${i + 1}`,
    ),
  );
}

/** A slab with the upper face through the origin, rising toward +X by `angle` radians. */
export function ramp(angle: number, length = 40, width = 12, thickness = 0.5): Box {
  return new Box(length / 2, thickness / 2, width / 2, 'ramp')
    .at((thickness / 2) * Math.sin(angle), (-thickness / 2) * Math.cos(angle), 0)
    .turn({ roll: angle });
}

/** A ramp that begins at x = 0, nothing of it above the floor before. */
export function rampFrom0(angle: number, length = 20, width = 12): Box {
  const slab = ramp(angle, length, width, 0.2);
  slab.object.position.x += (length / 2) * Math.cos(angle);
  slab.object.position.y += (length / 2) * Math.sin(angle);
  return slab;
}

/** Two thin walls that meet at the origin, open toward +X by `angle` radians. */
export function corner(angle: number, thickness = 0.01, length = 10): Solid[] {
  return [-1, 1].map((side) => {
    const yaw = (side * angle) / 2;
    // Along its own X the wall leads away from the corner; it lies on the outer side of the corner's border.
    const off = (side * thickness) / 2;
    return new Box(length / 2 + thickness, 5, thickness / 2, `corner ${side}`)
      .at(
        (length / 2) * Math.cos(yaw) - off * Math.sin(yaw),
        0,
        (-length / 2) * Math.sin(yaw) - off * Math.cos(yaw),
      )
      .turn({ yaw });
  });
}

/** A table top with four legs, its middle at (x, z). */
export function table(x: number, z: number, height = 0.75, size = 1.2, thickness = 0.03): Solid[] {
  const half = size / 2;
  const legs = [-1, 1].flatMap((i) =>
    [-1, 1].map((k) => {
      const leg = (height - thickness) / 2;
      return new Cylinder(0.03, leg, 'leg').at(x + i * (half - 0.05), leg, z + k * (half - 0.05));
    }),
  );
  return [
    block([x - half, height - thickness, z - half], [x + half, height, z + half], 'table'),
    ...legs,
  ];
}

/** An upright pole on y = 0. */
export const pole = (x: number, z: number, radius = 0.05, height = 3): Cylinder =>
  new Cylinder(radius, height / 2, 'pole').at(x, height / 2, z);

/** A level bar along Z. */
export function rail(x: number, height: number, radius = 0.03, length = 8): Cylinder {
  return new Cylinder(radius, length / 2, 'rail').at(x, height, 0).turn({ pitch: Math.PI / 2 });
}

/** Treads around a newel, each a wedge-like box, rising counter-clockwise seen from above. */
export function spiral(count: number, rise: number, outer = 2.2): Solid[] {
  const solids: Solid[] = [new Cylinder(0.15, (count * rise) / 2 + 1.2, 'newel')];
  solids[0]!.at(0, (count * rise) / 2 + 0.2, 0);
  for (let i = 0; i < count; i++) {
    const yaw = i * (Math.PI / 9);
    solids.push(
      new Box(outer / 2, 0.05, 0.45, `tread ${i + 1}`)
        .at((outer / 2) * Math.cos(yaw), (i + 1) * rise - 0.05, (-outer / 2) * Math.sin(yaw))
        .turn({ yaw }),
    );
  }
  return solids;
}

/** Six thin plates around a room, its inner faces at ± the half extents of its middle. */
export function room(hx: number, hy: number, hz: number, thickness = 0.01): Solid[] {
  const t = thickness / 2;
  return [
    new Box(t, hy + thickness, hz + thickness, 'wall +x').at(hx + t, 0, 0),
    new Box(t, hy + thickness, hz + thickness, 'wall -x').at(-hx - t, 0, 0),
    new Box(hx + thickness, t, hz + thickness, 'ceiling').at(0, hy + t, 0),
    new Box(hx + thickness, t, hz + thickness, 'floor').at(0, -hy - t, 0),
    new Box(hx + thickness, hy + thickness, t, 'wall +z').at(0, 0, hz + t),
    new Box(hx + thickness, hy + thickness, t, 'wall -z').at(0, 0, -hz - t),
  ];
}

export { Ball, Box, Cylinder, Plane };
