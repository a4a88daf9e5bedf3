/** What both entries have: all but `CubeCollider`, of which there is one for each renderer. */
export type { CubeColliderOptions } from './collider/CubeColliderOptions.js';
export type { CubeColliderStats } from './collider/CubeColliderStats.js';
export {
  CubeColliderGroup,
  type CubeColliderGroupOptions,
  type CubeColliderGroupStats,
} from './collider/CubeColliderGroup.js';
export { CharacterController, type CharacterBody } from './character/CharacterController.js';
export type { CharacterCollider, Survey } from './character/CharacterCollider.js';
export type { CharacterEventMap } from './character/characterEvents.js';
export type { CharacterOptions } from './character/characterOptions.js';
export type { CharacterStats } from './character/SlideMotion.js';
export type { Contact } from './character/Contact.js';
export { CameraBoom, type BoomCollider } from './controls/CameraBoom.js';
export { CharacterControls } from './controls/CharacterControls.js';
export type {
  CharacterControlsEventMap,
  CharacterControlsOptions,
} from './controls/controlsOptions.js';
export type { Boom } from './controls/Boom.js';
export type { ControlledCharacter, View } from './controls/ControlledCharacter.js';
export type { Action, ButtonAction, ButtonMap, KeyMap } from './controls/actions.js';
export type { TouchStick } from './controls/TouchStick.js';
export { AxisMaxima } from './cube/AxisMaxima.js';
export { FACE_NAMES, type FaceName } from './cube/faces.js';
export type { TexelFormat } from './cube/encoding.js';
export { DEFAULTS } from './defaults.js';
export { SurfaceField, type SurfaceSample, type SurfaceSampler } from './field/SurfaceField.js';
export { AxisResponse, type AxisResponseOptions } from './response/AxisResponse.js';
export type { CollisionResponse } from './response/CollisionResponse.js';
export { SlideResponse } from './response/SlideResponse.js';
