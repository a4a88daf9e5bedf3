import { MathUtils, type PerspectiveCamera } from 'three';

/** So many degrees high; on an upright phone at least 50° wide. */
export function fit(camera: PerspectiveCamera, aspect: number, degrees: number): void {
  const wide = 2 * Math.atan(Math.tan(MathUtils.degToRad(50) / 2) / aspect);
  camera.aspect = aspect;
  camera.fov = Math.max(degrees, MathUtils.radToDeg(wide));
  camera.updateProjectionMatrix();
}
