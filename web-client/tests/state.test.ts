import { describe, expect, it, vi } from 'vitest';
import type { Scene } from '../src/protocol/messages.ts';
import { fromHex, toHex } from '../src/state/colour.ts';
import { errorDetail } from '../src/state/error_text.ts';
import { lightAngles, lightDirection } from '../src/state/light_angles.ts';
import { mergePatch, nestedPatch, valueAt } from '../src/state/merge_patch.ts';
import { SceneAddressError, sceneFromAddress, sceneToAddress } from '../src/state/scene_address.ts';
import { SceneSync } from '../src/state/scene_sync.ts';
import { ShownView } from '../src/state/shown_view.ts';
import { Store } from '../src/state/store.ts';
import { matchingStyle, stylePatch } from '../src/state/style_patch.ts';
import { volumeFacts, volumeWarnings } from '../src/state/volume_text.ts';
import { capabilities } from './capabilities.ts';

describe('the store', () => {
  it('tells listeners of a change, with the state before it', () => {
    const store = new Store({ count: 1, name: 'a' });
    const heard = vi.fn();
    const unsubscribe = store.subscribe(heard);
    store.update({ count: 2 });
    expect(heard).toHaveBeenCalledExactlyOnceWith({ count: 2, name: 'a' }, { count: 1, name: 'a' });
    store.update({ count: 2 });
    unsubscribe();
    store.update({ count: 3 });
    expect(heard).toHaveBeenCalledOnce();
  });
});

describe('a merge patch', () => {
  it('changes what it says and nothing else', () => {
    expect(mergePatch({ a: { b: 1, c: 2 }, d: [1, 2] }, { a: { b: 3 }, d: [4] })).toEqual({
      a: { b: 3, c: 2 },
      d: [4],
    });
  });

  it('removes with null, also inside of something new', () => {
    expect(mergePatch({ a: { b: 1, c: 2 } }, { a: { b: null }, e: { f: null, g: 1 } })).toEqual({
      a: { c: 2 },
      e: { g: 1 },
    });
  });

  it('replaces a module of another name whole, and merges one of the same', () => {
    const base = { shading: { name: 'tone', detail: 0.5 } };
    expect(mergePatch(base, { shading: { name: 'phong' } })).toEqual({
      shading: { name: 'phong' },
    });
    expect(mergePatch(base, { shading: { name: 'tone', dark: 1 } })).toEqual({
      shading: { name: 'tone', detail: 0.5, dark: 1 },
    });
  });

  it('is built and read by path', () => {
    const patch = nestedPatch(['a', 'b', 'c'], 7);
    expect(patch).toEqual({ a: { b: { c: 7 } } });
    expect(valueAt(patch, ['a', 'b', 'c'])).toBe(7);
    expect(valueAt(patch, ['a', 'x', 'c'])).toBeUndefined();
  });
});

describe('the scene in the address', () => {
  const scene = {
    version: 1,
    volume: 'Kopf-Ü',
    camera: { eye_mm: [1.123456789, -600, 0] },
    viewport: { width_px: 800 },
  };

  it('comes back, without the window’s size and with seven digits', async () => {
    const address = await sceneToAddress(scene);
    expect(address).toMatch(/^#1\.[A-Za-z0-9_-]+$/);
    expect(await sceneFromAddress(address)).toEqual({
      version: 1,
      volume: 'Kopf-Ü',
      camera: { eye_mm: [1.123457, -600, 0] },
    });
  });

  it('is not there in an empty address', async () => {
    expect(await sceneFromAddress('')).toBeUndefined();
    expect(await sceneFromAddress('#')).toBeUndefined();
  });

  it.each(['#0.abc', '#1.', '#nonsense', '#1.!!!', '#1.AAAA', '#99.q1Y'])(
    'is refused in words: %s',
    async (address) => {
      await expect(sceneFromAddress(address)).rejects.toThrow(SceneAddressError);
    },
  );

  it('is refused where it is cut short', async () => {
    const address = await sceneToAddress(scene);
    await expect(sceneFromAddress(address.slice(0, -8))).rejects.toThrow('damaged');
  });

  it('is refused where it is no object or inflates without end', async () => {
    await expect(
      sceneFromAddress(await sceneToAddress({ text: 'x'.repeat(10_000_000) })),
    ).rejects.toThrow('too_large');
  });
});

describe('the page’s scene and the server’s', () => {
  const base = { lens: { radius_mm: 10, centre_mm: [0, 0, 0] }, focus: { detail: 1 } };

  it('is unknown before the server has spoken', () => {
    const sync = new SceneSync();
    sync.sent(1, { lens: { radius_mm: 3 } });
    expect(sync.scene).toBeUndefined();
  });

  it('keeps a newer change when an older answer arrives', () => {
    const sync = new SceneSync();
    sync.told(base);
    sync.stage({ lens: { radius_mm: 20 } });
    expect(sync.scene).toMatchObject({ lens: { radius_mm: 20 } });
    sync.sent(5, { lens: { radius_mm: 20 } });
    sync.told({ ...base, focus: { detail: 0 } });
    expect(sync.scene).toMatchObject({ lens: { radius_mm: 20 }, focus: { detail: 0 } });
  });

  it('takes the server’s word once a picture shows the change', () => {
    const sync = new SceneSync();
    sync.told(base);
    sync.sent(5, { lens: { radius_mm: 20 } });
    sync.shown(4);
    sync.told(base);
    expect(sync.scene).toMatchObject({ lens: { radius_mm: 20 } });
    sync.shown(5);
    expect(sync.scene).toMatchObject({ lens: { radius_mm: 20 } });
    sync.told(base);
    expect(sync.scene).toEqual(base);
  });

  it('goes back to the last good value where a change is refused', () => {
    const sync = new SceneSync();
    sync.told(base);
    sync.sent(5, { lens: { radius_mm: -1 } });
    sync.sent(6, { focus: { detail: 0.5 } });
    sync.refused(5);
    expect(sync.scene).toEqual({ ...base, focus: { detail: 0.5 } });
  });

  it('leaves a value that the server shall choose until it has', () => {
    const sync = new SceneSync();
    sync.told(base);
    sync.sent(5, { lens: { radius_mm: null } });
    expect(sync.scene).toEqual(base);
  });

  it('takes away at once what the server puts nothing in the place of', () => {
    const sync = new SceneSync();
    const banded = { focus: { surface: { iso_value: 1, upper_value: 9 } } };
    sync.told(banded);
    sync.sent(5, { focus: { surface: { upper_value: null } } });
    expect(sync.scene).toEqual({ focus: { surface: { iso_value: 1 } } });
    sync.refused(5);
    expect(sync.scene).toEqual(banded);
    sync.sent(6, { focus: { surface: { upper_value: null } } });
    sync.shown(6);
    expect(sync.scene).toEqual({ focus: { surface: { iso_value: 1 } } });
  });

  it('forgets a change on its way once the server shall choose that value', () => {
    const sync = new SceneSync();
    sync.told(base);
    sync.sent(5, { lens: { radius_mm: 20 }, focus: { detail: 0.5 } });
    sync.sent(6, { lens: { radius_mm: null } });
    const chosen = { lens: { radius_mm: 12, centre_mm: [0, 0, 0] }, focus: { detail: 0.5 } };
    sync.told(chosen);
    expect(sync.scene).toEqual(chosen);
    sync.shown(6);
    expect(sync.scene).toEqual(chosen);
  });

  it('leaves the lens to the server once it is dragged', () => {
    const sync = new SceneSync();
    sync.told(base);
    sync.sent(5, { lens: { radius_mm: 20, centre_mm: [9, 9, 9] } });
    sync.leaveOpen({ lens: { centre_mm: null } });
    sync.told({ ...base, lens: { radius_mm: 10, centre_mm: [1, 2, 3] } });
    expect(sync.scene).toMatchObject({ lens: { radius_mm: 20, centre_mm: [1, 2, 3] } });
  });
});

describe('what the picture shows', () => {
  const scene = (volume: string): Scene => ({ volume });

  it('is the newest step that the frame has reached, by input or by revision', () => {
    const shown = new ShownView<Scene>();
    shown.changedByServer(2, scene('opened'));
    shown.changedByInput(10, scene('turned'));
    shown.changedByServer(5, scene('dragged'));
    expect(shown.shownBy({ input: 3, revision: 1 })).toBeUndefined();
    expect(shown.shownBy({ input: 3, revision: 2 })).toEqual(scene('opened'));
    expect(shown.shownBy({ input: 10, revision: 4 })).toEqual(scene('turned'));
    expect(shown.shownBy({ input: 10, revision: 5 })).toEqual(scene('dragged'));
    expect(shown.shownBy({ input: 11, revision: 6 })).toEqual(scene('dragged'));
  });

  it('stays through a new session', () => {
    const shown = new ShownView<Scene>();
    shown.changedByInput(900, scene('old'));
    shown.restart(scene('old'));
    expect(shown.shownBy({ input: 1, revision: 1 })).toEqual(scene('old'));
  });
});

describe('styles', () => {
  const [first, second] = capabilities.styles;
  const worn: Scene = {
    volume: 'head',
    focus: { surface: { iso_value: 3 }, shading: { name: 'tone', detail: 0.5 } },
  };

  it('are recognised by all that they say', () => {
    expect(matchingStyle(worn, capabilities.styles)).toBe(first);
    expect(matchingStyle({ focus: { shading: { name: 'phong' } } }, capabilities.styles)).toBe(
      second,
    );
    expect(
      matchingStyle({ focus: { shading: { name: 'tone', detail: 0.6 } } }, capabilities.styles),
    ).toBeUndefined();
  });

  it('take a parameter that they leave out back to its default', () => {
    const patch = first && stylePatch(first, capabilities.modules);
    expect(patch).toEqual({
      focus: { shading: { name: 'tone', detail: 0.5, dark: null, lambert: null } },
    });
  });
});

describe('words and numbers for people', () => {
  it('say an error whole', () => {
    const error = {
      type: 'error',
      code: 'out-of-range',
      message: 'The radius is too large',
      field: '/lens/radius_mm',
      expected: '0 to 2000 mm',
      received: '9000',
    } as const;
    expect(errorDetail(error)).toBe(
      'The radius is too large. Field: /lens/radius_mm. Expected: 0 to 2000 mm. Received: 9000.',
    );
  });

  it('say of a volume what is known', () => {
    expect(
      volumeFacts({
        modality: 'CT',
        size_voxels: [512, 512, 275],
        spacing_mm: [0.78125, 0.78125, 1],
      }),
    ).toBe('CT · 512×512×275 · 0.781×0.781×1\u00a0mm');
    expect(volumeFacts({ modality: '' })).toBe('');
  });

  it('warn of a volume, once each, also of what was found when it was read', () => {
    const entry = { id: 'a', warnings: ['no spacing', 'no place'] };
    const open = { id: 'a', warnings: ['no place', 'values were rescaled'] };
    expect(volumeWarnings(entry, open)).toEqual(['no spacing', 'no place', 'values were rescaled']);
    expect(volumeWarnings(entry, { ...open, id: 'b' })).toEqual(entry.warnings);
    expect(volumeWarnings({ id: 'a' }, open)).toEqual(open.warnings);
    expect(volumeWarnings({ id: 'a' }, undefined)).toEqual([]);
  });

  it('turn colours into the browser’s form and back', () => {
    expect(toHex([1, 0.62, 0])).toBe('#ff9e00');
    expect(toHex(fromHex('#1a80ff'))).toBe('#1a80ff');
  });

  it('turn the light’s direction into angles and back', () => {
    expect(lightAngles([0, 0, 1])).toEqual({ azimuth_degrees: 0, elevation_degrees: 0 });
    const direction = lightDirection(lightAngles([-0.6, 0.64, 0.48]));
    [-0.6, 0.64, 0.48].forEach((part, axis) => expect(direction[axis]).toBeCloseTo(part));
  });
});
