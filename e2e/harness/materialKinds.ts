import {
  BoxGeometry,
  BufferAttribute,
  type BufferGeometry,
  type Camera,
  ClampToEdgeWrapping,
  DataTexture,
  DoubleSide,
  GLSL3,
  type IUniform,
  LinearFilter,
  LinearMipmapLinearFilter,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  MeshStandardMaterial,
  NearestFilter,
  Plane,
  PlaneGeometry,
  RawShaderMaterial,
  RepeatWrapping,
  ShaderMaterial,
  Vector3,
  type WebGLRenderer,
} from 'three';
import { seeded } from '../support/axisScenes.js';
import type { Hit, Surface } from './materialOracle.js';

/** One kind of material on four meshes: placed, rotated, scaled unevenly, mirrored; and what may become of it. */
export interface Kind {
  readonly surfaces: Surface[];
  readonly materials: Material[];
  /** Each is made in turn, and everything drawn and judged again. */
  readonly changes: (() => void)[];
}

export type Place = NonNullable<Surface['place']>;
export type There = NonNullable<Surface['there']>;

const PLACES: [position: number[], rotation: number[], scale: number[]][] = [
  [[0, 0, -1.2], [0, 0, 0], [1, 1, 1]],
  [[1.1, 0.2, 0.3], [0.5, -1.2, 0.3], [1, 1, 1]],
  [[-0.2, -1, 0.1], [-1.4, 0.2, 0.5], [1.5, 0.7, 1.2]],
  [[-1.1, 0.3, 0.4], [0.2, 1.3, 0.1], [-1.1, 0.8, 1]],
]; // prettier-ignore

export function put(geometry: BufferGeometry, material: Material | Material[]): Mesh[] {
  return PLACES.map(([position, rotation, scale], i) => {
    const mesh = new Mesh(geometry, Array.isArray(material) ? material[i] : material);
    mesh.position.fromArray(position);
    mesh.rotation.set(rotation[0]!, rotation[1]!, rotation[2]!);
    mesh.scale.fromArray(scale);
    return mesh;
  });
}

/** A picture that the processor reads as the graphics card does. */
export class Picture {
  readonly texture: DataTexture;
  readonly #data: Uint8Array;

  constructor(
    readonly size: number,
    readonly smooth: boolean,
    texel: (x: number, y: number) => number[],
  ) {
    this.#data = new Uint8Array(4 * size * size);
    for (let y = 0; y < size; y++) {
      for (let x = 0; x < size; x++) this.#data.set(texel(x, y), 4 * (y * size + x));
    }
    this.texture = new DataTexture(this.#data, size, size);
    // Sharp ones do not repeat: at a mesh's rim a rounding would bring the other side's colour.
    this.texture.wrapS = this.texture.wrapT = smooth ? RepeatWrapping : ClampToEdgeWrapping;
    this.texture.magFilter = smooth ? LinearFilter : NearestFilter;
    this.texture.minFilter = smooth ? LinearFilter : NearestFilter;
    this.texture.needsUpdate = true;
  }

  /** 0 to 1. */
  at([u, v]: number[], channel: number): number {
    const { offset, repeat } = this.texture;
    const x = (u! * repeat.x + offset.x) * this.size;
    const y = (v! * repeat.y + offset.y) * this.size;
    if (!this.smooth) return this.#texel(Math.floor(x), Math.floor(y), channel);
    const left = Math.floor(x - 0.5);
    const low = Math.floor(y - 0.5);
    const a = x - 0.5 - left;
    const b = y - 0.5 - low;
    return (
      (1 - b) *
        ((1 - a) * this.#texel(left, low, channel) + a * this.#texel(left + 1, low, channel)) +
      b *
        ((1 - a) * this.#texel(left, low + 1, channel) +
          a * this.#texel(left + 1, low + 1, channel))
    );
  }

  #texel(x: number, y: number, channel: number): number {
    const { size } = this;
    const within = (i: number) =>
      this.smooth ? ((i % size) + size) % size : Math.min(Math.max(i, 0), size - 1);
    const column = within(x);
    const row = within(y);
    return this.#data[4 * (row * size + column) + channel]! / 255;
  }
}

export const waves = (size: number, phase: number) =>
  new Picture(size, true, (x, y) => {
    const [u, v] = [(2 * Math.PI * (x + 0.5)) / size, (2 * Math.PI * (y + 0.5)) / size];
    const value = 127.5 + 127.5 * Math.sin(u + phase) * Math.cos(2 * v);
    return [value, value, value, value];
  });

export const patches = (size: number, seed: number) => {
  const random = seeded(seed);
  return new Picture(size, false, () => {
    const value = [0, 100, 200, 255][Math.floor(4 * random())]!;
    return [value, value, value, value];
  });
};

export const plane = (segments = 10) => new PlaneGeometry(1.4, 1.4, segments, segments);
export const uvOf = (hit: Hit) => hit.attribute('uv');
/** How the shaders below move and cut. */
export const wave =
  (time: () => number): Place =>
  (position) => {
    position.z += 0.15 * Math.sin(6 * position.x + time());
  };
export const stripes: There = (hit) => {
  // Nothing changes at the rims, where a rounding may put a place just outside.
  const along = 4 * uvOf(hit)[0]! + 0.5;
  return along - Math.floor(along) >= 0.3;
};
const WAVE = 'vec3 moved = position + vec3( 0.0, 0.0, 0.15 * sin( 6.0 * position.x + time ) );';

export function surfacesOf(meshes: Mesh[], rules: Omit<Surface, 'mesh' | 'room'>): Surface[] {
  return meshes.map((mesh) => ({ mesh, ...rules }));
}

function displaced(): Kind {
  const pictures = [waves(16, 0), waves(16, 1.5)];
  let picture = pictures[0]!;
  const material = new MeshLambertMaterial({
    displacementMap: picture.texture,
    displacementScale: 0.3,
    displacementBias: -0.1,
  });
  const geometry = plane();
  const { uv } = geometry.attributes;
  return {
    materials: [material],
    surfaces: surfacesOf(put(geometry, material), {
      place: (position, i) => {
        const height = picture.at([uv!.getX(i), uv!.getY(i)], 0);
        position.z += material.displacementScale * height + material.displacementBias;
      },
    }),
    changes: [
      () => (material.displacementScale = -0.25),
      () => (material.displacementMap = (picture = pictures[1]!).texture),
      () => picture.texture.offset.set(0.3, 0.1),
    ],
  };
}

function alphaTested(): Kind {
  const pictures = [patches(6, 3), patches(6, 4)];
  let picture = pictures[0]!;
  const material = new MeshBasicMaterial({
    map: picture.texture,
    alphaTest: 0.5,
    transparent: true,
  });
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), {
      there: (hit) => material.opacity * picture.at(uvOf(hit), 3) >= material.alphaTest,
    }),
    changes: [
      () => (material.alphaTest = 0.9),
      () => picture.texture.offset.set(0.3, 0.1),
      () => (material.map = (picture = pictures[1]!).texture),
      () => Object.assign(material, { opacity: 0.6, alphaTest: 0.3 }),
    ],
  };
}

/** A fence so fine that the smaller images of its map are all thin air. */
function alphaMapped(): Kind {
  const picture = new Picture(64, false, (x, y) => {
    const value = x % 16 < 5 || y % 16 < 5 ? 255 : 0;
    return [0, value, 0, 255];
  });
  picture.texture.generateMipmaps = true;
  picture.texture.minFilter = LinearMipmapLinearFilter;
  const material = new MeshLambertMaterial({ alphaMap: picture.texture, alphaTest: 0.7 });
  const surfaces = surfacesOf(put(plane(1), material), {
    there: (hit) => material.opacity * picture.at(uvOf(hit), 1) >= material.alphaTest,
  });
  return {
    materials: [material],
    surfaces,
    changes: [() => picture.texture.repeat.set(0.5, 0.7)],
  };
}

function dithered(how: 'alphaToCoverage' | 'alphaHash'): Kind {
  const picture = waves(16, 0);
  const material = new MeshBasicMaterial({ map: picture.texture, [how]: true });
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), {
      there: (hit) => picture.at(uvOf(hit), 3) >= (material[how] ? 0.5 : 0),
    }),
    changes: [
      () => picture.texture.offset.set(0.2, 0.4),
      () => {
        material[how] = false;
        material.needsUpdate = true;
      },
    ],
  };
}

function vertexAlpha(): Kind {
  const geometry = plane(6);
  const random = seeded(9);
  const { count } = geometry.attributes.position!;
  const colors = Float32Array.from({ length: 4 * count }, () => random());
  geometry.setAttribute('color', new BufferAttribute(colors, 4));
  const material = new MeshBasicMaterial({ vertexColors: true, alphaTest: 0.5, side: DoubleSide });
  return {
    materials: [material],
    surfaces: surfacesOf(put(geometry, material), {
      there: (hit) => hit.attribute('color')[3]! >= material.alphaTest,
    }),
    changes: [() => (material.alphaTest = 0.35)],
  };
}

function clipped(renderer: WebGLRenderer): Kind {
  renderer.localClippingEnabled = true;
  const planes = [
    new Plane(new Vector3(0.3, 0.9, -0.2).normalize(), 0.3),
    new Plane(new Vector3(-0.5, -0.6, 0.6).normalize(), 0.6),
  ];
  const material = new MeshBasicMaterial({ clippingPlanes: planes });
  const own: There = ({ point }) => {
    if (!renderer.localClippingEnabled) return true;
    const inside = planes.map((each) => each.distanceToPoint(point) >= 0);
    return material.clipIntersection ? inside.includes(true) : !inside.includes(false);
  };
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(1), material), {
      there: (hit) =>
        own(hit) &&
        renderer.clippingPlanes.every((each: Plane) => each.distanceToPoint(hit.point) >= 0),
    }),
    changes: [
      () => planes[0]!.translate(new Vector3(0, 0.2, 0)),
      () => (material.clipIntersection = true),
      () => (renderer.clippingPlanes = [new Plane(new Vector3(0.2, 0.1, -1).normalize(), 1.15)]),
      () => (renderer.localClippingEnabled = false),
      () => (renderer.clippingPlanes = []),
    ],
  };
}

/** Four apps, and four ways to keep hold of the uniforms of their hook. */
function hooked(): Kind {
  const time = { value: 0.4 };
  const handles: { value: number }[] = [];
  const setters: ((value: number) => void)[] = [];
  interface Shader {
    uniforms: Record<string, IUniform>;
    vertexShader: string;
    fragmentShader: string;
  }
  const keep: ((shader: Shader) => void)[] = [
    // The shader, whichever came last.
    (shader) => {
      shader.uniforms.time = { value: time.value };
      setters[0] = (value) => (shader.uniforms.time!.value = value);
    },
    // The uniform, whichever came last.
    (shader) => {
      shader.uniforms.time = handles[1] = { value: time.value };
      setters[1] = (value) => (handles[1]!.value = value);
    },
    // The shader that came first.
    (shader) => {
      shader.uniforms.time = { value: time.value };
      setters[2] ??= (value) => (shader.uniforms.time!.value = value);
    },
    // A uniform of its own, for all.
    (shader) => {
      shader.uniforms.time = time;
      setters[3] = () => {};
    },
  ];
  const materials = keep.map((each) => {
    const material = new MeshStandardMaterial();
    material.onBeforeCompile = (shader) => {
      each(shader);
      shader.vertexShader = `uniform float time;\n${shader.vertexShader.replace(
        '#include <begin_vertex>',
        `${WAVE}\nvec3 transformed = moved;`,
      )}`;
      shader.fragmentShader = shader.fragmentShader.replace(
        '#include <opaque_fragment>',
        'if ( vViewPosition.x > 1e5 ) discard;\n#include <opaque_fragment>',
      );
    };
    return material;
  });
  const set = (value: number) => {
    time.value = value;
    for (const each of setters) each(value);
  };
  return {
    materials,
    surfaces: surfacesOf(put(plane(), materials), { place: wave(() => time.value) }),
    changes: [() => set(1.7), () => set(3.1)],
  };
}

function shaderMaterial(): Kind {
  const picture = patches(5, 8);
  const uniforms: Record<string, IUniform> = {
    time: { value: 0.3 },
    holes: { value: picture.texture },
    level: { value: 0.5 },
  };
  const material = new ShaderMaterial({
    uniforms,
    // Names and macros that ours have, too.
    vertexShader: `
      uniform float time;
      varying vec2 vUv;
      float octahedral( float x ) { return x; }
      void main( ) {
        vUv = uv;
        ${WAVE}
        gl_Position = projectionMatrix * modelViewMatrix * vec4( moved, octahedral( 1.0 ) );
      } // void main() {}`,
    fragmentShader: `
      #define far 10.0
      #define normal vUv.xyx
      varying vec2 vUv;
      uniform sampler2D holes;
      uniform float level;
      float octahedral( float x ) { return x * far; }
      void cut( vec2 at ) { if ( texture2D( holes, at ).a < level ) discard; }
      void main() {
        gl_FragColor = vec4( normal, octahedral( 1.0 ) );
        cut( vUv );
      }`,
  });
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(), material), {
      place: wave(() => uniforms.time!.value as number),
      there: (hit) => picture.at(uvOf(hit), 3) >= (uniforms.level!.value as number),
    }),
    changes: [
      () => (uniforms.time!.value = 2),
      () => (material.uniforms.level = { value: 0.2 }),
      () => {
        uniforms.time!.value = 3;
        material.uniformsNeedUpdate = true;
      },
    ],
  };
}

function shaderMaterial3(): Kind {
  const uniforms = { time: { value: 0.3 } };
  const material = new ShaderMaterial({
    glslVersion: GLSL3,
    uniforms,
    vertexShader: `
      uniform float time;
      out vec2 at;
      void main() {
        at = uv;
        ${WAVE}
        gl_Position = projectionMatrix * modelViewMatrix * vec4( moved, 1.0 );
      }`,
    fragmentShader: `
      in vec2 at;
      // out vec4 nothing;
      layout( location = 0 ) out vec4 color;
      void stripe( float x, out bool gone );
      void main() {
        bool gone;
        stripe( at.x, gone );
        if ( gone ) discard;
        color = vec4( 1.0 );
      }
      void stripe( float x, out bool gone ) { gone = fract( 4.0 * x + 0.5 ) < 0.3; }`,
  });
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(), material), {
      place: wave(() => uniforms.time.value),
      there: stripes,
    }),
    changes: [() => (uniforms.time.value = 2)],
  };
}

function rawMaterial(glsl3: boolean): Kind {
  const uniforms = { time: { value: 0.3 } };
  const [attribute, varyingOut, varyingIn] = glsl3
    ? ['in', 'out', 'in']
    : ['attribute', 'varying', 'varying'];
  const material = new RawShaderMaterial({
    glslVersion: glsl3 ? GLSL3 : null,
    uniforms,
    vertexShader: `
      uniform mat4 projectionMatrix, modelViewMatrix;
      uniform float time;
      ${attribute} vec3 position;
      ${attribute} vec2 uv;
      ${varyingOut} vec2 at;
      void main(void) {
        at = uv;
        ${WAVE}
        gl_Position = projectionMatrix * modelViewMatrix * vec4( moved, 1.0 );
      }`,
    fragmentShader: `${glsl3 ? '' : '#extension GL_OES_standard_derivatives : enable'}
      precision mediump float;
      ${varyingIn} vec2 at;
      ${glsl3 ? 'out vec4 color;' : ''}
      void main() {
        if ( fract( 4.0 * at.x + 0.5 ) < 0.3 ) discard;
        ${glsl3 ? 'color' : 'gl_FragColor'} = vec4( 1.0, 0.5, 0.2, 1.0 );
      }`,
  });
  return {
    materials: [material],
    surfaces: surfacesOf(put(plane(), material), {
      place: wave(() => uniforms.time.value),
      there: stripes,
    }),
    changes: [() => (uniforms.time.value = 2)],
  };
}

/** Balls drawn as boxes: the fragment shader casts the ray, discards and writes the depth. */
function impostor(): Kind {
  const uniforms = { radius: { value: 0.5 } };
  const material = new ShaderMaterial({
    uniforms,
    side: DoubleSide,
    vertexShader: `
      varying vec3 place;
      varying vec3 eye;
      void main() {
        place = position;
        eye = ( inverse( modelViewMatrix ) * vec4( 0.0, 0.0, 0.0, 1.0 ) ).xyz;
        gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
      }`,
    fragmentShader: `
      uniform mat4 modelViewMatrix;
      uniform mat4 projectionMatrix;
      uniform float radius;
      varying vec3 place;
      varying vec3 eye;
      void main() {
        vec3 ray = normalize( place - eye );
        float b = dot( eye, ray );
        float c = dot( eye, eye ) - radius * radius;
        float h = b * b - c;
        if ( h < 0.0 ) discard;
        vec4 clip = projectionMatrix * modelViewMatrix * vec4( eye + ray * ( - b - sqrt( h ) ), 1.0 );
        #ifdef USE_REVERSED_DEPTH_BUFFER
          gl_FragDepth = clip.z / clip.w;
        #else
          gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
        #endif
        gl_FragColor = vec4( 1.0 );
      }`,
  });
  const meshes = put(new BoxGeometry(1.02, 1.02, 1.02), material);
  const toObject = new Matrix4();
  const eye = new Vector3();
  const ray = new Vector3();
  return {
    materials: [material],
    surfaces: meshes.map((mesh) => ({
      mesh,
      depth: (origin: Vector3, direction: Vector3) => {
        toObject.copy(mesh.matrixWorld).invert();
        eye.copy(origin).applyMatrix4(toObject);
        // Not normalised: its parameter is then the distance in the world.
        ray.copy(origin).add(direction).applyMatrix4(toObject).sub(eye);
        const a = ray.lengthSq();
        const b = eye.dot(ray);
        const h = b * b - a * (eye.lengthSq() - uniforms.radius.value ** 2);
        return h < 0 ? null : (-b - Math.sqrt(h)) / a;
      },
    })),
    changes: [() => (uniforms.radius.value = 0.35)],
  };
}

/** One material for four meshes, and what each differs in set just before it is drawn. */
function perObject(): Kind {
  const material = new ShaderMaterial({
    uniforms: { shift: { value: 0 } },
    vertexShader: `
      uniform float shift;
      void main() {
        gl_Position = projectionMatrix * modelViewMatrix * vec4( position.xy, position.z + shift, 1.0 );
      }`,
    fragmentShader: 'void main() { gl_FragColor = vec4( 1.0 ); }',
  });
  const shifts = [0.1, -0.2, 0.3, 0.2];
  const meshes = put(plane(1), material);
  meshes.forEach((mesh, i) => {
    mesh.onBeforeRender = (_renderer, scene, camera: Camera, _geometry, given) => {
      if (given !== material || !scene.getObjectById(mesh.id) || !camera.isCamera) return;
      material.uniforms.shift!.value = shifts[i];
      material.uniformsNeedUpdate = true;
    };
  });
  return {
    materials: [material],
    surfaces: meshes.map((mesh, i) => ({
      mesh,
      place: (position: Vector3) => {
        position.z += shifts[i]!;
      },
    })),
    changes: [() => shifts.reverse()],
  };
}

export const kinds = {
  displacement: displaced,
  'alpha test': alphaTested,
  'alpha map': alphaMapped,
  'alpha to coverage': () => dithered('alphaToCoverage'),
  'alpha hash': () => dithered('alphaHash'),
  'vertex alpha': vertexAlpha,
  'clipping planes': clipped,
  onBeforeCompile: hooked,
  ShaderMaterial: shaderMaterial,
  'ShaderMaterial, GLSL 3': shaderMaterial3,
  'RawShaderMaterial, GLSL 1': () => rawMaterial(false),
  'RawShaderMaterial, GLSL 3': () => rawMaterial(true),
  gl_FragDepth: impostor,
  'uniforms of an object': perObject,
} satisfies Record<string, (renderer: WebGLRenderer) => Kind>;

export type KindName = keyof typeof kinds;
