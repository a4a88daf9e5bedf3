import { Vector3 } from 'three';
import type { SurfaceField } from 'three-cube-collider';
import { type Backend, createRendering } from '../support/rendering.js';
import { boxesAround } from './boxes.js';

export interface Agreement {
  /** Texels that see the same triangle's plane in both fields, of those that see anything. */
  same: number;
  seen: number;
  /** Largest differences among them: of distance, metres, and of the unit normals. */
  distance: number;
  normal: number;
  /** Of them, those that name another object, instance or side. */
  strangers: number;
}

/** Normals of one plane differ by less than this; those of two in the scene by more. */
const ONE_PLANE = 0.01;

/** Fields of one scene from each backend, against that of the first. */
export default async function agreement(backends: Backend[]): Promise<Agreement[]> {
  const center = new Vector3(10, 2, 3);
  const fields: SurfaceField[] = [];
  const { scene } = boxesAround(center);
  for (const backend of backends) {
    const { renderer, collider: create } = await createRendering(backend);
    const collider = create({ far: 6 });
    collider.position.copy(center);
    fields.push((await collider.updateAsync(renderer, scene))!);
    collider.dispose();
    renderer.dispose();
  }
  const [first, ...others] = fields;
  return others.map((other) => compare(first!, other));
}

function compare(a: SurfaceField, b: SurfaceField): Agreement {
  const report: Agreement = { same: 0, seen: 0, distance: 0, normal: 0, strangers: 0 };
  for (let texel = 0; texel < a.count; texel++) {
    if (a.distance[texel] === Infinity && b.distance[texel] === Infinity) continue;
    report.seen++;
    let normal = 0;
    let aside = 0;
    for (let i = 3 * texel; i < 3 * texel + 3; i++) {
      normal = Math.max(normal, Math.abs(a.normal[i]! - b.normal[i]!));
      // Drawn finer, they may have kept different texels of a block.
      aside = Math.max(aside, Math.abs(a.direction[i]! - b.direction[i]!));
    }
    const distance = Math.abs(a.distance[texel]! - b.distance[texel]!);
    if (normal > ONE_PLANE || aside > 1e-6 || a.object[texel] !== b.object[texel]) continue;
    report.same++;
    report.normal = Math.max(report.normal, normal);
    report.distance = Math.max(report.distance, distance);
    if (a.front[texel] !== b.front[texel] || a.instance[texel] !== b.instance[texel]) {
      report.strangers++;
    }
  }
  return report;
}
