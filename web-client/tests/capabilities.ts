// What a server says it can do, for tests: small, but with a control of every kind.
import type {
  CapabilitiesMessage,
  ModuleDescription,
  ParameterDescription,
  SceneStateMessage,
  VolumeSummary,
} from '../src/protocol/messages.ts';

const tone: ModuleDescription = {
  name: 'tone',
  title: 'Tone',
  description: 'Two colours.',
  parameters: [
    {
      name: 'detail',
      title: 'Detail',
      description: '',
      type: 'number',
      default: 1,
      minimum: 0,
      maximum: 1,
      step: 0.01,
      level: 'basic',
    },
    {
      name: 'dark',
      title: 'Dark',
      description: '',
      type: 'colour',
      default: [0.1, 0.2, 0.3],
      level: 'basic',
    },
    {
      name: 'lambert',
      title: 'Lambert',
      description: '',
      type: 'choice',
      default: 'half',
      choices: ['half', 'clamped'],
      level: 'advanced',
    },
  ],
};

const phong: ModuleDescription = {
  name: 'phong',
  title: 'Phong',
  description: 'Plain.',
  parameters: [
    {
      name: 'two_sided',
      title: 'Two-sided',
      description: '',
      type: 'boolean',
      default: true,
      level: 'basic',
    },
  ],
};

const blur: ModuleDescription = {
  name: 'blur',
  title: 'Blur',
  description: 'Blurs.',
  parameters: [
    {
      name: 'radius',
      title: 'Radius',
      description: '',
      type: 'integer',
      default: 2,
      minimum: 0,
      maximum: 15,
      unit: 'px',
      level: 'basic',
    },
  ],
};

const lines: ModuleDescription = {
  name: 'lines',
  title: 'Lines',
  description: 'Draws lines.',
  parameters: [],
};

const SECTION_CORNERS = 33;

export const sphere: ModuleDescription = {
  name: 'sphere',
  title: 'Sphere',
  description: '',
  parameters: [],
  outline: {
    profile: Array.from({ length: SECTION_CORNERS }, (_, index): [number, number] => {
      const angle = (Math.PI * index) / (SECTION_CORNERS - 1);
      return [Math.sin(angle), -Math.cos(angle)];
    }) as [[number, number], [number, number]],
    round: true,
  },
};

const half = (name: string, axis: 'x' | 'y' | 'z'): ParameterDescription => ({
  name,
  axis,
  title: name,
  description: '',
  type: 'number',
  default: 1,
  minimum: 0,
  maximum: 4,
  level: 'basic',
});

const turned = (name: string): ParameterDescription => ({
  name,
  title: name,
  description: '',
  type: 'number',
  default: 0,
  minimum: -180,
  maximum: 180,
  level: 'basic',
});

export const box: ModuleDescription = {
  name: 'box',
  title: 'Box',
  description: '',
  parameters: [
    half('width', 'x'),
    half('height', 'y'),
    half('depth', 'z'),
    turned('azimuth_degrees'),
    turned('elevation_degrees'),
    turned('roll_degrees'),
  ],
  outline: {
    profile: [
      [0, -1],
      [1, -1],
      [1, 1],
      [0, 1],
    ],
    round: false,
  },
};

export const capabilities: CapabilitiesMessage = {
  type: 'capabilities',
  protocol: 'cutaway.v1',
  server: 'cutaway',
  renderer: 'test',
  software_renderer: false,
  limits: {
    message_bytes: 65536,
    viewport_side_px: 4096,
    still_side_px: 8192,
    viewport_pixels: 8388608,
    frames_in_flight: 2,
  },
  modules: {
    shading: [tone, phong],
    filter: [blur, lines],
    lens_shape: [sphere, box],
  },
  styles: [
    {
      name: 'first',
      title: 'First',
      description: '',
      scene: { focus: { shading: { name: 'tone', detail: 0.5 } } },
    },
    {
      name: 'second',
      title: 'Second',
      description: '',
      scene: { focus: { shading: { name: 'phong' } } },
    },
  ],
  notice: 'Not for diagnostic use',
};

export const volume: VolumeSummary = {
  id: 'head',
  title: 'Head',
  modality: 'CT',
  units: 'HU',
  size_voxels: [4, 4, 4],
  spacing_mm: [1, 1, 2],
  origin_mm: [-2, -2, -4],
  axes: [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  bounds_minimum_mm: [-2, -2, -4],
  bounds_maximum_mm: [2, 2, 4],
  diagonal_mm: 90,
  value_range: [-1000, 3000],
  outer_iso_value: -200,
  inner_iso_value: 250,
  histogram: [5, 3, 1],
  warnings: [],
};

export const sceneMessage: SceneStateMessage & { volume: VolumeSummary } = {
  type: 'scene',
  revision: 1,
  input: 0,
  volume,
  scene: {
    version: 1,
    volume: 'head',
    camera: {
      projection: 'perspective',
      eye_mm: [0, -600, 0],
      target_mm: [0, 0, 0],
      up: [0, 0, 1],
      vertical_fov_degrees: 30,
    },
    focus: {
      surface: { iso_value: 300 },
      shading: { name: 'tone', detail: 0.5 },
      filters: [{ name: 'sobel', strength: 0.7 }],
    },
    context: { surface: { iso_value: -200 }, shading: { name: 'tone', detail: 0 }, filters: [] },
    lens: {
      mode: 'cutaway',
      shape: { name: 'sphere' },
      centre_mm: [0, -80, 0],
      radius_mm: 30,
      cap: 'flat',
    },
  },
};
