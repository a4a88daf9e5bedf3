import {
  ACESFilmicToneMapping,
  Color,
  DirectionalLight,
  Fog,
  HemisphereLight,
  Matrix4,
  type PerspectiveCamera,
  PCFShadowMap,
  Vector3,
  type Scene,
  type WebGLRenderer,
} from 'three';
import { createSky } from './sky.js';

/** Toward the sun: from behind and to the left of the start's view, so that what one sees first is lit. */
const SUN = new Vector3(-0.62, 0.68, 0.5).normalize();
const HORIZON = new Color('#d8e2e0');
const ZENITH = new Color('#3f82bd');
const GROUND_BOUNCE = new Color('#b89f7c');
const SUN_COLOR = new Color('#ffe6c4');

/** The haze begins here, and the camera sees no farther than that, in a level of the usual size, metres. */
const CLEAR = 40;
export const RANGE = 250;
/** The farthest that the camera ever sees, metres. */
const FARTHEST = 3000;

/** Half the width of the square around the character that has shadows, metres. */
const SHADOW_REACH = 32;
/** Texels of the shadow map along an edge, where the pointer is fine, and on phones. */
const SHADOW_TEXELS = { fine: 2048, coarse: 1024 };

export interface Lighting {
  /** Once a frame, before rendering: the shadows follow this point. */
  update(target: Vector3): void;
  /** Lets the haze, and the camera's range, begin and end as suits a level that is so wide, metres. */
  fit(camera: PerspectiveCamera, width: number): void;
}

/** Adds sun, sky, and haze to a scene, and sets the renderer's tone mapping and shadows to suit them. */
export function addLighting(scene: Scene, renderer: WebGLRenderer): Lighting {
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.toneMappingExposure = 0.92;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;

  const sky = createSky({ sun: SUN, horizon: HORIZON, zenith: ZENITH, glow: SUN_COLOR });
  scene.add(sky, new HemisphereLight(ZENITH.clone().lerp(HORIZON, 0.7), GROUND_BOUNCE, 2.3));
  // The haze is the sky's own colour at the horizon, so that far hills melt into it.
  const haze = new Fog(HORIZON, CLEAR, RANGE - 40);
  scene.fog = haze;

  const texels = matchMedia('(pointer: coarse)').matches
    ? SHADOW_TEXELS.coarse
    : SHADOW_TEXELS.fine;
  const sun = new DirectionalLight(SUN_COLOR, 3.2);
  sun.castShadow = true;
  sun.shadow.mapSize.set(texels, texels);
  sun.shadow.radius = 2.6;
  sun.shadow.normalBias = 0.05;
  sun.shadow.bias = -0.0004;
  const { camera } = sun.shadow;
  camera.left = camera.bottom = -SHADOW_REACH;
  camera.right = camera.top = SHADOW_REACH;
  camera.near = 1;
  camera.far = 140;
  scene.add(sun, sun.target);

  const toLight = new Matrix4().lookAt(SUN, new Vector3(), new Vector3(0, 1, 0));
  const toWorld = toLight.clone();
  toLight.invert();
  const texel = (2 * SHADOW_REACH) / texels;
  const snapped = new Vector3();

  const lighting: Lighting = {
    update(target) {
      // The map moves by whole texels only: a shadow's edge then falls on the same texels wherever the character is.
      snapped.copy(target).applyMatrix4(toLight);
      snapped.x = Math.round(snapped.x / texel) * texel;
      snapped.y = Math.round(snapped.y / texel) * texel;
      snapped.applyMatrix4(toWorld);
      sun.target.position.copy(snapped);
      sun.position.copy(snapped).addScaledVector(SUN, 70);
    },
    fit(camera, width) {
      camera.far = Math.min(FARTHEST, Math.max(RANGE, 1.2 * width));
      camera.updateProjectionMatrix();
      haze.near = (CLEAR * camera.far) / RANGE;
      haze.far = camera.far - 40;
    },
  };
  lighting.update(new Vector3());
  return lighting;
}
