// WebKitGTK's MiniBrowser by the W3C WebDriver protocol, on an X display of its own.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, rm } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { ended } from './ended.mjs';

const DRIVER = '/usr/bin/WebKitWebDriver';
const MINI_BROWSER = '/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser';
const X_SERVER = '/usr/bin/Xvfb';
export const WEBKIT_NEEDS = [DRIVER, MINI_BROWSER, X_SERVER];

const START_LIMIT_MS = 60_000;
const SCRIPT_LIMIT_MS = 60_000;

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  await once(server, 'close');
  return port;
}

export class WebKit {
  #x_server;
  #driver;
  #home;
  #address;
  #session;

  static async start(size) {
    const browser = new WebKit();
    try {
      await browser.#start(size);
    } catch (error) {
      await browser.close();
      throw error;
    }
    return browser;
  }

  async #start({ width, height }) {
    this.#home = await mkdtemp(join(tmpdir(), 'cutaway-webkit-'));
    const display = await this.#openDisplay(width, height);
    const port = await freePort();
    this.#address = `http://127.0.0.1:${port}`;
    this.#driver = spawn(DRIVER, [`--port=${port}`], {
      stdio: 'ignore',
      env: {
        ...process.env,
        DISPLAY: display,
        HOME: this.#home,
        LANGUAGE: 'en',
      },
    });
    await this.#answers();
    const options = { binary: MINI_BROWSER, args: ['--automation'] };
    const alwaysMatch = { 'webkitgtk:browserOptions': options };
    const { sessionId } = await this.#request('POST', '/session', {
      capabilities: { alwaysMatch },
    });
    this.#session = `/session/${sessionId}`;
    await this.#post('/timeouts', { script: SCRIPT_LIMIT_MS });
    await this.#post('/window/rect', { x: 0, y: 0, width, height });
  }

  /** Its name, once the server says that it is there. */
  async #openDisplay(width, height) {
    const screen = ['-screen', '0', `${width}x${height}x24`, '-nolisten', 'tcp'];
    this.#x_server = spawn(X_SERVER, ['-displayfd', '3', ...screen], {
      stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
    });
    const [number] = await once(this.#x_server.stdio[3], 'data');
    return `:${String(number).trim()}`;
  }

  async #answers() {
    for (const begun = performance.now(); performance.now() - begun < START_LIMIT_MS;) {
      const there = await fetch(`${this.#address}/status`).catch(() => undefined);
      if (there?.ok) return;
      await wait(50);
    }
    throw new Error(`${DRIVER} does not answer`);
  }

  async #request(method, path, body) {
    const options = { method, ...(body && { body: JSON.stringify(body) }) };
    const answer = await fetch(`${this.#address}${path}`, options);
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`${method} ${path}: ${value?.error}: ${value?.message}`);
    return value;
  }

  #post(command, body) {
    return this.#request('POST', `${this.#session}${command}`, body);
  }

  async goto(url) {
    await this.#post('/url', { url });
  }

  /** The script calls its last argument with the result. */
  script(script, args) {
    return this.#post('/execute/async', { script, args });
  }

  async perform(actions) {
    await this.#post('/actions', { actions });
  }

  screenshot() {
    return this.#request('GET', `${this.#session}/screenshot`);
  }

  async close() {
    if (this.#session) await this.#request('DELETE', this.#session).catch(() => undefined);
    await ended(this.#driver);
    await ended(this.#x_server);
    if (this.#home) await rm(this.#home, { recursive: true, force: true });
  }
}
