// SPDX-License-Identifier: BSD-3-Clause

/** A figure with so many digits after its point, and no sign where it is nought. */
export function rounded(value: number, digits: number): string {
  const figure = value.toFixed(digits);
  return Number(figure) === 0 ? (0).toFixed(digits) : figure;
}
