import {
  GLSL3,
  type IUniform,
  type Material,
  type ShaderMaterial,
  type WebGLRenderer,
} from 'three';
import type { TexelFormat } from '../cube/encoding.js';
import {
  type DerivedMaterial,
  deriveMaterial,
  refreshUniforms,
  type Turn,
} from './derivedMaterial.js';
import { isMirror } from './isMirror.js';
import { alphaCut, frontSignOf, isHooked } from './materialKind.js';
import { NOTHING, wrapShader } from './wrapShader.js';

type Uniforms = Record<string, IUniform>;

interface Shader {
  uniforms: Uniforms;
  vertexShader: string;
  fragmentShader: string;
  glslVersion?: string | null;
}

export interface WrapSettings {
  readonly output: 'surface' | 'axis';
  readonly sides: 'both' | 'drawn';
  readonly format: TexelFormat;
  /** Of all materials; taken over under names of the wrapper's own. */
  readonly uniforms: Readonly<Uniforms>;
}

/**
 * The collision material of one with the user's code in it: a `ShaderMaterial`, raw or not, or one of three's with an
 * `onBeforeCompile`. It runs that code (`wrapShader`) with the user's own uniforms, as they are now.
 *
 * The user's hook is called for our program as it is for theirs, with a shader of ours. Many apps keep what the hook is
 * given, or the uniforms that it adds, to animate them: they then hold ours instead of theirs, and their own picture
 * would freeze. So every uniform that the hook adds to ours reads and writes the one that it added to theirs. Neither
 * the user's uniforms nor what three keeps of their material is written to.
 */
export class WrappedMaterial {
  readonly material: DerivedMaterial;
  /** Why it cannot be wrapped; null as long as it can. */
  failure: string | null = null;
  readonly #source: Material;
  readonly #renderer: WebGLRenderer;
  readonly #settings: WrapSettings;
  readonly #own: Uniforms;
  /** What the user's hook added to our shader when it was called last. */
  #added: { name: string; ours: IUniform; initial: unknown; linked: boolean }[] = [];
  /** The uniforms of the user's program that those follow. */
  #followed: Uniforms | undefined;

  constructor(source: Material, renderer: WebGLRenderer, settings: WrapSettings) {
    this.#source = source;
    this.#renderer = renderer;
    this.#settings = settings;
    this.#own = {
      cc_object: { value: 0 },
      cc_frontSign: { value: 1 },
      cc_alphaCut: { value: 0 },
    };
    for (const name of Object.keys(settings.uniforms)) {
      this.#own[`cc_${name}`] = settings.uniforms[name]!;
    }
    const { output, format, sides } = settings;
    const tag = `|CubeCollider ${output} ${output === 'axis' ? '' : format}`;
    this.material = deriveMaterial(source, sides, {
      // A list of lights without any: their uniforms are the user's, and stay theirs.
      lights: false,
      uniformsNeedUpdate: false,
      customProgramCacheKey: () => source.customProgramCacheKey() + tag,
      onBeforeCompile: (shader: Shader) => this.#compile(shader),
      onBeforeRender: this.#materialHook(),
      beforeTurn: this.#before,
      afterTurn: this.#after,
    });
  }

  /** Lets what the user's hook added to our shader follow what it added to theirs, once they have a program. */
  follow(): void {
    if (this.#added.length === 0) return;
    const { uniforms } = this.#renderer.properties.get(this.#source) as { uniforms?: Uniforms };
    if (uniforms === undefined || uniforms === this.#followed) return;
    this.#followed = uniforms;
    for (const added of this.#added) {
      const { name, ours, initial, linked } = added;
      const theirs = uniforms[name];
      if (theirs === undefined || theirs === ours) continue;
      // Ours came first, and the user has set it in the belief that it was theirs.
      if (!linked && !Object.is(ours.value, initial)) theirs.value = ours.value as unknown;
      added.linked = true;
      Object.defineProperty(ours, 'value', {
        get: () => theirs.value as unknown,
        set: (value: unknown) => (theirs.value = value),
        enumerable: true,
        configurable: true,
      });
    }
  }

  /** Has it made this program? */
  made(program: unknown): boolean {
    const { programs } = this.#renderer.properties.get(this.material) as {
      programs?: Map<string, { program: unknown }>;
    };
    if (programs === undefined) return false;
    for (const each of programs.values()) if (each.program === program) return true;
    return false;
  }

  #compile(shader: Shader): void {
    const source = this.#source;
    const own = source as Partial<ShaderMaterial> & { isRawShaderMaterial?: boolean };
    const glsl3 = own.glslVersion === GLSL3;
    const raw = own.isRawShaderMaterial === true;
    try {
      this.#callHook(shader, own);
      Object.assign(shader, wrapShader(shader, { ...this.#settings, glsl3, raw }));
    } catch (error) {
      this.failure = String(error);
      Object.assign(shader, NOTHING);
    }
    // We put out what we put out ourselves, and raw shaders of GLSL ES 1 are translated.
    shader.glslVersion = GLSL3;
  }

  /** Lets the user's hook change `shader`, and gives it our uniforms. */
  #callHook(shader: Shader, source: Partial<ShaderMaterial>): void {
    const theirs = source.isShaderMaterial === true ? (source.uniforms as Uniforms) : null;
    if (theirs !== null) shader.uniforms = { ...theirs };
    const before = { ...shader.uniforms };
    if (isHooked(this.#source)) this.#source.onBeforeCompile(shader as never, this.#renderer);
    const after = shader.uniforms;
    this.#added = Object.entries(after)
      .filter(([name, uniform]) => before[name] !== uniform)
      .map(([name, ours]) => ({ name, ours, initial: ours.value as unknown, linked: false }));
    // What the user adds to or exchanges in their own uniforms counts, as it does for three.
    const all = theirs === null ? after : (Object.create(theirs) as Uniforms);
    for (const { name, ours } of this.#added) all[name] = ours;
    shader.uniforms = Object.assign(all, this.#own);
    this.#followed = undefined;
    this.follow();
  }

  readonly #before: Turn = (proxy, renderer, camera, geometry, group) => {
    const source = this.#source;
    const { source: mesh, scene } = proxy;
    // Uniforms of a single object are set there.
    if (!isMirror(mesh)) mesh.onBeforeRender(renderer, scene, camera, geometry, source, group);
    const { cc_object, cc_frontSign, cc_alphaCut } = this.#own;
    cc_object!.value = proxy.drawNumber;
    cc_frontSign!.value = frontSignOf(source.side, this.#settings.sides);
    // An alpha test is the shader's own; what multisampling would have dithered is ours to decide.
    cc_alphaCut!.value = source.alphaTest > 0 ? 0 : alphaCut(source);
    refreshUniforms(this.material);
  };

  readonly #after: Turn = (proxy, renderer, camera, geometry, group) => {
    const { source: mesh, scene } = proxy;
    if (isMirror(mesh)) return;
    mesh.onAfterRender(renderer, scene, camera, geometry, this.#source, group);
  };

  /** three calls it between the object's own hook and the draw. */
  #materialHook(): Material['onBeforeRender'] {
    const source = this.#source;
    return (renderer, scene, camera, geometry, object, group) => {
      source.onBeforeRender(renderer, scene, camera, geometry, object, group);
    };
  }
}
