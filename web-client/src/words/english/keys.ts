// The help sheet: gestures and keys.

export const keys = {
  help: 'Help',
  close: 'Close',
  gestures_heading: 'Mouse, touchpad, touch',
  keys_heading: 'Keys, while the picture has the focus',
  about: (notice: string) =>
    `${notice} The letters at the picture's edges are the patient's directions: R and L, A and P, ` +
    'S and I.',

  /** What is printed on a key, where that is another word in another language. */
  caps: {
    Shift: 'Shift',
    Alt: 'Alt',
    Ctrl: 'Ctrl',
    Esc: 'Esc',
    PageUp: 'Page up',
    PageDown: 'Page down',
  },

  gestures: {
    rotate: ['Drag, or one finger', 'Rotate'],
    pan: ['Shift or middle drag, or two fingers', 'Pan'],
    zoom: ['Wheel or right drag, or pinch', 'Zoom'],
    move_lens: ['Drag the grip in the lens', 'Move the lens over the surface'],
    resize_lens: ['Alt or Shift + wheel, or drag the rim', 'Resize the lens'],
    place_point: ['Click or tap with a measuring tool', 'Place a point on the surface'],
    pick_crosshair: ['Click or tap, while slices are shown', 'Put the crosshair on the surface'],
  } as Readonly<Record<string, GestureWords>>,
  slice_gestures_heading: 'In a slice',
  slice_gestures: {
    crosshair: ['Click or drag, or one finger', 'Move the crosshair'],
    scroll: ['Wheel, or the slider', 'Step through the slices'],
    window: [
      'Ctrl or Alt + drag, or drag after w',
      'Window: across its width, up and down its centre',
    ],
    zoom: ['Right drag, Ctrl + wheel, or pinch', 'Zoom about the pointer'],
    pan: ['Shift or middle drag, or two fingers', 'Pan'],
    tilt: ['Drag the end of a crosshair line', 'Tilt that plane'],
    lens: ['Drag the lens’ outline or its grips', 'Move or resize the lens'],
    enlarge: ['Double click', 'Enlarge the view, and back'],
  } as Readonly<Record<string, GestureWords>>,

  groups: {
    view: 'View',
    lens: 'Lens',
    measure: 'Measuring',
    style: 'Style and steps',
    views: 'Views',
    slices: 'In a slice',
    page: 'Page',
  },
  meanings: {
    rotate: 'Rotate',
    pan: 'Pan',
    move_lens: 'Move the lens over the surface',
    zoom_in: 'Zoom in',
    zoom_out: 'Zoom out',
    larger_lens: 'Larger lens',
    smaller_lens: 'Smaller lens',
    toggle_lens: 'Lens on or off',
    follow: 'Lens follows the pointer, until f, Esc or a drag',
    roll_left: 'Roll left',
    roll_right: 'Roll right',
    compare: 'Show the previous style while held',
    undo: 'Undo',
    redo: 'Redo',
    measure_distance: 'Measure a distance',
    measure_angle: 'Measure an angle',
    measure_probe: 'Read value and position at a point',
    move_point: 'With a tool: move the point, with Shift finely',
    place_point: 'With a tool: place the point',
    take_back_point: 'With a tool: take back the last point',
    cancel_measuring: 'Give up the measurement, then the tool',
    next_layout: 'Next layout: 3-D alone, all four, one large',
    enlarge: 'Enlarge this view, and back',
    lens_at_crosshair: 'Lens follows the crosshair, on or off',
    window_presets: 'Window: soft tissue, lung, bone, brain, liver',
    scroll: 'Next and previous slice',
    scroll_ten: 'Ten slices on and back',
    move_crosshair: 'Move the crosshair in the slice',
    zoom_slice: 'Zoom in and out',
    tilt: 'Tilt the other two planes',
    reset_tilt: 'Straighten the planes',
    reset_slice: 'Show the whole slice',
    drag_window: 'Drag changes the window, on or off',
    reset_view: 'Reset the view',
    status_line: 'Status line on or off',
    toggle_panel: 'Show or hide the panel',
    help: 'This sheet',
  },
};

/** The gesture, and what it does. */
type GestureWords = readonly [string, string];
