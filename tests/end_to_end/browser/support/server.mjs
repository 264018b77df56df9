// The server under test: the executable that CUTAWAY_BINARY names, or, where it is unset, the
// client's own stand-in.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

const repository = fileURLToPath(new URL('../../../../', import.meta.url));
const alikeStills = fileURLToPath(new URL('stills.toml', import.meta.url));
const binary = process.env.CUTAWAY_BINARY;

export const isStandIn = !binary;

/** The executable finds the built client beside itself, in its own repository. */
function commandFor(port, options) {
  if (!isStandIn) return [binary, ['serve', '--listen', `127.0.0.1:${port}`, ...options]];
  const stand_in = `${repository}web-client/dev/mock-server.mjs`;
  return [process.execPath, [stand_in, '--port', String(port)]];
}

export class Server {
  #process;
  #options;
  url;

  constructor(options) {
    this.#options = options;
  }

  /**
   * Port 0 picks a free one. `data` are folders with volumes, `config` is a file; the stand-in takes
   * neither.
   */
  static async start({ port = 0, data = [], config = alikeStills } = {}) {
    const folders = data.flatMap((folder) => ['--data', folder]);
    const server = new Server([...folders, '--config', config]);
    await server.#start(port);
    return server;
  }

  async #start(port) {
    const [command, options] = commandFor(port, this.#options);
    this.#process = spawn(command, options, {
      stdio: ['ignore', 'pipe', 'pipe'],
    });
    this.#process.stderr.resume();
    const gone = once(this.#process, 'exit').then(([status]) => {
      throw new Error(`the server ended with status ${status} before it said its address`);
    });
    gone.catch(() => undefined);
    this.url = await Promise.race([this.#announcedAddress(), gone]);
  }

  async #announcedAddress() {
    for await (const line of createInterface({ input: this.#process.stdout })) {
      const [address] = /https?:\/\/[\d.]+:\d+\/?/.exec(line) ?? [];
      if (!address) continue;
      this.#process.stdout.resume();
      return address.replace(/\/?$/, '/');
    }
    throw new Error('the server said no address');
  }

  /** At once, as in a crash. */
  async kill() {
    const exit = once(this.#process, 'exit');
    this.#process.kill('SIGKILL');
    await exit;
  }

  /** Answers nothing until it goes on. */
  stall() {
    this.#process.kill('SIGSTOP');
  }

  goOn() {
    this.#process.kill('SIGCONT');
  }

  async startAgain() {
    await this.#start(Number(new URL(this.url).port));
  }
}
