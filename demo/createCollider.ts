import { AxisResponse, type CubeCollider, DEFAULTS, SlideResponse } from 'three-cube-collider';
import type { Settings } from './hud/panel.js';
import type { Rendering } from './rendering.js';

/** The collider that the settings ask for. */
export function createCollider(
  { output, resolution, supersample, readback }: Settings,
  rendering: Rendering,
): CubeCollider {
  return output === 'axis'
    ? rendering.createCollider({ output, resolution, rMax: DEFAULTS.character.radius })
    : rendering.createCollider({ resolution, supersample, readback });
}

/** And how a character answers what it finds. */
export function createResponse({ output, response }: Settings): SlideResponse | AxisResponse {
  return output === 'axis' || response === 'axis' ? new AxisResponse() : new SlideResponse();
}
