import type { Vector3 } from 'three';
import type { ContactSet } from '../field/ContactSet.js';
import { type SlideLimits, type SlideResponse, TOUCH } from '../response/SlideResponse.js';

/** What is this much nearer than the skin is run into, metres. */
const INTO = 0.001;
/** Rounds in which contacts take their parts out of a velocity. */
const ROUNDS = 3;

/**
 * Turns a flyer's level speed toward the one wanted, by `most` at most, but not up what it could not walk up, nor against
 * what it slides down.
 *
 * @param velocity m/s, body's frame, changed in place
 * @param wantedX @param wantedZ m/s
 * @param contacts around it
 */
export function steer(
  velocity: Vector3,
  wantedX: number,
  wantedZ: number,
  contacts: ContactSet,
  skin: number,
  most: number,
): void {
  let dx = wantedX - velocity.x;
  let dz = wantedZ - velocity.z;
  for (let i = 0; i < contacts.count; i++) {
    if (contacts.gap[i]! > skin + TOUCH) continue;
    const nx = contacts.normal[3 * i]!;
    const nz = contacts.normal[3 * i + 2]!;
    const level = nx * nx + nz * nz;
    const into = dx * nx + dz * nz;
    const steep = contacts.normal[3 * i + 1]! > 0.01;
    if (level < 1e-4 || (into >= 0 && !steep)) continue;
    dx -= (into / level) * nx;
    dz -= (into / level) * nz;
  }
  const change = Math.sqrt(dx * dx + dz * dz);
  const part = change > most ? most / change : 1;
  velocity.x += part * dx;
  velocity.z += part * dz;
}

/**
 * Takes out of a flyer's velocity what leads into what it touches.
 *
 * @param velocity m/s, body's frame, changed in place
 * @returns whether it came down on something that carries
 */
export function clip(velocity: Vector3, response: SlideResponse, limits: SlideLimits): boolean {
  const { contacts } = response;
  let lands = false;
  for (let round = 0; round < ROUNDS; round++) {
    for (let i = 0; i < contacts.count; i++) {
      if (contacts.gap[i]! > limits.skin + INTO) continue;
      const nx = contacts.normal[3 * i]!;
      const ny = contacts.normal[3 * i + 1]!;
      const nz = contacts.normal[3 * i + 2]!;
      const into = velocity.x * nx + velocity.y * ny + velocity.z * nz;
      if (into >= 0) continue;
      if (response.carries(contacts, i, limits)) lands = true;
      velocity.x -= into * nx;
      velocity.y -= into * ny;
      velocity.z -= into * nz;
    }
  }
  return lands;
}
