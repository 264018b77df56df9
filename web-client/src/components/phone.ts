// Where the panel is a sheet from below instead of a column beside the picture. The styles' media
// queries say the same.
const PHONE = matchMedia('(max-width: 720px)');

export const isPhone = (): boolean => PHONE.matches;
