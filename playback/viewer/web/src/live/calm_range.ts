// SPDX-License-Identifier: BSD-3-Clause

/** Time for which the data must need a smaller range before the axis shrinks. */
const kShrinkAfter_ms = 1000;
const kStepsWide = 4;

/** The smallest of 1, 2 and 5 times a power of ten that is not less than a number. */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5].find((step) => step * power >= least * (1 - 1e-9)) ?? 10);
}

/** The ends of an axis: round numbers around the data. They widen at once and shrink after a delay. */
export class CalmRange {
  private ends: [number, number] | null = null;
  private roomSince_ms = 0;

  /** @param span  smallest range shown. */
  constructor(
    private readonly span: number,
    private readonly withZero: boolean,
  ) {}

  /** The range of an axis that contains two values. */
  around(low: number | null, high: number | null, now_ms: number): [number, number] {
    const { ends } = this;
    if (ends && (low === null || high === null)) return ends;
    const wanted = this.outward(low ?? 0, high ?? 0);
    if (!ends) return (this.ends = wanted);
    const grown: [number, number] = [Math.min(ends[0], wanted[0]), Math.max(ends[1], wanted[1])];
    if (grown[0] === wanted[0] && grown[1] === wanted[1]) this.roomSince_ms = now_ms;
    if (now_ms - this.roomSince_ms > kShrinkAfter_ms) return (this.ends = wanted);
    return (this.ends = grown);
  }

  clear(): void {
    this.ends = null;
  }

  private outward(low: number, high: number): [number, number] {
    const least = this.withZero ? Math.min(low, 0) : low, most = this.withZero ? Math.max(high, 0) : high;
    const air = Math.max(0.5 * (this.span - (most - least)), 0);
    const step = roundStep((most - least + 2 * air) / kStepsWide);
    return [step * Math.floor((least - air) / step), step * Math.ceil((most + air) / step)];
  }
}
