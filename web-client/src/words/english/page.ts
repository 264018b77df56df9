// The bar, the picture and what lies over it.

export const page = {
  volumes_and_settings: 'Volumes and settings',
  showing: (title: string) => `Showing ${title}`,

  links: {
    connecting: 'Connecting',
    connected: 'Connected',
    queued: 'In the queue',
    gave_way: 'Paused',
    waiting: 'Disconnected',
  },
  bar: {
    view: 'View',
    follow: 'Lens follows the pointer',
    undo: 'Undo',
    redo: 'Redo',
    copy_link: 'Copy a link to this view',
    help: 'Help and keys',
    hide_panel: 'Hide the panel',
    show_panel: 'Show the panel',
  },

  picture: '3-D picture',
  keys_in_short:
    'Arrow keys rotate, plus and minus zoom, Shift and arrows move the lens. ' +
    'Question mark lists all keys.',
  no_volumes: 'The server has no volumes to show.',
  looking_for_volumes: 'Looking for volumes…',
  preparing: 'Preparing the picture…',
  connecting: 'Connecting…',
  reconnecting: (reason: string) => `Reconnecting: ${reason}.`,
  disconnected: (reason: string) => `Disconnected: ${reason}. Trying again.`,
  stalled:
    'No new picture for a while: the server is busy or the connection stalls. The page goes on by itself.',
  try_now: 'Try now',
  queue: (place: number) =>
    `The server is full. ${
      place === 1 ? 'You are next' : `You are number ${place} in the queue`
    }; this page goes on by itself.`,
  gave_way:
    'Others were waiting, and this page’s place on the server went to one of them. It goes on as soon as you are back.',
  go_on: 'Go on',
  link_reasons: {
    full: 'the server is full',
    lost: 'the connection was lost',
    no_answer: 'the server does not answer',
    too_large: 'a message was far larger than the server takes',
  },

  comparing: 'Previous style',
  lens: 'Lens',
  lens_keys: 'Arrow keys move the lens over the surface, plus and minus resize it.',
  lens_size: 'Lens size',
  lens_turn: 'Turn the lens',
  lens_follows: 'The lens follows the pointer. Escape ends it.',
  lossy: 'lossy',
  lossy_hint: 'JPEG-compressed',
  not_for_diagnosis: 'Not for diagnostic use',

  edges: { top: 'top', right: 'right', bottom: 'bottom', left: 'left' },
  directions: {
    A: 'Anterior',
    P: 'Posterior',
    R: 'Right',
    L: 'Left',
    S: 'Superior',
    I: 'Inferior',
  },

  opening_a_volume: 'Opening a volume',
  opening: (what: string) => `Opening ${what}`,
  cancel: 'Cancel',
  stages: {
    read: 'Reading',
    decode: 'Decoding',
    min_max: 'Analysing',
    upload: 'Uploading to the renderer',
    ready: 'Ready',
    cancelled: 'Cancelled',
    failed: 'Failed',
  },
  dismiss: 'Dismiss',

  status: {
    name: 'Status',
    frames_per_second: 'Frames per second',
    at_rest: 'at rest',
    latency: 'Latency',
    bytes: 'Picture',
    scale: 'Resolution',
    quality: 'Quality',
    high: 'high',
    in_motion: 'in motion',
    lossless: 'lossless',
    renderer: 'Renderer',
  },
  hints: {
    name: 'Hints',
    turn: 'Drag to turn, wheel to zoom',
    turn_by_touch: 'One finger turns, two zoom',
    lens: 'Drag the lens to look inside',
    style: 'Styles and volumes in the panel',
    got_it: 'Got it',
  },
};
