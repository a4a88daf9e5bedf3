import {
  BufferGeometry,
  OrthographicCamera,
  Float32BufferAttribute,
  Mesh,
  NoBlending,
  ShaderMaterial,
  type Texture,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { ATLAS_COLUMNS } from '../cube/atlas.js';
import type { AxisMaxima } from '../cube/AxisMaxima.js';
import { PrivateScene } from './PrivateScene.js';
import { createTexelTarget } from './texelTarget.js';

const vertexShader = /* glsl */ `
void main() {
  gl_Position = vec4( position.xy, 0.0, 1.0 );
}`;

/** For each face (x) and row (y): the highest red of the row and its column. */
const rowsShader = /* glsl */ `
uniform sampler2D texels;

void main() {
  ivec2 cell = ivec2( gl_FragCoord.xy );
  ivec2 from = ivec2( cell.x % ${ATLAS_COLUMNS}, cell.x / ${ATLAS_COLUMNS} ) * RESOLUTION + ivec2( 0, cell.y );
  float best = -1.0;
  int column = 0;
  int bestOff = 0;
  for ( int x = 0; x < RESOLUTION; x ++ ) {
    float red = texelFetch( texels, from + ivec2( x, 0 ), 0 ).r;
    int off = abs( 2 * x + 1 - RESOLUTION );
    if ( red > best || red == best && off < bestOff ) {
      best = red;
      column = x;
      bestOff = off;
    }
  }
  gl_FragColor = vec4( best, float( column ) / 255.0, 0.0, 1.0 );
}`;

/** For each face (x): the highest red of its rows, with column and row. */
const columnsShader = /* glsl */ `
uniform sampler2D texels;

void main() {
  int face = int( gl_FragCoord.x );
  float best = -1.0;
  vec2 place = vec2( 0.0 );
  int bestOff = 0;
  for ( int y = 0; y < RESOLUTION; y ++ ) {
    vec4 row = texelFetch( texels, ivec2( face, y ), 0 );
    int x = int( row.g * 255.0 + 0.5 );
    int offX = 2 * x + 1 - RESOLUTION;
    int offY = 2 * y + 1 - RESOLUTION;
    int off = offX * offX + offY * offY;
    if ( row.r > best || row.r == best && off < bestOff ) {
      best = row.r;
      place = vec2( row.g, float( y ) / 255.0 );
      bestOff = off;
    }
  }
  gl_FragColor = vec4( best, place, 1.0 );
}`;

/**
 * The paper's search for the highest red per face, (17)-(22), on the GPU: a pass over rows, a pass over what they leave,
 * and six texels (24 bytes) to read: red, column, row. Keeping the winner's place keeps its direction.
 *
 * Among equal reds the texel nearest to the face's middle wins: a wall met head-on pushes straight back.
 */
export class AxisPass {
  /** 6×1 texels, RGBA8: red, column, row of each face's winner. */
  readonly result: WebGLRenderTarget;
  readonly #rows: WebGLRenderTarget;
  readonly #rowsMaterial: ShaderMaterial;
  readonly #columnsMaterial: ShaderMaterial;
  readonly #triangle: Mesh<BufferGeometry, ShaderMaterial>;
  readonly #scene = new PrivateScene();
  readonly #camera = new OrthographicCamera();
  readonly #resolution: number;

  constructor(resolution: number, atlas: Texture) {
    this.#resolution = resolution;
    this.#rows = createTexelTarget(6, resolution, 'RGBA8', false);
    this.result = createTexelTarget(6, 1, 'RGBA8', false);
    this.#rowsMaterial = reduction('rows', rowsShader, resolution, atlas);
    this.#columnsMaterial = reduction('columns', columnsShader, resolution, this.#rows.texture);
    const geometry = new BufferGeometry();
    geometry.setAttribute(
      'position',
      new Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3),
    );
    this.#triangle = new Mesh(geometry, this.#rowsMaterial);
    this.#triangle.frustumCulled = false;
    this.#scene.add(this.#triangle);
  }

  /** Runs both passes; leaves `result` the current target, ready to be read. */
  reduce(renderer: WebGLRenderer): void {
    this.#triangle.material = this.#rowsMaterial;
    renderer.setRenderTarget(this.#rows);
    renderer.render(this.#scene, this.#camera);
    this.#triangle.material = this.#columnsMaterial;
    renderer.setRenderTarget(this.result);
    renderer.render(this.#scene, this.#camera);
  }

  /** Programs ready before the first frame. */
  compile(renderer: WebGLRenderer): void {
    for (const material of [this.#rowsMaterial, this.#columnsMaterial]) {
      this.#triangle.material = material;
      renderer.compile(this.#scene, this.#camera);
    }
  }

  /** Decodes the 24 bytes of `result`. Allocates nothing. */
  decode(bytes: Uint8Array, target: AxisMaxima): void {
    for (let face = 0; face < 6; face++) {
      const red = bytes[4 * face]! / 255;
      target.set(face, red, bytes[4 * face + 1]!, bytes[4 * face + 2]!, this.#resolution);
    }
  }

  dispose(): void {
    this.#rows.dispose();
    this.result.dispose();
    this.#rowsMaterial.dispose();
    this.#columnsMaterial.dispose();
    this.#triangle.geometry.dispose();
  }
}

function reduction(
  name: string,
  fragmentShader: string,
  resolution: number,
  texels: Texture,
): ShaderMaterial {
  return new ShaderMaterial({
    name: `CubeCollider maxima of ${name}`,
    vertexShader,
    fragmentShader,
    defines: { RESOLUTION: resolution },
    uniforms: { texels: { value: texels } },
    depthTest: false,
    depthWrite: false,
    blending: NoBlending,
    toneMapped: false,
  });
}
