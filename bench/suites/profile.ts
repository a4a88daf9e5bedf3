import { Vector3 } from 'three';
import type { Backend } from '../../e2e/support/rendering.js';
import { Inputs } from '../walk/Inputs.js';
import { enterOurs } from './crowd.js';
import { MeteredCharacter } from './MeteredCharacter.js';
import { tryRendering } from './ours.js';
import { FRAME } from './pace.js';
import { levelPlace, terrainPlace } from './places.js';

/** Frames after it was placed for a walker to come to rest. */
const SETTLING = 90;

/** What is made ready, warmed up, and then walked while the browser's profiler looks on. */
export type ProfileRequest =
  | { do: 'enter'; backend: Backend; level?: { name: string; url: string }; characters: number }
  | { do: 'walk'; round: number; frames: number };

interface Subject {
  walk(round: number, frames: number): Promise<void>;
}

let subject: Subject | null = null;

/** @returns after 'enter', the names of the GPU's functions; null where this browser has no such backend */
export default async function profile(request: ProfileRequest): Promise<string[] | null> {
  if (request.do === 'walk') {
    await subject!.walk(request.round, request.frames);
    return null;
  }
  subject = request.characters > 1 ? await enterCrowd(request) : await enterOne(request);
  return subject && gpuCalls();
}

/** As a profile names them. */
function gpuCalls(): string[] {
  const interfaces = Object.getOwnPropertyNames(window).filter((name) => /^(GPU|WebGL)/.test(name));
  return interfaces.flatMap((name) => {
    const { prototype } = window[name as keyof Window] as { prototype?: object };
    return prototype ? Object.getOwnPropertyNames(prototype) : [];
  });
}

type Entry = Extract<ProfileRequest, { do: 'enter' }>;

async function enterOne({ backend, level }: Entry): Promise<Subject | null> {
  const place = level ? await levelPlace(level) : terrainPlace('10k triangles', 10_000);
  const metered = await MeteredCharacter.create(backend, place.scene, place.start(0));
  if (metered === null) return null;
  const still = new Vector3();
  return {
    walk: (round, frames) =>
      metered.watched(async () => {
        metered.character.teleport(place.start(round));
        for (let i = 0; i < SETTLING; i++) {
          await metered.frame(still, false);
          if (i > 2 && metered.character.grounded) break;
        }
        const inputs = new Inputs(1 + round, new Vector3());
        for (let i = 0; i < frames; i++) {
          const { velocity, jump } = inputs.advanceTo(i * FRAME);
          await metered.frame(velocity, jump);
        }
      }),
  };
}

async function enterCrowd({ backend, characters }: Entry): Promise<Subject | null> {
  const rendering = await tryRendering(backend);
  if (rendering === null) return null;
  const place = terrainPlace('10k triangles', 10_000);
  const crowd = await enterOurs(rendering, place, characters, true);
  await crowd.place();
  return {
    async walk(round, frames) {
      const inputs = Array.from(
        { length: characters },
        (_, i) => new Inputs(1 + i + round * characters, new Vector3()),
      );
      await crowd.walk(inputs, frames);
    },
  };
}
