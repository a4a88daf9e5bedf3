// The joints: metres, in the frame of the whole figure, which stands on y = 0 and looks along +Z; its left is +X.
// At rest no joint is turned, arms and legs hang straight down.

/** The sole below the ankle, and the joint of the toes ahead of it and above the sole, metres. */
export const ANKLE = 0.085;
export const TOE = { ahead: 0.115, height: 0.03 };
/** The heel's edge, behind the ankle, metres. */
export const HEEL = 0.095;

export const THIGH = 0.36;
export const SHIN = 0.36;
const HIP = ANKLE + THIGH + SHIN;
/** Sideways from the middle to the hip joint. */
export const HIP_WIDTH = 0.108;

const both = (name, parent, [x, y, z]) => [
  { name: `${name}L`, parent: parent.replace('*', 'L'), at: [x, y, z] },
  { name: `${name}R`, parent: parent.replace('*', 'R'), at: [-x, y, z] },
];

/** Parents before their children. */
export const JOINTS = [
  { name: 'hips', parent: null, at: [0, HIP, 0] },
  { name: 'spine', parent: 'hips', at: [0, 0.88, 0] },
  { name: 'chest', parent: 'spine', at: [0, 0.97, 0] },
  { name: 'head', parent: 'chest', at: [0, 1.23, 0] },
  { name: 'eyes', parent: 'head', at: [0, 1.45, 0.2] },
  { name: 'antenna', parent: 'head', at: [0, 1.655, -0.04] },
  ...both('upperArm', 'chest', [0.238, 1.135, 0]),
  ...both('lowerArm', 'upperArm*', [0.238, 0.91, 0]),
  ...both('hand', 'lowerArm*', [0.238, 0.69, 0]),
  ...both('upperLeg', 'hips', [HIP_WIDTH, HIP, 0]),
  ...both('lowerLeg', 'upperLeg*', [HIP_WIDTH, HIP - THIGH, 0]),
  ...both('foot', 'lowerLeg*', [HIP_WIDTH, ANKLE, 0]),
  ...both('toes', 'foot*', [HIP_WIDTH, TOE.height, TOE.ahead]),
];

/** Where a joint is at rest. */
export const at = (name) => JOINTS.find((joint) => joint.name === name).at;
