import {
  type BufferGeometry,
  type Camera,
  DoubleSide,
  type Group,
  LessEqualDepth,
  type Material,
  NoBlending,
  type WebGLRenderer,
} from 'three';
import type { ObjectProxy } from './objectProxy.js';

/** What three tells before and after it draws an object. */
export type Turn = (
  proxy: ObjectProxy,
  renderer: WebGLRenderer,
  camera: Camera,
  geometry: BufferGeometry,
  group: Group,
) => void;

/** A collision material made of a user's: it reads everything live from that and has its own state of drawing. */
export interface DerivedMaterial extends Material {
  readonly source: Material;
  id: number;
  /** Called just before an object is drawn with it. */
  beforeTurn: Turn;
  /** Called just after. */
  afterTurn: Turn;
}

export function isDerived(material: Material): material is DerivedMaterial {
  return Object.hasOwn(material, 'beforeTurn');
}

/** Below all of three's own, which count up from 0 (and -1 is its "none"). */
let nextId = -2;

/**
 * Lets three upload a material's uniforms for the next object: it does where the material's id is not the one it saw
 * last, and for built-in materials nowhere else.
 */
export function refreshUniforms(material: DerivedMaterial): void {
  material.id = nextId--;
}

const nothing = () => {};

/**
 * A material that is `source` but for how it is drawn. Nothing is written to the user's.
 *
 * @param overrides further properties, by name
 */
export function deriveMaterial(
  source: Material,
  sides: 'both' | 'drawn',
  overrides: Record<string, unknown>,
): DerivedMaterial {
  const properties: PropertyDescriptorMap = {
    // Live: the user may turn a material round.
    side: {
      get: () => (sides === 'both' ? DoubleSide : source.side),
      set: nothing,
      enumerable: true,
      configurable: true,
    },
  };
  const values: Record<string, unknown> = {
    source,
    id: nextId--,
    name: `CubeCollider ${source.name || source.type}`,
    // Whoever listens to the user's material does not listen to this one.
    _listeners: undefined,
    visible: true,
    transparent: false,
    forceSinglePass: true,
    blending: NoBlending,
    premultipliedAlpha: false,
    alphaToCoverage: false,
    depthTest: true,
    depthWrite: true,
    depthFunc: LessEqualDepth,
    colorWrite: true,
    stencilWrite: false,
    polygonOffset: false,
    wireframe: false,
    fog: false,
    dithering: false,
    toneMapped: false,
    allowOverride: false,
    // Else the private scene gets a pass for what shines through, and a rendered environment.
    transmission: 0,
    envMap: null,
    // Distances need all the precision there is.
    precision: null,
    beforeTurn: nothing,
    afterTurn: nothing,
    onBeforeRender: nothing,
    ...overrides,
  };
  for (const name of Object.keys(values)) {
    properties[name] = {
      value: values[name],
      writable: true,
      enumerable: true,
      configurable: true,
    };
  }
  return Object.create(source, properties) as DerivedMaterial;
}
