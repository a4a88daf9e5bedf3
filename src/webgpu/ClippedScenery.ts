import { ClippingGroup, type Object3D } from 'three/webgpu';
import type { ObjectProxy } from '../collider/objectProxy.js';

/** A user's group with our proxies in it. */
interface GroupProxy extends Object3D {
  children: Object3D[];
  /** Number of the draw it was filled for last. */
  draw: number;
}

/** Puts proxies under stand-ins for the `ClippingGroup`s that their objects are in: three clips by these alone. */
export class ClippedScenery {
  readonly #proxies = new WeakMap<Object3D, GroupProxy>();
  readonly #children: Object3D[] = [];
  #draw = 0;

  /** @returns what the private scene's children are to be; `proxies` itself where none is clipped */
  arrange(proxies: readonly ObjectProxy[]): Object3D[] {
    this.#draw++;
    this.#children.length = 0;
    let any = false;
    for (const proxy of proxies) {
      const siblings = this.#siblings(proxy.source.parent);
      any ||= siblings !== this.#children;
      siblings.push(proxy);
    }
    return any ? this.#children : (proxies as ObjectProxy[]);
  }

  /** The children of the stand-in for the innermost group at or above `object`. */
  #siblings(object: Object3D | null): Object3D[] {
    let group = object;
    while (group !== null && (group as Partial<ClippingGroup>).isClippingGroup !== true) {
      group = group.parent;
    }
    if (group === null) return this.#children;
    let proxy = this.#proxies.get(group);
    if (proxy === undefined) this.#proxies.set(group, (proxy = createGroupProxy(group)));
    if (proxy.draw !== this.#draw) {
      proxy.draw = this.#draw;
      proxy.children.length = 0;
      this.#siblings(group.parent).push(proxy);
    }
    return proxy.children;
  }
}

/** All it says of its planes is the user's, live. */
function createGroupProxy(group: Object3D): GroupProxy {
  const own = <T>(value: T) => ({ value, writable: true, enumerable: true, configurable: true });
  return Object.create(group, {
    parent: own(null),
    children: own([]),
    visible: own(true),
    layers: own(group.layers),
    renderOrder: own(0),
    draw: own(0),
    _listeners: own(undefined),
  }) as GroupProxy;
}
