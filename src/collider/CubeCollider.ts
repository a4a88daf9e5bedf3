import type { WebGLRenderer, WebGLRenderTarget } from 'three';
import type { Warnings } from '../Warnings.js';
import { ColliderBase } from './ColliderBase.js';
import {
  type CubeColliderOptions,
  type CubeColliderSettings,
  resolveOptions,
} from './CubeColliderOptions.js';
import type { CubemapDevice, DeviceClient } from './CubemapDevice.js';
import { WebGLDevice } from './WebGLDevice.js';

/**
 * A depth cubemap around a point, read back: what the GPU draws within reach, as surfaces to collide with.
 *
 * Like three's `CubeCamera` it is an `Object3D` placed where it shall look from, and `update` draws it. Unlike it, it
 * draws all faces in one pass, leaves the renderer as it found it, and gives numbers.
 *
 * ```js
 * const collider = new CubeCollider({ far: 2 });
 * renderer.setAnimationLoop(() => {
 *   collider.position.copy(player.position);
 *   collider.update(renderer, scene);
 *   if (collider.field) console.log(collider.field.distance[0]);
 *   renderer.render(scene, camera);
 * });
 * ```
 *
 * Constructor mistakes throw. `update` never does: without renderer or scene, disposed, or with its context lost, it
 * warns once and leaves what is there.
 */
export class CubeCollider extends ColliderBase<WebGLRenderer> {
  constructor(options: CubeColliderOptions = {}) {
    super(resolveOptions(options));
  }

  override get renderTarget(): WebGLRenderTarget | null {
    return super.renderTarget as WebGLRenderTarget | null;
  }

  protected override faultOf(renderer: WebGLRenderer): string | null {
    const given = renderer as { isWebGLRenderer?: boolean; isRenderer?: boolean } | undefined;
    if (given?.isRenderer === true) {
      return "update(renderer, scene) needs a WebGLRenderer; for WebGPURenderer import CubeCollider from 'three-cube-collider/webgpu'.";
    }
    if (given?.isWebGLRenderer !== true) return 'update(renderer, scene) needs a WebGLRenderer.';
    return renderer.getContext().isContextLost() ? '' : null;
  }

  protected override createDevice(
    renderer: WebGLRenderer,
    settings: CubeColliderSettings,
    client: DeviceClient,
    warnings: Warnings,
  ): CubemapDevice<WebGLRenderer> {
    return new WebGLDevice(renderer, settings, client, warnings);
  }
}
