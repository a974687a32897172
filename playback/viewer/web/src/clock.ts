// SPDX-License-Identifier: BSD-3-Clause

/** The one time that everything on the page shows. */
export class Clock {
  playing = false;
  speed = 1;
  private now: number;
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

  onChange(listener: (t: number) => void): void {
    this.listeners.push(listener);
    listener(this.now);
  }

  set(t: number): void {
    this.now = Math.min(Math.max(t, this.start), this.end);
    for (const listener of this.listeners) listener(this.now);
  }

  toggle(): void {
    this.playing = !this.playing;
    if (this.playing && this.now >= this.end) this.now = this.start;
    this.set(this.now);
  }

  pause(): void {
    this.playing = false;
    this.set(this.now);
  }

  /** Goes on by so many seconds of the reader's time; stops at the end. */
  advance(seconds: number): void {
    if (!this.playing) return;
    const next = this.now + seconds * this.speed;
    if (next >= this.end) this.playing = false;
    this.set(next);
  }
}
