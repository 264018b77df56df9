export const BUILD_TARGET: string[];
export function newerThanFloor(text: string, is_script: boolean): string[];
