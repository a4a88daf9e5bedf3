import { DrawStamp } from './DrawStamp.js';

/** A pixel-pack buffer for each texture and what is on its way in them. */
class PackBuffer extends DrawStamp {
  buffer: WebGLBuffer | null = null;
  /** For ids; a buffer of its own, since several browsers mishandle offsets into one. */
  idBuffer: WebGLBuffer | null = null;
  fence: WebGLSync | null = null;
  pending = false;
  /** Numbers of each that are on their way. */
  length = 0;
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
  /** The ids copied last, 4 numbers a texel, of which 2 are used; null if they have no texture of their own. */
  readonly ids: Uint32Array | null;
  readonly #gl: WebGL2RenderingContext;
  readonly #slots = Array.from({ length: SLOTS }, () => new PackBuffer());
  readonly #width: number;
  readonly #height: number;
  readonly #type: number;

  /**
   * @param float RGBA floats if true, RGBA bytes if not
   * @param ids whether a second texture, of whole numbers, is read too
   */
  constructor(
    gl: WebGL2RenderingContext,
    width: number,
    height: number,
    float: boolean,
    ids = false,
  ) {
    this.#gl = gl;
    this.#width = width;
    this.#height = height;
    this.#type = float ? gl.FLOAT : gl.UNSIGNED_BYTE;
    const length = 4 * width * height;
    this.data = float ? new Float32Array(length) : new Uint8Array(length);
    this.ids = ids ? new Uint32Array(length) : null;
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
    if (this.ids === null) return;
    gl.readBuffer(gl.COLOR_ATTACHMENT1);
    gl.readPixels(0, 0, this.#width, this.#height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, this.ids);
    gl.readBuffer(gl.COLOR_ATTACHMENT0);
  }

  /**
   * Starts reading the framebuffer bound now; returns false if no buffer is free.
   *
   * @param rows how many, from the lowest on
   */
  start(stamp: DrawStamp, rows = this.#height): boolean {
    let slot: PackBuffer | null = null;
    for (const candidate of this.#slots) if (!candidate.pending) slot = candidate;
    if (slot === null) return false;
    const gl = this.#gl;
    slot.buffer = this.#pack(slot.buffer, gl.RGBA, this.#type, this.data.byteLength, rows);
    if (this.ids !== null) {
      gl.readBuffer(gl.COLOR_ATTACHMENT1);
      slot.idBuffer = this.#pack(
        slot.idBuffer,
        gl.RGBA_INTEGER,
        gl.UNSIGNED_INT,
        this.ids.byteLength,
        rows,
      );
      gl.readBuffer(gl.COLOR_ATTACHMENT0);
    }
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    slot.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    slot.take(stamp);
    slot.pending = true;
    slot.length = 4 * this.#width * rows;
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
   * @param oldest copies the oldest instead, and drops none
   * @returns where, when and what was drawn (the table is the caller's to take), or null if none is on its way
   */
  finish(oldest = false): DrawStamp | null {
    const slot = oldest ? this.#oldest() : this.#newest();
    if (slot === null) return null;
    const gl = this.#gl;
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, slot.buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, this.data, 0, slot.length);
    if (this.ids !== null) {
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, slot.idBuffer);
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, this.ids, 0, slot.length);
    }
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    for (const other of this.#slots) {
      if (other.serial <= slot.serial) this.#drop(other, other === slot);
    }
    return slot;
  }

  /** Forgets the reads on their way. */
  drop(): void {
    for (const slot of this.#slots) this.#drop(slot, false);
  }

  dispose(): void {
    this.drop();
    for (const slot of this.#slots) {
      this.#gl.deleteBuffer(slot.buffer);
      this.#gl.deleteBuffer(slot.idBuffer);
      slot.buffer = slot.idBuffer = null;
    }
  }

  /** Copies from the read buffer into a pixel-pack buffer, on the GPU's side; leaves it bound. */
  #pack(
    buffer: WebGLBuffer | null,
    format: number,
    type: number,
    bytes: number,
    rows: number,
  ): WebGLBuffer {
    const gl = this.#gl;
    const target = buffer ?? gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, target);
    // STREAM_READ is no faster here and makes Chromium warn at every read.
    if (buffer === null) gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes, gl.STREAM_COPY);
    gl.readPixels(0, 0, this.#width, rows, format, type, 0);
    return target;
  }

  /** @param taken keeps its table: it is about to be decoded */
  #drop(slot: PackBuffer, taken: boolean): void {
    if (slot.fence !== null) this.#gl.deleteSync(slot.fence);
    slot.fence = null;
    slot.pending = false;
    if (!taken) slot.objects.clear();
  }

  #oldest(): PackBuffer | null {
    let oldest: PackBuffer | null = null;
    for (const slot of this.#slots) {
      if (slot.pending && (oldest === null || slot.serial < oldest.serial)) oldest = slot;
    }
    return oldest;
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
