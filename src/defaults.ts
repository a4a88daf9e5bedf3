/**
 * Every default of the package, in one place; the docs' tables are tested against it.
 * Metres, seconds, radians unless a line says otherwise.
 */
export const DEFAULTS = {
  /** Of `CubeColliderOptions`. */
  collider: {
    /** What is read back: 'surface' (distance and normal of every texel) or 'axis' (the paper's six maxima). */
    output: 'surface',
    /** Texels per face edge. */
    resolution: 32,
    /** Drawn this many times finer along each edge; each texel read is the nearest of its block. (The paper's mode: 1.) */
    supersample: 4,
    /** Reach: how far from its centre the cubemap sees. */
    far: 1.8,
    /** Nearest distance drawn, as a part of the reach. */
    nearRatio: 0.01,
    /** Deepest penetration told apart in the paper's mode, as a part of rMax. */
    rMinRatio: 0.5,
    /** The sphere of the paper's mode. */
    rMax: 0.35,
    /** 'async' for surfaces; the paper's mode reads 'sync'. */
    readback: 'async',
    /** Which sides of a triangle are solid: 'both', or 'drawn' as each material culls. */
    sides: 'both',
    /** What see-through things are: 'ignore', no obstacles, or 'solid'. */
    transparent: 'ignore',
    /** Texel format: 'auto' takes the first that the context can draw of RGBA32F, RGBA16F, RGBA8. */
    format: 'auto',
    /** How far it may move from its newest field before `update` waits for the next, as a part of the reach. */
    slackRatio: 0.25,
    /** How old its newest field may be before `update` waits for the next. */
    maxAge: 0.5,
  },
  /** Of `CubeColliderGroupOptions`. */
  group: {
    /** Cubemaps drawn and read together at most, in one update. */
    size: 20,
  },
  /** Of `CharacterOptions`. */
  character: {
    /** Radius of the body. */
    radius: 0.35,
    /** From foot to crown. */
    height: 1.8,
    /** Downward acceleration, m/s². */
    gravity: 20,
    /** Fastest fall, m/s. */
    terminalSpeed: 50,
    /** Rise of a jump's foot. */
    jumpHeight: 1.1,
    /** Gap kept between body and surface. */
    skin: 0.02,
    /** Steepest slope that is walked and stood on. */
    slopeLimit: (50 * Math.PI) / 180,
    /** Highest step that is climbed without a jump. */
    stepHeight: 0.4,
    /** How far down it follows the ground it walks off. */
    snapDistance: 0.4,
    /** Total height while crouched. */
    crouchHeight: 1.1,
    /** How long it counts as grounded, and may jump, after the ground last carried it. */
    coyoteTime: 0.1,
    /** How long a jump asked for too early is remembered. */
    jumpBuffer: 0.1,
    /** How fast the speed in the air turns toward the wish, m/s². */
    airControl: 25,
    /** Longest step taken at once. */
    maxDelta: 0.1,
  },
  /** Of `AxisResponseOptions`. */
  axis: {
    /** Response factor along X and Z, less than `cY` (equations (23), (25)). */
    cXZ: 0.5,
    /** Response factor along Y (equation (24)). */
    cY: 1,
    /** Pushes shorter than this are dropped (§1.2.3): off. */
    hMax: 0,
  },
  /** Of `CharacterControlsOptions`. */
  controls: {
    /** In the head, or behind it ('third'). */
    view: 'first',
    /** m/s. */
    walkSpeed: 3,
    /** While Shift is held, m/s. */
    runSpeed: 6,
    /** Above the foot, standing. */
    eyeHeight: 1.6,
    /** Radians a pixel of mouse travel. */
    sensitivity: 0.002,
    /** Radians a pixel of a finger's travel. */
    touchSensitivity: 0.006,
    /** Radians a second, of a gamepad's stick all the way out. */
    stickSensitivity: 3,
    /** Radians a second, of keys that turn. */
    turnSpeed: 2,
    /** Whether looking up and down is the other way round. */
    invertY: false,
    /** Part of a gamepad's stick's way that counts as none. */
    deadZone: 0.15,
    /** Whether the left half of a touch screen walks. */
    touchStick: true,
    /** Whether the keys of `turnLeft` and `turnRight` turn rather than walk. */
    turnKeys: false,
    /** Whether run is switched on and off by a press. */
    toggleRun: false,
    /** Captures the pointer on a click; where it may not, dragging looks around. */
    pointerLock: true,
    /** Asks for the mouse's own travel, without the system's acceleration. */
    unadjustedMovement: false,
    /** How fast the wanted velocity is taken up, 1/s. */
    agility: 12,
    /** Scale of the camera's smoothing rate; Infinity settles at once. */
    smoothing: 1,
    /** Largest pitch either way. */
    maxPitch: (85 * Math.PI) / 180,
    /** Third person: camera's distance from the head. */
    distance: 4,
    /** Nearest that the wheel brings it. */
    minDistance: 1,
    /** Farthest that the wheel takes it. */
    maxDistance: 7,
  },
} as const;
