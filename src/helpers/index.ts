export {
  CubeColliderHelper,
  type CubeColliderHelperOptions,
  type ViewableCollider,
} from './CubeColliderHelper.js';
