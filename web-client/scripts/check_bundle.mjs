// The built client: small enough for a first visit, with no address of another origin in it, and with
// nothing that the oldest browsers lack.
import { readdirSync, readFileSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { newerThanFloor } from './floor.mjs';
import { NOTICES_FILE } from './third_party.mjs';

const LARGEST_INITIAL_BYTES = 120 * 1000;
const dist = fileURLToPath(new URL('../dist', import.meta.url));
const files = readdirSync(dist, { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile() && extname(entry.name) !== '.gz')
  .filter((entry) => entry.name !== NOTICES_FILE)
  .map((entry) => join(entry.parentPath, entry.name));

/** Names in comments, in namespaces and in links for people; nothing that a page loads. */
const HARMLESS = [
  /^http:\/\/www\.w3\.org\//,
  /^https:\/\/fontawesome\.com/,
  /^https:\/\/webawesome\.com\//,
  /^https:\/\/issues\.chromium\.org\//,
  /^https:\/\/www\.w3\.org\/TR\//,
  /^https:\/\/www\.webmproject\.org\//,
  /^https:\/\/aomediacodec\.github\.io\//,
];

/** By the name of a module's file: at once with the module that says so, or once it is wanted. */
const IMPORTED = /(?:from|import)\s*[`'"]\.\/([\w.-]+\.js)[`'"]/g;
const LOADED_LATER = /import\(\s*[`'"]\.\/([\w.-]+\.js)[`'"]\s*\)/g;

const problems = [];
const imports = new Map();
const loaded_later = new Set();
const bytes = new Map();
for (const file of files) {
  const content = readFileSync(file);
  const text = content.toString('latin1');
  bytes.set(basename(file), gzipSync(content, { level: 9 }).length);
  imports.set(basename(file), new Set([...text.matchAll(IMPORTED)].map(([, name]) => name)));
  for (const [, name] of text.matchAll(LOADED_LATER)) loaded_later.add(name);
  if (['.js', '.css'].includes(extname(file)))
    for (const problem of newerThanFloor(content.toString(), extname(file) === '.js'))
      problems.push(`${file}: ${problem}`);
  for (const [address] of text.matchAll(/(?:https?|wss?):\/\/[\w.-]+\.[a-z]{2,}[\w./-]*/g)) {
    if (!HARMLESS.some((known) => known.test(address)))
      problems.push(`${file}: address of another origin: ${address}`);
  }
}

/** With all that come with them. */
function withImports(names) {
  const found = new Set(names);
  for (const name of found) for (const imported of imports.get(name) ?? []) found.add(imported);
  return found;
}

const imported_by_some = new Set([...imports.values()].flatMap((names) => [...names]));
const initial = withImports(
  [...bytes.keys()].filter((name) => !loaded_later.has(name) && !imported_by_some.has(name)),
);
const initial_bytes = [...initial].reduce((sum, name) => sum + bytes.get(name), 0);
if (initial_bytes > LARGEST_INITIAL_BYTES)
  problems.push(`the bundle has ${initial_bytes} bytes gzipped, ${LARGEST_INITIAL_BYTES} at most`);

for (const problem of problems) console.error(problem);
console.log(
  `bundle: ${files.length} files, ${initial_bytes} bytes gzipped at first, ${[...loaded_later].join(', ') || 'nothing'} later`,
);
process.exitCode = problems.length > 0 ? 1 : 0;
