import type { WebGPURenderer } from 'three/webgpu';
import { ColliderBase } from '../collider/ColliderBase.js';
import {
  type CubeColliderOptions,
  type CubeColliderSettings,
  resolveOptions,
} from '../collider/CubeColliderOptions.js';
import type { CubemapDevice, DeviceClient } from '../collider/CubemapDevice.js';
import { backendOf } from './backendOf.js';
import { isLost } from './deviceLoss.js';
import { WebGPUDevice } from './WebGPUDevice.js';

/** What three keeps of a renderer's state and does not tell in its types. */
interface RendererParts {
  isWebGLRenderer?: boolean;
  isRenderer?: boolean;
  initialized?: boolean;
  _isDeviceLost?: boolean;
}

/**
 * The same collider for `WebGPURenderer`, on its WebGPU backend and on its WebGL 2 fallback: class, options, field and
 * promises are those of the root entry's `CubeCollider`.
 *
 * ```js
 * import { CubeCollider } from 'three-cube-collider/webgpu';
 *
 * const collider = new CubeCollider({ far: 2 });
 * renderer.setAnimationLoop(() => {
 *   collider.position.copy(player.position);
 *   collider.update(renderer, scene);
 *   renderer.render(scene, camera);
 * });
 * ```
 *
 * WebGPU cannot wait for a read, so there is no `readback: 'sync'`; `await collider.updateAsync(renderer, scene)` where a
 * field must be there. Texels are RGBA32F. Until the renderer is initialised, and once its device is lost, `update` does
 * nothing; given a new renderer, it goes on.
 */
export class CubeCollider extends ColliderBase<WebGPURenderer> {
  /** @throws TypeError for `readback: 'sync'`, and as the root entry's */
  constructor(options: CubeColliderOptions = {}) {
    if (options.readback === 'sync') {
      throw new TypeError(
        'CubeCollider: WebGPU has no synchronous read; leave "readback" at \'async\' and await collider.updateAsync(renderer, scene) where a field must be there.',
      );
    }
    super(resolveOptions({ ...options, readback: 'async' }));
  }

  protected override faultOf(renderer: WebGPURenderer): string | null {
    const given = renderer as unknown as RendererParts | undefined;
    if (given?.isWebGLRenderer === true) {
      return "update(renderer, scene) needs a WebGPURenderer; for WebGLRenderer import CubeCollider from 'three-cube-collider'.";
    }
    if (given?.isRenderer !== true) return 'update(renderer, scene) needs a WebGPURenderer.';
    if (given.initialized === false) return '';
    if (given._isDeviceLost === true || isLost(renderer)) {
      return 'the renderer has lost its device; give it a new one.';
    }
    const { gl } = backendOf(renderer);
    if (gl === undefined) return null;
    return gl.getExtension('EXT_color_buffer_float') !== null
      ? null
      : "this WebGL 2 cannot draw floats; take WebGLRenderer and CubeCollider from 'three-cube-collider'.";
  }

  protected override createDevice(
    renderer: WebGPURenderer,
    settings: CubeColliderSettings,
    client: DeviceClient,
  ): CubemapDevice<WebGPURenderer> {
    return new WebGPUDevice(renderer, settings, client);
  }
}
