// SPDX-License-Identifier: BSD-3-Clause
import { make, menu } from "../elements";
import type { Frame, Send } from "./messages";
import { Slider } from "./slider";

/** The physics engine, and friction and slope of the ground under the robot. */
export class GroundPanel {
  readonly root = make("section", "gw-section");
  private readonly friction: Slider;
  private readonly slope: Slider;
  private readonly direction: Slider;
  private readonly engine = menu("physics engine");

  constructor(engines: string[], private readonly send: Send) {
    const degrees = (value: number) => `${value.toFixed(1)}\u00b0`;
    this.friction = new Slider({
      name: "friction", label: "Friction", title: "coefficient of friction", least: 0.1, most: 1.5, step: 0.05, value: 0.8,
      words: (value) => value.toFixed(2),
    });
    this.slope = new Slider({
      name: "slope_deg", label: "Slope", title: "slope of the ground about the robot's place", least: 0, most: 15, step: 0.5, value: 0, words: degrees,
    });
    this.direction = new Slider({
      name: "slope_direction_deg", label: "Rises to", title: "uphill direction, measured from the world's x axis to the left",
      least: -180, most: 180, step: 5, value: 0, words: (value) => `${value.toFixed(0)}\u00b0`, leftward: true,
    });
    this.root.append(make("h2", "", "Ground"));
    for (const slider of [this.friction, this.slope, this.direction]) {
      slider.onSet = () => this.ask();
      this.root.append(slider.root);
    }
    for (const name of engines) this.engine.append(new Option(name, name));
    this.engine.title = "restarts in this engine";
    this.engine.addEventListener("change", () => this.send({ do: "reset", engine: this.engine.value }));
    const row = make("label", "gw-note", "Engine ");
    row.append(this.engine);
    if (engines.length > 1) this.root.append(row);
    this.root.append(make("p", "gw-note", "Plans do not use the slope: they are made for level ground."));
  }

  show(frame: Frame): void {
    if (document.activeElement !== this.engine) this.engine.value = frame.ground.engine;
    if ([this.friction, this.slope, this.direction].some((slider) => slider.busy)) return;
    this.friction.follow(frame.ground.friction);
    this.slope.follow(frame.ground.slope_deg);
    this.direction.follow(frame.ground.slope_direction_deg);
  }

  private ask(): void {
    this.send({
      do: "ground",
      friction: this.friction.value,
      slope_deg: this.slope.value,
      slope_direction_deg: this.direction.value,
    });
  }
}
