// Forms of a phrase by number, and numbers, as a language has them.

export interface PluralForms {
  readonly one: string;
  readonly other: string;
}

/** '#' in a form stands for the number. */
export function pluralIn(language: string): (count: number, forms: PluralForms) => string {
  const rules = new Intl.PluralRules(language);
  const number = new Intl.NumberFormat(language);
  return (count, { one, other }) =>
    (rules.select(count) === 'one' ? one : other).replace('#', number.format(count));
}

/** With so many digits after the point. */
export function numberIn(language: string): (value: number, digits?: number) => string {
  return (value, digits = 0) =>
    new Intl.NumberFormat(language, {
      minimumFractionDigits: digits,
      maximumFractionDigits: digits,
    }).format(value);
}

/** As many digits as tell it from others, whatever its size. */
export function valueIn(language: string): (value: number | undefined) => string {
  const format = new Intl.NumberFormat(language, { maximumSignificantDigits: 6 });
  return (value = 0) => format.format(value);
}
