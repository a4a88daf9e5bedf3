export { CharacterHelper, type ViewableBody } from './CharacterHelper.js';
export { HELPER_COLORS } from './colors.js';
export {
  ContactsHelper,
  type ContactsHelperOptions,
  type ViewableContacts,
} from './ContactsHelper.js';
export {
  CubeColliderHelper,
  type CubeColliderHelperOptions,
  type ViewableCollider,
} from './CubeColliderHelper.js';
export { FreeSpaceHelper } from './FreeSpaceHelper.js';
export { ReadbackTimeline, type ReadbackTimelineOptions } from './ReadbackTimeline.js';
export { SurfelsHelper, type SurfelsHelperOptions, type ViewableField } from './SurfelsHelper.js';
export { UnfoldedField, type UnfoldedFieldOptions } from './UnfoldedField.js';
