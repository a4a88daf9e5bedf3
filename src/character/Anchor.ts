import {
  type BatchedMesh,
  type InstancedMesh,
  Matrix4,
  type Mesh,
  type Object3D,
  type SkinnedMesh,
  Vector3,
} from 'three';

/** A body farther than this from the triangle that it rides by looks for another, metres. */
const LONGEST = 0.25;
/** Vertices looked at in search of one; of more, only every so many-th. */
const MOST_LOOKED_AT = 600;
/** Sides of the triangle are at least this long, metres, and as far from parallel as this sine. */
const SHORTEST = 0.01;
const LEAST_SINE = 0.3;

/**
 * Where on an object a body stands, as a pose that moves as that place does: of an instance its own matrix, of a skin or
 * a morph a small triangle of vertices, which three moves on the processor as the GPU does. (A shader's own waves it
 * cannot follow: of those only the field tells.)
 */
export class Anchor {
  /** World space. Of a triangle: its first corner, and a right-handed frame along its first side. */
  readonly pose = new Matrix4();
  object: Object3D | null = null;
  /** Which instance, where only one of several moves; else -1. */
  instance = -1;
  readonly #vertices = [0, 0, 0];
  /** Whether it goes by vertices. */
  #bends = false;

  /** Does more than the object's world matrix say where the place is? */
  get deforms(): boolean {
    return this.#bends || this.instance >= 0;
  }

  release(): void {
    this.object = null;
  }

  /**
   * Holds on to a place.
   *
   * @param point where it is touched, world space
   * @returns whether it held on to the same before
   */
  hold(object: Object3D, instance: number, point: Vector3): boolean {
    const parts =
      (object as InstancedMesh).isInstancedMesh || (object as BatchedMesh).isBatchedMesh === true;
    const wanted = parts ? instance : -1;
    const same = object === this.object && wanted === this.instance;
    if (same && (!this.#bends || this.#corner(0, a).distanceTo(point) < LONGEST)) return true;
    this.object = object;
    this.instance = wanted;
    this.#bends = bends(object) && this.#choose(object as Mesh, point);
    this.follow();
    return false;
  }

  /** Brings `pose` up to date. The object's world matrix, and its bones', must be. */
  follow(): void {
    const object = this.object!;
    if (this.#bends) {
      this.#corner(0, a);
      this.#corner(1, b).sub(a).normalize();
      this.#corner(2, c).sub(a).cross(b).normalize();
      this.pose.makeBasis(b, c, x.crossVectors(b, c)).setPosition(a);
      return;
    }
    this.pose.copy(object.matrixWorld);
    if (this.instance < 0) return;
    (object as InstancedMesh).getMatrixAt(this.instance, local);
    this.pose.multiply(local);
  }

  /** Finds the vertex nearest to `point` and two more near by that make a triangle of some size; is there one? */
  #choose(mesh: Mesh, point: Vector3): boolean {
    const { count } = mesh.geometry.attributes.position!;
    const every = Math.max(1, Math.ceil(count / MOST_LOOKED_AT));
    for (let corner = 0; corner < 3; corner++) {
      let best = Infinity;
      for (let vertex = 0; vertex < count; vertex += every) {
        vertexOf(mesh, vertex, x);
        const away = x.distanceToSquared(point);
        if (away >= best || !this.#suits(corner, x)) continue;
        best = away;
        this.#vertices[corner] = vertex;
      }
      if (best === Infinity) return false;
      if (corner === 0) vertexOf(mesh, this.#vertices[0]!, a);
      if (corner === 1) vertexOf(mesh, this.#vertices[1]!, b);
    }
    return true;
  }

  /** Would a vertex at `place` do as that corner, with those before it in `a` and `b`? */
  #suits(corner: number, place: Vector3): boolean {
    if (corner === 0) return true;
    c.subVectors(place, a);
    const length = c.length();
    if (length < SHORTEST) return false;
    if (corner === 1) return true;
    side.subVectors(b, a);
    const shortest = LEAST_SINE * length * side.length();
    return c.cross(side).length() > shortest;
  }

  #corner(corner: number, target: Vector3): Vector3 {
    return vertexOf(this.object as Mesh, this.#vertices[corner]!, target);
  }
}

/** Does three move vertices of it, each its own way, where the processor can follow? */
function bends(object: Object3D): boolean {
  if ((object as SkinnedMesh).isSkinnedMesh) return true;
  const { geometry, morphTargetInfluences } = object as Mesh;
  return morphTargetInfluences !== undefined && 'position' in geometry.morphAttributes;
}

/** World place of a vertex. */
function vertexOf(mesh: Mesh, vertex: number, target: Vector3): Vector3 {
  return mesh.getVertexPosition(vertex, target).applyMatrix4(mesh.matrixWorld);
}

const a = /* @__PURE__ */ new Vector3();
const b = /* @__PURE__ */ new Vector3();
const c = /* @__PURE__ */ new Vector3();
const x = /* @__PURE__ */ new Vector3();
const side = /* @__PURE__ */ new Vector3();
const local = /* @__PURE__ */ new Matrix4();
