import {
  BackSide,
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  RedFormat,
  RepeatWrapping,
  ShaderMaterial,
  SphereGeometry,
  type Color,
  type Vector3,
} from 'three';

export interface SkyOptions {
  /** Unit vector toward the sun. */
  sun: Vector3;
  horizon: Color;
  zenith: Color;
  /** The light around the sun. */
  glow: Color;
}

/** A dome infinitely far away: a gradient, a glow where the sun is, a few thin clouds. Not solid, and never culled. */
export function createSky({ sun, horizon, zenith, glow }: SkyOptions): Mesh {
  const material = new ShaderMaterial({
    name: 'sky',
    side: BackSide,
    depthWrite: false,
    fog: false,
    uniforms: {
      sun: { value: sun },
      horizon: { value: horizon },
      zenith: { value: zenith },
      glow: { value: glow },
      clouds: { value: cloudTexture() },
    },
    vertexShader: /* glsl */ `
      varying vec3 vDirection;
      void main() {
        vDirection = position;
        gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0);
        // On the far plane, whatever the camera's range is.
        gl_Position.z = gl_Position.w * 0.999999;
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 vDirection;
      uniform vec3 sun, horizon, zenith, glow;
      uniform sampler2D clouds;
      void main() {
        vec3 direction = normalize(vDirection);
        float height = max(direction.y, 0.0);
        float low = (1.0 - height) * (1.0 - height);
        vec3 color = mix(zenith, horizon, low * (1.0 - 0.4 * height));
        float toSun = max(dot(direction, sun), 0.0);
        float near = toSun * toSun * toSun;
        color += glow * (0.22 * near * near + 6.0 * smoothstep(0.9993, 0.9997, toSun));
        // Clouds lie on a plane overhead, and thin out toward the horizon.
        float cloud = texture2D(clouds, direction.xz / (height + 0.12) * 0.11).r;
        color = mix(color, vec3(1.0, 0.97, 0.93), 0.75 * cloud * smoothstep(0.03, 0.3, height));
        gl_FragColor = vec4(color, 1.0);
        #include <tonemapping_fragment>
        #include <colorspace_fragment>
      }`,
  });
  const sky = new Mesh(new SphereGeometry(1, 32, 16), material);
  sky.name = 'sky';
  sky.frustumCulled = false;
  sky.renderOrder = 1; // after the level: only what it left open is shaded
  sky.userData.collider = false;
  return sky;
}

/** A tile of cover, 0 to 1, from five octaves of value noise; drawn out along x like wind does. */
function cloudTexture(): DataTexture {
  const size = 256;
  const data = new Uint8Array(size * size);
  for (let y = 0; y < size; y++)
    for (let x = 0; x < size; x++) {
      let sum = 0;
      for (let octave = 0, weight = 0.5; octave < 5; octave++, weight /= 2) {
        const cells = 3 << octave;
        sum += weight * tileNoise((x / size) * cells, (y / size) * 2 * cells, cells, octave);
      }
      const cover = Math.min(1, Math.max(0, (sum - 0.5) / 0.32));
      data[y * size + x] = 255 * cover * cover * (3 - 2 * cover);
    }
  const texture = new DataTexture(data, size, size, RedFormat);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

/** Smooth noise in 0 to 1 that repeats every `cells` along x and every 2 × `cells` along y. */
function tileNoise(x: number, y: number, cells: number, seed: number): number {
  const [ix, iy] = [Math.floor(x), Math.floor(y)];
  const smooth = (t: number) => t * t * (3 - 2 * t);
  const [fx, fy] = [smooth(x - ix), smooth(y - iy)];
  const at = (dx: number, dy: number) => {
    const sine = Math.sin(
      ((ix + dx) % cells) * 127.1 + ((iy + dy) % (2 * cells)) * 311.7 + seed * 74.7,
    );
    const spread = sine * 43758.5453;
    return spread - Math.floor(spread);
  };
  const low = at(0, 0) + (at(1, 0) - at(0, 0)) * fx;
  const high = at(0, 1) + (at(1, 1) - at(0, 1)) * fx;
  return low + (high - low) * fy;
}
