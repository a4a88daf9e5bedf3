import { type IUniform, type Material, type Texture } from 'three';
import type { CollisionProgram } from './collisionProgram.js';
import { type DerivedMaterial, deriveMaterial, refreshUniforms } from './derivedMaterial.js';
import { alphaCut, frontSignOf } from './materialKind.js';

/** Maps that change neither shape nor coverage: left out, they cost neither a texture nor a program of their own. */
const IDLE_MAPS = [
  'aoMap', 'lightMap', 'bumpMap', 'normalMap', 'emissiveMap', 'metalnessMap', 'roughnessMap', 'specularMap',
  'specularColorMap', 'specularIntensityMap', 'anisotropyMap', 'clearcoatMap', 'clearcoatNormalMap',
  'clearcoatRoughnessMap', 'diffuseRoughnessMap', 'iridescenceMap', 'iridescenceThicknessMap', 'sheenColorMap',
  'sheenRoughnessMap', 'thicknessMap', 'transmissionMap', 'gradientMap', 'matcap', 'emissive', 'defines',
] as const; // prettier-ignore

/** Lobes that three tells programs apart by. */
const IDLE_LOBES = [
  'anisotropy', 'clearcoat', 'dispersion', 'iridescence', 'sheen', 'diffuseRoughness', 'retroreflectivity',
] as const; // prettier-ignore

const KINDS = [
  'Basic',
  'Lambert',
  'Phong',
  'Toon',
  'Standard',
  'Physical',
  'Matcap',
  'Normal',
  'Distance',
];

interface WithMaps extends Material {
  map?: Texture | null;
  alphaMap?: Texture | null;
}

/**
 * The collision material of a built-in one with a displacement map, an alpha test or clipping planes of its own. three
 * takes it for a `MeshDepthMaterial` (the one of its kinds that has just these features) and so keeps its uniforms in
 * step with what the user's is now; the shaders are the plain ones, which have three's parts for all of it. Materials
 * with the same features share a program.
 */
export function createCutMaterial(
  source: WithMaps,
  sides: 'both' | 'drawn',
  program: CollisionProgram,
): DerivedMaterial {
  const object: IUniform<number> = { value: 0 };
  const frontSign: IUniform<number> = { value: 1 };
  const overrides: Record<string, unknown> = {
    type: 'MeshDepthMaterial',
    isMeshDepthMaterial: true,
    depthPacking: undefined,
    alphaHash: false,
    customProgramCacheKey: () => program.key,
    onBeforeCompile: (shader: {
      uniforms: Record<string, IUniform>;
      vertexShader: string;
      fragmentShader: string;
      glslVersion?: string | null;
    }) => {
      Object.assign(shader.uniforms, program.uniforms, { object, frontSign });
      shader.vertexShader = program.vertexShader;
      shader.fragmentShader = program.fragmentShader;
      shader.glslVersion = program.glslVersion;
    },
  };
  for (const kind of KINDS) overrides[`isMesh${kind}Material`] = false;
  for (const name of IDLE_MAPS) overrides[name] = name === 'defines' ? undefined : null;
  for (const name of IDLE_LOBES) overrides[name] = 0;
  const material = deriveMaterial(source, sides, overrides);
  const live = (get: () => unknown) => ({ get, set: () => {}, configurable: true });
  Object.defineProperties(material, {
    alphaTest: live(() => alphaCut(source)),
    // Where alpha cuts nothing no map matters.
    map: live(() => (alphaCut(source) > 0 ? source.map : null)),
    alphaMap: live(() => (alphaCut(source) > 0 ? source.alphaMap : null)),
    vertexColors: live(() => alphaCut(source) > 0 && source.vertexColors),
  });
  material.beforeTurn = (proxy) => {
    object.value = proxy.drawNumber;
    frontSign.value = frontSignOf(source.side, sides);
    refreshUniforms(material);
  };
  return material;
}
