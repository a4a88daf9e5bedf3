import {
  FloatType,
  HalfFloatType,
  NearestFilter,
  RGBAFormat,
  type TextureDataType,
  RGIntegerFormat,
  UnsignedByteType,
  UnsignedIntType,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { TEXEL_FORMATS, type TexelFormat } from '../cube/encoding.js';

const TYPES: Record<TexelFormat, TextureDataType> = {
  RGBA32F: FloatType,
  RGBA16F: HalfFloatType,
  RGBA8: UnsignedByteType,
};

/**
 * A target of plain texels: nearest, no mipmaps, no antialiasing.
 *
 * @param ids whether it has a second texture beside, RG32UI, for objects' and instances' numbers
 */
export function createTexelTarget(
  width: number,
  height: number,
  format: TexelFormat,
  depthBuffer: boolean,
  ids = false,
): WebGLRenderTarget {
  const target = new WebGLRenderTarget(width, height, {
    type: TYPES[format],
    format: RGBAFormat,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
    depthBuffer,
    stencilBuffer: false,
    samples: 0,
    count: ids ? 2 : 1,
  });
  if (ids) {
    target.textures[1]!.format = RGIntegerFormat;
    target.textures[1]!.type = UnsignedIntType;
  }
  return target;
}

const ZERO = new Float32Array(4);
const NOTHING = new Uint32Array(4);
const depthValue = new Float32Array(1);

/** Makes `target` current and clears it to zeros and farthest depth, without touching the context's clear values. */
export function clearTexels(renderer: WebGLRenderer, target: WebGLRenderTarget): void {
  renderer.setRenderTarget(target);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { color, depth } = renderer.state.buffers;
  color.setMask(true);
  depth.setMask(true);
  depthValue[0] = depth.getReversed() ? 0 : 1;
  gl.clearBufferfv(gl.COLOR, 0, ZERO);
  if (target.textures.length > 1) gl.clearBufferuiv(gl.COLOR, 1, NOTHING);
  gl.clearBufferfv(gl.DEPTH, 0, depthValue);
}

/**
 * The best texel format this context can really draw and read: each is tried on one texel, since extensions promise
 * more than some devices keep. RGBA8 always works.
 *
 * It changes bindings that three does not track between renders (framebuffer, texture), so it restores them.
 */
export function bestTexelFormat(gl: WebGL2RenderingContext): TexelFormat {
  return TEXEL_FORMATS.find((format) => canDraw(gl, format))!;
}

/** True if a framebuffer of this format can be cleared to a value and read back as it. */
export function canDraw(gl: WebGL2RenderingContext, format: TexelFormat): boolean {
  if (format === 'RGBA8') return true;
  const float = gl.getExtension('EXT_color_buffer_float');
  const half = gl.getExtension('EXT_color_buffer_half_float');
  if (!float && !(half && format === 'RGBA16F')) return false;

  const oldTexture = gl.getParameter(gl.TEXTURE_BINDING_2D) as WebGLTexture | null;
  const oldDraw = gl.getParameter(gl.DRAW_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  const oldRead = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
  const texture = gl.createTexture();
  const framebuffer = gl.createFramebuffer();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format === 'RGBA32F' ? gl.RGBA32F : gl.RGBA16F, 1, 1);
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  let works = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
  if (works) {
    const scissor = gl.isEnabled(gl.SCISSOR_TEST);
    const mask = gl.getParameter(gl.COLOR_WRITEMASK) as boolean[];
    gl.disable(gl.SCISSOR_TEST);
    gl.colorMask(true, true, true, true);
    // 2047 needs all of a half float's bits; -0.5 would not survive a normalised format.
    gl.clearBufferfv(gl.COLOR, 0, [2047, -0.5, 1, 0]);
    // A failed read leaves it as it is. (An error asked for here might be the user's own.)
    const texel = new Float32Array(4).fill(NaN);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, texel);
    works = texel[0] === 2047 && texel[1] === -0.5;
    if (scissor) gl.enable(gl.SCISSOR_TEST);
    gl.colorMask(mask[0]!, mask[1]!, mask[2]!, mask[3]!);
  }
  gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, oldDraw);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, oldRead);
  gl.bindTexture(gl.TEXTURE_2D, oldTexture);
  gl.deleteFramebuffer(framebuffer);
  gl.deleteTexture(texture);
  return works;
}
