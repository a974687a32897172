// SPDX-License-Identifier: BSD-3-Clause

/** The common time of everything on the page. */
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

  /** The listener is called now, and whenever the time or the playing state changes. */
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

  /** Advances by a number of seconds of real time; stops at the end. */
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
