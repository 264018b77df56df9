import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { SCENE_GROUPS, SCENE_PATHS, type CapabilitiesMessage } from '../src/protocol/messages.ts';
import { groupReset } from '../src/state/group_reset.ts';
import { mergePatch, type JsonObject } from '../src/state/merge_patch.ts';
import { lookOf } from '../src/state/own_styles.ts';
import { fieldsOf, fieldsUnder, leftOpen, withoutFields } from '../src/state/scene_fields.ts';
import { styleFromFile } from '../src/state/style_file.ts';
import { capabilities } from './capabilities.ts';

const folder = fileURLToPath(new URL('../../protocol/fixtures/', import.meta.url));
const read = (path: string): JsonObject =>
  JSON.parse(readFileSync(`${folder}${path}`, 'utf8')) as JsonObject;

describe('what the schema says of the scene’s fields', () => {
  it('is said of each group', () => {
    for (const group of SCENE_GROUPS) expect(fieldsUnder(group).length).toBeGreaterThan(0);
    expect(new Set(SCENE_PATHS.map(({ path }) => path.join('/'))).size).toBe(SCENE_PATHS.length);
  });

  it.each(readdirSync(`${folder}belongings`))('parts a scene as the server does: %s', (name) => {
    const fixture = read(`belongings/${name}`);
    const scene = fixture['scene'] as JsonObject;
    expect(lookOf(scene)).toEqual(fixture['look']);
    expect(withoutFields(scene, fieldsOf('volume'))).toEqual(fixture['in_another_volume']);
    expect(mergePatch(scene, leftOpen(fieldsOf('volume')))).toMatchObject(
      fixture['in_another_volume'] as object,
    );
  });

  it('leaves no field of a group out when that is reset', () => {
    const { modules } = capabilities;
    const plain = { styles: [], modules } as Pick<CapabilitiesMessage, 'styles' | 'modules'>;
    expect(groupReset('focus', plain, undefined)).toEqual({
      focus: {
        surface: { iso_value: null, upper_value: null, opacity: null },
        shading: null,
        normals: { scale: null, scale_mm: null, reconstruction: null },
        occlusion: { strength: null, range_mm: null, near_share: null, colour: null },
        shadow: { strength: null, softness_degrees: null },
        filters: null,
      },
      preparation: { focus_islands_ml: null },
    });
    const { preparation } = groupReset('context', plain, undefined);
    expect(preparation).toEqual({
      hide_couch: null,
      fill_context: null,
      context_islands_ml: null,
    });
    expect(groupReset('lens', plain, undefined)).not.toHaveProperty('preparation');
  });

  it('takes an own style from any whole scene, slices and all', () => {
    const { scene } = read('belongings/whole.json');
    const { look } = read('belongings/whole.json');
    const style = styleFromFile(JSON.stringify(scene), 'Mine.scene.json');
    expect(style.scene).toEqual({ version: 1, ...(look as object) });
  });
});
