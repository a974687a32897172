// SPDX-License-Identifier: BSD-3-Clause
import type { Clock } from "./clock";
import { make, tell } from "./elements";
import { mainTrack, namesOf, sampleAt, type MarkFile, type Motion } from "./scene";

/** Heights of a foot's row and of the room above a motion's feet, as in the style sheet. */
const kRow = 13;
const kHead = 18;
const kLine = 10;
/** Overhang of a mark above the rows of its feet; gap between a mark and its words. */
const kOut = 4;
const kGap = 8;

/** The time bar: contact of each foot, events, and a slider for mouse and keyboard. */
export class Timeline {
  readonly root = make("div", "gw-timeline");
  private readonly bars = document.createElement("canvas");
  private readonly slider = make("input", "gw-slider");
  private readonly needle = make("div", "gw-now");
  private readonly track = make("div", "gw-track");
  private readonly names = make("div", "gw-feet");
  /** The words beside marks, and the share of the track that is free for them. */
  private readonly words: { element: HTMLElement; share: number }[] = [];
  private width = 0;

  constructor(
    private readonly motions: Motion[],
    private readonly clock: Clock,
  ) {
    Object.assign(this.slider, { type: "range", min: String(clock.start), max: String(clock.end), step: "0.005" });
    this.slider.setAttribute("aria-label", "time [s]");
    this.slider.addEventListener("input", () => {
      const wanted = Number(this.slider.value);  // pausing moves the slider to the present time
      clock.pause();
      clock.set(wanted);
    });
    this.bars.setAttribute("aria-hidden", "true");
    this.track.append(this.bars, this.needle);
    let top = 0;
    namesOf(motions).forEach((name, i) => {
      const { robot, marks } = motions[i].file;
      robot.feet.forEach((foot, k) => this.addName(k === 0 ? name : "", foot.name, k === 0));
      for (const mark of marks) this.addMark(name, mark, top, heightOf(motions[i]));
      top += heightOf(motions[i]);
    });
    this.track.addEventListener("pointerdown", (event) => this.press(event));
    this.track.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) this.press(event);
    });
    this.root.append(this.names, this.track, this.slider);
    new ResizeObserver(() => this.draw()).observe(this.track);
    clock.onChange((t) => this.showTime(t));
  }

  /** Draws the bars in the current colours of the page. */
  draw(): void {
    const width = this.track.clientWidth;
    this.width = width;
    this.placeNeedle(this.clock.time);
    for (const { element, share } of this.words) element.style.maxWidth = `${Math.max(width * share - kGap, 0)}px`;
    const height = this.motions.reduce((sum, m) => sum + heightOf(m), 0);
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
      top += kHead;
      for (let foot = 0; foot < motion.file.robot.feet.length; ++foot, top += kRow) {
        if (planned) this.bar(context, motion, planned.contact.values, foot, top, kLine, style.getPropertyValue("--gw-planned"));
        if (measured) this.bar(context, motion, measured.contact.values, foot, top + 3, kLine - 6, style.getPropertyValue("--gw-ink"));
      }
    }
  }

  private showTime(t: number): void {
    this.slider.value = String(t);
    tell(this.slider, "aria-valuetext", `${t.toFixed(this.clock.playing ? 1 : 3)} s`);
    this.placeNeedle(t);
  }

  private placeNeedle(t: number): void {
    this.needle.style.transform = `translateX(${this.width * this.share(t)}px)`;
  }

  private bar(
    context: CanvasRenderingContext2D, motion: Motion, contact: ArrayLike<number>, foot: number, top: number, height: number, colour: string,
  ): void {
    const feet = mainTrack(motion).contact.columns;
    const { width } = this;
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

  /**
   * @param motion  empty if there is only one.
   * @param isFirst  of its motion.
   */
  private addName(motion: string, foot: string, isFirst: boolean): void {
    const name = make("span", isFirst ? "gw-first" : "");
    if (motion) {
      const which = make("small");
      which.append(make("bdi", "", motion));
      name.append(which);
    }
    name.append(make("b", "", foot));
    name.title = [motion, foot].filter(Boolean).join(": ");
    this.names.append(name);
  }

  /** Placed on the rows of its own motion. The reason of a fall is beside it, on the side with more room. */
  private addMark(motion: string, mark: MarkFile, top: number, height: number): void {
    const flag = make("button", `gw-mark gw-${mark.kind}`), share = this.share(mark.at_s);
    const isFall = mark.kind === "fall", head = isFall ? 0 : kHead - kOut;
    Object.assign(flag.style, { left: `${100 * share}%`, top: `${top + head}px`, height: `${height - head}px` });
    if (isFall) {
      const element = make("span", share > 0.5 ? "gw-before" : "", `fall: ${mark.text}`);
      this.words.push({ element, share: Math.max(share, 1 - share) });
      flag.append(element);
    }
    flag.title = `${motion ? `${motion}, ` : ""}${mark.at_s.toFixed(2)} s: ${mark.text}`;
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

function heightOf(motion: Motion): number {
  return kHead + motion.file.robot.feet.length * kRow;
}

/** Names of the feet that carry load at a time. */
export function bearingFeet(motion: Motion, t: number): string[] {
  const { contact } = mainTrack(motion);
  const k = sampleAt(motion.time, t);
  return motion.file.robot.feet.filter((_, i) => contact.values[k * contact.columns + i] !== 0).map((foot) => foot.name);
}
