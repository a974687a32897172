// SPDX-License-Identifier: BSD-3-Clause
import { disable, make, write } from "../elements";

/** Time after a motion of the slider during which it does not follow the program, because the answer is on the way. */
const kQuiet_ms = 500;
const kLogarithmicSteps = 400;

export interface SliderOptions {
  /** Name of the input element, for scripts and tests. */
  name: string;
  label: string;
  title?: string;
  /** Accessible name, if the label alone is not clear. */
  spoken?: string;
  least: number;
  most: number;
  step: number;
  value: number;
  /** The number as shown. */
  words: (value: number) => string;
  logarithmic?: boolean;
  /** Larger values are on the left, for quantities that turn or shift a robot to the left. */
  leftward?: boolean;
  /** Labels of its ends, for values with hard limits. */
  ends?: [string, string];
  /** The range moves along if the followed value leaves it. */
  wanders?: boolean;
}

/** A number that a person sets and that the program may change too: label, slider and readout. */
export class Slider {
  readonly root = make("label", "gw-slide");
  readonly input = make("input");
  /** Called while it is moved. */
  onMove: (value: number) => void = () => {};
  /** Called when it is released. */
  onSet: (value: number) => void = () => {};
  private readonly readout = make("span", "gw-value");
  private now: number;
  private held = false;
  private moved_ms = Number.NEGATIVE_INFINITY;

  constructor(private readonly options: SliderOptions) {
    this.now = options.value;
    const ends = options.logarithmic ? { min: "0", max: String(kLogarithmicSteps), step: "1" } : { step: String(options.step) };
    Object.assign(this.input, { type: "range", name: options.name, ...ends });
    if (options.leftward) this.input.dir = "rtl";
    this.root.title = options.title ?? "";
    this.input.setAttribute("aria-label", options.spoken ?? options.label);
    const [low, high] = (options.ends ?? []).map((end) => make("small", "gw-end", end));
    this.root.append(make("span", "gw-name", options.label), ...(low ? [low, this.input, high] : [this.input]), this.readout);
    this.setRange(options.least, options.most);
    this.input.addEventListener("pointerdown", () => this.holdUntilLetGo());
    this.input.addEventListener("input", () => this.move());
    this.input.addEventListener("change", () => {
      this.move();
      this.onSet(this.now);
    });
  }

  get value(): number {
    return this.now;
  }

  /** Whether a person is moving it. */
  get busy(): boolean {
    return this.held || performance.now() - this.moved_ms < kQuiet_ms;
  }

  get disabled(): boolean {
    return this.input.disabled;
  }

  /** @param why  reason for which it is disabled; "" enables it. */
  disable(why: string): void {
    disable(this.input, why);
  }

  /** Shows a value from the program, unless a person is moving the slider. */
  follow(value: number | null | undefined): void {
    if (value == null || value === this.now || this.busy) return;
    this.set(value);
  }

  /** Shows a value that was requested by another control. */
  put(value: number): void {
    this.moved_ms = performance.now();
    this.set(value);
  }

  private set(value: number): void {
    this.now = value;
    const { least, most } = this.options;
    if (this.options.wanders && (value < least || value > most)) {
      const middle = Number(value.toPrecision(2));
      this.setRange(middle - 0.5 * (most - least), middle + 0.5 * (most - least));
    }
    this.show();
  }

  private setRange(least: number, most: number): void {
    Object.assign(this.options, { least, most });
    if (!this.options.logarithmic) Object.assign(this.input, { min: String(least), max: String(most) });
    this.show();
  }

  /** Handles a release anywhere. */
  private holdUntilLetGo(): void {
    this.held = true;
    const ended = new AbortController();
    const letGo = () => {
      this.held = false;
      ended.abort();
    };
    for (const end of ["pointerup", "pointercancel", "blur"]) window.addEventListener(end, letGo, { signal: ended.signal });
  }

  private move(): void {
    this.moved_ms = performance.now();
    this.now = this.fromThumb(Number(this.input.value));
    this.tell();
    this.onMove(this.now);
  }

  private show(): void {
    this.input.value = String(this.toThumb(this.now));
    this.tell();
  }

  private tell(): void {
    const words = this.options.words(this.now);
    if (this.readout.textContent === words) return;
    write(this.readout, words);
    this.input.setAttribute("aria-valuetext", words);
  }

  private toThumb(value: number): number {
    const { logarithmic, least, most } = this.options;
    return logarithmic ? (kLogarithmicSteps * Math.log(value / least)) / Math.log(most / least) : value;
  }

  /** With three digits if it is logarithmic. */
  private fromThumb(thumb: number): number {
    const { logarithmic, least, most } = this.options;
    if (!logarithmic) return thumb;
    if (thumb <= 0 || thumb >= kLogarithmicSteps) return thumb <= 0 ? least : most;
    return Number((least * (most / least) ** (thumb / kLogarithmicSteps)).toPrecision(3));
  }
}
