import type { WebGPURenderer } from 'three/webgpu';
import { backendOf } from './backendOf.js';

/** What is told of a device that goes. */
interface DeviceLoss {
  readonly lost: boolean;
  /** Called when it is. */
  readonly listeners: Set<() => void>;
}

const losses = /* @__PURE__ */ new WeakMap<GPUDevice, DeviceLoss>();

/**
 * One for each device, since a promise never lets go of who waits for it. three tells of no device that was destroyed,
 * and of no other either where the user has an `onDeviceLost` of their own.
 */
function lossOf(device: GPUDevice): DeviceLoss {
  let loss = losses.get(device);
  if (loss === undefined) {
    const made = { lost: false, listeners: new Set<() => void>() };
    losses.set(device, (loss = made));
    void device.lost.then(() => {
      made.lost = true;
      for (const listener of [...made.listeners]) listener();
    });
  }
  return loss;
}

/** Has the device, or the fallback's context, gone? */
export function isLost(renderer: WebGPURenderer): boolean {
  const { device, gl } = backendOf(renderer);
  if (gl !== undefined) return gl.isContextLost();
  return device === undefined || lossOf(device).lost;
}

/** @returns to be called when nobody wants to know any more */
export function watchLoss(renderer: WebGPURenderer, lost: () => void): () => void {
  const { device } = backendOf(renderer);
  if (device !== undefined) {
    const { listeners } = lossOf(device);
    listeners.add(lost);
    return () => listeners.delete(lost);
  }
  const { domElement } = renderer;
  domElement.addEventListener('webglcontextlost', lost);
  return () => domElement.removeEventListener('webglcontextlost', lost);
}
