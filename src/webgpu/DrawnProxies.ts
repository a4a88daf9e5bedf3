import type { Material } from 'three/webgpu';
import { isDerived } from '../collider/derivedMaterial.js';
import type { ObjectProxy } from '../collider/objectProxy.js';

/** Draws for which what an object needs on the GPU is kept though it is out of reach: ten seconds and more. */
const KEPT = 600;
/** Draws between two looks for such. */
const EVERY = 64;

/**
 * three keeps bindings and programs for each object and material until either is disposed of. The user's objects often
 * never are, and our material for plain ones lives as long as the collider: so proxies that were not drawn for long, or
 * whose own material was disposed of, say that they are.
 */
export class DrawnProxies {
  /** In which draw each was drawn last. */
  readonly #drawn = new Map<ObjectProxy, number>();
  #draw = 0;

  /** Before each draw. */
  note(proxies: readonly ObjectProxy[]): void {
    const draw = ++this.#draw;
    for (let i = 0; i < proxies.length; i++) this.#drawn.set(proxies[i]!, draw);
    if (draw % EVERY === 0) this.#sweep();
  }

  /** The user has disposed of a material. */
  free(source: Material): void {
    for (const proxy of this.#drawn.keys()) {
      const { material } = proxy.source;
      if (Array.isArray(material) ? material.includes(source) : material === source) {
        this.#free(proxy);
      }
    }
  }

  clear(): void {
    for (const proxy of this.#drawn.keys()) this.#free(proxy);
  }

  #sweep(): void {
    for (const [proxy, drawn] of this.#drawn) {
      if (this.#draw - drawn <= KEPT) continue;
      // A program of its own goes with the user's material alone: it would have to be made anew.
      if (wearsDerived(proxy)) this.#drawn.delete(proxy);
      else this.#free(proxy);
    }
  }

  #free(proxy: ObjectProxy): void {
    this.#drawn.delete(proxy);
    proxy.dispatchEvent({ type: 'dispose' } as never);
  }
}

function wearsDerived({ material }: ObjectProxy): boolean {
  return Array.isArray(material) ? material.some(isDerived) : isDerived(material);
}
