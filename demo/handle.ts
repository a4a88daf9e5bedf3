import type { Player } from './Player.js';
import type { World } from './World.js';

/** The page's parts for the console and for tests, with those that are exchanged as they are when asked for. */
export function handleOf<Parts extends object>(parts: Parts, player: Player, world: World) {
  const changing = {
    get collider() {
      return player.collider;
    },
    get character() {
      return player.character;
    },
    get level() {
      return world.level;
    },
    get movers() {
      return world.movers;
    },
    get hall() {
      return world.hall;
    },
  };
  return Object.assign(changing, parts);
}
