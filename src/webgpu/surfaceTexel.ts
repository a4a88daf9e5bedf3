import {
  cameraViewMatrix,
  float,
  frontFacing,
  instanceIndex,
  normalize,
  screenCoordinate,
  uniform,
  varying,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import * as TSL from 'three/tsl';
import type { Node, NodeBuilder } from 'three/webgpu';
import { NORMAL_STEPS } from '../cube/encoding.js';
import type { ObjectProxy } from '../collider/objectProxy.js';
import type { CollisionNodeMaterial } from './CollisionNodeMaterial.js';

/** What all collision materials of a collider share. */
export interface TexelUniforms {
  /** Tells their programs from those of others. */
  readonly key: string;
  /** Texels per face edge, as drawn. */
  readonly resolution: number;
  /** Reach, metres; one node, to be set. */
  readonly far: ReturnType<typeof uniform<'float', number>>;
  /** The paper's mode: its shell, metres; null for surfaces. */
  readonly shell: { readonly rMin: number; readonly rMax: number } | null;
}

/** The number of the object drawn now. */
const objectNumber = /* @__PURE__ */ uniform(0).onObjectUpdate(
  ({ object }) => (object as unknown as ObjectProxy).drawNumber,
);

/** 1, -1 of what shows the inside of its triangles, 0 of what shows both sides. */
const frontSign = /* @__PURE__ */ uniform(1).onObjectUpdate(
  ({ material }) => (material as unknown as CollisionNodeMaterial).frontSign,
);

/**
 * The nodes of one fragment's texel, as `collisionShader.ts` computes it for WebGL: equation (9), the geometric normal,
 * and where the texel's own ray meets the plane. To be built before anything is discarded: derivatives are undefined
 * after.
 *
 * @param surface where a fragment's surface is, the face camera's axes
 */
export function surfaceTexel(
  builder: NodeBuilder,
  uniforms: TexelUniforms,
  surface: Node<'vec3'>,
): Node<'vec4'> {
  const place = surface.toVar();
  const away = place.length().toVar();
  const slope = place.dFdx().cross(place.dFdy()).toVar();
  const turn = slope.dot(place).greaterThan(0).select(float(-1), float(1));
  const flat = slope.mul(turn.div(slope.length().max(1e-30)));
  // Edge-on to the point of nothing, it faces us.
  const normal = slope.dot(slope).greaterThan(0).select(flat, place.negate().div(away)).toVar();

  // Rows of the target count downward.
  const tile = screenCoordinate
    .mod(uniforms.resolution)
    .mul(2 / uniforms.resolution)
    .sub(1);
  const ray = normalize(vec3(tile.x, tile.y.negate(), -1));
  const slant = normal.dot(ray).negate().toVar();
  const met = normal.dot(place).negate().div(slant);
  const most = away.mul(0.1).max(away.fwidth());
  const distance = slant
    .greaterThan(0.02)
    .select(met.clamp(away.sub(most), away.add(most)), away)
    .toVar();

  if (uniforms.shell !== null) {
    const { rMin, rMax } = uniforms.shell;
    const red = float(1).sub(distance.sub(rMin).div(rMax - rMin)); // (10)
    // (11), in the steps that the paper's 8 bits have.
    return vec4(red.clamp(0, 1).mul(255).add(0.5).floor().div(255), 0, 0, 1).toVar();
  }

  distance.greaterThan(uniforms.far).discard();
  const octahedral = octahedron(vec4(normal, 0).mul(cameraViewMatrix).xyz);
  const grid = octahedral.mul(0.5).add(0.5).mul(NORMAL_STEPS.RGBA32F).add(0.5).floor();
  const faces = float(frontFacing).mul(2).sub(1).mul(frontSign);
  const front = faces.greaterThanEqual(0).select(float(1), float(-1));
  return vec4(
    distance,
    grid.x.mul(4096).add(grid.y),
    front.mul(objectNumber.add(1)),
    instanceNumber(builder),
  ).toVar();
}

/** A unit vector on the octahedron, unfolded. */
function octahedron(direction: Node<'vec3'>): Node<'vec2'> {
  const n = direction.div(direction.x.abs().add(direction.y.abs()).add(direction.z.abs())).toVar();
  const folded = vec2(
    float(1).sub(n.y.abs()).mul(signOf(n.x)),
    float(1).sub(n.x.abs()).mul(signOf(n.y)),
  );
  return n.z.lessThan(0).select(folded, n.xy).toVar();
}

/** 1 or -1; 1 of 0. */
function signOf(value: Node<'float'>): Node<'float'> {
  return value.lessThan(0).select(float(-1), float(1));
}

/** Which instance of the object this is; of a batch, the batch's own number. */
function instanceNumber({ object }: NodeBuilder): Node<'float'> {
  const isBatch = (object as { isBatchedMesh?: boolean }).isBatchedMesh === true;
  return float(isBatch ? TSL.batchIndirectIndex : varying(instanceIndex));
}
