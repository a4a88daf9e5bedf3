import {
  cameraProjectionMatrix,
  float,
  highpModelViewMatrix,
  output,
  positionLocal,
  positionView,
  vec4,
} from 'three/tsl';
import {
  LessEqualDepth,
  NoBlending,
  type Node,
  type NodeBuilder,
  NodeMaterial,
  type NodeMaterialObserver,
} from 'three/webgpu';
import { surfaceTexel, type TexelUniforms } from './surfaceTexel.js';

/**
 * What scenery wears in the cubemap of a `WebGPURenderer`: three's own chain of vertex tricks and of what cuts holes into
 * a surface, and our texel for its colour.
 */
export class CollisionNodeMaterial extends NodeMaterial {
  static override get type(): string {
    return 'CollisionNodeMaterial';
  }

  /** See `frontSignOf`; here also -1 of a `BackSide` that is culled. */
  frontSign = 1;
  /** Smallest w of a vertex, metres. */
  readonly #least: number;
  readonly #uniforms: TexelUniforms;
  #texel: Node<'vec4'> | null = null;

  /** @param near of the face cameras, metres */
  constructor(uniforms: TexelUniforms, near: number) {
    super();
    this.#uniforms = uniforms;
    this.#least = 0.1 * near;
    this.name = 'CubeCollider';
    this.lights = false;
    this.fog = false;
    this.blending = NoBlending;
    this.toneMapped = false;
    this.depthFunc = LessEqualDepth;
    // Drawn twice otherwise, where a side is double.
    this.forceSinglePass = true;
    this.allowOverride = false;
  }

  override customProgramCacheKey(): string {
    return super.customProgramCacheKey() + this.#uniforms.key;
  }

  override setupObserver(builder: NodeBuilder): NodeMaterialObserver {
    leaveOutPictures(builder);
    const observer = super.setupObserver(builder);
    // Else three looks for changes in what it knows; our objects' numbers it does not.
    observer.hasNode = true;
    return observer;
  }

  /** In doubles up to the matrix, whatever the renderer's `highPrecision`. */
  override setupPositionView(): Node<'vec3'> {
    return highpModelViewMatrix.mul(vec4(positionLocal, 1)).xyz;
  }

  override setupModelViewProjection(): Node<'vec4'> {
    return this.nudge(cameraProjectionMatrix.mul(vec4(positionView, 1)));
  }

  /** As in `collisionShader.ts`: a vertex in the face camera's own plane. */
  nudge(clip: Node<'vec4'>): Node<'vec4'> {
    const place = clip.toVar();
    const least = float(this.#least);
    const w = place.w
      .abs()
      .lessThan(least)
      .select(place.w.lessThan(0).select(least.negate(), least), place.w);
    return vec4(place.xyz, w);
  }

  /** The first of what a fragment does: derivatives are undefined once others of its block were discarded. */
  override setupClipping(builder: NodeBuilder): ReturnType<NodeMaterial['setupClipping']> {
    this.#texel = surfaceTexel(builder, this.#uniforms, this.place());
    return super.setupClipping(builder);
  }

  /** Where a fragment's surface is, the face camera's axes. */
  protected place(): Node<'vec3'> {
    return positionView;
  }

  override setupDiffuseColor(builder: NodeBuilder): void {
    this.setupTextures(builder);
    super.setupDiffuseColor(builder);
  }

  /** Maps unblurred: a texel stands for one ray, and a fence's wires must not fade because the cubemap is small. */
  protected setupTextures(builder: NodeBuilder): void {
    (builder.context as { getTextureLevel?: unknown }).getTextureLevel = () => float(0);
  }

  override setupOutput(builder: NodeBuilder, outputNode: Node<'vec4'>): Node<'vec4'> {
    this.setupHoles(builder, outputNode);
    return this.#texel!;
  }

  /** What else may discard a fragment. */
  protected setupHoles(_builder: NodeBuilder, outputNode: Node<'vec4'>): void {
    output.assign(outputNode);
  }
}

/** What a builder gathers for before and after each draw, which its types do not tell. */
interface Gathering {
  buildUpdateNodes(): void;
  updateBeforeNodes: Node[];
  updateAfterNodes: Node[];
}

/**
 * Mirrors, passes and the like among the user's nodes make a picture of their own before they are drawn: for our eyes
 * they must not, and nothing solid depends on it. The user's own events are called.
 */
function leaveOutPictures(builder: NodeBuilder): void {
  const gathering = builder as unknown as Gathering;
  const gather = gathering.buildUpdateNodes;
  gathering.buildUpdateNodes = () => {
    gather.call(gathering);
    const isEvent = ({ type }: Node) => type === 'EventNode';
    gathering.updateBeforeNodes = gathering.updateBeforeNodes.filter(isEvent);
    gathering.updateAfterNodes = gathering.updateAfterNodes.filter(isEvent);
  };
}
