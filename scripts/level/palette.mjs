// Every material of the level: a texture and a colour over it, so that one picture serves many colours.

/** Family colours (sRGB): each kind of feature is told by its own. */
const TEAL = '#70aaa4';
const TERRACOTTA = '#d88763';
const OCHRE = '#e8b95a';
const PLUM = '#a67c98';
const BLUE = '#7a9fc4';
const SAGE = '#9db886';
const CREAM = '#fbf0d8';

export const MATERIALS = {
  paving: { texture: 'paving', color: '#e8d8ba', roughness: 0.9 },
  grass: { texture: 'grass', color: '#ffffff', roughness: 1 },
  plaster: { texture: 'plaster', color: CREAM, roughness: 0.95 },
  stone: { texture: 'stone', color: '#e8d6b6', roughness: 0.95 },
  slab: { texture: 'plaster', color: '#dfcfb0', roughness: 0.9 },
  nosing: { texture: 'plaster', color: '#fff6e2', roughness: 0.8 },
  wood: { texture: 'wood', color: '#ffffff', roughness: 0.8 },
  metal: { texture: 'metal', color: '#7f8a8c', roughness: 0.45 },
  tile: { texture: 'tile', color: '#ffffff', roughness: 0.85 },
  leaf: { texture: 'leaf', color: '#ffffff', roughness: 1 },
  dark: { texture: 'plaster', color: '#3a3532', roughness: 1 },
  shaft: { texture: 'shaft', color: '#ffffff', roughness: 1 },
  sign: { texture: 'sign', color: '#ffffff', roughness: 0.7 },
  guide: { texture: 'guide', color: '#ffffff', roughness: 0.7 },
  teal: { texture: 'plaster', color: TEAL, roughness: 0.85 },
  terracotta: { texture: 'plaster', color: TERRACOTTA, roughness: 0.85 },
  ochre: { texture: 'plaster', color: OCHRE, roughness: 0.85 },
  plum: { texture: 'plaster', color: PLUM, roughness: 0.85 },
  blue: { texture: 'plaster', color: BLUE, roughness: 0.85 },
  sage: { texture: 'plaster', color: SAGE, roughness: 0.85 },
  rosette: { texture: 'rosette', color: '#ffffff', roughness: 0.9, occlusion: true },
  // Of the examples, which have no textures.
  plain: { color: '#ffffff', roughness: 1 },
  floor: { color: '#d9ccb2', roughness: 0.95 },
  hedge: { color: '#8fb065', roughness: 1 },
  'hedge-top': { color: '#aecb7c', roughness: 1 },
  fir: { color: '#6f9e68', roughness: 1 },
  trunk: { color: '#94714f', roughness: 1 },
  // The plaza's own floor carries the baked occlusion map on a second set of UVs.
  'floor-paving': { texture: 'paving', color: '#e8d8ba', roughness: 0.9, occlusion: true },
  'floor-grass': { texture: 'grass', color: '#ffffff', roughness: 1, occlusion: true },
};

/** An sRGB '#rrggbb' as linear factors. */
export function linear(hex) {
  return [1, 3, 5].map((i) => {
    const value = parseInt(hex.slice(i, i + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
}
