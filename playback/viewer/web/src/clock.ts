// SPDX-License-Identifier: BSD-3-Clause

/** The one time that everything on the page shows. */
export class Clock {
  speed = 1;
  private now: number;
  private runs = false;
  private readonly listeners: ((t: number) => void)[] = [];

  constructor(
    readonly start: number,
    readonly end: number,
  ) {
    this.now = start;
  }

  get time(): number {
    return this.now;
  }

  get playing(): boolean {
    return this.runs;
  }

  /** Told now, and whenever time or playing is another. */
  onChange(listener: (t: number) => void): void {
    this.listeners.push(listener);
    listener(this.now);
  }

  set(t: number): void {
    this.change(t, this.runs);
  }

  toggle(): void {
    this.change(!this.runs && this.now >= this.end ? this.start : this.now, !this.runs);
  }

  pause(): void {
    this.change(this.now, false);
  }

  /** Goes on by so many seconds of the reader's time; stops at the end. */
  advance(seconds: number): void {
    if (!this.runs) return;
    const next = this.now + seconds * this.speed;
    this.change(next, next < this.end);
  }

  private change(t: number, runs: boolean): void {
    const now = Math.min(Math.max(t, this.start), this.end);
    if (now === this.now && runs === this.runs) return;
    this.now = now;
    this.runs = runs;
    for (const listener of this.listeners) listener(now);
  }
}
