// SPDX-License-Identifier: BSD-3-Clause
import { button, make } from "../elements";
import type { OptionFile } from "./messages";
import { Slider } from "./slider";

/** Largest distance of a slider's end from the default value, as a factor. */
const kFarthest = 4;
const kFarthestLogarithmic = 100;
const kWideRange = 100;
const kSteps = 200;

/** The part of an option's range that its slider has: the whole range, except values far from the default. */
export function sliderRange(option: OptionFile): { least: number; most: number; logarithmic: boolean } {
  const lowest = option.lowest ?? Number.NEGATIVE_INFINITY, highest = option.highest ?? Number.POSITIVE_INFINITY;
  const usual = option.value, size = Math.abs(usual) || 1;
  const logarithmic = lowest > 0 && usual > 0 && highest / lowest > kWideRange;
  if (logarithmic) {
    const [near, far] = [usual / kFarthestLogarithmic, usual * kFarthestLogarithmic];
    return { least: Math.max(lowest, near), most: Math.min(highest, far), logarithmic };
  }
  return { least: Math.max(lowest, usual - kFarthest * size), most: Math.min(highest, usual + kFarthest * size), logarithmic };
}

/** A number with the digits that it needs. */
export function figure(value: number): string {
  return String(Number(value.toPrecision(4)));
}

/** "swing_acceleration_m_s2" as words; the unit is shown separately. */
function words(name: string): string {
  return name.replace(/(_rad_s2?|_m_s2?|_rad|_deg|_s|_m|_n)$/, "").replaceAll("_", " ").replace("dcm", "DCM");
}

/** One option of the controller: slider, number field, and a button for its default value. */
export class OptionRow {
  readonly root = make("div", "gw-option");
  onSet: (value: number) => void = () => {};
  /** Called for a value that is not accepted. */
  onRefuse: (why: string) => void = () => {};
  private readonly slider: Slider;
  private readonly field = make("input");
  private readonly back = button("\u21ba", "", () => this.set(this.option.value));

  constructor(
    readonly key: string,
    readonly option: OptionFile,
  ) {
    const range = sliderRange(option), step = (range.most - range.least) / kSteps;
    this.slider = new Slider({
      name: key, label: words(key.slice(key.indexOf(".") + 1)), title: `${key}: ${option.meaning}`, spoken: key, ...range, step,
      value: option.value, words: figure,
    });
    this.slider.input.setAttribute("aria-description", option.meaning);
    this.slider.onMove = () => this.tell();
    this.slider.onSet = (value) => this.set(Number(value.toPrecision(3)));
    Object.assign(this.field, { type: "number", name: key, step: "any", min: String(option.lowest ?? ""), max: String(option.highest ?? "") });
    this.field.setAttribute("aria-label", key);
    this.field.addEventListener("change", () => this.take());
    this.back.title = `reset to the default, ${figure(option.value)}`;
    this.back.setAttribute("aria-label", `${key}: ${this.back.title}`);
    this.root.append(this.slider.root, this.field, make("small", "", option.unit === "1" ? "" : option.unit), this.back);
    this.tell();
  }

  get isUsual(): boolean {
    return Math.abs(this.slider.value - this.option.value) <= 1e-6 * Math.abs(this.option.value);
  }

  follow(value: number | null): void {
    if (document.activeElement === this.field) return;
    this.slider.follow(value);
    this.tell();
  }

  /** Shows a value without a request. */
  show(value: number): void {
    this.slider.put(value);
    this.tell();
  }

  private take(): void {
    const { value } = this.field;
    if (value !== "" && this.field.checkValidity()) return this.set(this.field.valueAsNumber);
    this.tell();
    this.onRefuse(`${this.key}: ${value === "" ? "not a number" : `${value} is not accepted`}; accepted: ${this.limits()}`);
  }

  private limits(): string {
    const { lowest, highest, unit } = this.option;
    const ends = [lowest === null ? "" : `from ${figure(lowest)}`, highest === null ? "" : `to ${figure(highest)}`].filter(Boolean);
    return `${ends.join(" ") || "any number"}${unit === "1" ? "" : ` ${unit}`}`;
  }

  private set(value: number): void {
    this.show(value);
    this.onSet(value);
  }

  private tell(): void {
    const value = figure(this.slider.value);
    if (this.field.value !== value) this.field.value = value;
    this.back.classList.toggle("gw-idle", this.isUsual);
    this.back.disabled = this.isUsual;
  }
}
