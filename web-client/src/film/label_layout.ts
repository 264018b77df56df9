// Where the labels of an exported picture stand, in its pixels from its upper left corner. The
// volume's name is in the upper left corner, a slice's facts in the upper right one, the notice and
// the scale bar in the lower ones, the patient's directions in the middle of the edges.
import type { Viewport } from '../view/camera.ts';
import { scaleBar, scaleText } from '../view/scale_bar.ts';
import { words } from '../words/words.ts';
import type { PictureLabels, PictureScale } from './picture_labels.ts';

export type Weight = 500 | 700;
export type Anchor = 'left' | 'center' | 'right';

/** `x` is where the anchor is, `y` the letters' baseline. */
export interface PlacedText {
  readonly text: string;
  readonly x: number;
  readonly y: number;
  readonly size_px: number;
  readonly weight: Weight;
  readonly anchor: Anchor;
}

/** A line with a tick at each end and between its equal parts. `y` is the line's. */
export interface PlacedBar {
  readonly left: number;
  readonly y: number;
  readonly width: number;
  readonly tick_px: number;
  readonly parts: number;
}

export interface LabelLayout {
  /** Of text and lines, for their outlines. */
  readonly em_px: number;
  readonly texts: readonly PlacedText[];
  readonly bar: PlacedBar | undefined;
}

/** How wide a text is, px. */
export type MeasureText = (text: string, size_px: number, weight: Weight) => number;

/** Of the picture's shorter side, with a least size that can be read. */
const TEXT_SHARE = 0.016;
const SMALLEST_TEXT_PX = 11;

/** In text sizes. */
const LETTER = 1.6;
const LINE = 1.45;
const TICK = 0.5;
const BAR_GAP = 0.4;
const LONGEST_BAR = 12;
/** Of a letter's size, how high a capital is. */
const CAPITAL = 0.72;
/** Of the picture's width. */
const BAR_SHARE = 0.25;
/** Shorter sides than these, in text sizes, have room for the notice alone, or for no scale. */
const SMALLEST_SIDE = 6;
const SMALLEST_SIDE_WITH_BAR = 10;

const ELLIPSIS = '…';

/** The text, or as much of its beginning as is not wider than `room_px`. */
function shortened(text: string, room_px: number, width: (text: string) => number): string {
  if (width(text) <= room_px) return text;
  const letters = Array.from(text);
  while (letters.length > 0 && width(letters.join('').trimEnd() + ELLIPSIS) > room_px)
    letters.pop();
  return letters.length > 0 ? letters.join('').trimEnd() + ELLIPSIS : '';
}

class LabelPlan {
  private readonly em_px: number;
  private readonly letter_px: number;
  private readonly line_px: number;
  private readonly texts: PlacedText[] = [];

  constructor(
    private readonly size: Viewport,
    private readonly labels: PictureLabels,
    private readonly measure: MeasureText,
  ) {
    const shorter_px = Math.min(size.width_px, size.height_px);
    this.em_px = Math.max(SMALLEST_TEXT_PX, Math.round(shorter_px * TEXT_SHARE));
    this.letter_px = Math.round(this.em_px * LETTER);
    this.line_px = this.em_px * LINE;
  }

  make(): LabelLayout {
    const { size, em_px, texts } = this;
    const side_em = Math.min(size.width_px, size.height_px) / em_px;
    const has_room = side_em >= SMALLEST_SIDE;
    if (has_room) this.sides();
    if (has_room) this.top();
    const bar = this.bottom(side_em >= SMALLEST_SIDE_WITH_BAR, has_room);
    return { em_px, texts, bar };
  }

  private readonly width = (text: string): number => this.measure(text, this.em_px, 500);

  /** What the letter in the middle of an edge leaves on each side of it. */
  private besideLetter(letter = ''): number {
    const letter_width = letter && this.measure(letter, this.letter_px, 700) + this.em_px * 2;
    return (this.size.width_px - Number(letter_width)) / 2 - this.em_px;
  }

  private write(text: string, x: number, y: number, anchor: Anchor, size_px = this.em_px): void {
    if (text) this.texts.push({ text, x, y, size_px, weight: 500, anchor });
  }

  private letter(text: string | undefined, x: number, y: number, anchor: Anchor): void {
    if (text) this.texts.push({ text, x, y, size_px: this.letter_px, weight: 700, anchor });
  }

  private sides(): void {
    const { size, em_px, letter_px, labels } = this;
    const y = size.height_px / 2 + (letter_px * CAPITAL) / 2;
    this.letter(labels.letters?.left, em_px, y, 'left');
    this.letter(labels.letters?.right, size.width_px - em_px, y, 'right');
  }

  /** Where the corners have no room beside the letter, it stands beneath one column of lines. */
  private top(): void {
    const { size, em_px, line_px, labels } = this;
    const { title = '', facts = [], letters } = labels;
    const beside_px = this.besideLetter(letters?.top);
    if (facts.every((fact) => this.width(fact) <= beside_px)) {
      this.write(shortened(title, beside_px, this.width), em_px, this.topLine(0), 'left');
      const there = facts.slice(0, this.linesAbove(0));
      there.forEach((fact, at) =>
        this.write(fact, size.width_px - em_px, this.topLine(at), 'right'),
      );
      return this.topLetter(0);
    }
    const lines = [...facts, title].slice(0, this.linesAbove(line_px));
    lines.forEach((line, at) => {
      const text = shortened(line, size.width_px - 2 * em_px, this.width);
      this.write(text, em_px, this.topLine(at), 'left');
    });
    this.topLetter(lines.length * line_px);
  }

  private topLine(at: number): number {
    return this.em_px + this.em_px * CAPITAL + at * this.line_px;
  }

  private topLetter(down_px: number): void {
    const y = this.em_px + this.letter_px * CAPITAL + down_px;
    this.letter(this.labels.letters?.top, this.size.width_px / 2, y, 'center');
  }

  /** How many lines end above the letters in the middle of the sides, and leave so much. */
  private linesAbove(left_px: number): number {
    const { size, em_px, letter_px, line_px } = this;
    const room_px = size.height_px / 2 - letter_px / 2 - em_px - left_px;
    return Math.max(0, Math.floor(room_px / line_px));
  }

  /** Where the corners have no room beside the letter, the notice has a line for itself. */
  private bottom(has_bar: boolean, has_letter: boolean): PlacedBar | undefined {
    const { size, em_px, line_px, labels } = this;
    const letter = has_letter ? labels.letters?.bottom : undefined;
    const beside_px = this.besideLetter(letter);
    const has_corners = this.width(labels.notice) <= beside_px;
    const base = size.height_px - em_px;
    this.notice(base);
    const y = has_corners ? base : base - line_px;
    this.letter(letter, size.width_px / 2, y, 'center');
    return has_bar && labels.scale ? this.bar(labels.scale, y, beside_px) : undefined;
  }

  /** Smaller rather than cut. */
  private notice(y: number): void {
    const { size, em_px } = this;
    const { notice } = this.labels;
    const margin_px = Math.min(em_px, size.width_px / 20);
    const share = Math.min(1, (size.width_px - 2 * margin_px) / this.width(notice));
    this.write(notice, margin_px, y, 'left', em_px * share);
  }

  private bar(
    { mm_per_pixel, foreshortens }: PictureScale,
    y: number,
    room_px: number,
  ): PlacedBar | undefined {
    const { size, em_px } = this;
    const longest_px = Math.min(LONGEST_BAR * em_px, size.width_px * BAR_SHARE, room_px);
    const bar = scaleBar(mm_per_pixel, longest_px);
    if (!bar) return undefined;
    const right = size.width_px - em_px;
    const length = scaleText(bar.length_mm);
    const whole = foreshortens ? words().export.at_target_depth(length) : length;
    const tick_px = em_px * TICK;
    const text = this.width(whole) <= room_px ? whole : length;
    this.write(text, right, y - tick_px - em_px * BAR_GAP, 'right');
    return {
      left: right - bar.width_css_px,
      y,
      width: bar.width_css_px,
      tick_px,
      parts: bar.parts,
    };
  }
}

export const labelLayout = (
  size: Viewport,
  labels: PictureLabels,
  measure: MeasureText,
): LabelLayout => new LabelPlan(size, labels, measure).make();
