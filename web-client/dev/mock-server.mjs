// A stand-in for `cutaway serve`, for work on the client alone: node dev/mock-server.mjs [--port N]
// [--web FOLDER]. It speaks protocol/README.md; its pictures are PNG, which a browser takes where
// JPEG is announced.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { WebSocketServer } from 'ws';
import { MockSession } from './mock/session.mjs';

const { values } = parseArgs({
  options: {
    port: { type: 'string', default: '8080' },
    web: { type: 'string', default: fileURLToPath(new URL('../dist', import.meta.url)) },
  },
});

const TYPES = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
};

const server = createServer(async (request, response) => {
  const path = normalize(new URL(request.url, 'http://localhost').pathname);
  const file = path === '/' ? '/index.html' : path;
  try {
    const content = await readFile(join(values.web, file));
    response
      .writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' })
      .end(content);
  } catch {
    response.writeHead(404).end();
  }
});

const sockets = new WebSocketServer({ server, path: '/ws', handleProtocols: () => 'cutaway.v1' });
sockets.on('connection', (socket) => new MockSession(socket));

server.listen(Number(values.port), '127.0.0.1', () => {
  console.log(`http://127.0.0.1:${server.address().port}/`);
});
