export { CubeCollider } from './collider/CubeCollider.js';
export * from './common.js';
