import {
  CubeCamera,
  DoubleSide,
  FloatType,
  NearestFilter,
  type Scene,
  ShaderMaterial,
  type Vector3,
  WebGLCubeRenderTarget,
} from 'three';
import type { Rendering } from '../../../e2e/support/rendering.js';

/** Texels of a face's edge: as ours. */
const RESOLUTION = 32;

/**
 * The plain way: three's `CubeCamera` draws distances and normals by an override material, and each face is read by
 * itself.
 */
export function createCubeCamera({ renderer }: Rendering, scene: Scene, far: number) {
  const target = new WebGLCubeRenderTarget(RESOLUTION, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
  });
  const camera = new CubeCamera(0.01 * far, far, target);
  const material = new ShaderMaterial({
    side: DoubleSide,
    vertexShader: `varying vec3 place;
      #include <common>
      #include <batching_pars_vertex>
      #include <morphtarget_pars_vertex>
      #include <skinning_pars_vertex>
      void main() {
        #include <batching_vertex>
        #include <begin_vertex>
        #include <morphtarget_vertex>
        #include <skinbase_vertex>
        #include <skinning_vertex>
        #include <project_vertex>
        place = mvPosition.xyz;
      }`,
    fragmentShader: `varying vec3 place;
      void main() {
        vec3 normal = normalize( cross( dFdx( place ), dFdy( place ) ) );
        gl_FragColor = vec4( length( place ), normal );
      }`,
  });
  const texels = Array.from({ length: 6 }, () => new Float32Array(4 * RESOLUTION * RESOLUTION));
  return {
    see(center: Vector3): void {
      camera.position.copy(center);
      camera.updateMatrixWorld();
      const { overrideMaterial } = scene;
      scene.overrideMaterial = material;
      camera.update(renderer, scene);
      scene.overrideMaterial = overrideMaterial;
      for (let face = 0; face < 6; face++) {
        renderer.readRenderTargetPixels(target, 0, 0, RESOLUTION, RESOLUTION, texels[face]!, face);
      }
    },
    release(): void {
      target.dispose();
      material.dispose();
    },
  };
}
