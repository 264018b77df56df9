// Labels of the panel's controls; those of modules come from the server.
import { SCENE_FIELDS } from '../../protocol/messages.ts';
import type { DescribedField } from '../described_field.ts';

export const controls = {
  /** What the schema says of a field of the scene. */
  description: (field: DescribedField): string => SCENE_FIELDS[field].description,
  /** Tells the field from the slider beside it. */
  as_number: (label: string) => `${label}, number`,

  mode: 'Mode',
  cut_surfaces: 'Cut surfaces',
  strength: 'Strength',
  soft_rim: 'Soft rim',
  fade_everywhere: 'Fade the context everywhere',
  opening: 'Opening',
  funnel_angle: 'Funnel angle',
  wall: {
    strength: 'Strength of its colour',
    colour: 'Colour',
    deepening: 'Darker with depth',
    edge_mm: 'Pale edge',
    edge_colour: 'Edge colour',
  },
  shape: 'Shape',
  radius: 'Radius',
  centre_in_patient: 'Centre in the patient',
  centre_towards: {
    L: 'Centre towards left (L)',
    P: 'Centre towards posterior (P)',
    S: 'Centre towards superior (S)',
  },

  lower_end: 'Lower end (iso-value)',
  upper_end: 'Upper end',
  upper_value: 'Upper value',
  opacity: 'Opacity',
  hide_couch: 'Hide couch and headrest',
  fill_context: 'Fill the body',
  islands: 'Leave out parts below',
  shading: 'Shading',

  smoothing: 'Smoothing',
  smoothing_hint:
    'Calms the form that light falls on, and leaves the picture sharp. Automatic suits the voxels of this volume.',
  smoothings: { off: 'Off', auto: 'Automatic', mm: 'In millimetres' },
  smoothing_width: 'Smoothing width',
  reconstruction: 'Between voxels',
  occlusion: 'Ambient occlusion',
  occlusion_near: 'Occlusion: small forms',
  occlusion_colour: 'Occlusion: colour',
  shadow: 'Shadow',
  shadow_softness: 'Shadow: softness',

  light_turns_with: 'Light turns with',
  light_from: 'Where the light comes from, in degrees.',
  from_the_side: 'From the side',
  from_above: 'From above',
  background: 'Background',
  background_hint: 'Behind everything.',

  projection: 'Projection',
  field_of_view: 'Field of view',
};
