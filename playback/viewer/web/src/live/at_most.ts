// SPDX-License-Identifier: BSD-3-Clause

/** Passes on the latest of many values, at most so many times a second; the last value is always passed on. */
export class AtMost<T> {
  private waiting: { value: T } | null = null;
  private timer = 0;
  private last_ms = Number.NEGATIVE_INFINITY;

  constructor(
    private readonly perSecond: number,
    private readonly pass: (value: T) => void,
  ) {}

  put(value: T): void {
    this.waiting = { value };
    if (this.timer) return;
    const left_ms = this.last_ms + 1000 / this.perSecond - performance.now();
    if (left_ms <= 0) this.passOn();
    else this.timer = window.setTimeout(() => this.passOn(), left_ms);
  }

  /** Discards a waiting value. */
  drop(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    this.waiting = null;
  }

  private passOn(): void {
    const { waiting } = this;
    this.drop();
    this.last_ms = performance.now();
    if (waiting) this.pass(waiting.value);
  }
}
