import { Controls, REVISION, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

export interface SmokeResult {
  revision: string;
  /** Whether the addons import the same copy of three as everybody else. */
  oneCopy: boolean;
  webgl2: boolean;
  renderer: string;
  floatBuffers: boolean;
}

/** What the page has to work with. */
export default function smoke(): SmokeResult {
  const renderer = new WebGLRenderer();
  const gl = renderer.getContext();
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const result = {
    revision: REVISION,
    oneCopy: OrbitControls.prototype instanceof Controls,
    webgl2: gl instanceof WebGL2RenderingContext,
    renderer: String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)),
    floatBuffers: gl.getExtension('EXT_color_buffer_float') !== null,
  };
  renderer.dispose();
  return result;
}
