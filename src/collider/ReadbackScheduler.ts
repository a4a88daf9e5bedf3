import { isSignalled } from './ReadbackRing.js';

/** Somebody who waits for a read. */
export interface ReadbackClient {
  /** Called once the copy is cheap, or the client was urgent; it is off the list then. */
  deliver(): void;
  /** True if the client's own read is through and it would rather copy now than wait for the queue to drain. */
  urgent(): boolean;
}

const schedulers = new WeakMap<WebGL2RenderingContext, ReadbackScheduler>();

/**
 * Finds the moments at which a read-back costs nothing: one for each context, shared by all its colliders.
 *
 * Behind the user's frame it puts a fence of its own (by a later task, since an app may render in several callbacks or
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
  readonly #clients: ReadbackClient[] = [];
  #drained: WebGLSync | null = null;
  #posted: ReturnType<typeof setTimeout> | null = null;
  #timer: ReturnType<typeof setTimeout> | null = null;
  #frame: number | null = null;

  private constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
  }

  /** Registers a client whose read was just started. */
  wait(client: ReadbackClient): void {
    if (!this.#clients.includes(client)) this.#clients.push(client);
    this.#frameBegan();
    this.#frame ??= requestAnimationFrame(this.#onFrame);
  }

  /** Takes a client off: it was disposed, or served itself. */
  cancel(client: ReadbackClient): void {
    const place = this.#clients.indexOf(client);
    if (place >= 0) this.#clients.splice(place, 1);
    if (this.#clients.length === 0) this.#rest();
  }

  /** A frame has begun: what was drained is not any more. */
  #frameBegan(): void {
    if (this.#drained !== null) this.#gl.deleteSync(this.#drained);
    this.#drained = null;
    // A timer's task comes after all of this frame's callbacks. (A MessageChannel's would too, but its open port would
    // keep the context alive for ever.)
    this.#posted ??= setTimeout(this.#afterFrame);
  }

  /** While a read is out, frames without a probe of ours fill the queue too. */
  readonly #onFrame = (): void => {
    this.#frame = null;
    if (this.#clients.length === 0) return;
    this.#frameBegan();
    this.#frame = requestAnimationFrame(this.#onFrame);
  };

  readonly #afterFrame = (): void => {
    this.#posted = null;
    if (this.#clients.length === 0) return;
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
    for (let i = this.#clients.length - 1; i >= 0; i--) {
      const client = this.#clients[i]!;
      if (!drained && !client.urgent()) continue;
      this.#clients.splice(i, 1);
      client.deliver();
    }
    if (this.#clients.length === 0) this.#rest();
    else this.#timer ??= setTimeout(this.#poll, 1);
  };

  #rest(): void {
    this.#clients.length = 0;
    if (this.#drained !== null) this.#gl.deleteSync(this.#drained);
    this.#drained = null;
    if (this.#timer !== null) clearTimeout(this.#timer);
    if (this.#posted !== null) clearTimeout(this.#posted);
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.#timer = this.#posted = this.#frame = null;
  }
}
