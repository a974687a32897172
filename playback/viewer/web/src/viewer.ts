// SPDX-License-Identifier: BSD-3-Clause
import { Clock } from "./clock";
import { button, isForPage, make, menu, tell, write } from "./elements";
import { kLooksHelp } from "./looks";
import { kOverlayNames, kOverlays } from "./overlays";
import { Plots } from "./plots";
import { namesOf, unpackScene, type Motion, type SceneFile } from "./scene";
import { ShownPage } from "./shown_page";
import { Stage } from "./stage";
import { bearingFeet, Timeline } from "./timeline";

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];
const kStep_s = 0.005;
const kBigStep_s = 0.1;
/** A page that was hidden continues at the same time. */
const kLongestAdvance_s = 0.1;
const kMicro = 1e6;
const kHelp =
  "Space play or pause \u00b7 \u2190 \u2192 5 ms (Shift 0.1 s) \u00b7 Home End \u00b7 + \u2212 speed \u00b7 " + kLooksHelp;

/** The whole viewer with its controls. */
export class Viewer extends ShownPage {
  readonly clock: Clock;
  readonly motions: Motion[];
  private readonly plots: Plots[] = [];
  private readonly timeline: Timeline;
  private readonly playButton = button("", "play or pause (Space)", () => this.clock.toggle(), "gw-play");
  private readonly speedMenu = menu("speed");
  private readonly readout = make("span", "gw-readout");

  /** @param root  a separate page if it has the class `gw-page`, else a part of a page. */
  constructor(
    private readonly root: HTMLElement,
    scene: SceneFile,
  ) {
    const motions = unpackScene(scene);
    const hasGhost = motions.some((m) => m.ghost);
    const named = motions.find((m) => m.file.ghost)?.file.ghost;
    const names = named ? { ...kOverlayNames, ghost: `${named.title} as a ghost` } : kOverlayNames;
    super(root, kOverlays.filter((overlay) => hasGhost || overlay !== "ghost"), (theme) => {
      for (const plots of this.plots) plots.paint(theme);
      this.timeline.draw();
    }, names);
    this.motions = motions;
    const ends = motions.map((m) => m.time[m.time.length - 1]);
    this.clock = new Clock(Math.min(...motions.map((m) => m.time[0])), Math.max(...ends));
    this.timeline = new Timeline(motions, this.clock);
    root.append(this.stageArea(), this.transport(), this.timeline.root, this.looks.legend, this.plotArea());
    root.append(make("p", "gw-help", kHelp));
    for (const stage of this.stages) this.clock.onChange((t) => stage.show(t));
    this.clock.onChange((t) => this.showReadout(t));
    this.looks.paint();
    this.takeKeys();
    this.begin();
  }

  /** Shows a time at once, with the cameras at their places: for pictures and tests. */
  showNow(t: number): void {
    this.clock.pause();
    this.clock.set(t);
    for (const stage of this.stages) {
      stage.goAfter(Number.POSITIVE_INFINITY);
      stage.draw();
    }
  }

  protected step(_: number, seconds: number): boolean {
    this.clock.advance(Math.min(seconds, kLongestAdvance_s));
    let drawn = false;
    for (const stage of this.stages) {
      stage.goAfter(seconds);
      drawn = stage.draw() || drawn;
    }
    return drawn;
  }

  /**
   * A separate page handles all keys; a part of a page handles them while it has the focus. A press in it sets the
   * focus.
   */
  private takeKeys(): void {
    const whole = this.root.classList.contains("gw-page");
    this.root.tabIndex = whole ? -1 : 0;
    (whole ? document : this.root).addEventListener("keydown", (event) => this.press(event as KeyboardEvent));
    if (whole) return;
    this.root.setAttribute("aria-label", "motion in 3D");
    this.root.setAttribute("role", "group");
    this.root.addEventListener("pointerdown", (event) => {
      if (!(event.target as HTMLElement).closest("button, input, select, label, a")) this.root.focus({ preventScroll: true });
    }, { capture: true });
    this.root.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !this.root.contains(document.activeElement)) event.stopPropagation();
    }, { capture: true, passive: true });
  }

  private stageArea(): HTMLElement {
    const area = make("div", "gw-stages");
    for (const motion of this.motions) {
      const box = make("figure", "gw-stage");
      const canvas = make("canvas");
      canvas.setAttribute("role", "img");
      canvas.setAttribute("aria-label", `${motion.file.title}, in 3D`);
      box.append(canvas, this.caption(motion));
      const shown = make("div", "gw-shown");
      shown.append(box, ...this.reason(motion));
      area.append(shown);
      try {
        this.stages.push(new Stage(canvas, motion));
      } catch (error) {
        canvas.replaceWith(make("p", "gw-sorry", `3D is not available in this browser (${String(error)}). Times and plots work.`));
      }
    }
    return area;
  }

  private caption(motion: Motion): HTMLElement {
    const caption = make("figcaption");
    const { verdict, title } = motion.file;
    if (verdict) caption.append(make("span", verdict.pass ? "gw-verdict gw-pass" : "gw-verdict gw-fails", verdict.pass ? "PASS" : "FAIL"));
    caption.append(make("b", "", title));
    return caption;
  }

  /** A long reason scrolls, also by keys. */
  private reason(motion: Motion): HTMLElement[] {
    const { verdict } = motion.file;
    if (!verdict?.reason) return [];
    const reason = make("p", "gw-reason", verdict.reason);
    reason.tabIndex = 0;
    return [reason];
  }

  private transport(): HTMLElement {
    const bar = make("div", "gw-bar");
    for (const speed of kSpeeds) this.speedMenu.add(new Option(`${speed}\u00d7`, String(speed), speed === 1, speed === 1));
    this.speedMenu.title = "speed (+ and \u2212)";
    this.speedMenu.addEventListener("change", () => (this.clock.speed = Number(this.speedMenu.value)));
    const back = button("\u25c2", "back (\u2190)", () => this.goOn(-kStep_s)), on = button("\u25b8", "forward (\u2192)", () => this.goOn(kStep_s));
    bar.append(this.playButton, back, on, this.speedMenu, ...this.looks.controls, this.readout);
    return bar;
  }

  private plotArea(): HTMLElement {
    const area = make("div", "gw-plots");
    namesOf(this.motions).forEach((name, i) => {
      const column = make("div", "gw-column");
      if (name) column.append(make("h2", "gw-title", name));
      area.append(column);
      this.plots.push(new Plots(column, this.motions[i], this.clock));
    });
    return area;
  }

  /** In whole microseconds, so that many small steps add up to one large step. */
  private goOn(seconds: number): void {
    this.clock.pause();
    this.clock.set(Math.round((this.clock.time + seconds) * kMicro) / kMicro);
  }

  private changeSpeed(by: number): void {
    const at = kSpeeds.indexOf(this.clock.speed) + by;
    this.clock.speed = kSpeeds[Math.min(Math.max(at, 0), kSpeeds.length - 1)];
    this.speedMenu.value = String(this.clock.speed);
  }

  private press(event: KeyboardEvent): void {
    if (!isForPage(event)) return;
    const step_s = event.shiftKey ? kBigStep_s : kStep_s;
    if (event.key === " ") this.pressSpace(event);
    else if (event.key === "ArrowLeft") this.goOn(-step_s);
    else if (event.key === "ArrowRight") this.goOn(step_s);
    else if (event.key === "Home") this.goOn(Number.NEGATIVE_INFINITY);
    else if (event.key === "End") this.goOn(Number.POSITIVE_INFINITY);
    else if (event.key === "+" || event.key === "=") this.changeSpeed(1);
    else if (event.key === "-") this.changeSpeed(-1);
    else if (!this.looks.press(event.key)) return;
    event.preventDefault();
  }

  private pressSpace(event: KeyboardEvent): void {
    if (!event.repeat) this.clock.toggle();
  }

  private showReadout(t: number): void {
    const { playing } = this.clock;
    write(this.playButton, playing ? "\u275a\u275a" : "\u25b6");
    tell(this.playButton, "aria-label", playing ? "pause" : "play");
    const bearing = this.motions.length === 1 ? `, on ${bearingFeet(this.motions[0], t).join(", ") || "no foot"}` : "";
    const text = `${t.toFixed(3)} s${bearing}`;
    write(this.readout, text);
    tell(this.readout, "title", text);
  }
}
