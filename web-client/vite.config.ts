import type { Plugin, Rolldown } from 'vite';
import { defineConfig } from 'vitest/config';
import { BUILD_TARGET } from './scripts/floor.mjs';
import { thirdPartyNotices } from './scripts/third_party.mjs';

/**
 * Web Awesome's default icon library carries the addresses of a CDN. Ours replaces it; the
 * addresses go as well.
 */
function withoutForeignIconAddresses(): Plugin {
  return {
    name: 'without-foreign-icon-addresses',
    apply: 'build',
    transform(code, id) {
      if (!id.includes('@awesome.me/webawesome') || !code.includes('fontawesome.com/'))
        return undefined;
      return { code: code.replaceAll(/https:\/\/[a-z-]+\.fontawesome\.com\//g, '/'), map: null };
    },
  };
}

/** Whether the page's entry imports it, itself or through others. */
function comesAtFirst(
  id: string,
  modules: Rolldown.ChunkingContext,
  seen = new Set<string>(),
): boolean {
  if (seen.has(id)) return false;
  seen.add(id);
  const module = modules.getModuleInfo(id);
  return (
    module?.isEntry === true ||
    (module?.importers ?? []).some((importer) => comesAtFirst(importer, modules, seen))
  );
}

const sharedAtFirst = {
  name: (id: string, modules: Rolldown.ChunkingContext) =>
    comesAtFirst(id, modules) ? 'shared' : null,
  debugName: 'shared',
  minShareCount: 2,
  priority: 1,
};

// Set by tests/run, which adds up the results of all languages.
const junit_file = process.env['VITEST_JUNIT'];
const server_address = process.env['CUTAWAY_ADDRESS'] ?? '127.0.0.1:8080';
const to_server = { target: `http://${server_address}` };

const notices = thirdPartyNotices();

export default defineConfig({
  base: './',
  plugins: [withoutForeignIconAddresses(), notices.page],
  server: {
    host: '127.0.0.1',
    proxy: {
      '/ws': { ...to_server, ws: true },
      '/api': to_server,
      '/healthz': to_server,
      '/readyz': to_server,
    },
  },
  build: {
    target: BUILD_TARGET,
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // What the page and its later parts share is one file, what these alone share another: many
    // small ones compress worse, and a first visit loads nothing that no first picture needs.
    rolldownOptions: {
      output: { codeSplitting: { groups: [sharedAtFirst, { name: 'later', minShareCount: 2 }] } },
    },
  },
  worker: { format: 'es', plugins: () => [notices.worker()] },
  test: {
    include: ['tests/**/*.test.ts'],
    environment: 'node',
    ...(junit_file ? { reporters: ['default', 'junit'], outputFile: { junit: junit_file } } : {}),
  },
});
