// Why a picture shows nothing, from the server's message to the page's words.
import { beforeEach, describe, expect, it } from 'vitest';
import { readFileSync } from 'node:fs';
import type { UnseenReason } from '../src/protocol/messages.ts';
import { english } from '../src/words/english.ts';
import { german } from '../src/words/german.ts';
import { Harness } from './harness.ts';

const above: UnseenReason = {
  code: 'above-all-values',
  message: 'in English',
  branch: 'focus',
  value: 12_345.5,
  limit: 3_071,
};

describe('a picture that shows nothing', () => {
  let harness: Harness;
  beforeEach(async () => {
    harness = new Harness();
    await harness.connect();
  });

  it('has its reasons until the server withdraws them', () => {
    expect(harness.state.unseen).toEqual([]);
    harness.say({ type: 'unseen', reasons: [above] });
    expect(harness.state.unseen).toEqual([above]);
    harness.say({ type: 'unseen', reasons: [] });
    expect(harness.state.unseen).toEqual([]);
  });

  it('has none of a session that is over: the next one says its own', async () => {
    harness.say({ type: 'unseen', reasons: [above] });
    await harness.connect();
    expect(harness.state.unseen).toEqual([]);
  });
});

describe('the words for it', () => {
  const schema = JSON.parse(
    readFileSync(
      new URL('../../protocol/schema/server-message.schema.json', import.meta.url),
      'utf8',
    ),
  ) as {
    definitions: { unseen_reason: { properties: { code: { enum: UnseenReason['code'][] } } } };
  };
  const codes = schema.definitions.unseen_reason.properties.code.enum;

  it.each([english, german])('are there for every code ($language)', ({ unseen }) => {
    const sentences = codes.map((code) => unseen[code]({ ...above, code }));
    expect(sentences.every((sentence) => sentence.endsWith('.'))).toBe(true);
    expect(new Set(sentences).size).toBe(codes.length);
  });

  it('name the branch and both numbers, as the language writes them', () => {
    expect(english.unseen['above-all-values'](above)).toBe(
      'Nothing of the focus can be seen: its iso-value, 12,345.5, is above all values, which end at 3,071.',
    );
    expect(german.unseen['above-all-values']({ ...above, branch: 'context' })).toBe(
      'Vom Kontext ist nichts zu sehen: sein Isowert, 12.345,5, liegt über allen Werten, die bei 3.071 enden.',
    );
  });
});
