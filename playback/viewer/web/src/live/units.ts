// SPDX-License-Identifier: BSD-3-Clause
import type { DofFile } from "../scene";

export const kDegrees = 180 / Math.PI;
export const kMillimetres = 1000;

/** Converts from a joint's own unit to the displayed one: degrees or millimetres. */
export function scaleOf(dof: DofFile): number {
  return dof.unit === "rad" ? kDegrees : kMillimetres;
}
