// @ts-check
import { openPage, quantile } from '../page.mjs';

/** Two digits that count. @param {number} value */
const show = (value) =>
  value < 0.1 ? value.toFixed(3) : value < 10 ? value.toFixed(2) : value.toFixed(0);

/** Median, and the part nineteen of twenty lie below. @param {number[]} times */
const spread = (times) =>
  `${show(quantile(times, 0.5) ?? NaN)} (${show(quantile(times, 0.95) ?? NaN)})`;

/** @param {string[]} head @param {unknown[][]} rows */
const table = (head, rows) =>
  [head, head.map((_, i) => (i === 0 ? '---' : '---:')), ...rows]
    .map((cells) => `| ${cells.join(' | ')} |`)
    .join('\n');

/** @type {Record<string, (run: (module: string, argument: unknown) => Promise<any>, seconds: number, results: any) => Promise<string>>} */
const PARTS = {
  async many(run, _, results) {
    results.many = [];
    for (const objects of [100, 10_000, 100_000]) {
      results.many.push(await run('/bench/size/many.ts', { objects, rounds: 400 }));
    }
    return table(
      [
        'meshes (of them within reach)',
        'first, ms',
        'survey, ms',
        'selection, ms',
        'a walk over all, ms',
        'survey, of a walk',
      ],
      results.many.map((/** @type {any} */ each) => [
        `${each.objects} (${each.near})`,
        show(each.first),
        spread(each.survey),
        spread(each.select),
        spread(each.walk),
        `1/${(quantile(each.walk, 0.5) / quantile(each.survey, 0.5)).toFixed(1)}`,
      ]),
    );
  },

  async huge(run, _, results) {
    results.huge = [];
    for (const [cells, shuffled, whole] of [
      [70, false, 0],
      [707, false, 3],
      [1581, false, 2],
      [1581, true, 0],
    ]) {
      const argument = { cells, shuffled, whole, rounds: 30 };
      results.huge.push(await run('/bench/size/huge.ts', argument));
    }
    const least = quantile(results.huge[0].draw, 0.5);
    return table(
      [
        'triangles',
        'drawn whole, ms',
        'times the first',
        'drawn near, ms',
        'times the first',
        'found in slices of 1.5 ms',
        'a slice, ms',
        'longest',
        'over 2 ms',
        'a busy loop, ms',
        'longest',
        'over 2 ms',
        'bytes a triangle',
      ],
      results.huge.map((/** @type {any} */ each) => [
        `${each.triangles}${each.shuffled ? ', shuffled' : ''}`,
        each.whole.length > 0 ? spread(each.whole) : '-',
        each.whole.length > 0 ? (quantile(each.whole, 0.5) / least).toFixed(0) : '-',
        spread(each.draw),
        (quantile(each.draw, 0.5) / least).toFixed(2),
        each.slices.length || '-',
        ...[each.slices, each.control].flatMap((times) =>
          times.length === 0
            ? ['-', '-', '-']
            : [
                spread(times),
                show(Math.max(...times)),
                times.filter((/** @type {number} */ t) => t > 2).length,
              ],
        ),
        each.bytes > 0 ? each.bytes.toFixed(2) : '-',
      ]),
    );
  },

  async stream(run, seconds, results) {
    results.stream = [];
    for (const tiles of [0, 1, 4]) {
      results.stream.push(await run('/bench/size/stream.ts', { tiles, seconds }));
    }
    return table(
      [
        'tiles added and dropped a frame',
        'frames',
        'our own work, ms',
        'p99',
        'longest',
        'over 4 ms',
        'a busy loop, ms',
        'p99',
        'longest',
        'over 4 ms',
        'not seen in their first frame',
        'geometries on the GPU',
      ],
      results.stream.map((/** @type {any} */ each) => [
        each.tiles,
        each.own.length,
        ...[each.own, each.control].flatMap((times) => [
          spread(times),
          show(quantile(times, 0.99) ?? NaN),
          show(Math.max(...times)),
          times.filter((/** @type {number} */ t) => t > 4).length,
        ]),
        `${each.missed} of ${each.asked}`,
        each.geometries.join(', '),
      ]),
    );
  },
};

/**
 * What many objects, huge meshes and tiles that come and go cost.
 *
 * @param {Record<string, string>} options
 */
export default async function size({ only, seconds }) {
  /** @type {Record<string, unknown>} */
  const results = {};
  const texts = [];
  let machine = '';
  for (const [name, part] of Object.entries(PARTS)) {
    if (!name.includes(only)) continue;
    const page = await openPage();
    machine = page.machine;
    texts.push(await part(page.run, Number(seconds), results));
    await page.close();
  }
  const text = [`${machine}. Medians, in brackets what 19 of 20 lie below.`, ...texts].join('\n\n');
  return { text, results };
}
