import { isSignalled } from './ReadbackRing.js';

/** Somebody who waits for a read. */
export interface ReadbackClient {
  /** Called once the copy is cheap; the client copies and takes itself off by returning. */
  deliver(): void;
  /** True if the client would rather wait for its own read than for the queue to drain. */
  readonly urgent: boolean;
}

const schedulers = new WeakMap<WebGL2RenderingContext, ReadbackScheduler>();

/**
 * Finds the moments at which a read-back costs nothing: one for each context, shared by all its colliders.
 *
 * Behind the user's frame it puts a fence of its own (by a posted task, since an app may render in several callbacks or
 * after an await) and polls it between frames. When that fence has been passed, and no further frame has begun, the
 * GPU's queue is empty and a copy has nothing to wait for.
 */
export class ReadbackScheduler {
  static of(gl: WebGL2RenderingContext): ReadbackScheduler {
    let scheduler = schedulers.get(gl);
    if (scheduler === undefined) schedulers.set(gl, (scheduler = new ReadbackScheduler(gl)));
    return scheduler;
  }

  readonly #gl: WebGL2RenderingContext;
  readonly #clients = new Set<ReadbackClient>();
  readonly #channel = new MessageChannel();
  #drained: WebGLSync | null = null;
  #posted = false;
  #timer: ReturnType<typeof setTimeout> | null = null;
  #frame: number | null = null;

  private constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#channel.port1.onmessage = this.#afterFrame;
  }

  /** Registers a client whose read was just started. */
  wait(client: ReadbackClient): void {
    this.#clients.add(client);
    this.#frameBegan();
    this.#frame ??= requestAnimationFrame(this.#onFrame);
  }

  /** Takes a client off: it was disposed, or served itself. */
  cancel(client: ReadbackClient): void {
    this.#clients.delete(client);
    if (this.#clients.size === 0) this.#rest();
  }

  /** A frame has begun: what was drained is not any more. */
  #frameBegan(): void {
    if (this.#drained !== null) this.#gl.deleteSync(this.#drained);
    this.#drained = null;
    if (this.#posted) return;
    this.#posted = true;
    this.#channel.port2.postMessage(null);
  }

  /** While a read is out, frames without a probe of ours fill the queue too. */
  readonly #onFrame = (): void => {
    this.#frame = null;
    if (this.#clients.size === 0) return;
    this.#frameBegan();
    this.#frame = requestAnimationFrame(this.#onFrame);
  };

  readonly #afterFrame = (): void => {
    this.#posted = false;
    if (this.#clients.size === 0) return;
    const gl = this.#gl;
    if (gl.isContextLost()) return this.#rest();
    this.#drained = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    this.#timer ??= setTimeout(this.#poll, 1);
  };

  readonly #poll = (): void => {
    this.#timer = null;
    const gl = this.#gl;
    if (gl.isContextLost()) return this.#rest();
    const drained = this.#drained !== null && isSignalled(gl, this.#drained);
    for (const client of this.#clients) {
      if (!drained && !client.urgent) continue;
      this.#clients.delete(client);
      client.deliver();
    }
    if (this.#clients.size === 0) this.#rest();
    else this.#timer ??= setTimeout(this.#poll, 1);
  };

  #rest(): void {
    this.#clients.clear();
    if (this.#drained !== null) this.#gl.deleteSync(this.#drained);
    this.#drained = null;
    if (this.#timer !== null) clearTimeout(this.#timer);
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.#timer = this.#frame = null;
  }
}
