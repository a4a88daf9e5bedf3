import { Vector3 } from 'three';

/** When and where the texels of a read were drawn. */
export interface DrawStamp {
  readonly center: Vector3;
  /** `performance.now()` milliseconds. */
  time: number;
  /** Number of the draw. */
  serial: number;
  /** Number of the update that drew. */
  update: number;
}

/** One pixel-pack buffer and what is on its way in it. */
class PackBuffer implements DrawStamp {
  readonly center = new Vector3();
  time = 0;
  serial = 0;
  update = 0;
  buffer: WebGLBuffer | null = null;
  fence: WebGLSync | null = null;
  pending = false;
}

/** Reads in flight at most: a third would only queue behind these. */
const SLOTS = 2;

/**
 * The asynchronous read: texels are copied into a pixel-pack buffer on the GPU's side, and from there to the processor
 * when that costs nothing. It decides nothing about when; see `ReadbackScheduler`.
 *
 * `getBufferSubData` is a round trip that waits for everything queued before it, a signalled fence of the read or not
 * (docs/architecture.md, "The read-back"), so a copy is cheap only once the whole queue has drained.
 */
export class ReadbackRing {
  /** The texels copied last. */
  readonly data: Float32Array | Uint8Array;
  readonly #gl: WebGL2RenderingContext;
  readonly #slots = Array.from({ length: SLOTS }, () => new PackBuffer());
  readonly #width: number;
  readonly #height: number;
  readonly #type: number;

  /** @param float RGBA floats if true, RGBA bytes if not */
  constructor(gl: WebGL2RenderingContext, width: number, height: number, float: boolean) {
    this.#gl = gl;
    this.#width = width;
    this.#height = height;
    this.#type = float ? gl.FLOAT : gl.UNSIGNED_BYTE;
    const length = 4 * width * height;
    this.data = float ? new Float32Array(length) : new Uint8Array(length);
  }

  /** Reads on their way. */
  get inFlight(): number {
    let count = 0;
    for (const slot of this.#slots) if (slot.pending) count++;
    return count;
  }

  /** False while as many reads as there are buffers are on their way. */
  get free(): boolean {
    return this.inFlight < SLOTS;
  }

  /** Reads the framebuffer bound now into `data`, waiting for the GPU. */
  readNow(): void {
    const gl = this.#gl;
    gl.readPixels(0, 0, this.#width, this.#height, gl.RGBA, this.#type, this.data);
  }

  /** Starts reading the framebuffer bound now; returns false if no buffer is free. */
  start(stamp: DrawStamp): boolean {
    let slot: PackBuffer | null = null;
    for (const candidate of this.#slots) if (!candidate.pending) slot = candidate;
    if (slot === null) return false;
    const gl = this.#gl;
    if (slot.buffer === null) {
      slot.buffer = gl.createBuffer();
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, slot.buffer);
      // STREAM_READ is no faster here and makes Chromium warn at every read.
      gl.bufferData(gl.PIXEL_PACK_BUFFER, this.data.byteLength, gl.STREAM_COPY);
    } else {
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, slot.buffer);
    }
    gl.readPixels(0, 0, this.#width, this.#height, gl.RGBA, this.#type, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    slot.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    slot.center.copy(stamp.center);
    slot.time = stamp.time;
    slot.serial = stamp.serial;
    slot.update = stamp.update;
    slot.pending = true;
    return true;
  }

  /** True once the newest read's own fence has been passed: its texels exist, though a copy may still have to wait. */
  get fenced(): boolean {
    const newest = this.#newest();
    return newest !== null && newest.fence !== null && isSignalled(this.#gl, newest.fence);
  }

  /**
   * Copies the newest read on its way into `data` and drops the older ones, waiting for the GPU if it must.
   *
   * @returns where and when it was drawn, or null if none is on its way
   */
  finish(): DrawStamp | null {
    const newest = this.#newest();
    if (newest === null) return null;
    const gl = this.#gl;
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, newest.buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, this.data);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    this.drop();
    return newest;
  }

  /** Forgets the reads on their way. */
  drop(): void {
    for (const slot of this.#slots) {
      if (slot.fence !== null) this.#gl.deleteSync(slot.fence);
      slot.fence = null;
      slot.pending = false;
    }
  }

  dispose(): void {
    this.drop();
    for (const slot of this.#slots) {
      this.#gl.deleteBuffer(slot.buffer);
      slot.buffer = null;
    }
  }

  #newest(): PackBuffer | null {
    let newest: PackBuffer | null = null;
    for (const slot of this.#slots) {
      if (slot.pending && (newest === null || slot.serial > newest.serial)) newest = slot;
    }
    return newest;
  }
}

/** Asks, without waiting, whether the GPU has passed a fence. */
export function isSignalled(gl: WebGL2RenderingContext, fence: WebGLSync): boolean {
  const status = gl.clientWaitSync(fence, 0, 0);
  return status === gl.ALREADY_SIGNALED || status === gl.CONDITION_SATISFIED;
}
