// Controls of the fields that every scene has; ranges and choices come from its schema.
import { SCENE_FIELDS, type Scene } from '../protocol/messages.ts';
import {
  choicesOf,
  type ChoiceControl,
  type ColourControl,
  type NumberControl,
} from './controls.ts';
import { lightAngles, lightDirection, type LightAngles } from './light_angles.ts';
import { nestedPatch, textOf, valueAt, type Json, type JsonObject } from './merge_patch.ts';
import { cameraOf, DEFAULT_FIELD_OF_VIEW_DEGREES } from './scene_parts.ts';
import { withProjection } from '../view/camera_motion.ts';

type ChoiceField = 'lens.mode' | 'lens.cap' | 'light.frame' | 'camera.projection';

/** A choice that the scene itself has. */
export function sceneChoiceControl(field: ChoiceField, label: string, scene: Scene): ChoiceControl {
  const path = field.split('.');
  const { choices, description, default: first } = SCENE_FIELDS[field];
  return {
    kind: 'choice',
    id: path.join('-'),
    label,
    description,
    value: textOf(valueAt(scene as Json, path), first),
    choices: choicesOf(choices),
    toPatch: (value) => nestedPatch(path, value),
  };
}

export function backgroundControl(scene: Scene): ColourControl {
  return {
    kind: 'colour',
    id: 'background-colour',
    label: 'Background',
    description: 'Behind everything.',
    value: scene.background?.colour ?? [0, 0, 0],
    toPatch: (value) => nestedPatch(['background', 'colour'], value),
  };
}

/** The light's direction as two angles; the length of the direction means nothing. */
export function lightControls(scene: Scene): NumberControl[] {
  const angles = lightAngles(scene.light?.direction ?? [0, 0, 1]);
  const control = (key: keyof LightAngles, label: string, limit: number): NumberControl => ({
    kind: 'number',
    id: `light-${key}`,
    label,
    description: 'Where the light comes from, in degrees.',
    value: angles[key],
    minimum: -limit,
    maximum: limit,
    step: 1,
    unit: '°',
    toPatch: (value) =>
      nestedPatch(['light', 'direction'], lightDirection({ ...angles, [key]: Number(value) })),
  });
  return [
    control('azimuth_degrees', 'From the side', 180),
    control('elevation_degrees', 'From above', 89),
  ];
}

/** What the viewport's height takes in: degrees in perspective, millimetres else. */
export function fieldOfViewControl(scene: Scene): NumberControl {
  const field = SCENE_FIELDS['camera.vertical_fov_degrees'];
  return {
    kind: 'number',
    id: 'camera-field-of-view',
    label: 'Field of view',
    description: field.description,
    value: scene.camera?.vertical_fov_degrees ?? field.minimum,
    minimum: 5,
    maximum: 90,
    step: 1,
    unit: '°',
    toPatch: (value) => nestedPatch(['camera', 'vertical_fov_degrees'], value),
  };
}

/** Changes the projection without a jump in size. */
export function projectionControl(scene: Scene): ChoiceControl {
  const control = sceneChoiceControl('camera.projection', 'Projection', scene);
  const camera = cameraOf(scene);
  if (!camera) return control;
  const fov_degrees = scene.camera?.vertical_fov_degrees ?? DEFAULT_FIELD_OF_VIEW_DEGREES;
  const toPatch = (value: Json): JsonObject => {
    const projection = value === 'orthographic' ? value : 'perspective';
    return { camera: { ...withProjection(camera, projection, fov_degrees) } };
  };
  return { ...control, toPatch };
}
