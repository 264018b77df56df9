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
  caps: { Shift: 'Shift', Alt: 'Alt', Ctrl: 'Ctrl', Esc: 'Esc' },

  gestures: {
    rotate: ['Drag, or one finger', 'Rotate'],
    pan: ['Shift or middle drag, or two fingers', 'Pan'],
    zoom: ['Wheel or right drag, or pinch', 'Zoom'],
    move_lens: ['Drag the grip in the lens', 'Move the lens over the surface'],
    resize_lens: ['Alt or Shift + wheel, or drag the rim', 'Resize the lens'],
    place_point: ['Click or tap with a measuring tool', 'Place a point on the surface'],
  } as Readonly<
    Record<'rotate' | 'pan' | 'zoom' | 'move_lens' | 'resize_lens' | 'place_point', GestureWords>
  >,

  groups: {
    view: 'View',
    lens: 'Lens',
    measure: 'Measuring',
    style: 'Style and steps',
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
    rotate_with_tool: 'With a tool: rotate the view, with Shift pan',
    place_point: 'With a tool: place the point',
    take_back_point: 'With a tool: take back the last point',
    cancel_measuring: 'Give up the measurement, then the tool',
    reset_view: 'Reset the view',
    export: 'Export a picture or a film; ends a recording',
    record: 'Record the view for a film, or end that',
    status_line: 'Status line on or off',
    toggle_panel: 'Show or hide the panel',
    help: 'This sheet',
  },
};

/** The gesture, and what it does. */
type GestureWords = readonly [string, string];
