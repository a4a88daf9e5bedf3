import { FloatType, NearestFilter, NoColorSpace, RenderTarget, RGBAFormat } from 'three/webgpu';

/** A target of plain float texels: nearest, no mipmaps, no antialiasing. */
export function createFloatTarget(
  width: number,
  height: number,
  depthBuffer: boolean,
): RenderTarget {
  return new RenderTarget(width, height, {
    type: FloatType,
    format: RGBAFormat,
    colorSpace: NoColorSpace,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer,
    stencilBuffer: false,
    samples: 0,
  });
}
