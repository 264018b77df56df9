import { expect, test } from 'vitest';
import { bestVolume } from '../src/state/best_volume.ts';

const entry = (id: string, worth: number | undefined, format = 'NIfTI') => ({
  id,
  title: id,
  format,
  modality: 'CT',
  ...(worth === undefined ? {} : { worth }),
});

test('the volume best worth seeing is opened, not the first of the alphabet', () => {
  expect(bestVolume([entry('a-mask', 0.05), entry('chest', 0.9), entry('head', 0.6)])?.id).toBe(
    'chest',
  );
});

test('files come before phantoms, and of equals the first', () => {
  expect(bestVolume([entry('phantom:head', 1, 'phantom'), entry('slab', 0.01)])?.id).toBe('slab');
  expect(bestVolume([entry('one', 0.5), entry('two', 0.5)])?.id).toBe('one');
  expect(bestVolume([entry('old-server', undefined), entry('two', undefined)])?.id).toBe(
    'old-server',
  );
  expect(bestVolume([])).toBeUndefined();
});
