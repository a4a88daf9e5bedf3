import {
  float,
  Fn,
  If,
  int,
  ivec2,
  localId,
  Loop,
  screenCoordinate,
  storage,
  textureLoad,
  vec4,
  workgroupArray,
  workgroupBarrier,
  workgroupId,
} from 'three/tsl';
import {
  NoBlending,
  type Node,
  NodeMaterial,
  QuadMesh,
  type RenderTarget,
  StorageBufferAttribute,
  type WebGPURenderer,
} from 'three/webgpu';
import { ATLAS_COLUMNS } from '../cube/atlas.js';
import { createFloatTarget } from './texelTargets.js';

/**
 * The paper's search for the highest red per face, (17)-(22), on the GPU: see `AxisPass`, which does it for WebGL. What
 * remains are six texels of red, column and row.
 */
export interface AxisReduction {
  /** Where the six are: a target of 6×1 texels, or a buffer of six times four floats. */
  readonly result: RenderTarget | StorageBufferAttribute;
  /** Finds the six anew. */
  reduce(renderer: WebGPURenderer): void;
  dispose(): void;
}

/** A value of the atlas by face and row; `row` counts upward. */
type Load = (face: Node<'int'>, x: Node<'int'>, row: Node<'int'>) => Node<'float'>;

/** How far from the middle of `resolution` texels, in half texels. */
const off = (place: Node<'int'>, resolution: number) =>
  place
    .mul(2)
    .add(1 - resolution)
    .abs();

/** The highest red of a row, its column: the one nearest to the middle of several. */
function rowWinner(load: Load, face: Node<'int'>, row: Node<'int'>, resolution: number) {
  const best = float(-1).toVar();
  const column = int(0).toVar();
  Loop({ start: int(0), end: int(resolution), type: 'int', condition: '<' }, ({ i }) => {
    const x = int(i);
    const red = load(face, x, row).toVar();
    const nearer = off(x, resolution).lessThan(off(column, resolution));
    If(red.greaterThan(best).or(red.equal(best).and(nearer)), () => {
      best.assign(red);
      column.assign(x);
    });
  });
  return vec4(best, float(column), float(row), 1);
}

/** The highest of the rows' winners: the one nearest to the middle of several. */
function faceWinner(rowOf: (row: Node<'int'>) => Node<'vec4'>, resolution: number): Node<'vec4'> {
  const winner = vec4(-1, 0, 0, 1).toVar();
  const least = int(0).toVar();
  Loop({ start: int(0), end: int(resolution), type: 'int', condition: '<' }, ({ i }) => {
    const candidate = rowOf(int(i)).toVar();
    const x = off(int(candidate.y), resolution).toVar();
    const y = off(int(candidate.z), resolution).toVar();
    const distance = x.mul(x).add(y.mul(y)).toVar();
    const nearer = candidate.x.equal(winner.x).and(distance.lessThan(least));
    If(candidate.x.greaterThan(winner.x).or(nearer), () => {
      winner.assign(candidate);
      least.assign(distance);
    });
  });
  return winner;
}

/** Reads the atlas that `NearestQuad` leaves. @param upward as there */
function loadFrom({ texture, height }: RenderTarget, resolution: number, upward: boolean): Load {
  return (face, x, row) => {
    const column = face.mod(ATLAS_COLUMNS).mul(resolution).add(x);
    const line = face.div(ATLAS_COLUMNS).mul(resolution).add(row);
    const y = upward ? line : int(height - 1).sub(line);
    return textureLoad(texture, ivec2(column, y), int(0)).x;
  };
}

/** WebGPU: a workgroup a face, a thread a row. */
export class ComputedAxisReduction implements AxisReduction {
  readonly result = new StorageBufferAttribute(6, 4);
  readonly #compute;

  constructor(resolution: number, atlas: RenderTarget) {
    const load = loadFrom(atlas, resolution, true);
    const result = storage(this.result, 'vec4', 6);
    const rows = workgroupArray('vec4', resolution) as unknown as ReturnType<typeof storage>;
    this.#compute = Fn(() => {
      const face = int(workgroupId.x);
      const row = int(localId.x);
      rows.element(row).assign(rowWinner(load, face, row, resolution));
      workgroupBarrier();
      If(row.equal(0), () => {
        const rowOf = (row: Node<'int'>) => rows.element(row) as unknown as Node<'vec4'>;
        result.element(face).assign(faceWinner(rowOf, resolution));
      });
    })().compute(6 * resolution, [resolution]);
    this.#compute.setName('CubeCollider maxima');
  }

  reduce(renderer: WebGPURenderer): void {
    renderer.compute(this.#compute);
  }

  dispose(): void {
    this.#compute.dispose();
  }
}

/** The WebGL 2 fallback: a pass over rows, and one over what they leave. */
export class DrawnAxisReduction implements AxisReduction {
  readonly result = createFloatTarget(6, 1, false);
  readonly #rows: RenderTarget;
  readonly #passes: { quad: QuadMesh; target: RenderTarget }[];

  constructor(resolution: number, atlas: RenderTarget) {
    this.#rows = createFloatTarget(6, resolution, false);
    const load = loadFrom(atlas, resolution, false);
    const { texture } = this.#rows;
    const rows = Fn(() =>
      rowWinner(load, int(screenCoordinate.x), int(screenCoordinate.y), resolution),
    );
    const faces = Fn(() => {
      const face = int(screenCoordinate.x);
      return faceWinner((row) => textureLoad(texture, ivec2(face, row), int(0)), resolution);
    });
    this.#passes = [
      { quad: createQuad('rows', rows()), target: this.#rows },
      { quad: createQuad('faces', faces()), target: this.result },
    ];
  }

  reduce(renderer: WebGPURenderer): void {
    for (const { quad, target } of this.#passes) {
      renderer.setRenderTarget(target);
      quad.render(renderer);
    }
  }

  dispose(): void {
    this.#rows.dispose();
    this.result.dispose();
    for (const { quad } of this.#passes) (quad.material as NodeMaterial).dispose();
  }
}

function createQuad(name: string, node: unknown): QuadMesh {
  const material = new NodeMaterial();
  material.name = `CubeCollider maxima of ${name}`;
  material.lights = material.fog = material.toneMapped = false;
  material.depthTest = material.depthWrite = false;
  material.blending = NoBlending;
  material.fragmentNode = node as never;
  return new QuadMesh(material);
}
