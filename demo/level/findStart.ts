import { Box3, Ray, Triangle, Vector3 } from 'three';
import { ColumnMap } from './ColumnMap.js';
import { boundsOf } from './orientation.js';
import { STRIDE } from './triangles.js';
import { findPlaces, type Place } from './walkable.js';

/** Where a walk begins. */
export interface Start {
  /** The foot, world, metres. */
  position: Vector3;
  /** The turn about +Y from looking along -Z, radians. */
  yaw: number;
}

/** A standing body and the air around it, metres: half its width, from its shin to its crown. */
const BODY = { half: 0.4, from: 0.45, to: 1.85 };
/** The foot begins this far above the ground: it falls the rest. */
const ABOVE = 0.03;
/** How far a candidate looks around, metres, at which height, into how many directions. */
const VIEW = 12;
const EYE = 1.3;
const DIRECTIONS = 16;
/** Places that are looked at closely. */
const CANDIDATES = 24;
/** Less ground than this, around or to walk to, is no place to begin: square metres. */
const LEAST_REGION = 3;

/**
 * A free place to stand on: level ground to walk on, with room for the head, near the middle rather than at the rim, low
 * rather than on a roof, under the sky rather than in a cellar, looking where there is most room.
 *
 * @param soup triangles, metres, Y up
 * @returns null where nobody could stand
 */
export function findStart(soup: Float32Array): Start | null {
  const bounds = boundsOf(soup);
  if (bounds.isEmpty()) return null;
  const map = new ColumnMap(soup, bounds);
  const worth = worthIn(map, bounds);
  const places = findPlaces(map)
    .filter(({ region }) => region >= LEAST_REGION)
    .map((place) => ({ place, worth: worth(place) }))
    .sort((a, b) => b.worth - a.worth);

  let best: (Start & { worth: number }) | null = null;
  for (const { place, worth: first } of apart(places, map)) {
    const foot = new Vector3(map.x(place.column), place.y, map.z(place.row));
    const near = trianglesNear(soup, foot);
    if (!isFree(near, foot)) continue;
    const { yaw, room } = lookAround(near, foot, bounds);
    const all = first + 2 * room;
    if (best !== null && all <= best.worth) continue;
    best = { position: foot.setY(foot.y + ABOVE), yaw, worth: all };
  }
  return best && { position: best.position, yaw: best.yaw };
}

/** The ground below a point, or just above it; null where there is none. Metres. */
export function groundBelow(soup: Float32Array, point: Vector3): number | null {
  const ray = new Ray(point.clone(), new Vector3(0, -1, 0));
  ray.origin.y += BODY.from;
  let highest: number | null = null;
  const hit = new Vector3();
  for (const [a, b, c] of near(soup, new Box3(point.clone(), point.clone()).expandByVector(DOWN))) {
    if (ray.intersectTriangle(a, b, c, false, hit) && !(hit.y <= (highest ?? -Infinity)))
      highest = hit.y;
  }
  return highest;
}

const DOWN = new Vector3(0.01, 1e6, 0.01);

function worthIn(map: ColumnMap, bounds: Box3): (place: Place) => number {
  const middle = bounds.getCenter(new Vector3());
  const size = bounds.getSize(new Vector3());
  const half = Math.max(size.x, size.z) / 2 || 1;
  const height = Math.max(size.y, 4);
  return ({ column, row, y, level, sky, region, around }) => {
    const away = Math.hypot(map.x(column) - middle.x, map.z(row) - middle.z) / half;
    const high = (y - bounds.min.y) / height;
    return (
      Math.log2(1 + Math.min(region, 1000)) +
      (sky ? 1 : 0) +
      2 * around +
      (level > 0.96 ? 1 : 0) -
      2 * away -
      2 * high
    );
  };
}

/** The first of them that keep apart, so that not all look at the same corner. */
function* apart(sorted: { place: Place; worth: number }[], map: ColumnMap) {
  const distance = Math.max(1, Math.max(map.columns, map.rows) / 24);
  const taken: Place[] = [];
  for (const each of sorted) {
    const { column, row, y } = each.place;
    const close = ({ place }: { place: Place }) =>
      Math.hypot(place.column - column, place.row - row) < distance && Math.abs(place.y - y) < 2;
    if (taken.some((place) => close({ place }))) continue;
    taken.push(each.place);
    yield each;
    if (taken.length >= CANDIDATES) return;
  }
}

type Corners = [Vector3, Vector3, Vector3];

function* near(soup: Float32Array, box: Box3): Generator<Corners> {
  const { min, max } = box;
  for (let i = 0; i + STRIDE <= soup.length; i += STRIDE) {
    if (outside(soup[i]!, soup[i + 3]!, soup[i + 6]!, min.x, max.x)) continue;
    if (outside(soup[i + 2]!, soup[i + 5]!, soup[i + 8]!, min.z, max.z)) continue;
    if (outside(soup[i + 1]!, soup[i + 4]!, soup[i + 7]!, min.y, max.y)) continue;
    yield [0, 3, 6].map((k) => new Vector3().fromArray(soup, i + k)) as Corners;
  }
}

const outside = (a: number, b: number, c: number, min: number, max: number) =>
  (a < min && b < min && c < min) || (a > max && b > max && c > max);

/** What a candidate may see. */
function trianglesNear(soup: Float32Array, foot: Vector3): Triangle[] {
  const box = new Box3(foot.clone(), foot.clone()).expandByScalar(VIEW);
  return Array.from(near(soup, box), (corners) => new Triangle(...corners));
}

function isFree(triangles: Triangle[], { x, y, z }: Vector3): boolean {
  const body = new Box3(
    new Vector3(x - BODY.half, y + BODY.from, z - BODY.half),
    new Vector3(x + BODY.half, y + BODY.to, z + BODY.half),
  );
  return !triangles.some((triangle) => body.intersectsTriangle(triangle));
}

/** The direction with most room to walk to, and how much that is, 0 to 1; toward the middle where several have it. */
function lookAround(triangles: Triangle[], foot: Vector3, bounds: Box3) {
  const eye = foot.clone().setY(foot.y + EYE);
  const toMiddle = bounds.getCenter(new Vector3()).sub(eye).setY(0);
  toMiddle.multiplyScalar(1 / Math.max(VIEW, toMiddle.length()));
  const ray = new Ray(eye);
  const hit = new Vector3();
  let [yaw, most, total] = [0, -Infinity, 0];
  for (let i = 0; i < DIRECTIONS; i++) {
    const turn = (2 * Math.PI * i) / DIRECTIONS;
    ray.direction.set(-Math.sin(turn), 0, -Math.cos(turn));
    let way = VIEW;
    for (const { a, b, c } of triangles) {
      if (ray.intersectTriangle(a, b, c, false, hit)) way = Math.min(way, hit.distanceTo(eye));
    }
    total += way;
    const liked = way + 3 * ray.direction.dot(toMiddle);
    if (liked > most) [yaw, most] = [turn, liked];
  }
  return { yaw, room: total / (DIRECTIONS * VIEW) };
}
