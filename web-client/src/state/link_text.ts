// Where the connection stands, in words.

/** `place` 1 is the next to be let in. */
export function queueText(place: number): string {
  const before = place === 1 ? 'You are next' : `You are number ${place} in the queue`;
  return `The server is full. ${before}; this page goes on by itself.`;
}
