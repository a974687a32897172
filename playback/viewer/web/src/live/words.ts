// SPDX-License-Identifier: BSD-3-Clause
import { rounded } from "../figures";
import type { Mode, Pace } from "./messages";

export const kModeWords: Record<Mode, string> = {
  stands: "stands",
  walks: "walks",
  posed: "held in a pose",
  fallen: "has fallen",
};

/** A force as text, with more digits for small forces of light robots. */
export function newtons(force_n: number): string {
  const size = Math.abs(force_n);
  return `${rounded(force_n, size < 1 ? 2 : size < 10 ? 1 : 0)} N`;
}

/** A number, its unit as written after it, and its side: left if positive. */
export function sided(value: number, digits: number, unit: string): string {
  const figure = Math.abs(value).toFixed(digits);
  return `${figure}${unit}${Number(figure) === 0 ? "" : value > 0 ? " left" : " right"}`;
}

export function paceWords(pace: Pace): string {
  if (pace.gait === "stand") return "stand";
  const parts = [`${pace.gait} at ${pace.speed_m_s.toFixed(2)} m/s`];
  if (pace.lateral_speed_m_s !== 0) parts.push(`sideways ${sided(pace.lateral_speed_m_s, 2, " m/s")}`);
  if (pace.yaw_rate_rad_s !== 0) parts.push(`turning ${sided(pace.yaw_rate_rad_s, 2, " rad/s")}`);
  return parts.join(", ");
}
