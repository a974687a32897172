// SPDX-License-Identifier: BSD-3-Clause

/** A number with a number of decimals, and without a sign if it is zero. */
export function rounded(value: number, digits: number): string {
  const figure = value.toFixed(digits);
  return Number(figure) === 0 ? (0).toFixed(digits) : figure;
}
