// Choosing how things look: bands of values, tones, and the user's own styles.
export const look = {
  detail: 'Detail',
  detail_range: 'Detail, from toon to smooth',
  tones: 'Tones, dark to light',

  tissues: { skin: 'Skin', muscle: 'Muscle', contrast_vessels: 'Contrast vessels', bone: 'Bone' },
  tissue_presets: 'Tissue',
  from: (lower: string) => `from ${lower}`,
  between: (lower: string, upper: string) => `${lower} to ${upper}`,
  not_in_volume: 'No value of this volume lies there',
  histogram: 'Histogram of the volume, logarithmic',
};

export const own_styles = {
  heading: 'Your styles',
  none: 'Save the present look under a name to find it again here.',
  name: 'Name of the look',
  save: 'Save',
  replace: 'Replace',
  import: 'Import a file',
  rename: (title: string) => `Rename ${title}`,
  remove: (title: string) => `Delete ${title}`,
  export: (title: string) => `Export ${title} as a file`,
  hint: 'One of your own styles.',
  untitled: 'Imported look',

  file_refused: (name: string) => `${name} could not be imported`,
  not_json: (reason: string) => `It is no JSON: ${reason}`,
  not_an_object: 'A scene document is a JSON object, and this is none.',
  other_version: (came: string, expected: number) =>
    `Its version is ${came}; this page reads version ${expected}.`,
  unknown_field: (field: string) => `A scene document has no field “${field}”.`,
  no_look: 'It says nothing of a look: no focus, context, lens, light or background.',
  too_large: (bytes: number, most: number) => `It has ${bytes} bytes, ${most} at most.`,

  unreadable: 'Your saved styles could not be read',
  unreadable_detail:
    'They are damaged or of another version of this page. They were put aside, and the list begins anew.',
  not_kept: 'The browser does not keep your styles',
  not_kept_detail: 'Its storage is full or switched off. They last until this page is closed.',
};

export const volume_browser = {
  search: 'Search volumes',
  modality: 'Modality',
  any: 'All',
  none_found: 'No volume matches.',
  cancel: (title: string) => `Cancel opening ${title}`,
};
