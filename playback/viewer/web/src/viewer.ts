// SPDX-License-Identifier: BSD-3-Clause
import { Clock } from "./clock";
import { button, isForPage, make } from "./elements";
import { FrameRate } from "./frame_rate";
import { kLooksHelp, Looks } from "./looks";
import { kOverlays, type Overlay } from "./overlays";
import { Plots } from "./plots";
import { unpackMotion, type Motion, type SceneFile } from "./scene";
import { Stage, type View } from "./stage";
import { bearingFeet, Timeline } from "./timeline";

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];
const kHelp =
  "Space play or pause \u00b7 \u2190 \u2192 5 ms (Shift 0.1 s) \u00b7 Home End \u00b7 + \u2212 speed \u00b7 " + kLooksHelp;

/** The whole of what the page shows and does. */
export class Viewer {
  readonly clock: Clock;
  readonly motions: Motion[];
  readonly stages: Stage[] = [];
  private readonly plots: Plots[] = [];
  private readonly timeline: Timeline;
  private readonly looks: Looks;
  private readonly playButton = button("", "play or pause (Space)", () => this.togglePlay(), "gw-play");
  private readonly speedMenu = make("select");
  private readonly readout = make("output", "gw-readout");
  private readonly frameRate = new FrameRate();
  private lastFrame = 0;

  constructor(root: HTMLElement, scene: SceneFile) {
    this.motions = scene.motions.map(unpackMotion);
    const ends = this.motions.map((m) => m.time[m.time.length - 1]);
    this.clock = new Clock(Math.min(...this.motions.map((m) => m.time[0])), Math.max(...ends));
    this.timeline = new Timeline(this.motions, this.clock);
    root.classList.add("gw-viewer");
    root.tabIndex = -1;
    const hasGhost = this.motions.some((m) => m.planned && m.measured);
    const overlays = kOverlays.filter((overlay) => hasGhost || overlay !== "ghost");
    this.looks = new Looks(root, this.stages, overlays, (theme) => {
      for (const plots of this.plots) plots.paint(theme);
      this.timeline.draw();
    });
    root.append(this.stageArea(), this.transport(), this.timeline.root, this.looks.legend, this.plotArea());
    root.append(make("p", "gw-help", kHelp));
    for (const stage of this.stages) this.clock.onChange((t) => stage.show(t));
    this.clock.onChange((t) => this.showReadout(t));
    this.looks.paint();
    document.addEventListener("keydown", (event) => this.press(event));
    requestAnimationFrame((now) => this.frame(now));
  }

  /** Shows a time, with the cameras where they belong, at once: for pictures and tests. */
  showNow(t: number): void {
    this.clock.pause();
    this.clock.set(t);
    for (const stage of this.stages) {
      stage.goAfter(Number.POSITIVE_INFINITY);
      stage.draw();
    }
  }

  look(view: View): void {
    this.looks.look(view);
  }

  setDark(dark: boolean): void {
    this.looks.setDark(dark);
  }

  setOverlay(overlay: Overlay, visible: boolean): void {
    this.looks.setOverlay(overlay, visible);
  }

  /** Pictures a second of late, and what one costs. */
  rate(): { frames_per_s: number; calls: number; triangles: number } {
    const cost = this.stages[0]?.cost() ?? { calls: 0, triangles: 0 };
    return { frames_per_s: this.frameRate.perSecond(), ...cost };
  }

  private stageArea(): HTMLElement {
    const area = make("div", "gw-stages");
    for (const motion of this.motions) {
      const box = make("figure", "gw-stage");
      const canvas = make("canvas");
      canvas.setAttribute("role", "img");
      canvas.setAttribute("aria-label", `${motion.file.title}, in 3D`);
      box.append(canvas, this.caption(motion));
      area.append(box);
      try {
        this.stages.push(new Stage(canvas, motion));
      } catch (error) {
        canvas.replaceWith(make("p", "gw-sorry", `This browser shows no 3D here (${String(error)}). Times and plots work.`));
      }
    }
    return area;
  }

  private caption(motion: Motion): HTMLElement {
    const caption = make("figcaption");
    const { verdict, title } = motion.file;
    if (verdict) caption.append(make("span", verdict.pass ? "gw-verdict gw-pass" : "gw-verdict gw-fails", verdict.pass ? "PASS" : "FAIL"));
    caption.append(make("b", "", title));
    if (verdict) caption.append(make("span", "gw-reason", verdict.reason));
    return caption;
  }

  private transport(): HTMLElement {
    const bar = make("div", "gw-bar");
    for (const speed of kSpeeds) this.speedMenu.add(new Option(`${speed}\u00d7`, String(speed), speed === 1, speed === 1));
    this.speedMenu.title = "speed (+ and \u2212)";
    this.speedMenu.setAttribute("aria-label", "speed");
    this.speedMenu.addEventListener("change", () => (this.clock.speed = Number(this.speedMenu.value)));
    bar.append(this.playButton, button("\u25c2", "back (\u2190)", () => this.step(-0.005)), button("\u25b8", "on (\u2192)", () => this.step(0.005)));
    bar.append(this.speedMenu, ...this.looks.controls, this.readout);
    return bar;
  }

  private plotArea(): HTMLElement {
    const area = make("div", "gw-plots");
    for (const motion of this.motions) {
      const column = make("div", "gw-column");
      area.append(column);
      this.plots.push(new Plots(column, motion, this.clock, this.looks.theme));
    }
    return area;
  }

  private togglePlay(): void {
    this.clock.toggle();
  }

  private step(seconds: number): void {
    this.clock.pause();
    this.clock.set(this.clock.time + seconds);
  }

  private changeSpeed(by: number): void {
    const at = kSpeeds.indexOf(this.clock.speed) + by;
    this.clock.speed = kSpeeds[Math.min(Math.max(at, 0), kSpeeds.length - 1)];
    this.speedMenu.value = String(this.clock.speed);
  }

  private press(event: KeyboardEvent): void {
    if (!isForPage(event)) return;
    const big = event.shiftKey ? 0.1 : 0.005;
    if (event.key === " " && !(event.target as HTMLElement).closest("button, input")) this.togglePlay();
    else if (event.key === "ArrowLeft") this.step(-big);
    else if (event.key === "ArrowRight") this.step(big);
    else if (event.key === "Home") this.step(Number.NEGATIVE_INFINITY);
    else if (event.key === "End") this.step(Number.POSITIVE_INFINITY);
    else if (event.key === "+" || event.key === "=") this.changeSpeed(1);
    else if (event.key === "-") this.changeSpeed(-1);
    else if (!this.looks.press(event.key)) return;
    event.preventDefault();
  }

  private showReadout(t: number): void {
    this.playButton.textContent = this.clock.playing ? "\u275a\u275a" : "\u25b6";
    const bearing = this.motions.length === 1 ? bearingFeet(this.motions[0], t) : [];
    this.readout.textContent = `${t.toFixed(3)} s` + (this.motions.length === 1 ? `, on ${bearing.join(", ") || "no foot"}` : "");
  }

  private frame(now: number): void {
    const seconds = this.lastFrame > 0 ? Math.min((now - this.lastFrame) / 1000, 0.1) : 0;
    this.lastFrame = now;
    this.clock.advance(seconds);
    let drawn = false;
    for (const stage of this.stages) {
      stage.goAfter(seconds);
      drawn = stage.draw() || drawn;
    }
    if (drawn) this.frameRate.note(now);
    requestAnimationFrame((next) => this.frame(next));
  }
}
