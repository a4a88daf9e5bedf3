import type { Camera, PerspectiveCamera } from 'three';

/** Nearest distance drawn by a camera that does not say, metres. */
const NEAR = 0.1;

/**
 * Radius of the ball around a camera that holds its near plane, corners included: whatever stays out of that is not cut
 * open by the picture. Metres; of perspective cameras and of orthographic ones.
 */
export function nearRadius(camera: Camera): number {
  const { near = NEAR, isPerspectiveCamera } = camera as PerspectiveCamera;
  const { elements: e } = camera.projectionMatrix;
  // Of a picture off the middle (`setViewOffset`) the farther side.
  const depth = isPerspectiveCamera ? near : 1;
  const offset = isPerspectiveCamera ? 8 : 12;
  const x = (depth * (1 + Math.abs(e[offset]!))) / e[0]!;
  const y = (depth * (1 + Math.abs(e[offset + 1]!))) / e[5]!;
  return Math.sqrt(x * x + y * y + near * near);
}
