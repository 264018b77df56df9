// The page's icons as the screen shows them.

/**
 * Of each icon in sight that can be used: the share of its place that ink covers, and the contrast of
 * the ink with what is behind it (WCAG 2.2, 1.4.3).
 */
export async function iconInks(page) {
  const icons = await page.until(iconsDrawn);
  return page.run(inksOf, await page.png(), icons);
}

/** Runs in the page. Nothing before the sprite is drawn. */
function iconsDrawn() {
  const all = (root) =>
    [...root.querySelectorAll('*')].flatMap((one) => [
      ...(one.localName === 'wa-icon' ? [one] : []),
      ...(one.shadowRoot ? all(one.shadowRoot) : []),
    ]);
  // The lens' grip lies on the picture, of any colour.
  const usable = all(document).filter(
    (icon) => !icon.closest('button')?.disabled && icon.getAttribute('name') !== 'move',
  );
  const boxes = usable.map((icon) => {
    const { x, y, width, height } = icon.shadowRoot.querySelector('svg').getBoundingClientRect();
    return { icon: icon.getAttribute('name'), x, y, width, height };
  });
  const in_sight = boxes.filter(
    ({ x, y, width, height }) =>
      width > 0 && x >= 0 && y >= 0 && x + width <= innerWidth && y + height <= innerHeight,
  );
  return in_sight.length > 0 && in_sight;
}

/** Runs in the page. The pixel in the corner of an icon's place is none of its ink. */
async function inksOf(base64, icons) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const scale = bitmap.width / innerWidth;
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  const luminance = (rgb) => {
    const [r, g, b] = rgb.map((part) => {
      const share = part / 255;
      return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  return icons.map(({ icon, ...box }) => {
    const [x, y, width, height] = [box.x, box.y, box.width, box.height].map((part) =>
      Math.round(part * scale),
    );
    const { data } = context.getImageData(x, y, width, height);
    const pixels = Array.from({ length: width * height }, (_, at) => [
      ...data.slice(4 * at, 4 * at + 3),
    ]);
    const behind = luminance(pixels[0]);
    const contrasts = pixels.map((pixel) => {
      const [low, high] = [luminance(pixel), behind].sort((a, b) => a - b);
      return (high + 0.05) / (low + 0.05);
    });
    // A pixel at a line's edge is ink in part.
    const inks = pixels.map((pixel) =>
      pixel.reduce((sum, part, at) => sum + Math.abs(part - pixels[0][at]), 0),
    );
    const darkest = Math.max(...inks, 1);
    return {
      icon,
      share: inks.reduce((sum, ink) => sum + ink / darkest, 0) / inks.length,
      contrast: Math.max(...contrasts),
    };
  });
}
