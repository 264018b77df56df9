// A light's direction as two angles that sliders can show. In its frame: x right, y up, z to the
// viewer.
import type { Vector3 } from '../view/vector.ts';

const DEGREES = 180 / Math.PI;

export interface LightAngles {
  /** From straight ahead towards the right, -180..180. */
  readonly azimuth_degrees: number;
  /** From the horizontal up, -90..90. */
  readonly elevation_degrees: number;
}

export function lightAngles([x, y, z]: Vector3): LightAngles {
  return {
    azimuth_degrees: Math.atan2(x, z) * DEGREES,
    elevation_degrees: Math.atan2(y, Math.hypot(x, z)) * DEGREES,
  };
}

/** Unit length. */
export function lightDirection({
  azimuth_degrees,
  elevation_degrees,
}: LightAngles): [number, number, number] {
  const azimuth = azimuth_degrees / DEGREES;
  const elevation = elevation_degrees / DEGREES;
  const level = Math.cos(elevation);
  return [Math.sin(azimuth) * level, Math.sin(elevation), Math.cos(azimuth) * level];
}
