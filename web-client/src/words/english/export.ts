// Exporting pictures and films.
import { numberIn, pluralIn } from '../plural.ts';

const number = numberIn('en');
const plural = pluralIn('en');

export const export_words = {
  heading: 'Export',
  open: 'Export a picture or a film (e)',
  kinds: { picture: 'Picture', film: 'Film' },
  kind: 'What to export',

  picture_of: 'Picture of',
  size: 'Size',
  width: 'Width',
  height: 'Height',
  keep_shape: 'Keep the view’s shape',
  free_shape_hint: 'A wider picture shows more at its sides, a narrower one less.',
  presets: {
    view: 'As the view',
    double: 'Twice the view',
    hd: 'HD',
    full_hd: 'Full HD',
    '4k': '4K',
    '8k': '8K',
    a4: 'A4 in print, 300 dpi',
    a3: 'A3 in print, 300 dpi',
    own: 'Own size',
  },
  preset: (name: string, size: string) => `${name} · ${size}`,
  pixels: (width: number, height: number) => `${width} × ${height}`,
  labels: 'Labels in the picture',
  labels_hint:
    'The patient’s directions, a scale bar, the volume’s name, what a slice shows, and the notice.',
  at_target_depth: (length: string) => `${length} at mid-depth`,
  labels_left_out: 'Saved without labels',
  labels_left_out_detail:
    'This browser cannot draw on a picture of this size. A smaller one can have them.',
  picture_note: (notice: string) =>
    `Lossless PNG. “${notice}” is written on the picture and in the file.`,
  bare_picture_note: (notice: string) =>
    `Lossless PNG, with no marks on it. “${notice}” is written in the file, not on the picture.`,
  save_picture: 'Save the picture',

  motion: 'Motion',
  motions: { turntable: 'Turntable', path: 'Recorded' },
  axis: 'Turns about',
  axes: { superior: 'Head to feet', view_up: 'Upright in the picture' },
  direction: 'Front goes',
  directions: { right: 'To the right', left: 'To the left' },
  angle: 'Turn',
  seconds: 'Length',
  frames_per_second: 'Frames per second',
  format: 'Format',
  formats: { mp4: 'MP4', webm: 'WebM', zip: 'Numbered PNG in a ZIP' },
  format_with: (format: string, codec: string) => `${format} (${codec})`,
  codecs: { avc: 'H.264', hevc: 'H.265', vp9: 'VP9', av1: 'AV1', vp8: 'VP8' },
  looking: 'Looking what this browser can write…',
  missing: {
    insecure: 'browsers encode video only for pages that came over HTTPS or from this machine',
    no_encoder: 'this browser has no video encoder',
    no_codec: 'this browser has no encoder for it at this size',
  },
  format_missing: (format: string, reason: string) => `No ${format}: ${reason}.`,
  film_facts: (frames: number, seconds: number) =>
    `${plural(frames, { one: '# frame', other: '# frames' })}, ${number(seconds, 1)} s`,
  film_note: (notice: string) => `“${notice}” is written into each frame.`,
  bare_film_note: (notice: string) =>
    `“${notice}” is written small into each frame; numbered pictures stay as the server made them and have it in the file.`,
  save_film: 'Make the film',

  record: 'Record the view',
  record_anew: 'Record anew',
  record_hint:
    'Move the view, the lens, anything, and stop. The film shows it again, without a stutter.',
  recorded: (seconds: number) => `Recorded: ${number(seconds, 1)} s`,
  recording: 'Recording',
  stop: 'Stop',

  making: { picture: 'The picture is made', film: 'The film is made' },
  waiting: 'Waiting for the server…',
  go_on: 'You can close this and go on meanwhile.',
  frame_of: (done: number, frames: number) => `Frame ${number(done)} of ${number(frames)}`,
  seconds_left: (seconds: number) =>
    plural(seconds, { one: '# second left', other: '# seconds left' }),
  minutes_left: (minutes: number) =>
    plural(minutes, { one: 'about # minute left', other: 'about # minutes left' }),
  cancel: 'Cancel',
  saved: (name: string) => `Saved: ${name}`,
  megabytes: (megabytes: number) => `${number(megabytes, 1)} MB`,

  failed: 'The export failed',
  other_volume: 'The export was given up',
  other_volume_detail: 'Another volume was opened while it was made.',
};
