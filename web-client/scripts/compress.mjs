// Writes NAME.gz beside each file of the built client, for the server to send as it is.
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const dist = fileURLToPath(new URL('../dist', import.meta.url));
for (const entry of readdirSync(dist, { recursive: true, withFileTypes: true })) {
  const path = join(entry.parentPath, entry.name);
  if (entry.isFile() && extname(path) !== '.gz')
    writeFileSync(`${path}.gz`, gzipSync(readFileSync(path), { level: 9 }));
}
