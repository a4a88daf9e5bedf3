import { Solid } from './Solid.js';

/** A box by its half extents. */
export class Box extends Solid {
  readonly bound: number;

  constructor(
    readonly hx: number,
    readonly hy: number,
    readonly hz: number,
    name = 'box',
  ) {
    super(name);
    this.bound = Math.sqrt(hx * hx + hy * hy + hz * hz);
  }

  cast(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number): number {
    const { hx, hy, hz } = this;
    let enter = -Infinity;
    let leave = Infinity;
    let entered = 0;
    let left = 0;
    for (let axis = 0; axis < 3; axis++) {
      const o = axis === 0 ? ox : axis === 1 ? oy : oz;
      const d = axis === 0 ? dx : axis === 1 ? dy : dz;
      const h = axis === 0 ? hx : axis === 1 ? hy : hz;
      if (d === 0) {
        if (o > h || o < -h) return Infinity;
        continue;
      }
      const near = (d > 0 ? -h - o : h - o) / d;
      const far = (d > 0 ? h - o : -h - o) / d;
      if (near > enter) {
        enter = near;
        entered = axis;
      }
      if (far < leave) {
        leave = far;
        left = axis;
      }
    }
    if (leave < enter || leave <= 0) return Infinity;
    const inside = enter <= 0;
    const axis = inside ? left : entered;
    const d = axis === 0 ? dx : axis === 1 ? dy : dz;
    const sign = d > 0 === inside ? 1 : -1;
    this.nx = axis === 0 ? sign : 0;
    this.ny = axis === 1 ? sign : 0;
    this.nz = axis === 2 ? sign : 0;
    return inside ? leave : enter;
  }

  nearest(x: number, y: number, z: number): void {
    const { hx, hy, hz } = this;
    this.nx = x > hx ? hx : x < -hx ? -hx : x;
    this.ny = y > hy ? hy : y < -hy ? -hy : y;
    this.nz = z > hz ? hz : z < -hz ? -hz : z;
  }
}

/** An endless plane y = 0 with no thickness, its front up. */
export class Plane extends Solid {
  readonly bound = Infinity;

  constructor(name = 'plane') {
    super(name);
  }

  cast(_x: number, oy: number, _z: number, _dx: number, dy: number): number {
    const t = -oy / dy;
    if (!(t > 0)) return Infinity;
    this.nx = this.nz = 0;
    this.ny = 1;
    return t;
  }

  nearest(x: number, _: number, z: number): void {
    this.nx = x;
    this.ny = 0;
    this.nz = z;
  }
}

/** A ball. */
export class Ball extends Solid {
  readonly bound: number;

  constructor(
    readonly radius: number,
    name = 'ball',
  ) {
    super(name);
    this.bound = radius;
  }

  cast(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number): number {
    const b = ox * dx + oy * dy + oz * dz;
    const root = b * b - (ox * ox + oy * oy + oz * oz - this.radius * this.radius);
    if (root < 0) return Infinity;
    const near = -b - Math.sqrt(root);
    const t = near > 0 ? near : -b + Math.sqrt(root);
    if (!(t > 0)) return Infinity;
    this.nx = (ox + t * dx) / this.radius;
    this.ny = (oy + t * dy) / this.radius;
    this.nz = (oz + t * dz) / this.radius;
    return t;
  }

  nearest(x: number, y: number, z: number): void {
    const length = Math.sqrt(x * x + y * y + z * z);
    const part = length > this.radius ? this.radius / length : 1;
    this.nx = part * x;
    this.ny = part * y;
    this.nz = part * z;
  }
}

/** A round bar along its own Y, with flat ends: a pole, or turned by a quarter a rail. */
export class Cylinder extends Solid {
  readonly bound: number;

  constructor(
    readonly radius: number,
    readonly half: number,
    name = 'cylinder',
  ) {
    super(name);
    this.bound = Math.sqrt(radius * radius + half * half);
  }

  cast(ox: number, oy: number, oz: number, dx: number, dy: number, dz: number): number {
    const a = dx * dx + dz * dz;
    const b = ox * dx + oz * dz;
    const c = ox * ox + oz * oz - this.radius * this.radius;
    let enter = -Infinity;
    let leave = Infinity;
    if (a > 0) {
      const root = b * b - a * c;
      if (root < 0) return Infinity;
      enter = (-b - Math.sqrt(root)) / a;
      leave = (-b + Math.sqrt(root)) / a;
    } else if (c > 0) {
      return Infinity;
    }
    let entersEnd = false;
    let leavesEnd = false;
    if (dy !== 0) {
      const near = (dy > 0 ? -this.half - oy : this.half - oy) / dy;
      const far = (dy > 0 ? this.half - oy : -this.half - oy) / dy;
      entersEnd = near > enter;
      leavesEnd = far < leave;
      if (entersEnd) enter = near;
      if (leavesEnd) leave = far;
    } else if (oy > this.half || oy < -this.half) {
      return Infinity;
    }
    if (leave < enter || leave <= 0) return Infinity;
    const inside = enter <= 0;
    const t = inside ? leave : enter;
    const end = inside ? leavesEnd : entersEnd;
    this.nx = end ? 0 : (ox + t * dx) / this.radius;
    this.ny = end ? (dy > 0 === inside ? 1 : -1) : 0;
    this.nz = end ? 0 : (oz + t * dz) / this.radius;
    return t;
  }

  nearest(x: number, y: number, z: number): void {
    const length = Math.sqrt(x * x + z * z);
    const part = length > this.radius ? this.radius / length : 1;
    this.nx = part * x;
    this.ny = y > this.half ? this.half : y < -this.half ? -this.half : y;
    this.nz = part * z;
  }
}
