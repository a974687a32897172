// SPDX-License-Identifier: BSD-3-Clause
import type { DofFile } from "../scene";

export const kDegrees = 180 / Math.PI;
export const kMillimetres = 1000;

/** From a joint's own unit to the one in which it is read: degrees or millimetres. */
export function scaleOf(dof: DofFile): number {
  return dof.unit === "rad" ? kDegrees : kMillimetres;
}
