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
all together and at a stretch, and how much the heap grows. Ours compiles its programs, finds out bit by bit where a large mesh
has its triangles, draws a cubemap and reads it; the others build their trees at once. Who would take over a minute is measured
on less, extrapolated, and marked.

Half of what ours blocks at 1M triangles are those slices, of 1.5 ms each, which a page does not feel; what is felt is the
longest stretch.`,
  },
  {
    name: 'step',
    title: 'A step of a character',
    about: `Main-thread time of a character's step, on the same hills and on real levels, averaged over the frames of a walk. Ours is
split where it can be: selecting what is near, submitting the draw, reading back, decoding, solving.

The parts below tell why ours is several times Rapier's: about every seventh step brings a new field to copy, decode and solve
anew, which is what p95 tells and what makes the mean twice the median; and in a page that is idle for most of each 16 ms a step
begins with cold caches. In Node, one step after the other, a step takes 0.05 to 0.3 ms in the mean; where its
caches are emptied in between, 0.15 to 0.45 (\`npm run bench:step\`, with \`-- --cold\`). By function:
[Where a step goes](#where-a-step-goes).`,
  },
  {
    name: 'gpu',
    title: 'A probe on the GPU',
    about: `Drawing one cubemap and reading it synchronously, beside three's plain \`CubeCamera\` whose six faces are read one by one:
the same resolution, the same scene. Ours draws each face four times finer along each edge, 16 texels for one, unless the row
says _supersample 1_, which is what the other does. On a software GPU it is time of the processor, all of it; a timer query
tells more where the GPU has one.

What is drawn is what the sphere, the box and, of meshes of 512 triangles and more, the triangles reach into each face; where
a level is in many small meshes, as level.glb is, their draw calls are what is left.`,
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
    about: `Main-thread time a frame for 1, 10 and 100 characters that walk on their own in one level. Ours are in a
\`CubeColliderGroup\`: five cubemaps a render, one read. What is left is each one's own step: a field to decode about every
seventh frame, and the walk among its surfels: most of it, spread over a dozen small functions
([Where a step goes](#where-a-step-goes)), so that no one of them stands in the way; only fewer or smaller fields help. At \`resolution: 16\` a field has a
quarter of the texels, and a character costs about half; for walkers whom nobody steers that is enough.`,
  },
  {
    name: 'feel',
    title: 'How it walks',
    seen: 3,
    about: `Stairs, a ramp, a slide along a wall, a kerb: how far it gets in a given time against the ideal, how it jerks on the way,
and how it wobbles when it stands.`,
  },
];
