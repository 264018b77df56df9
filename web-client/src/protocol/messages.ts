// The protocol's types, by the names that this client uses; all of them are generated from
// protocol/schema.
export type {
  CapabilitiesMessage,
  ClientMessage,
  ErrorMessage,
  LensOutline,
  Limits,
  LoadingMessage,
  ModuleDescription,
  ModuleRegistries,
  ParameterDescription,
  PickedMessage,
  RefusedEntry,
  Scene,
  SceneMessage,
  SceneStateMessage,
  ServerMessage,
  Style,
  UnseenReason,
  VolumeEntry,
  VolumeSummary,
  VolumesMessage,
} from './generated/protocol.ts';
export {
  PREVIEW_SIDE_PX,
  SCENE_FIELDS,
  SCENE_GROUPS,
  SCENE_PATHS,
  SCENE_VERSION,
  SLICES_GROUPS,
  STYLE_FIELDS,
} from './generated/scene_fields.ts';
