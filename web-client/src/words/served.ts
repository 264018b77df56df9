// Names and descriptions that the server sends, in the page's language where its catalogue has
// them; the server's English where it has not.
import type {
  CapabilitiesMessage,
  ModuleDescription,
  ParameterDescription,
  Style,
  VolumeEntry,
} from '../protocol/messages.ts';

/** Of a module, a parameter, a style. */
export interface NameWords {
  readonly title: string;
  readonly description: string;
}

type ByName<Value> = Readonly<Record<string, Value>>;

export interface ServedWords {
  /** By registry and name: 'filter.sobel'. */
  readonly modules: ByName<NameWords>;
  /** By registry, module and name: 'filter.sobel.strength'. */
  readonly parameters: ByName<NameWords>;
  /** By the choice's value. */
  readonly choices: ByName<string>;
  /** By the unit's English abbreviation. */
  readonly units: ByName<string>;
  readonly styles: ByName<NameWords>;
  /** By id; those that every server has. */
  readonly volumes: ByName<string>;
  /** By the English notice. */
  readonly notices: ByName<string>;
}

export const AS_SERVED: ServedWords = {
  modules: {},
  parameters: {},
  choices: {},
  units: {},
  styles: {},
  volumes: {},
  notices: {},
};

function parameterInWords(
  parameter: ParameterDescription,
  module: string,
  { parameters }: ServedWords,
): ParameterDescription {
  return { ...parameter, ...parameters[`${module}.${parameter.name}`] };
}

function moduleInWords(
  registry: string,
  module: ModuleDescription,
  served: ServedWords,
): ModuleDescription {
  const name = `${registry}.${module.name}`;
  const parameters = module.parameters.map((parameter) =>
    parameterInWords(parameter, name, served),
  );
  return { ...module, ...served.modules[name], parameters };
}

const styleInWords = (style: Style, { styles }: ServedWords): Style => ({
  ...style,
  ...styles[style.name],
});

export function capabilitiesInWords(
  capabilities: CapabilitiesMessage,
  served: ServedWords,
): CapabilitiesMessage {
  const { modules, styles, notice } = capabilities;
  const registry = (name: keyof typeof modules): ModuleDescription[] =>
    modules[name].map((module) => moduleInWords(name, module, served));
  return {
    ...capabilities,
    modules: {
      shading: registry('shading'),
      filter: registry('filter'),
      lens_shape: registry('lens_shape'),
    },
    styles: styles.map((style) => styleInWords(style, served)),
    notice: served.notices[notice] ?? notice,
  };
}

/** Of a volume's entry in the list, and of what is said of the open one. */
export function volumeInWords<Volume extends Pick<VolumeEntry, 'id' | 'title'>>(
  volume: Volume,
  { volumes }: ServedWords,
): Volume {
  return { ...volume, title: volumes[volume.id] ?? volume.title };
}
