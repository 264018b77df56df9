// Controls of the fields that every scene has; ranges and choices come from its schema.
import { SCENE_FIELDS, type Scene } from '../protocol/messages.ts';
import type { ChoiceControl, ColourControl, NumberControl } from './controls.ts';
import { choiceField } from './field_controls.ts';
import { lightAngles, lightDirection, type LightAngles } from './light_angles.ts';
import { nestedPatch, type Json, type JsonObject } from './merge_patch.ts';
import { cameraOf, DEFAULT_FIELD_OF_VIEW_DEGREES } from './scene_parts.ts';
import { withProjection } from '../view/camera_motion.ts';
import { words } from '../words/words.ts';

type ChoiceField = 'lens.mode' | 'lens.opening' | 'lens.cap' | 'light.frame' | 'camera.projection';

/** A choice that the scene itself has. */
export const sceneChoiceControl = (field: ChoiceField, label: string, scene: Scene) =>
  choiceField({ field, path: field.split('.'), label }, scene);

export function backgroundControl(scene: Scene): ColourControl {
  return {
    kind: 'colour',
    id: 'background-colour',
    label: words().controls.background,
    description: words().controls.background_hint,
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
    description: words().controls.light_from,
    value: angles[key],
    minimum: -limit,
    maximum: limit,
    step: 1,
    unit: '°',
    toPatch: (value) =>
      nestedPatch(['light', 'direction'], lightDirection({ ...angles, [key]: Number(value) })),
  });
  return [
    control('azimuth_degrees', words().controls.from_the_side, 180),
    control('elevation_degrees', words().controls.from_above, 89),
  ];
}

/** What the viewport's height takes in: degrees in perspective, millimetres else. */
export function fieldOfViewControl(scene: Scene): NumberControl {
  const field = SCENE_FIELDS['camera.vertical_fov_degrees'];
  return {
    kind: 'number',
    id: 'camera-field-of-view',
    label: words().controls.field_of_view,
    description: words().controls.description('camera.vertical_fov_degrees'),
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
  const control = sceneChoiceControl('camera.projection', words().controls.projection, scene);
  const camera = cameraOf(scene);
  if (!camera) return control;
  const fov_degrees = scene.camera?.vertical_fov_degrees ?? DEFAULT_FIELD_OF_VIEW_DEGREES;
  const toPatch = (value: Json): JsonObject => {
    const projection = value === 'orthographic' ? value : 'perspective';
    return { camera: { ...withProjection(camera, projection, fov_degrees) } };
  };
  return { ...control, toPatch };
}
