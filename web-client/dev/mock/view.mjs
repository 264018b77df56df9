// One of a stand-in session's pictures: its size, its frame numbers and its credits.
import { frameMessage } from './frame.mjs';

const REST_MS = 200;
const LIVE_SCALE = 0.15;
const STILL_SCALE = 0.35;

export class MockView {
  viewport;
  #number;
  #socket;
  #draw;
  #frame = 0;
  #acknowledged = 0;
  #shown;
  #wanted;
  #drawing = false;
  #rest;

  /** `draw` gives the picture of a size in pixels, and the header's part that is not the view's own. */
  constructor(number, socket, draw) {
    this.#number = number;
    this.#socket = socket;
    this.#draw = draw;
  }

  close() {
    clearTimeout(this.#rest);
    this.viewport = undefined;
    this.#shown = undefined;
  }

  acknowledge(frame) {
    this.#acknowledged = frame;
    this.#pump();
  }

  /** `content` is all that the picture depends on: where that is what is shown, nothing is drawn. */
  change(content) {
    if (!this.viewport) return;
    this.#wanted = JSON.stringify([content, this.viewport]);
    if (this.#wanted === this.#shown) return;
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => this.#send(true), REST_MS);
    this.#pump();
  }

  #pump() {
    const full = this.#frame - this.#acknowledged >= 2;
    if (this.#wanted === this.#shown || this.#drawing || full) return;
    this.#drawing = true;
    setImmediate(() => {
      this.#drawing = false;
      this.#send(false);
    });
  }

  #send(still) {
    if (!this.viewport) return;
    this.#shown = this.#wanted;
    const began = performance.now();
    const [width, height] = Object.values(this.viewport).map((side) =>
      Math.max(1, Math.round(side * (still ? STILL_SCALE : LIVE_SCALE))),
    );
    const { picture, ...header } = this.#draw(width, height);
    this.#frame += 1;
    const own = { view: this.#number, frame: this.#frame, viewport: this.viewport };
    const flags = still ? 1 : 0;
    const render_ms = performance.now() - began;
    this.#socket.send(
      frameMessage({ ...header, ...own, flags, width, height, render_ms }, picture),
    );
  }
}
