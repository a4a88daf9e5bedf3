import {
  BufferGeometry,
  Camera,
  DataTexture,
  Float32BufferAttribute,
  FloatType,
  GLSL3,
  Mesh,
  NoBlending,
  ShaderMaterial,
  Vector3,
  WebGLRenderer,
} from 'three';
import { SurfaceField, type TexelFormat } from 'three-cube-collider';
import { ReadbackRing } from '../../src/collider/ReadbackRing.js';
import { clearTexels, createTexelTarget } from '../../src/collider/texelTarget.js';
import { atlasIndex, atlasSize, texelIndex } from '../../src/cube/atlas.js';
import {
  decodeSurface,
  encodeIdsGLSL,
  encodeSurfaceGLSL,
  hasIdTexture,
} from '../../src/cube/encoding.js';
import { seeded } from '../support/axisScenes.js';

const FAR = 2.5;
const N = 16;

/** Numbers that the ids' packing might trip on, then random ones. */
const OBJECTS = [1, 2, 15, 16, 17, 255, 256, 4095, 4096, 65000, 65534, 65535];
const INSTANCES = [0, 1, 255, 256, 65535, 65536, 1000000, 1048575, 1048576, 16777214, 16777215];

/** Surfaces through the shader's own encoding, a target, a read and the decoding; what came back otherwise. */
export default function encoding({ format, seed }: { format: TexelFormat; seed: number }) {
  const random = seeded(seed);
  const renderer = new WebGLRenderer();
  const { width, height } = atlasSize(N);
  const beside = hasIdTexture(format);
  const surfaces = new Float32Array(4 * width * height);
  const ids = new Float32Array(4 * width * height);
  const normal = new Vector3();
  for (let texel = 0; texel < width * height; texel++) {
    normal.set(random() - 0.5, random() - 0.5, random() - 0.5).normalize();
    if (texel % 8 === 0) {
      normal.set(0, 0, 0).setComponent((texel / 8) % 3, texel % 16 === 0 ? 1 : -1);
    }
    surfaces.set([FAR * Math.max(1e-4, random()), ...normal.toArray()], 4 * texel);
    const limits = [65536, 1 << 24];
    const object = OBJECTS[texel] ?? 1 + Math.floor(random() * (limits[0]! - 1));
    const instance = INSTANCES[texel % 50] ?? Math.floor(random() * limits[1]!);
    ids.set([random() < 0.5 ? 1 : 0, object, instance, texel % 7 === 3 ? 0 : 1], 4 * texel);
  }
  const material = new ShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: 'void main() { gl_Position = vec4( position.xy, 0.0, 1.0 ); }',
    fragmentShader: /* glsl */ `
      layout( location = 0 ) out highp vec4 texel;
      ${beside ? 'layout( location = 1 ) out highp uvec2 numbers;' : ''}
      uniform highp sampler2D surfaces;
      uniform highp sampler2D ids;
      ${encodeSurfaceGLSL(format)}
      ${encodeIdsGLSL}
      void main() {
        vec4 surface = texelFetch( surfaces, ivec2( gl_FragCoord.xy ), 0 );
        vec4 id = texelFetch( ids, ivec2( gl_FragCoord.xy ), 0 );
        if ( id.a == 0.0 ) discard;
        texel = encodeSurface( surface.x, surface.yzw, id.r > 0.5, ${FAR.toFixed(1)}, id.g, id.b );
        ${beside ? 'numbers = encodeIds( id.g, id.b );' : ''}
      }`,
    uniforms: {
      surfaces: { value: texture(surfaces, width, height) },
      ids: { value: texture(ids, width, height) },
    },
    blending: NoBlending,
    depthTest: false,
  });
  const triangle = new Mesh(new BufferGeometry(), material);
  triangle.geometry.setAttribute(
    'position',
    new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3),
  );
  triangle.frustumCulled = false;
  const target = createTexelTarget(width, height, format, false, beside);
  clearTexels(renderer, target);
  renderer.autoClear = false;
  renderer.render(triangle, new Camera());
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const ring = new ReadbackRing(gl, width, height, format !== 'RGBA8', beside);
  ring.readNow();
  const field = new SurfaceField(N, FAR);
  decodeSurface(format, ring.data, field, ring.ids);

  const report = {
    surfaces: 0,
    misses: 0,
    /** Largest errors, metres and length of the normals' difference. */
    distance: 0,
    normal: 0,
    /** The same along the axes. */
    axisNormal: 0,
    wrong: [] as string[],
  };
  const back = new Vector3();
  for (let face = 0; face < 6; face++) {
    for (let y = 0; y < N; y++) {
      for (let x = 0; x < N; x++) {
        const from = 4 * atlasIndex(face, x, y, N);
        const to = texelIndex(face, x, y, N);
        const [front, object, instance, hit] = ids.subarray(from, from + 4);
        const found = [field.front[to], field.object[to], field.instance[to]].join();
        if (hit === 0) {
          report.misses++;
          if (field.distance[to] !== Infinity || found !== '0,0,0') report.wrong.push(found);
          continue;
        }
        report.surfaces++;
        const expected = [front, object, instance].join();
        if (found !== expected) report.wrong.push(`${found} for ${expected}`);
        report.distance = Math.max(
          report.distance,
          Math.abs(field.distance[to]! - surfaces[from]!),
        );
        normal.fromArray(surfaces, from + 1);
        const error = back.fromArray(field.normal, 3 * to).distanceTo(normal);
        report.normal = Math.max(report.normal, error);
        if (normal.toArray().some((c) => Math.abs(c) === 1)) {
          report.axisNormal = Math.max(report.axisNormal, error);
        }
      }
    }
  }
  target.dispose();
  renderer.dispose();
  return report;
}

function texture(data: Float32Array<ArrayBuffer>, width: number, height: number): DataTexture {
  const made = new DataTexture(data, width, height, undefined, FloatType);
  made.needsUpdate = true;
  return made;
}
