import { property, varying, vec3, vec4 } from 'three/tsl';
import {
  DoubleSide,
  type Material,
  type Node,
  type NodeBuilder,
  type NodeMaterial,
  BackSide,
} from 'three/webgpu';
import type { Turn } from '../collider/derivedMaterial.js';
import { alphaCut } from '../collider/materialKind.js';
import { isMirror } from '../collider/isMirror.js';
import { CollisionNodeMaterial } from './CollisionNodeMaterial.js';
import type { TexelUniforms } from './surfaceTexel.js';

/** Own properties that are never taken over: what a material is, and how it is drawn. */
const OWN = new Set([
  ...['uuid', 'id', 'name', 'version', 'userData', '_listeners', 'type', 'frontSign'],
  ...['side', 'blending', 'transparent', 'premultipliedAlpha', 'forceSinglePass', 'visible', 'fog', 'lights'],
  ...['depthTest', 'depthWrite', 'depthFunc', 'colorWrite', 'stencilWrite', 'polygonOffset', 'wireframe'],
  ...['toneMapped', 'dithering', 'allowOverride', 'alphaToCoverage', 'alphaHash', 'alphaTest', 'precision'],
  // Nodes that only colour what is drawn, or draw something else.
  ...['mrtNode', 'fragmentNode', 'outputNode', 'vertexNode', 'emissiveNode', 'normalNode', 'lightsNode', 'envNode'],
  ...['aoNode', 'backdropNode', 'backdropAlphaNode', 'receivedShadowPositionNode', 'castShadowPositionNode'],
  ...['castShadowNode', 'receivedShadowNode', 'contextNode', 'aoMap', 'envMap', 'lightMap', 'emissive'],
  ...['beforeTurn', 'afterTurn', 'source', 'isNodeMaterial'],
]); // prettier-ignore

/** Of materials that are no node materials: all that moves vertices or cuts holes. */
const CLASSIC = [
  ...['map', 'alphaMap', 'opacity', 'vertexColors'],
  ...['displacementMap', 'displacementScale', 'displacementBias'],
]; // prettier-ignore

type Properties = Record<string, unknown>;
type Source = Material & { isNodeMaterial?: boolean } & Partial<
    Pick<NodeMaterial, 'vertexNode' | 'fragmentNode' | 'outputNode'>
  >;

/**
 * The collision material of one of the user's that moves vertices or cuts holes: it has their nodes, maps and numbers,
 * which `follow` takes over as they are now. Nothing is written to theirs.
 */
export class DerivedNodeMaterial extends CollisionNodeMaterial {
  readonly beforeTurn: Turn;
  readonly afterTurn: Turn;
  readonly #source: Source;
  #version = -1;
  #names: string[] = [];
  #vertexNode: Node<'vec4'> | null = null;

  constructor(source: Material, uniforms: TexelUniforms, near: number) {
    super(uniforms, near);
    this.#source = source;
    this.name = `CubeCollider ${source.name || source.type}`;
    // Uniforms of a single object are set in the user's hooks.
    this.beforeTurn = ({ source: mesh, scene }, renderer, camera, geometry, group) => {
      if (!isMirror(mesh)) mesh.onBeforeRender(renderer, scene, camera, geometry, source, group);
    };
    this.afterTurn = ({ source: mesh, scene }, renderer, camera, geometry, group) => {
      if (!isMirror(mesh)) mesh.onAfterRender(renderer, scene, camera, geometry, source, group);
    };
  }

  /** Takes over what the user's material is now. */
  follow(sides: 'both' | 'drawn'): void {
    const source = this.#source;
    const ours = this as unknown as Properties;
    const theirs = source as unknown as Properties;
    if (source.version !== this.#version) {
      this.#version = source.version;
      const names = source.isNodeMaterial === true ? Object.keys(source) : CLASSIC;
      this.#names = names.filter((name) => !OWN.has(name) && !name.startsWith('_'));
      this.needsUpdate = true;
    }
    for (const name of this.#names) {
      if (theirs[name] !== undefined) ours[name] = theirs[name];
    }
    const cut = alphaCut(source);
    if (cut > 0 !== this.alphaTest > 0) this.needsUpdate = true;
    this.alphaTest = cut;
    this.#follow(sides);
  }

  #follow(sides: 'both' | 'drawn'): void {
    const { side, vertexNode = null } = this.#source;
    this.frontSign = side === DoubleSide ? 0 : side === BackSide ? -1 : 1;
    const drawn = sides === 'both' ? DoubleSide : side;
    if (drawn !== this.side) this.needsUpdate = true;
    this.side = drawn;
    if (vertexNode === this.#vertexNode) return;
    this.#vertexNode = vertexNode as Node<'vec4'> | null;
    this.vertexNode = vertexNode === null ? null : this.nudge(vec4(vertexNode as Node<'vec4'>));
  }

  /** Two of the same nodes share a program; those that we only run are not among ours. */
  override customProgramCacheKey(): string {
    const { fragmentNode, outputNode } = this.#source;
    const keys = [fragmentNode, outputNode].map((node) => node?.getCacheKey(true) ?? 0);
    return `${super.customProgramCacheKey()} ${keys.join(' ')}`;
  }

  /** The face cameras' projections are of 90° and square: what the user puts out for them is the place itself. */
  protected override place(): Node<'vec3'> {
    if (this.#vertexNode === null) return super.place();
    const clip = vec4(this.#vertexNode);
    return varying(vec3(clip.xy, clip.w.negate()));
  }

  override setupDiffuseColor(builder: NodeBuilder): void {
    // A fragment node stands for all that three makes of a colour, its holes included.
    if (this.#source.fragmentNode) this.setupTextures(builder);
    else super.setupDiffuseColor(builder);
  }

  protected override setupHoles(builder: NodeBuilder, outputNode: Node<'vec4'>): void {
    super.setupHoles(builder, outputNode);
    const { fragmentNode, outputNode: theirs } = this.#source;
    const node = fragmentNode ?? theirs;
    if (node) property('vec4', 'unseen').assign(vec4(node as Node<'vec4'>));
  }
}
