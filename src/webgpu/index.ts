export { CubeCollider } from './CubeCollider.js';
export * from '../common.js';
