// SPDX-License-Identifier: BSD-3-Clause
import type { Theme } from "../colours";
import { button, disable, make, menu, write } from "../elements";
import { HeadingDial, wrapped } from "./heading_dial";
import { isWalk, kStand, paceAhead, type Frame, type Greeting, type Pace, type Send } from "./messages";
import { Slider } from "./slider";
import { sided } from "./words";

/** Share of the robot's normal speed. */
const kFastest = 4;
const kFastestAside = 1;
const kQuickestTurn_rad_s = 1;
/** Time during which the menu does not follow the program: it may be open, or an answer is on the way. */
const kMenuOpen_ms = 4000;
const kQuiet_ms = 500;

let made = 0;

/** A slider's end as a round number. */
function oneDigit(value: number): number {
  return Number(value.toPrecision(1));
}

/** Walking command: gait, speeds and heading. A change during walking is requested at once. */
export class WalkPanel {
  readonly root = make("section", "gw-section");
  private readonly gait = menu("gait");
  private readonly walk = button("Walk", "", () => this.toggle(), "gw-main");
  private readonly speed: Slider;
  private readonly aside: Slider;
  private readonly turn: Slider;
  private readonly heading: Slider;
  private readonly dial = new HeadingDial();
  private menuBusyUntil_ms = 0;
  private walking = false;

  constructor(
    greeting: Greeting,
    private readonly send: Send,
  ) {
    const usual = greeting.usual_pace;
    for (const gait of greeting.gaits) if (gait !== "stand") this.offer(gait);
    this.choose(usual.gait);
    const fastest = oneDigit(kFastest * usual.speed_m_s), aside = oneDigit(kFastestAside * usual.speed_m_s);
    const metres = (value: number) => `${value.toFixed(2)} m/s`;
    const leftward = (unit: string) => (value: number) => sided(value, 2, unit);
    this.speed = new Slider({ name: "speed_m_s", label: "Speed", least: 0, most: fastest, step: 0.01, value: usual.speed_m_s, words: metres });
    this.aside = new Slider({
      name: "lateral_speed_m_s", label: "Sideways", least: -aside, most: aside, step: 0.01, value: usual.lateral_speed_m_s,
      words: leftward(" m/s"), leftward: true,
    });
    this.turn = new Slider({
      name: "yaw_rate_rad_s", label: "Turning", least: -kQuickestTurn_rad_s, most: kQuickestTurn_rad_s, step: 0.02,
      value: usual.yaw_rate_rad_s, words: leftward(" rad/s"), leftward: true,
    });
    this.heading = new Slider({
      name: "heading_deg", label: "Heading", title: "a walking robot turns to this heading and then walks straight", least: -180, most: 180,
      step: 1, value: 0, words: (value) => sided(value, 0, "\u00b0"), leftward: true,
    });
    this.fill();
    this.listen();
  }

  paint(theme: Theme): void {
    this.dial.paint(theme);
  }

  show(frame: Frame): void {
    const ahead = paceAhead(frame);
    const down = frame.mode === "fallen" || frame.mode === "posed";
    this.walking = !down && isWalk(ahead);
    write(this.walk, this.walking ? "Stop (stand)" : "Walk");
    this.walk.classList.toggle("gw-on", this.walking);
    disable(this.walk, down ? "press U to stand it up first" : "");
    if (this.walking) this.follow(ahead);
    this.showHeading(frame);
  }

  private fill(): void {
    this.gait.name = "gait";
    this.walk.name = "walk";
    const gait = make("div", "gw-slide"), name = make("label", "gw-name", "Gait");
    name.htmlFor = this.gait.id = `gw-gait-${++made}`;
    gait.append(name, this.gait, this.walk);
    const turning = make("div", "gw-heading");
    turning.append(this.heading.root, this.dial.canvas);
    this.root.append(make("h2", "", "Walk"), gait, this.speed.root, this.aside.root, this.turn.root, turning);
  }

  private listen(): void {
    const ask = () => {
      if (this.walking) this.send({ do: "pace", ...this.pace() });
    };
    const leaveMenu = (for_ms: number) => (this.menuBusyUntil_ms = performance.now() + for_ms);
    for (const start of ["pointerdown", "keydown"]) this.gait.addEventListener(start, () => leaveMenu(kMenuOpen_ms));
    this.gait.addEventListener("change", () => {
      leaveMenu(kQuiet_ms);
      ask();
    });
    for (const slider of [this.speed, this.aside, this.turn]) slider.onSet = ask;
    this.heading.onSet = (value) => this.askHeading(value);
    this.dial.onTurn = (value) => {
      if (!this.heading.disabled) this.heading.put(value);
    };
    this.dial.onSet = (value) => {
      if (!this.heading.disabled) this.askHeading(value);
    };
  }

  private pace(): Pace {
    return {
      gait: this.gait.value,
      speed_m_s: this.speed.value,
      lateral_speed_m_s: this.aside.value,
      yaw_rate_rad_s: this.turn.value,
    };
  }

  private toggle(): void {
    this.send({ do: "pace", ...(this.walking ? kStand : this.pace()) });
  }

  private askHeading(heading_deg: number): void {
    this.heading.put(heading_deg);
    this.send({ do: "heading", heading_deg });
  }

  private follow(pace: Pace): void {
    if (this.gait.value !== pace.gait && performance.now() > this.menuBusyUntil_ms) this.choose(pace.gait);
    this.speed.follow(pace.speed_m_s);
    this.aside.follow(pace.lateral_speed_m_s);
    this.turn.follow(pace.yaw_rate_rad_s);
  }

  /** The wanted heading, else the present one. */
  private showHeading(frame: Frame): void {
    const now_deg = frame.heading_deg ?? 0;
    this.heading.disable(frame.mode === "walks" ? "" : "the robot turns to a heading only while it walks");
    if (!this.dial.held) this.heading.follow(Math.round(wrapped(frame.wanted_heading_deg ?? now_deg)));
    this.dial.show(now_deg, this.heading.value);
  }

  private offer(gait: string): void {
    this.gait.add(new Option(gait, gait));
  }

  /** Shows a gait in the menu; adds it if the menu does not have it. */
  private choose(gait: string): void {
    if (!gait) return;
    if (!Array.from(this.gait.options).some((option) => option.value === gait)) this.offer(gait);
    this.gait.value = gait;
  }
}
