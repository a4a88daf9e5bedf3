/** Contacts of one look, in plain arrays: it is filled several times a step. Body's frame, metres. */
export class ContactSet {
  static readonly CAPACITY = 48;
  count = 0;
  /** Where the surface is touched or nearest: x, y, z each. */
  readonly point = new Float64Array(3 * ContactSet.CAPACITY);
  /** Unit vector from there to the body: x, y, z each. */
  readonly normal = new Float64Array(3 * ContactSet.CAPACITY);
  /** Between surface and body; negative if they overlap. */
  readonly gap = new Float64Array(ContactSet.CAPACITY);
  /** Steepest-up of the surface's own normals there, its Y: an edge is met from many sides, but belongs to a face. */
  readonly surfaceUp = new Float64Array(ContactSet.CAPACITY);
  /** Which kept field it was found in, and which of its surfels it is. */
  readonly kept = new Int32Array(ContactSet.CAPACITY);
  readonly surfel = new Int32Array(ContactSet.CAPACITY);

  /** Adds contact `i` of another set. There must be room. */
  take(other: ContactSet, i: number): void {
    const c = this.count++;
    for (let v = 0; v < 3; v++) {
      this.point[3 * c + v] = other.point[3 * i + v]!;
      this.normal[3 * c + v] = other.normal[3 * i + v]!;
    }
    this.gap[c] = other.gap[i]!;
    this.surfaceUp[c] = other.surfaceUp[i]!;
    this.kept[c] = other.kept[i]!;
    this.surfel[c] = other.surfel[i]!;
  }
}
