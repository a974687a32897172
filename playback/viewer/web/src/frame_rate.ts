// SPDX-License-Identifier: BSD-3-Clause

const kMostPictures = 120;

/** Number of pictures drawn per second recently. */
export class FrameRate {
  private readonly times_ms: number[] = [];

  note(now_ms: number): void {
    this.times_ms.push(now_ms);
    if (this.times_ms.length > kMostPictures) this.times_ms.shift();
  }

  perSecond(): number {
    const times = this.times_ms;
    return times.length > 1 ? (1000 * (times.length - 1)) / (times[times.length - 1] - times[0]) : 0;
  }
}
