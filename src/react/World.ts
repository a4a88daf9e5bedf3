import { createContext } from 'react';
import type { ColliderBase } from '../collider/ColliderBase.js';
import { CubeCollider } from '../collider/CubeCollider.js';
import { CubeColliderGroup, type CubeColliderGroupOptions } from '../collider/CubeColliderGroup.js';
import type { CubeColliderOptions } from '../collider/CubeColliderOptions.js';
import type { OwnedCollider, Walker } from './Walker.js';

/** Makes colliders: `CubeCollider` of either entry. */
export type ColliderClass = new (options?: CubeColliderOptions) => OwnedCollider;

/** What the characters below a `<CubeColliderProvider>` share. */
export class World {
  type: ColliderClass = CubeCollider;
  options: CubeColliderOptions = {};
  groupOptions: CubeColliderGroupOptions | null = null;
  paused = false;

  readonly #walkers: Walker[] = [];
  readonly #listeners = new Set<() => void>();
  /** There while it has colliders: what is mounted twice must not find it disposed of. */
  #group: CubeColliderGroup<unknown> | null = null;
  #grouped = 0;

  /** The character that was mounted first; null while there is none. */
  readonly first = (): Walker | null => this.#walkers[0] ?? null;

  readonly subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  };

  add(walker: Walker): void {
    this.#walkers.push(walker);
    this.#tell();
  }

  remove(walker: Walker): void {
    this.#walkers.splice(this.#walkers.indexOf(walker), 1);
    this.#tell();
  }

  /** A collider of the world's class, with its options beneath `own`. */
  createCollider(own: CubeColliderOptions | undefined): OwnedCollider {
    const collider = new this.type({ ...this.options, ...own });
    if (this.groupOptions !== null) {
      this.#group ??= new CubeColliderGroup(this.groupOptions);
      this.#group.add(collider as unknown as ColliderBase<unknown>);
      this.#grouped++;
    }
    return collider;
  }

  /** Lets a disposed collider go. */
  release(collider: OwnedCollider): void {
    const group = this.#group;
    if (group === null) return;
    group.remove(collider as unknown as ColliderBase<unknown>);
    this.#grouped--;
    if (this.#grouped > 0) return;
    group.dispose();
    this.#group = null;
  }

  /** Draws the cubemaps that were asked for, where they are drawn together. */
  draw(renderer: unknown, scene: Parameters<CubeColliderGroup<unknown>['update']>[1]): void {
    this.#group?.update(renderer, scene);
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }
}

/** The world of the nearest provider; null without one. */
export const WorldContext = /* @__PURE__ */ createContext<World | null>(null);

/** The character that a component is a child of. */
export const WalkerContext = /* @__PURE__ */ createContext<Walker | null>(null);
