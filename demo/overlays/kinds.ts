import { HELPER_COLORS as COLORS } from 'three-cube-collider/helpers';

/** The ends of the cubemap's scale, and what is beyond. */
const [NEAR, FAR, NOTHING] = [0xfde725, 0x440154, 0x05070a];

/** What can be shown of what the collider sees. */
export type OverlayName =
  'cubemap' | 'contacts' | 'surfels' | 'free' | 'body' | 'timeline' | 'numbers';

export interface OverlayKind {
  readonly name: OverlayName;
  /** `KeyboardEvent.code`, and what stands on the key. */
  readonly code: string;
  readonly key: string;
  readonly label: string;
  /** What one sees, in a line of plain words. */
  readonly line: string;
  /** More of it, for who points at it. */
  readonly more: string;
  /** What its colours mean. */
  readonly legend?: readonly (readonly [color: number, meaning: string])[];
}

export const OVERLAYS: readonly OverlayKind[] = [
  {
    name: 'cubemap',
    code: 'KeyH',
    key: 'H',
    label: 'Cubemap',
    line: 'The character sees only this.',
    more: 'Six tiny pictures of what is near, one to each side of a cube, unfolded.',
    legend: [
      [NEAR, 'near'],
      [FAR, 'far'],
      [NOTHING, 'nothing'],
    ],
  },
  {
    name: 'surfels',
    code: 'Digit1',
    key: '1',
    label: 'Surfaces',
    line: 'What came back: all it walks against.',
    more: 'A disc for each texel that was read back, as large as the texel there.',
    legend: [
      [COLORS.floor, 'floor'],
      [COLORS.wall, 'wall'],
      [COLORS.ceiling, 'ceiling'],
      [COLORS.back, 'back'],
    ],
  },
  {
    name: 'contacts',
    code: 'Digit2',
    key: '2',
    label: 'Contacts',
    line: 'Where it touches; arrows point away.',
    more: 'Each arrow stands where the body touches a surface, along its normal, in its colour.',
  },
  {
    name: 'free',
    code: 'Digit3',
    key: '3',
    label: 'Free space',
    line: 'All within the net was seen to be free.',
    more: 'Before it goes beyond the net, the character waits for another cubemap.',
  },
  {
    name: 'body',
    code: 'Digit4',
    key: '4',
    label: 'Body',
    line: 'What collides, and the gap it keeps.',
    more: 'A capsule; crouch, and it shrinks. Held: it waits, or has no room.',
    legend: [
      [COLORS.grounded, 'standing'],
      [COLORS.airborne, 'in the air'],
      [COLORS.held, 'held'],
    ],
  },
  {
    name: 'timeline',
    code: 'Digit5',
    key: '5',
    label: 'Read-backs',
    line: 'Cubemaps: drawn, on their way, in use.',
    more: 'The last seconds: when cubemaps were drawn, how long each took to come back, how old the newest is.',
  },
  {
    name: 'numbers',
    code: 'Digit6',
    key: '6',
    label: 'Numbers',
    line: 'What a frame takes, and colliding of it.',
    more: 'What a frame costs the main thread, and what of it colliding takes, stage by stage.',
  },
];
