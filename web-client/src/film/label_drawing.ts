// Draws labels on a picture: light with a dark outline, so that they read on any ground.
import type { LabelLayout, MeasureText, PlacedBar, PlacedText, Weight } from './label_layout.ts';

type Context = OffscreenCanvasRenderingContext2D;

const LIGHT = '#fff';
const DARK = 'rgb(8 11 13 / 82%)';
/** In text sizes. */
const OUTLINE = 0.2;
const LINE = 0.11;
/** Of the ticks at the bar's ends. */
const INNER_TICK = 0.55;

const font = (size_px: number, weight: Weight): string =>
  `${weight} ${size_px}px system-ui, sans-serif`;

export function measureWith(context: Context): MeasureText {
  return (text, size_px, weight) => {
    context.font = font(size_px, weight);
    return context.measureText(text).width;
  };
}

function drawText(context: Context, { text, x, y, size_px, weight, anchor }: PlacedText): void {
  context.font = font(size_px, weight);
  context.textAlign = anchor;
  context.lineWidth = size_px * OUTLINE;
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

function barPath({ left, y, width, tick_px, parts }: PlacedBar): Path2D {
  const path = new Path2D();
  path.moveTo(left, y - tick_px);
  path.lineTo(left, y);
  path.lineTo(left + width, y);
  path.lineTo(left + width, y - tick_px);
  for (let part = 1; part < parts; part++) {
    const x = left + (width * part) / parts;
    path.moveTo(x, y);
    path.lineTo(x, y - tick_px * INNER_TICK);
  }
  return path;
}

function drawBar(context: Context, bar: PlacedBar, em_px: number): void {
  const path = barPath(bar);
  context.lineWidth = em_px * (LINE + OUTLINE);
  context.stroke(path);
  context.strokeStyle = LIGHT;
  context.lineWidth = em_px * LINE;
  context.stroke(path);
}

export function drawLabels(context: Context, { em_px, texts, bar }: LabelLayout): void {
  context.save();
  context.textBaseline = 'alphabetic';
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.strokeStyle = DARK;
  context.fillStyle = LIGHT;
  for (const text of texts) drawText(context, text);
  if (bar) drawBar(context, bar, em_px);
  context.restore();
}
