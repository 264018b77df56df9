// The panel's tabs.
import { pluralIn } from '../plural.ts';

const plural = pluralIn('en');

export const panel = {
  name: 'Panel',
  tabs: {
    volumes: 'Volumes',
    styles: 'Styles',
    adjust: 'Adjust',
    measure: 'Measure',
    view: 'View',
  },
  reset: (group: string) => `${group}: reset`,
  advanced: 'Advanced',

  volumes: {
    none: 'No volumes yet.',
    scanning: 'Looking for more volumes…',
    refused: (count: number) =>
      plural(count, { one: '# could not be read', other: '# could not be read' }),
  },

  styles: {
    waiting: 'Waiting for the server…',
    illustrations: 'Illustrations',
    studies: 'Technique studies',
    hold_to_compare: 'Hold to compare',
    hold_to_compare_hint: 'Shows the previous style while it is held',
    own_look: 'Your own look.',
    own_look_hint: 'No named style has these settings.',
  },

  adjust: {
    later: 'Opens with the first picture.',
    focus: 'Focus',
    focus_hint: 'inside the lens',
    context: 'Context',
    context_hint: 'around it',
    lens: 'Lens',
    wall: 'Wall of the cavity',
    surface_and_light: 'Surface and light',
    only_opaque: 'On opaque surfaces only: where focus and context both have an opacity of 1.',
    light: 'Light',
    light_and_background: 'Light and background',
    filters: 'Filters, in the order they run',
    add: (filter: string) => `add ${filter}`,
    earlier: (filter: string) => `${filter}: earlier`,
    later_in_order: (filter: string) => `${filter}: later`,
    remove: (filter: string) => `${filter}: remove`,
  },

  view: {
    look_from: 'Look from',
    reset: 'Reset the view',
    projection: 'Projection',
    view: 'View',
    status: 'Status',
    software: 'The server has no graphics processor: pictures are made in software, and slowly.',
    server: 'Server',
    renderer: 'Renderer',
    picture: 'Picture',
    picture_size: (rendered: string, shown: string) => `${rendered} of ${shown}`,
    quality: 'Quality',
    still: 'still',
    in_motion: 'in motion',
    size: 'Size',
    render_encode: 'Render, encode',
    latency: 'Input to picture',
    frames_per_second: 'Pictures in the last second',
  },

  settings: {
    heading: 'This page',
    language: 'Language',
    as_browser: 'As the browser',
    status_line: 'Status line under the picture',
    theme: 'Theme',
    themes: { system: 'As the system', dark: 'Dark', light: 'Light' },
  },
};
