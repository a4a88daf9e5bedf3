// @ts-check
// The suites that run in a web page, for `npm run bench` and the demo's /bench; each is the module of its name here.

/** @typedef {{ name: string, title: string, about: string, plot?: string, seen?: number }} PageSuite */

/** @type {PageSuite[]} */
export const PAGE_SUITES = [
  {
    name: 'load',
    title: 'Loading a level',
    seen: 8,
    about: `From “the scene is loaded” to the first resolved step, on hills of 10k to 5M triangles: how long the page is blocked,
and how much the heap grows. Ours compiles its programs, draws a cubemap and reads it; the others build their trees. Who would
take over a minute is measured on less, extrapolated, and marked.`,
  },
  {
    name: 'step',
    title: 'A step of a character',
    about: `Main-thread time of a character's step, on the same hills and on real levels, averaged over the frames of a walk. Ours is
split where it can be: selecting what is near, submitting the draw, reading back, decoding, solving.`,
  },
  {
    name: 'gpu',
    title: 'A probe on the GPU',
    about: `Drawing one cubemap and reading it synchronously, beside three's plain \`CubeCamera\` whose six faces are read one by one:
the same resolution, the same scene. On a software GPU it is time of the processor, all of it; a timer query tells more where
the GPU has one.`,
  },
  {
    name: 'moving',
    title: 'Scenery that moves',
    about: `Main-thread time a frame where everything moves: a crowd of skinned figures, a terrain of morph targets, a thousand rigid
objects. Ours draws what the GPU has deformed anyway; three-mesh-bvh refits a \`SkinnedMeshBVH\` after every pose, or moves its
queries into each object's own space; Octree and Rapier have to be built anew where vertices move.`,
  },
  {
    name: 'crowd',
    title: 'Many characters',
    about: `Main-thread time a frame for 1, 10 and 100 characters that walk on their own in one level.`,
  },
  {
    name: 'feel',
    title: 'How it walks',
    seen: 3,
    about: `Stairs, a ramp, a slide along a wall, a kerb: how far it gets in a given time against the ideal, how it jerks on the way,
and how it wobbles when it stands.`,
  },
];
