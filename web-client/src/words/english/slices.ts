// Slices: their names, what stands at them, and their part of the panel.
export const slices = {
  heading: 'Slices',
  names: { '3d': '3-D', axial: 'Axial', coronal: 'Coronal', sagittal: 'Sagittal' },
  picture: (name: string) => `${name} slice`,
  keys_in_short:
    'Arrow keys step through the slices, Shift and arrows move the crosshair, plus and minus zoom. ' +
    'Question mark lists all keys.',
  scroller: (name: string) => `${name}: position`,
  window: (width: string, centre: string) => `W ${width} · C ${centre}`,
  window_drag: 'Drag changes the window (w)',
  tilted: 'oblique',
  tilt_handle: (name: string) => `Tilt the ${name.toLowerCase()} plane`,
  move_lens: 'Lens in this slice',
  lens_keys: 'Arrow keys move the lens in this slice, plus and minus resize it.',
  enlarge: (name: string) => `${name}: enlarge (z)`,
  shrink: (name: string) => `${name}: back to all views (z)`,

  layout: 'Layout',
  layouts: {
    single: '3-D alone',
    grid: '3-D and three slices',
    focus: 'One large, three small',
  },
  show: 'Show the slices',

  window_centre: 'Window centre',
  window_width: 'Window width',
  presets_heading: 'Windows',
  presets: {
    soft_tissue: 'Soft tissue',
    lung: 'Lung',
    bone: 'Bone',
    brain: 'Brain',
    liver: 'Liver',
  },
  preset_hint: (key: number, centre: string, width: string) =>
    `Centre ${centre}, width ${width} (${key})`,
  presets_need_hu: 'Window presets need Hounsfield units',
  convention: 'Convention',
  convention_hint:
    'Radiological: the patient’s right is on the left of the picture. Neurological: on the right.',
  conventions: { radiological: 'Radiological', neurological: 'Neurological' },
  lens_at_crosshair: 'The lens follows the crosshair',
  lens_at_crosshair_hint: 'Moving the crosshair moves the lens along (l).',
  reset_tilt: 'Straighten the planes',
  reset_views: 'Whole slices',
};
