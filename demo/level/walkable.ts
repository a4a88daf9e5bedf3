import type { ColumnMap } from './ColumnMap.js';

/** A standing place in a column. */
export interface Place {
  column: number;
  row: number;
  /** Height of the ground, metres. */
  y: number;
  /** The vertical part of the ground's normal. */
  level: number;
  /** Nothing is above. */
  sky: boolean;
  /** Square metres that can be walked to from here. */
  region: number;
  /** How many of the eight columns around can be walked to at once, 0 to 1. */
  around: number;
}

/** Room for a standing body of 1.8 m and a hand's breadth, metres. */
const HEAD_ROOM = 1.95;
/** The steepest ground to begin on: 40°. */
const LEVEL = Math.cos((40 * Math.PI) / 180);
/** What is climbed from column to column: a step, or a slope's rise. */
const STEP = 0.35;

const SIDES = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
  [1, 1],
  [-1, 1],
  [-1, -1],
  [1, -1],
] as const;

/** Every place in which one could stand, with how much ground is around it. */
export function findPlaces(map: ColumnMap): Place[] {
  const byColumn: Place[][] = [];
  for (let row = 0; row < map.rows; row++)
    for (let column = 0; column < map.columns; column++) byColumn.push(placesIn(map, column, row));
  const climb = Math.max(STEP, map.cell * Math.tan(Math.acos(LEVEL)));
  const neighbours = (place: Place): Place[] =>
    SIDES.flatMap(([dx, dz]) => {
      const [column, row] = [place.column + dx, place.row + dz];
      if (column < 0 || column >= map.columns || row < 0 || row >= map.rows) return [];
      const near = byColumn[row * map.columns + column]!;
      return near.find(({ y }) => Math.abs(y - place.y) <= climb) ?? [];
    });
  const places = byColumn.flat();
  measureRegions(places, neighbours, map.cell * map.cell);
  return places;
}

function placesIn(map: ColumnMap, column: number, row: number): Place[] {
  const surfaces = map.at(column, row);
  return surfaces.flatMap(({ y, level }, i) => {
    const above = surfaces[i + 1];
    if (level < LEVEL || (above !== undefined && above.y - y < HEAD_ROOM)) return [];
    return [{ column, row, y, level, sky: above === undefined, region: 0, around: 0 }];
  });
}

/** Floods from place to place. */
function measureRegions(places: Place[], neighbours: (of: Place) => Place[], area: number): void {
  const seen = new Set<Place>();
  for (const first of places) {
    if (seen.has(first)) continue;
    const region = [first];
    seen.add(first);
    for (const place of region) {
      const near = neighbours(place);
      place.around = near.length / SIDES.length;
      for (const next of near) {
        if (seen.has(next)) continue;
        seen.add(next);
        region.push(next);
      }
    }
    for (const place of region) place.region = region.length * area;
  }
}
