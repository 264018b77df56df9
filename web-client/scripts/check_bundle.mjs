// The built client: small enough for a first visit, and with no address of another origin in it.
import { readdirSync, readFileSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const LARGEST_INITIAL_BYTES = 150 * 1000;
const dist = fileURLToPath(new URL('../dist', import.meta.url));
const files = readdirSync(dist, { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile() && extname(entry.name) !== '.gz')
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

/** A module that is imported only once it is wanted, by the name of its file. */
const LOADED_LATER = /import\(\s*[`'"]\.\/([\w.-]+\.js)[`'"]\s*\)/g;

const problems = [];
const loaded_later = new Set();
const bytes = new Map();
for (const file of files) {
  const content = readFileSync(file);
  bytes.set(basename(file), gzipSync(content, { level: 9 }).length);
  for (const [, name] of content.toString('latin1').matchAll(LOADED_LATER)) loaded_later.add(name);
  for (const [address] of content
    .toString('latin1')
    .matchAll(/(?:https?|wss?):\/\/[\w.-]+\.[a-z]{2,}[\w./-]*/g)) {
    if (!HARMLESS.some((known) => known.test(address)))
      problems.push(`${file}: address of another origin: ${address}`);
  }
}
const initial_bytes = [...bytes]
  .filter(([name]) => !loaded_later.has(name))
  .reduce((sum, [, size]) => sum + size, 0);
if (initial_bytes > LARGEST_INITIAL_BYTES)
  problems.push(`the bundle has ${initial_bytes} bytes gzipped, ${LARGEST_INITIAL_BYTES} at most`);

for (const problem of problems) console.error(problem);
console.log(
  `bundle: ${files.length} files, ${initial_bytes} bytes gzipped at first, ${[...loaded_later].join(', ') || 'nothing'} later`,
);
process.exitCode = problems.length > 0 ? 1 : 0;
