// A Vite plugin: leaves `third-party-licences.txt` beside the page, with the notice of every package of which something is
// in what was built. Licences ask for it of whoever hands the page on.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

export const NOTICES_FILE = 'third-party-licences.txt';

/** The folder of the package that a module belongs to; nothing for a module of ours. */
function packageFolder(module_id) {
  const found = /^(.*\/node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(module_id.replace(/^\0/, ''));
  return found?.[1];
}

function notice(folder) {
  const { name, version, license, author } = JSON.parse(
    readFileSync(join(folder, 'package.json'), 'utf8'),
  );
  const files = readdirSync(folder).filter((file) => /^(licen[cs]e|notice|copying)\b/i.test(file));
  if (files.length === 0 && !license) throw new Error(`${folder}: neither licence file nor field`);
  const texts = files.map((file) => readFileSync(join(folder, file), 'utf8').trim());
  if (texts.length === 0) texts.push(`Copyright ${author?.name ?? author ?? `${name}'s authors`}`);
  return [`${name} ${version}: ${license}`, ...texts].join('\n\n');
}

/** One for the page and for its workers, which are built apart and before it ends. */
export function thirdPartyNotices() {
  const folders = new Set();
  const note = (bundle) => {
    for (const chunk of Object.values(bundle))
      for (const id of chunk.moduleIds ?? []) {
        const folder = packageFolder(id);
        if (folder && existsSync(join(folder, 'package.json'))) folders.add(folder);
      }
  };
  return {
    worker: () => ({ name: 'third-party-of-workers', generateBundle: (_, bundle) => note(bundle) }),
    page: {
      name: 'third-party-notices',
      apply: 'build',
      generateBundle(_, bundle) {
        note(bundle);
        const source = [...folders]
          .sort()
          .map(notice)
          .join(`\n\n${'-'.repeat(80)}\n\n`);
        this.emitFile({ type: 'asset', fileName: NOTICES_FILE, source: `${source}\n` });
      },
    },
  };
}
