// One stand-in session: messages in, frames out, with the credits and the still frame of
// protocol/README.md.
import { frameMessage } from './frame.mjs';
import { drawScene, drawSlice, surfaceUnder, valueAt } from './picture.mjs';
import { mergePatch, resolve } from './scene.mjs';
import { modules, validateClientMessage, validateScene } from './schemas.mjs';
import { planeOf, pointUnder } from './slice.mjs';
import { styles } from './styles.mjs';
import { MockView } from './view.mjs';
import { refused, summary, volumes } from './volumes.mjs';

const LOAD_STEP_MS = 60;

export class MockSession {
  #socket;
  #document = {};
  #views;
  #volume;
  #scene;
  #revision = 0;
  #input = { input: 0, clock_ms: 0 };
  #load;

  constructor(socket) {
    this.#socket = socket;
    this.#views = [0, 1, 2, 3].map(
      (view) => new MockView(view, socket, (...size) => this.#live(view, ...size)),
    );
    socket.on('message', (data) => this.#receive(String(data)));
    socket.on('close', () => {
      for (const view of this.#views) view.close();
      clearInterval(this.#load);
    });
    const limits = {
      message_bytes: 65536,
      viewport_side_px: 4096,
      viewport_pixels: 9437184,
      still_side_px: 8192,
      frames_in_flight: 2,
    };
    this.#send({
      type: 'capabilities',
      protocol: 'cutaway.v1',
      server: 'cutaway stand-in',
      renderer: 'two ellipsoids',
      software_renderer: true,
      limits,
      modules,
      styles,
      notice: 'Not for diagnostic use',
    });
    this.#send({
      type: 'volumes',
      volumes: volumes.map(({ entry }) => entry),
      refused,
      scanning: false,
    });
  }

  #send(message) {
    this.#socket.send(JSON.stringify(message));
  }

  #refuse(error, message) {
    this.#send({
      type: 'error',
      ...error,
      ...(message?.input !== undefined && { input: message.input }),
      ...(message?.request !== undefined && { request: message.request }),
    });
  }

  #receive(text) {
    const message = JSON.parse(text);
    if (!validateClientMessage(message)) {
      return this.#refuse(
        {
          code: 'out-of-range',
          message: 'The message does not fit its schema',
          field: validateClientMessage.errors[0].instancePath,
        },
        message,
      );
    }
    const { input, clock_ms } = message;
    if (message.type === 'ack') {
      return this.#views[message.view ?? 0].acknowledge(message.frame);
    }
    if (message.type === 'close_view') return this.#views[message.view].close();
    if (message.type === 'presence') return undefined;
    if (message.type === 'cancel_load') return this.#cancelLoad();
    if (message.type === 'save_still') {
      const scene = mergePatch(this.#scene, message.scene ?? {});
      return this.#sendPicture({ type: 2, flags: 3 }, message, this.#picture(scene, message));
    }
    if (message.type === 'preview') return void setTimeout(() => this.#preview(message));
    if (input !== undefined) this.#input = { input, clock_ms };
    if (message.type === 'viewport') {
      const { view = 0, width_px, height_px } = message;
      this.#views[view].viewport = { width_px, height_px };
      return this.#resolve(false);
    }
    if (message.type === 'pick') return this.#pick(message);
    if (message.type === 'drag_lens') return this.#dragLens(message);
    if (message.type === 'scene') return this.#changeScene(message);
  }

  #changeScene(message) {
    const document = mergePatch(message.replace ? {} : this.#document, message.scene);
    if (!validateScene(document)) {
      const [error] = validateScene.errors;
      return this.#refuse(
        {
          code: 'out-of-range',
          message: 'A field of the scene is not as it should be',
          field: error.instancePath,
          expected: error.message,
        },
        message,
      );
    }
    const wanted = volumes.find(({ entry }) => entry.id === document.volume);
    if (document.volume && !wanted) {
      return this.#refuse(
        {
          code: 'unknown-volume',
          message: 'There is no such volume',
          field: '/volume',
          received: document.volume,
        },
        message,
      );
    }
    if (wanted && wanted !== this.#volume)
      return this.#open(wanted, message.replace ? document : { ...message.scene });
    this.#document = document;
    this.#resolve(JSON.stringify(message.scene).includes('null') || message.replace);
  }

  #open(volume, document) {
    clearInterval(this.#load);
    const stages = ['read', 'decode', 'min_max', 'upload'];
    let step = 0;
    const report = () => {
      const stage = stages[Math.floor(step / 4)];
      if (stage)
        return this.#send({
          type: 'loading',
          volume: volume.entry.id,
          stage,
          fraction: (step++ % 4) / 4,
        });
      clearInterval(this.#load);
      this.#volume = volume;
      this.#document = { ...this.#look(), ...document };
      this.#send({ type: 'loading', volume: volume.entry.id, stage: 'ready', fraction: 1 });
      this.#resolve(true);
    };
    this.#load = setInterval(report, LOAD_STEP_MS);
    this.#loading = volume.entry.id;
  }

  #loading;

  #look() {
    const { focus, context, light, background } = this.#document;
    return Object.fromEntries(
      Object.entries({ focus, context, light, background }).filter(([, value]) => value),
    );
  }

  #cancelLoad() {
    clearInterval(this.#load);
    this.#send({ type: 'loading', volume: this.#loading, stage: 'cancelled', fraction: 0 });
  }

  #dragLens({ position_px }) {
    const centre_mm = this.#scene && surfaceUnder(this.#scene, this.#volume, position_px);
    if (!centre_mm) return;
    this.#document = mergePatch(this.#document, { lens: { centre_mm } });
    this.#resolve(true);
  }

  #pick({ view, request, position_px }) {
    if (view) return this.#pickInSlice(view, request, position_px);
    const position_mm = this.#scene && surfaceUnder(this.#scene, this.#volume, position_px);
    const value = this.#scene?.context.surface.iso_value;
    const hit = position_mm && { position_mm, value, units: 'HU', branch: 'context' };
    this.#send({ type: 'picked', request, ...hit });
  }

  #pickInSlice(view, request, position_px) {
    const { viewport } = this.#views[view];
    if (!this.#scene || !viewport) return this.#send({ type: 'picked', request });
    const position_mm = pointUnder(this.#plane(view), viewport, position_px);
    const value = valueAt(this.#volume, position_mm);
    this.#send({ type: 'picked', request, position_mm, value, units: 'HU' });
  }

  #resolve(tell) {
    const { viewport } = this.#views[0];
    if (!this.#volume || !viewport) return;
    this.#revision += 1;
    this.#scene = resolve(this.#document, this.#volume, viewport);
    this.#document = this.#scene;
    if (tell)
      this.#send({
        type: 'scene',
        revision: this.#revision,
        scene: this.#scene,
        volume: summary(this.#volume),
      });
    const { slices, ...volume } = this.#scene;
    this.#views[0].change(volume);
    for (const view of this.#views.slice(1)) view.change([volume.volume, slices]);
  }

  #live(view, width, height) {
    const picture =
      view === 0
        ? drawScene(this.#scene, this.#volume, width, height)
        : drawSlice(this.#scene, this.#volume, this.#plane(view), width, height);
    return { picture, revision: this.#revision, ...this.#input };
  }

  #plane(view) {
    return planeOf(this.#scene, this.#volume, view, this.#views[view].viewport);
  }

  #picture(scene, { width_px, height_px }, volume = this.#volume) {
    return drawScene(scene, volume, width_px, height_px);
  }

  #preview(message) {
    const style = styles.find(({ name }) => name === message.style);
    const other = volumes.find(({ entry }) => entry.id === message.volume);
    if (!this.#scene)
      return this.#refuse({ code: 'no-volume', message: 'No volume is open' }, message);
    if (message.style && !style)
      return this.#refuse(
        { code: 'unknown-style', message: 'There is no such style', field: '/style' },
        message,
      );
    const look = mergePatch(style?.scene ?? {}, message.scene ?? {});
    const document = mergePatch(other ? this.#look() : this.#document, look);
    const volume = other ?? this.#volume;
    const picture = this.#picture(resolve(document, volume, message), message, volume);
    this.#sendPicture({ type: 3, flags: 1 }, message, picture);
  }

  /** One that was asked for, beside the live frames. */
  #sendPicture(kind, { request, width_px, height_px }, picture) {
    const header = {
      ...kind,
      ...this.#input,
      frame: request,
      revision: this.#revision,
      viewport: { width_px, height_px },
    };
    const size = { width: width_px, height: height_px };
    this.#socket.send(frameMessage({ ...header, ...size, render_ms: 0 }, picture));
  }
}
