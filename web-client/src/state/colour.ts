// Colours as the protocol has them (display-encoded sRGB, 0..1) and as the browser's colour input
// has them ('#rrggbb').

const toByte = (part: number): number => Math.round(Math.min(1, Math.max(0, part)) * 255);

export function toHex(colour: readonly number[]): string {
  const parts = [0, 1, 2].map((index) =>
    toByte(colour[index] ?? 0)
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${parts.join('')}`;
}

export function fromHex(hex: string): [number, number, number] {
  const part = (start: number): number =>
    Number((Number.parseInt(hex.slice(start, start + 2), 16) / 255).toFixed(4));
  return [part(1), part(3), part(5)];
}
