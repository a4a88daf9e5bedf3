// Wide things in four pieces: what lies all around would otherwise be near everything, to a camera's culling and to a
// collider's.

/** Shapes that spread over the whole level. */
const WIDE = new Set(['ground', 'outer-walls', 'trees', 'benches', 'signs', 'surroundings']);
const QUARTERS = ['north-west', 'north-east', 'south-west', 'south-east'];

/**
 * The pieces of a shape: itself, or its triangles by the quarter that their middles lie in. No vertex moves, so no crack
 * opens.
 *
 * @returns pairs of a name and its parts by material
 */
export function quarters({ name, parts }) {
  if (!WIDE.has(name)) return [[name, parts]];
  const pieces = QUARTERS.map(() => new Map());
  for (const [material, part] of parts) {
    const { indices, positions } = part;
    const lists = QUARTERS.map(() => []);
    for (let i = 0; i < indices.length; i += 3) {
      const corners = [indices[i], indices[i + 1], indices[i + 2]];
      const middle = (axis) => corners.reduce((sum, at) => sum + positions[3 * at + axis], 0);
      lists[(middle(0) < 0 ? 0 : 1) + (middle(2) < 0 ? 0 : 2)].push(...corners);
    }
    lists.forEach((list, i) => {
      if (list.length > 0) pieces[i].set(material, { ...part, indices: list });
    });
  }
  return pieces
    .map((piece, i) => [`${name}-${QUARTERS[i]}`, piece])
    .filter(([, { size }]) => size > 0);
}
