// All that is wanted of two large modules: a build of the page that imports this one, when it needs it, leaves out the rest.
export { CubeCollider } from 'three-cube-collider/webgpu';
export { WebGPURenderer } from 'three/webgpu';
