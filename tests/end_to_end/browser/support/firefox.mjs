// Debian's Firefox by its own end of the WebDriver protocol, Marionette: JSON over TCP, each message
// after its length.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { ended } from './ended.mjs';

const FIREFOX = process.env.CUTAWAY_FIREFOX ?? '/usr/bin/firefox-esr';
export const FIREFOX_NEEDS = [FIREFOX];

const START_LIMIT_MS = 60_000;
const SCRIPT_LIMIT_MS = 60_000;
const COLON = 58;
const [COMMAND, ANSWER] = [0, 1];

/** On a first visit it shows no page of its own; a free port is written into the profile. */
const PREFERENCES = `
user_pref('marionette.port', 0);
user_pref('intl.accept_languages', 'en-GB');
user_pref('browser.shell.checkDefaultBrowser', false);
user_pref('datareporting.policy.dataSubmissionEnabled', false);
user_pref('toolkit.telemetry.reportingpolicy.firstRun', false);
user_pref('app.update.enabled', false);
`;

export class Firefox {
  #process;
  #profile;
  #socket;
  #received = Buffer.alloc(0);
  #waiting = new Map();
  #last = 0;

  static async start(size) {
    const browser = new Firefox();
    try {
      await browser.#start(size);
    } catch (error) {
      await browser.close();
      throw error;
    }
    return browser;
  }

  async #start({ width, height }) {
    this.#profile = await mkdtemp(join(tmpdir(), 'cutaway-firefox-'));
    await writeFile(join(this.#profile, 'user.js'), PREFERENCES);
    const options = ['--headless', '--no-remote', '--marionette', '--profile', this.#profile];
    const size = [`--width=${width}`, `--height=${height}`];
    this.#process = spawn(FIREFOX, [...options, ...size], {
      stdio: 'ignore',
      env: { ...process.env, HOME: this.#profile },
    });
    this.#socket = connect(Number(await this.#port()), '127.0.0.1');
    this.#socket.on('data', (bytes) => this.#receive(bytes));
    this.#socket.on('close', () => this.#gone());
    await once(this.#socket, 'connect');
    await this.#command('NewSession', { capabilities: {} });
    await this.#command('SetTimeouts', { script: SCRIPT_LIMIT_MS });
    await this.#resize(width, height);
  }

  async #port() {
    for (const begun = performance.now(); performance.now() - begun < START_LIMIT_MS;) {
      const path = join(this.#profile, 'MarionetteActivePort');
      const port = await readFile(path, 'utf8').catch(() => '');
      if (port) return port;
      await wait(50);
    }
    throw new Error(`${FIREFOX} names no port`);
  }

  /** The page's size: the window is larger by its own bars. */
  async #resize(width, height) {
    const [width_more, height_more] = await this.script(
      'arguments[0]([outerWidth - innerWidth, outerHeight - innerHeight])',
      [],
    );
    await this.#command('SetWindowRect', {
      width: width + width_more,
      height: height + height_more,
    });
  }

  #receive(bytes) {
    this.#received = Buffer.concat([this.#received, bytes]);
    for (;;) {
      const colon = this.#received.indexOf(COLON);
      if (colon < 0) return;
      const end = colon + 1 + Number(this.#received.subarray(0, colon));
      if (this.#received.length < end) return;
      const message = JSON.parse(this.#received.subarray(colon + 1, end).toString());
      this.#received = this.#received.subarray(end);
      if (Array.isArray(message) && message[0] === ANSWER) this.#answer(message);
    }
  }

  #answer([, id, error, result]) {
    const { resolve, reject } = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (error) reject(new Error(`${error.error}: ${error.message}`));
    else resolve(result);
  }

  #gone() {
    for (const { reject } of this.#waiting.values()) reject(new Error('Firefox has ended'));
  }

  #command(name, parameters = {}) {
    const text = JSON.stringify([COMMAND, ++this.#last, `WebDriver:${name}`, parameters]);
    const answer = new Promise((resolve, reject) => {
      this.#waiting.set(this.#last, { resolve, reject });
    });
    this.#socket.write(`${Buffer.byteLength(text)}:${text}`);
    return answer;
  }

  async goto(url) {
    await this.#command('Navigate', { url });
  }

  /** The script calls its last argument with the result. */
  async script(script, args) {
    const { value } = await this.#command('ExecuteAsyncScript', {
      script,
      args,
    });
    return value;
  }

  async perform(actions) {
    await this.#command('PerformActions', { actions });
  }

  async screenshot() {
    const { value } = await this.#command('TakeScreenshot', { full: false });
    return value;
  }

  async close() {
    this.#socket?.destroy();
    await ended(this.#process);
    if (this.#profile) await rm(this.#profile, { recursive: true, force: true });
  }
}
