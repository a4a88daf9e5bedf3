import { type BufferGeometry, type Mesh, Ray, Sphere, Vector3 } from 'three';
import type { SurfaceField } from 'three-cube-collider';

/** A place on a triangle that a ray meets. */
export interface Hit {
  readonly surface: Surface;
  /** From the centre, metres. */
  distance: number;
  /** World space. */
  readonly point: Vector3;
  /** Interpolated from the triangle's corners. */
  attribute(name: string): number[];
}

/** What a mesh should look like, told to the oracle apart from how it is drawn. */
export interface Surface {
  readonly mesh: Mesh;
  /** Its triangles. Default the mesh's own. */
  readonly geometry?: BufferGeometry;
  /** Where vertex `index` of the geometry is put, object space. */
  place?: (position: Vector3, index: number) => void;
  /** Is anything there? */
  there?: (hit: Hit) => boolean;
  /** Where the drawn point lies along the ray, for shaders that write depth; null for nothing. World space. */
  depth?: (origin: Vector3, direction: Vector3) => number | null;
  /** Which instance of the mesh it is. Default 0. */
  readonly instance?: number;
  /** The room around, whose texels do not count as the kind's. */
  readonly room?: boolean;
}

export interface Verdict {
  /** Texels that should see the kind's meshes. */
  texels: number;
  /** Largest error among all texels but the silhouettes, metres. */
  worst: number;
  /** Texels off by more than a centimetre that are no silhouettes. */
  wrong: number;
  /** Texels that name another mesh or instance than is there, and are at no outline. */
  strangers: number;
  /** Texels off by more than a centimetre, or misnamed, within half a drawn texel of an outline. */
  silhouettes: number;
}

interface Triangles {
  readonly surface: Surface;
  readonly geometry: BufferGeometry;
  readonly corners: number[];
  /** Nine numbers a triangle, world space. */
  readonly points: Float64Array;
  /** Around all of them. */
  readonly sphere: Sphere;
}

const LIMIT = 0.01;
const ray = new Ray();

/**
 * Holds every texel of a field against rays cast here, in doubles, on triangles transformed here: the distance to the
 * first place where something should be.
 *
 * A texel that is off by more than a centimetre counts as a silhouette only if, of eight rays within half a drawn texel
 * around it, one meets another surface, another mesh, nothing, or a place more than 2 cm off the plane met in the middle.
 */
export function judge(
  field: SurfaceField,
  near: number,
  supersample: number,
  surfaces: readonly Surface[],
): Verdict {
  const all = surfaces.map(trianglesOf);
  const verdict: Verdict = { texels: 0, worst: 0, wrong: 0, strangers: 0, silhouettes: 0 };
  const direction = new Vector3();
  for (let texel = 0; texel < field.count; texel++) {
    direction.fromArray(field.direction, 3 * texel).normalize();
    const hit = first(all, field.center, direction, near);
    const expected = hit !== null && hit.distance <= field.far ? hit.distance : Infinity;
    const seen = field.distance[texel]!;
    const counts = hit !== null && hit.surface.room !== true;
    if (counts) verdict.texels++;
    const error = seen === expected ? 0 : Math.abs(seen - expected);
    const right = error <= LIMIT;
    if (right) verdict.worst = Math.max(verdict.worst, error);
    const named = expected === Infinity || !right || isNamed(field, texel, hit!.surface);
    if (right && named) continue;
    if (atOutline(all, field.center, direction, near, hit, 1 / (field.resolution * supersample))) {
      verdict.silhouettes++;
    } else if (right) {
      verdict.strangers++;
    } else {
      verdict.wrong++;
      verdict.worst = Math.max(verdict.worst, Math.min(error, 1e3));
    }
  }
  return verdict;
}

function isNamed(field: SurfaceField, texel: number, { mesh, instance = 0 }: Surface): boolean {
  const number = field.object[texel]!;
  return field.objects[number - 1] === mesh && field.instance[texel] === instance;
}

function trianglesOf(surface: Surface): Triangles {
  const { mesh } = surface;
  const { geometry = mesh.geometry } = surface;
  const { position } = geometry.attributes;
  const index = geometry.index;
  const count = index === null ? position!.count : index.count;
  const corners = Array.from({ length: count }, (_, i) => (index === null ? i : index.getX(i)));
  const points = new Float64Array(3 * count);
  const point = new Vector3();
  mesh.updateWorldMatrix(true, false);
  const m = mesh.matrixWorld.elements;
  corners.forEach((corner, i) => {
    point.fromBufferAttribute(position!, corner);
    surface.place?.(point, corner);
    for (let row = 0; row < 3; row++) {
      points[3 * i + row] =
        m[row]! * point.x + m[4 + row]! * point.y + m[8 + row]! * point.z + m[12 + row]!;
    }
  });
  const sphere = new Sphere();
  sphere.setFromPoints(corners.map((_, i) => new Vector3().fromArray(points, 3 * i)));
  sphere.radius += 1e-6;
  return { surface, geometry, corners, points, sphere };
}

interface Met extends Hit {
  /** Unit normal of what was met, towards the centre. */
  readonly normal: Vector3;
}

function first(
  all: readonly Triangles[],
  center: Vector3,
  direction: Vector3,
  near: number,
): Met | null {
  let best: Met | null = null;
  for (const triangles of all) {
    const { surface } = triangles;
    if (surface.depth !== undefined) {
      const distance = surface.depth(center, direction);
      if (distance !== null && distance > near && !(best && best.distance <= distance)) {
        const point = center.clone().addScaledVector(direction, distance);
        const normal = direction.clone().negate();
        best = { surface, distance, point, normal, attribute: () => [] };
      }
      continue;
    }
    ray.set(center, direction);
    if (!ray.intersectsSphere(triangles.sphere)) continue;
    for (let i = 0; i < triangles.points.length; i += 9) {
      const met = meet(triangles, i, center, direction);
      if (met === null || met.distance <= near || (best && best.distance <= met.distance)) continue;
      if (surface.there?.(met) === false) continue;
      best = met;
    }
  }
  return best;
}

/** Möller and Trumbore, from both sides. */
function meet(
  { surface, geometry, corners, points: p }: Triangles,
  i: number,
  o: Vector3,
  d: Vector3,
): Met | null {
  const e1x = p[i + 3]! - p[i]!;
  const e1y = p[i + 4]! - p[i + 1]!;
  const e1z = p[i + 5]! - p[i + 2]!;
  const e2x = p[i + 6]! - p[i]!;
  const e2y = p[i + 7]! - p[i + 1]!;
  const e2z = p[i + 8]! - p[i + 2]!;
  const hx = d.y * e2z - d.z * e2y;
  const hy = d.z * e2x - d.x * e2z;
  const hz = d.x * e2y - d.y * e2x;
  const det = e1x * hx + e1y * hy + e1z * hz;
  if (det === 0) return null;
  const sx = o.x - p[i]!;
  const sy = o.y - p[i + 1]!;
  const sz = o.z - p[i + 2]!;
  const u = (sx * hx + sy * hy + sz * hz) / det;
  if (u < 0 || u > 1) return null;
  const qx = sy * e1z - sz * e1y;
  const qy = sz * e1x - sx * e1z;
  const qz = sx * e1y - sy * e1x;
  const v = (d.x * qx + d.y * qy + d.z * qz) / det;
  if (v < 0 || u + v > 1) return null;
  const distance = (e2x * qx + e2y * qy + e2z * qz) / det;
  if (distance <= 0) return null;
  const normal = new Vector3(e1x, e1y, e1z).cross(new Vector3(e2x, e2y, e2z)).normalize();
  if (normal.dot(d) > 0) normal.negate();
  return {
    surface,
    distance,
    point: o.clone().addScaledVector(d, distance),
    normal,
    attribute: (name) => {
      const attribute = geometry.attributes[name]!;
      const [a, b, c] = [0, 1, 2].map((k) => corners[i / 3 + k]!) as [number, number, number];
      return Array.from(
        { length: attribute.itemSize },
        (_, k) =>
          (1 - u - v) * attribute.getComponent(a, k) +
          u * attribute.getComponent(b, k) +
          v * attribute.getComponent(c, k),
      );
    },
  };
}

function atOutline(
  all: readonly Triangles[],
  center: Vector3,
  direction: Vector3,
  near: number,
  middle: Met | null,
  spread: number,
): boolean {
  const side = new Vector3(direction.y, direction.z, direction.x).cross(direction).normalize();
  const other = new Vector3().crossVectors(direction, side);
  for (let i = 0; i < 8; i++) {
    const angle = (i * Math.PI) / 4;
    const around = direction
      .clone()
      .addScaledVector(side, spread * Math.cos(angle))
      .addScaledVector(other, spread * Math.sin(angle))
      .normalize();
    const met = first(all, center, around, near);
    if ((met === null) !== (middle === null)) return true;
    if (met === null || middle === null) continue;
    if (met.surface !== middle.surface) return true;
    if (Math.abs(met.point.clone().sub(middle.point).dot(middle.normal)) > 0.02) return true;
  }
  return false;
}
