// SPDX-License-Identifier: BSD-3-Clause
import type { Clock } from "./clock";
import { make } from "./elements";
import { mainTrack, sampleAt, type MarkFile, type Motion } from "./scene";

const kRow = 9;

/** The bar to scrub on: which feet bear when, what happened, and a slider that the keyboard moves too. */
export class Timeline {
  readonly root = make("div", "gw-timeline");
  private readonly bars = document.createElement("canvas");
  private readonly slider = make("input", "gw-slider");
  private readonly needle = make("div", "gw-now");
  private readonly track = make("div", "gw-track");
  private readonly names = make("div", "gw-feet");

  constructor(
    private readonly motions: Motion[],
    private readonly clock: Clock,
  ) {
    Object.assign(this.slider, { type: "range", min: String(clock.start), max: String(clock.end), step: "0.005" });
    this.slider.setAttribute("aria-label", "time [s]");
    this.slider.addEventListener("input", () => {
      const wanted = Number(this.slider.value);  // pausing moves the slider to the time that is
      clock.pause();
      clock.set(wanted);
    });
    this.bars.setAttribute("aria-hidden", "true");
    this.track.append(this.bars, this.needle);
    for (const motion of motions) {
      for (const foot of motion.file.robot.feet) this.names.append(make("span", "", foot.name));
      for (const mark of motion.file.marks) this.addMark(mark);
    }
    this.track.addEventListener("pointerdown", (event) => this.press(event));
    this.track.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) this.press(event);
    });
    this.root.append(this.names, this.track, this.slider);
    new ResizeObserver(() => this.draw()).observe(this.track);
    clock.onChange((t) => {
      this.slider.value = String(t);
      this.needle.style.left = `${100 * this.share(t)}%`;
    });
  }

  /** Draws the bars in the colours that the page has now. */
  draw(): void {
    const width = this.track.clientWidth;
    const height = this.motions.reduce((sum, m) => sum + m.file.robot.feet.length * kRow, 0);
    const ratio = window.devicePixelRatio;
    this.bars.width = width * ratio;
    this.bars.height = height * ratio;
    this.bars.style.height = `${height}px`;
    const style = getComputedStyle(this.root);
    const context = this.bars.getContext("2d");
    if (!context || width === 0) return;
    context.scale(ratio, ratio);
    let top = 0;
    for (const motion of this.motions) {
      const { planned, measured } = motion;
      for (let foot = 0; foot < motion.file.robot.feet.length; ++foot, top += kRow) {
        if (planned) this.bar(context, motion, planned.contact.values, foot, top, kRow - 2, style.getPropertyValue("--gw-planned"));
        if (measured) this.bar(context, motion, measured.contact.values, foot, top + 2, kRow - 6, style.getPropertyValue("--gw-ink"));
      }
    }
  }

  private bar(context: CanvasRenderingContext2D, motion: Motion, contact: ArrayLike<number>, foot: number, top: number, height: number, colour: string): void {
    const feet = mainTrack(motion).contact.columns;
    const width = this.track.clientWidth;
    context.fillStyle = colour;
    let from = -1;
    for (let k = 0; k <= motion.time.length; ++k) {
      const bears = k < motion.time.length && contact[k * feet + foot] !== 0;
      if (bears && from < 0) from = k;
      if (!bears && from >= 0) {
        const left = width * this.share(motion.time[from]);
        const right = width * this.share(motion.time[Math.min(k, motion.time.length - 1)]);
        context.fillRect(left, top, Math.max(right - left, 1), height);
        from = -1;
      }
    }
  }

  private addMark(mark: MarkFile): void {
    const flag = make("button", `gw-mark gw-${mark.kind}`, mark.kind === "fall" ? "fall" : "");
    flag.style.left = `${100 * this.share(mark.at_s)}%`;
    flag.title = `${mark.at_s.toFixed(2)} s: ${mark.text}`;
    flag.setAttribute("aria-label", flag.title);
    flag.addEventListener("pointerdown", (event) => event.stopPropagation());
    flag.addEventListener("click", () => {
      this.clock.pause();
      this.clock.set(mark.at_s);
    });
    this.track.append(flag);
  }

  private press(event: PointerEvent): void {
    const box = this.track.getBoundingClientRect();
    this.clock.pause();
    this.clock.set(this.clock.start + ((event.clientX - box.left) / box.width) * (this.clock.end - this.clock.start));
  }

  private share(t: number): number {
    return (t - this.clock.start) / Math.max(this.clock.end - this.clock.start, 1e-9);
  }
}

/** Which feet bear at a time, by name. */
export function bearingFeet(motion: Motion, t: number): string[] {
  const { contact } = mainTrack(motion);
  const k = sampleAt(motion.time, t);
  return motion.file.robot.feet.filter((_, i) => contact.values[k * contact.columns + i] !== 0).map((foot) => foot.name);
}
