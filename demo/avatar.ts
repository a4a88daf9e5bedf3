import {
  CapsuleGeometry,
  CylinderGeometry,
  Group,
  LatheGeometry,
  type Material,
  Mesh,
  MeshStandardMaterial,
  type Object3D,
  SphereGeometry,
  TorusGeometry,
  Vector2,
} from 'three';
import { RoundedBoxGeometry } from 'three/addons/geometries/RoundedBoxGeometry.js';

/** Metres of walking for a left and a right step. */
const STRIDE = 1.5;

/** A figure that walks: put it where the character is and tell it how fast it goes. */
export interface Avatar {
  /** Origin at the foot, looking along +Z, 1.75 m tall. */
  readonly object: Group;
  /** Swings arms and legs; crouched it is 1.1 m tall. @param speed m/s along the ground */
  animate(delta: number, speed: number, grounded: boolean, crouched: boolean): void;
}

/** A small rounded traveller with a visor and a backpack, made of primitives. */
export function createAvatar(): Avatar {
  const shell = new MeshStandardMaterial({ color: 0xf4efe6, roughness: 0.45 });
  const dark = new MeshStandardMaterial({ color: 0x2a3138, roughness: 0.6 });
  const glass = new MeshStandardMaterial({ color: 0x10161c, roughness: 0.12, metalness: 0.4 });
  const glow = new MeshStandardMaterial({ color: 0x0, emissive: 0x7fe8dc, emissiveIntensity: 1.6 });
  const accent = new MeshStandardMaterial({ color: 0xe0653a, roughness: 0.55 });

  const object = new Group();
  object.name = 'Avatar';
  const upper = new Group();
  object.add(upper);

  // A pear on its way to an egg: hips wider than shoulders.
  const torso = [
    [0.0, 0.42],
    [0.15, 0.425],
    [0.245, 0.475],
    [0.285, 0.58],
    [0.275, 0.74],
    [0.235, 0.92],
    [0.185, 1.05],
    [0.1, 1.12],
    [0.0, 1.13],
  ].map(([x, y]) => new Vector2(x, y));
  upper.add(part(new LatheGeometry(smooth(torso), 40), shell));
  const belt = part(new TorusGeometry(0.279, 0.024, 12, 48), dark, 0, 0.64, 0);
  belt.rotation.x = Math.PI / 2;
  upper.add(belt, part(new RoundedBoxGeometry(0.1, 0.07, 0.04, 4, 0.015), accent, 0, 0.64, 0.29));

  // A scarf hides where head and torso meet.
  const scarf = part(new TorusGeometry(0.15, 0.055, 16, 40), accent, 0, 1.1, 0);
  scarf.rotation.x = Math.PI / 2 + 0.08;
  upper.add(scarf);

  const head = new Group();
  head.position.y = 1.41;
  const skull = part(new SphereGeometry(0.3, 40, 28), shell);
  skull.scale.set(1.04, 0.96, 0.98);
  // A piece of a slightly larger sphere, turned to look along +Z.
  const visor = part(
    new SphereGeometry(
      0.305,
      40,
      20,
      Math.PI * 0.22,
      Math.PI * 0.56,
      Math.PI * 0.36,
      Math.PI * 0.26,
    ),
    glass,
  );
  visor.scale.copy(skull.scale).multiplyScalar(1.012);
  head.add(skull, visor);
  for (const side of [-1, 1]) {
    const eye = part(new CapsuleGeometry(0.021, 0.045, 6, 12), glow, side * 0.088, 0.005, 0.3);
    eye.rotation.y = side * 0.28;
    eye.scale.z = 0.5;
    const ear = part(new CylinderGeometry(0.085, 0.095, 0.06, 28), accent, side * 0.315, -0.01, 0);
    ear.rotation.z = Math.PI / 2;
    const rim = part(new CylinderGeometry(0.05, 0.05, 0.075, 24), dark, side * 0.315, -0.01, 0);
    rim.rotation.z = Math.PI / 2;
    head.add(eye, ear, rim);
  }
  head.add(part(new CylinderGeometry(0.009, 0.012, 0.14, 10), dark, 0, 0.34, -0.06));
  head.add(part(new SphereGeometry(0.03, 16, 12), accent, 0, 0.42, -0.06));
  upper.add(head);

  upper.add(
    part(new RoundedBoxGeometry(0.34, 0.42, 0.18, 5, 0.07), accent, 0, 0.83, -0.29),
    part(new RoundedBoxGeometry(0.26, 0.15, 0.08, 4, 0.035), dark, 0, 0.74, -0.38),
  );
  const roll = part(new CapsuleGeometry(0.062, 0.27, 8, 20), dark, 0, 1.075, -0.28);
  roll.rotation.z = Math.PI / 2;
  upper.add(roll);

  const arms = [-1, 1].map((side) => {
    const arm = new Group();
    arm.position.set(side * 0.245, 0.97, 0);
    arm.rotation.z = side * 0.3;
    arm.add(
      part(new CapsuleGeometry(0.06, 0.26, 8, 18), shell, 0, -0.16, 0),
      part(new SphereGeometry(0.082, 22, 16), dark, 0, -0.37, 0.01),
    );
    upper.add(arm);
    return arm;
  });
  const legs = [-1, 1].map((side) => {
    const leg = new Group();
    leg.position.set(side * 0.125, 0.5, 0);
    const shoe = part(new SphereGeometry(0.115, 26, 18), accent, 0, -0.42, 0.045);
    shoe.scale.set(0.92, 0.66, 1.42);
    const sole = part(new CapsuleGeometry(0.1, 0.09, 8, 20), dark, 0, -0.475, 0.045);
    sole.rotation.x = Math.PI / 2;
    sole.scale.set(1, 1, 0.24);
    leg.add(part(new CapsuleGeometry(0.078, 0.26, 8, 18), dark, 0, -0.2, 0), shoe, sole);
    object.add(leg);
    return leg;
  });

  let phase = 0;
  let swing = 0;
  let air = 0;
  let crouch = 0;
  let time = 0;
  return {
    object,
    animate(delta, speed, grounded, crouched) {
      const soft = 1 - Math.exp(-10 * delta);
      time += delta;
      phase += ((speed * delta) / STRIDE) * 2 * Math.PI;
      swing += ((grounded ? Math.min(speed / 4, 1) : 0) - swing) * soft;
      air += ((grounded ? 0 : 1) - air) * soft;
      crouch += ((crouched ? 1 : 0) - crouch) * soft;
      [-1, 1].forEach((side, i) => {
        const turn = Math.sin(phase) * side;
        // In the air one knee comes forward, the arms lift.
        legs[i]!.rotation.x = 0.75 * swing * turn + 0.4 * air * side;
        arms[i]!.rotation.x = -0.65 * swing * turn - 0.3 * air;
        arms[i]!.rotation.z = side * (0.3 + 0.12 * swing + 0.55 * air);
      });
      // Crouched it sits on its heels, leans forward and draws in its head.
      for (const leg of legs) {
        leg.position.y = 0.5 - 0.24 * crouch;
        leg.scale.y = 1 - 0.48 * crouch;
      }
      upper.position.y =
        0.025 * swing * Math.abs(Math.cos(phase)) + 0.006 * Math.sin(2 * time) - 0.3 * crouch;
      upper.position.z = -0.12 * crouch;
      upper.scale.y = 1 - 0.14 * crouch;
      head.position.y = 1.41 - 0.2 * crouch;
      upper.rotation.x = 0.09 * swing + 0.12 * crouch;
      upper.rotation.y = 0.07 * swing * Math.sin(phase);
      head.rotation.x = -0.07 * swing - 0.1 * crouch;
    },
  };
}

function part(
  geometry: Mesh['geometry'],
  material: Material,
  x = 0,
  y = 0,
  z = 0,
): Mesh & Object3D {
  const mesh = new Mesh(geometry, material);
  mesh.position.set(x, y, z);
  mesh.castShadow = mesh.receiveShadow = true;
  return mesh;
}

/** A finer profile through the same points, so that the lathe shades round. */
function smooth(points: Vector2[]): Vector2[] {
  const fine: Vector2[] = [];
  const at = (i: number) => points[Math.min(points.length - 1, Math.max(0, i))]!;
  for (let i = 0; i < points.length - 1; i++) {
    for (let k = 0; k < 5; k++) {
      const t = k / 5;
      const spline = (a: number, b: number, c: number, d: number) =>
        0.5 *
        (2 * b +
          (c - a) * t +
          (2 * a - 5 * b + 4 * c - d) * t ** 2 +
          (3 * (b - c) + d - a) * t ** 3);
      const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
      fine.push(new Vector2(Math.max(0, spline(a.x, b.x, c.x, d.x)), spline(a.y, b.y, c.y, d.y)));
    }
  }
  return [...fine, points[points.length - 1]!];
}
