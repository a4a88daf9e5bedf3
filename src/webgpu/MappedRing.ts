import { DrawStamp } from '../collider/DrawStamp.js';

/** Reads in flight at most: a third would only queue behind these. */
const READS = 2;
/** Rows in a buffer start at multiples of this, bytes. */
const ALIGNMENT = 256;
/** `GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST`, and `GPUMapMode.READ`. */
const READ_BUFFER = 0x1 | 0x8;
const READ = 0x1;

/** A buffer and what is on its way in it. */
class MappedBuffer extends DrawStamp {
  /** Wanted still: neither taken nor dropped. */
  pending = false;
  /** Its texels can be read. */
  mapped = false;
  /** The GPU has it. */
  busy = false;
  /** Rows that are on their way. */
  rows = 0;

  constructor(
    readonly buffer: GPUBuffer,
    readonly onMapped: () => void,
  ) {
    super();
  }
}

/**
 * The read of a WebGPU device, which never blocks: texels are copied into a buffer on the GPU's side, and the page is told
 * when that can be mapped. Buffers are made once, and used in turn.
 */
export class MappedRing {
  /** The texels copied last. */
  readonly data: Float32Array;
  readonly #device: GPUDevice;
  readonly #arrived: () => void;
  readonly #width: number;
  readonly #height: number;
  readonly #stride: number;
  readonly #slots: MappedBuffer[] = [];
  #disposed = false;

  /**
   * @param width in texels of four floats
   * @param arrived called when a read can be finished
   */
  constructor(device: GPUDevice, width: number, height: number, arrived: () => void) {
    this.#device = device;
    this.#arrived = arrived;
    this.#width = width;
    this.#height = height;
    this.#stride = Math.ceil((16 * width) / ALIGNMENT) * ALIGNMENT;
    this.data = new Float32Array(4 * width * height);
  }

  /** Reads on their way. */
  get inFlight(): number {
    let count = 0;
    for (const slot of this.#slots) if (slot.pending) count++;
    return count;
  }

  get free(): boolean {
    return this.inFlight < READS;
  }

  /**
   * Starts reading a texture of that size, or a buffer of one row.
   *
   * @param rows how many of a texture's, from the first on
   */
  start(source: GPUTexture | GPUBuffer, stamp: DrawStamp, rows = this.#height): void {
    const slot = this.#slots.find(({ busy }) => !busy) ?? this.#create();
    const encoder = this.#device.createCommandEncoder({ label: 'CubeCollider' });
    if ('createView' in source) {
      encoder.copyTextureToBuffer(
        { texture: source },
        { buffer: slot.buffer, bytesPerRow: this.#stride },
        [this.#width, rows],
      );
    } else {
      encoder.copyBufferToBuffer(source, 0, slot.buffer, 0, 16 * this.#width);
    }
    this.#device.queue.submit([encoder.finish()]);
    slot.take(stamp);
    slot.pending = slot.busy = true;
    slot.rows = rows;
    // It fails where the device was lost or the buffer destroyed: then nobody waits for it.
    slot.buffer.mapAsync(READ).then(slot.onMapped, () => {});
  }

  /**
   * Copies the newest read that has come and drops the older ones; those still on their way are newer.
   *
   * @param oldest copies the oldest that has come instead, and drops none
   */
  finish(oldest = false): DrawStamp | null {
    let chosen: MappedBuffer | null = null;
    for (const slot of this.#slots) {
      if (!slot.pending || !slot.mapped) continue;
      if (chosen === null || slot.serial > chosen.serial !== oldest) chosen = slot;
    }
    if (chosen === null) return null;
    this.#copy(chosen.buffer.getMappedRange(), chosen.rows);
    for (const slot of this.#slots) {
      if (slot === chosen || (!oldest && slot.pending && slot.serial < chosen.serial)) {
        this.#drop(slot, slot !== chosen);
      }
    }
    return chosen;
  }

  /** Forgets the reads on their way. */
  drop(): void {
    for (const slot of this.#slots) if (slot.pending) this.#drop(slot, true);
  }

  dispose(): void {
    this.drop();
    this.#disposed = true;
    for (const slot of this.#slots) slot.buffer.destroy();
    this.#slots.length = 0;
  }

  /** Without the rows' padding. */
  #copy(mapped: ArrayBuffer, rows: number): void {
    const { data } = this;
    const row = 4 * this.#width;
    if (this.#stride === 4 * row) {
      data.set(new Float32Array(mapped, 0, rows * row));
      return;
    }
    for (let y = 0; y < rows; y++) {
      data.set(new Float32Array(mapped, y * this.#stride, row), y * row);
    }
  }

  #drop(slot: MappedBuffer, clear: boolean): void {
    slot.pending = false;
    if (clear) slot.objects.clear();
    if (slot.mapped) this.#release(slot);
  }

  #release(slot: MappedBuffer): void {
    slot.buffer.unmap();
    slot.mapped = slot.busy = false;
  }

  #create(): MappedBuffer {
    const buffer = this.#device.createBuffer({
      label: 'CubeCollider',
      size: this.#stride * this.#height,
      usage: READ_BUFFER,
    });
    const slot = new MappedBuffer(buffer, () => {
      if (this.#disposed) return;
      slot.mapped = true;
      if (slot.pending) this.#arrived();
      else this.#release(slot);
    });
    this.#slots.push(slot);
    return slot;
  }
}
