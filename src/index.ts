export { CubeCollider, type CubeColliderStats } from './collider/CubeCollider.js';
export type { CubeColliderOptions } from './collider/CubeColliderOptions.js';
export { AxisMaxima } from './cube/AxisMaxima.js';
export { FACE_NAMES, type FaceName } from './cube/faces.js';
export type { TexelFormat } from './cube/encoding.js';
export { DEFAULTS } from './defaults.js';
export { SurfaceField, type SurfaceSample, type SurfaceSampler } from './field/SurfaceField.js';
