// SPDX-License-Identifier: BSD-3-Clause
import { Clock } from "./clock";
import { themeOf, type Theme } from "./colours";
import { kOverlayInk, kOverlayNames, kOverlays, type Overlay } from "./overlays";
import { Plots } from "./plots";
import { unpackMotion, type Motion, type SceneFile } from "./scene";
import { Stage, type View } from "./stage";
import { bearingFeet, Timeline } from "./timeline";

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];
const kViewKeys: Record<string, View> = { "1": "corner", "2": "side", "3": "front", "4": "top" };
const kHelp =
  "Space play or pause \u00b7 \u2190 \u2192 5 ms (Shift 0.1 s) \u00b7 Home End \u00b7 + \u2212 speed \u00b7 1 2 3 4 views \u00b7 F follow \u00b7 G ghost \u00b7 T light or dark \u00b7 drag turns, wheel zooms, right drag shifts";

function make<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", text = ""): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

/** The whole of what the page shows and does. */
export class Viewer {
  readonly clock: Clock;
  readonly motions: Motion[];
  readonly stages: Stage[] = [];
  private readonly plots: Plots[] = [];
  private readonly timeline: Timeline;
  private readonly playButton = make("button", "gw-play");
  private readonly speedMenu = make("select");
  private readonly readout = make("output", "gw-readout");
  private readonly followBox = make("input");
  private readonly overlayBoxes = new Map<Overlay, HTMLInputElement>();
  private readonly frameTimes: number[] = [];
  private dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  private lastFrame = 0;

  constructor(
    private readonly root: HTMLElement,
    scene: SceneFile,
  ) {
    this.motions = scene.motions.map(unpackMotion);
    const ends = this.motions.map((m) => m.time[m.time.length - 1]);
    this.clock = new Clock(Math.min(...this.motions.map((m) => m.time[0])), Math.max(...ends));
    this.timeline = new Timeline(this.motions, this.clock);
    root.classList.add("gw-viewer");
    root.tabIndex = -1;
    root.append(this.stageArea(), this.transport(), this.timeline.root, this.legend(), this.plotArea());
    root.append(make("p", "gw-help", kHelp));
    for (const stage of this.stages) this.clock.onChange((t) => stage.show(t));
    this.clock.onChange((t) => this.showReadout(t));
    this.followThemeOfPage();
    this.paint();
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
    for (const stage of this.stages) stage.look(view);
  }

  setDark(dark: boolean): void {
    this.dark = dark;
    this.paint();
  }

  setOverlay(overlay: Overlay, visible: boolean): void {
    const box = this.overlayBoxes.get(overlay);
    if (box) box.checked = visible;
    for (const stage of this.stages) stage.setVisible(overlay, visible);
  }

  /** Pictures a second of late, and what one costs. */
  rate(): { frames_per_s: number; calls: number; triangles: number } {
    const times = this.frameTimes;
    const span = times.length > 1 ? times[times.length - 1] - times[0] : Number.POSITIVE_INFINITY;
    const cost = this.stages[0]?.cost() ?? { calls: 0, triangles: 0 };
    return { frames_per_s: (1000 * (times.length - 1)) / span, ...cost };
  }

  private theme(): Theme {
    return themeOf(this.dark);
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

  private button(text: string, title: string, act: () => void, button = make("button")): HTMLButtonElement {
    if (text) button.textContent = text;
    button.title = title;
    button.type = "button";
    button.addEventListener("click", act);
    return button;
  }

  private transport(): HTMLElement {
    const bar = make("div", "gw-bar");
    this.button("", "play or pause (Space)", () => this.togglePlay(), this.playButton);
    for (const speed of kSpeeds) this.speedMenu.add(new Option(`${speed}\u00d7`, String(speed), speed === 1, speed === 1));
    this.speedMenu.title = "speed (+ and \u2212)";
    this.speedMenu.setAttribute("aria-label", "speed");
    this.speedMenu.addEventListener("change", () => (this.clock.speed = Number(this.speedMenu.value)));
    const views = make("span", "gw-group");
    for (const [key, view] of Object.entries(kViewKeys)) views.append(this.button(view, `view from there (${key})`, () => this.look(view)));
    Object.assign(this.followBox, { type: "checkbox", checked: true });
    this.followBox.addEventListener("change", () => this.setFollow(this.followBox.checked));
    const follow = make("label", "", " follow");
    follow.title = "the camera goes with the robot (F)";
    follow.prepend(this.followBox);
    bar.append(this.playButton, this.button("\u25c2", "back (\u2190)", () => this.step(-0.005)), this.button("\u25b8", "on (\u2192)", () => this.step(0.005)));
    bar.append(this.speedMenu, views, follow, this.button("\u25d0", "light or dark (T)", () => this.setDark(!this.dark)), this.readout);
    return bar;
  }

  private legend(): HTMLElement {
    const legend = make("div", "gw-legend");
    for (const overlay of kOverlays) {
      if (overlay === "ghost" && !this.motions.some((m) => m.planned && m.measured)) continue;
      const box = make("input");
      Object.assign(box, { type: "checkbox", checked: true });
      box.addEventListener("change", () => this.setOverlay(overlay, box.checked));
      this.overlayBoxes.set(overlay, box);
      const label = make("label", `gw-ink-${kOverlayInk[overlay]}`, ` ${kOverlayNames[overlay]}`);
      label.prepend(box);
      legend.append(label);
    }
    legend.append(make("span", "gw-note", "rings and broad pale lines: planned; filled and thin lines: measured"));
    return legend;
  }

  private plotArea(): HTMLElement {
    const area = make("div", "gw-plots");
    for (const motion of this.motions) {
      const column = make("div", "gw-column");
      area.append(column);
      this.plots.push(new Plots(column, motion, this.clock, this.theme()));
    }
    return area;
  }

  private paint(): void {
    this.root.dataset.theme = this.dark ? "dark" : "light";
    for (const stage of this.stages) stage.paint(this.theme());
    for (const plots of this.plots) plots.paint(this.theme());
    this.timeline.draw();
  }

  private followThemeOfPage(): void {
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) => this.setDark(event.matches));
  }

  private setFollow(follow: boolean): void {
    this.followBox.checked = follow;
    for (const stage of this.stages) stage.follow = follow;
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
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest("input:not([type=checkbox]):not([type=range]), select, textarea")) return;
    const big = event.shiftKey ? 0.1 : 0.005;
    const view = kViewKeys[event.key];
    if (view) this.look(view);
    else if (event.key === " " && !target.closest("button, input")) this.togglePlay();
    else if (event.key === "ArrowLeft") this.step(-big);
    else if (event.key === "ArrowRight") this.step(big);
    else if (event.key === "Home") this.step(Number.NEGATIVE_INFINITY);
    else if (event.key === "End") this.step(Number.POSITIVE_INFINITY);
    else if (event.key === "+" || event.key === "=") this.changeSpeed(1);
    else if (event.key === "-") this.changeSpeed(-1);
    else if (event.key === "f" || event.key === "F") this.setFollow(!this.followBox.checked);
    else if (event.key === "g" || event.key === "G") this.setOverlay("ghost", !this.overlayBoxes.get("ghost")?.checked);
    else if (event.key === "t" || event.key === "T") this.setDark(!this.dark);
    else return;
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
    if (drawn) {
      this.frameTimes.push(now);
      if (this.frameTimes.length > 120) this.frameTimes.shift();
    }
    requestAnimationFrame((next) => this.frame(next));
  }
}
