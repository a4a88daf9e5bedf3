/** Part of all texels that may disagree since they lie on an outline (`isOutline` in the harness says what that is). */
export const OUTLINES = 0.003;

/** Kinds of objects, by what they are called in docs/solid.md. */
export const KINDS = [
  'Mesh, 16-bit indices',
  'Mesh, 32-bit indices',
  'Mesh, not indexed',
  'Mesh, drawRange',
  'Mesh, several materials and groups',
  'Mesh, interleaved',
  'Mesh, normalized Int16',
  'Mesh, normalized Int8',
  'Mesh, KHR_mesh_quantization from a GLB',
  'Mesh, sheared by its parents',
  'SkinnedMesh, attached',
  'SkinnedMesh, detached',
  'SkinnedMesh with morph targets',
  'Morph targets, relative',
  'Morph targets, absolute',
  'InstancedMesh',
  'InstancedMesh with morph targets',
  'BatchedMesh, never rendered',
  'BatchedMesh, the user’s camera elsewhere',
  'LOD, never rendered',
  'LOD, rendered',
];
