// Things that are made one after the other, the next while the last is used.

/** In their order. `make` is called for at most `ahead` that have not been taken yet. */
export async function* pipelined<Item>(
  count: number,
  ahead: number,
  make: (index: number) => Promise<Item>,
): AsyncGenerator<Item, void, undefined> {
  const coming: Promise<Item>[] = [];
  let next = 0;
  const refill = (): void => {
    for (; next < count && coming.length < ahead; next++) {
      const made = make(next);
      // Whoever waits for it hears of its failure; until somebody does, it is no unheard one.
      void made.catch(() => undefined);
      coming.push(made);
    }
  };
  refill();
  while (coming[0]) {
    const item = await coming[0];
    void coming.shift();
    refill();
    yield item;
  }
}
