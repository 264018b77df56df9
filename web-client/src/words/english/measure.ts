// Measuring: tools, what they say, and the list of what was measured.

export const measure = {
  kinds: { distance: 'Distance', angle: 'Angle', probe: 'Probe' },
  tools: 'Measuring tools',
  tool_titles: {
    distance: 'Distance between two points (m)',
    angle: 'Angle between three points (a)',
    probe: 'Value and position at a point (v)',
  },
  steps: {
    distance: ['Distance: choose the first point', 'Choose the second point'],
    angle: ['Angle: choose the first point', 'Choose the vertex', 'Choose the last point'],
    probe: ['Probe: choose a point'],
  },
  surface_hint: 'Click or tap the surface; drag to turn it',
  nothing_there: { volume: 'No surface here', slice: 'Beside the volume' },
  put_away: 'Put the tool away',
  take_back: 'Take back the last point',

  none: 'Nothing measured in this volume yet.',
  how: 'Points lie on the surface that is drawn, or in a slice, and stay where they are in the patient.',
  list: 'Measured',
  rename: (name: string) => `Name of ${name}`,
  show: (name: string) => `Select ${name} in the picture`,
  remove: (name: string) => `Delete ${name}`,
  remove_all: 'Delete all',
  removed: (name: string) => `${name} was deleted`,
  all_removed: 'All measurements of this volume were deleted',
  unreadable: 'Your saved measurements could not be read',
  unreadable_detail:
    'They are damaged or of another version of this page. They were put aside, and the list begins anew.',
  elsewhere: 'Measured in another volume of this name; not shown',
  elsewhere_detail: 'What you measured there is kept, and shows again when that volume is opened.',
  not_kept: 'The browser does not keep your measurements',
  not_kept_detail: 'Its storage is full or switched off. They last until this page is closed.',
  as_json: 'Save as JSON',
  as_csv: 'Save as CSV',
  point: (name: string, number: number) => `${name}, point ${number}`,
  point_hint: 'Arrow keys move the point, with Shift by single pixels.',
  measured: (name: string, result: string) => `${name}: ${result}`,
  file: (volume: string) => `cutaway ${volume} measurements`,

  at_target_depth: 'Scale at the depth of the point in the middle of the view; nearer is larger',
  everywhere: 'Scale of the whole picture',
  scale: (length: string) => `Scale bar: ${length}`,
};
