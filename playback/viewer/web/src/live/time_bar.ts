// SPDX-License-Identifier: BSD-3-Clause
import { button, make } from "../elements";
import type { Frame, Send } from "./messages";

/** So many time steps a press of the step button does, and with Shift. */
const kSteps = 1;
const kManySteps = 10;

export const kTimeHelp = "Space pause or go on \u00b7 . one time step (Shift ten) \u00b7 R reset \u00b7 U stand up";

/** What is done to time, and to a robot that has gone astray. */
export class TimeBar {
  readonly buttons: HTMLElement[];
  private readonly pause = button("", "pause or go on (Space)", () => this.toggle(), "gw-play");
  private readonly step = button("step", "one time step while it is paused (.)", () => this.steps(kSteps));
  private paused = false;

  constructor(private readonly send: Send) {
    const reset = button("reset", "back to the beginning (R)", () => send({ do: "reset" }));
    const standUp = button("stand up", "upright, where it is (U)", () => send({ do: "stand_up" }));
    [this.pause, this.step, reset, standUp].forEach((made, i) => (made.name = ["pause", "step", "reset", "stand_up"][i]));
    const group = make("span", "gw-group");
    group.append(reset, standUp);
    this.buttons = [this.pause, this.step, group];
  }

  show(frame: Frame): void {
    this.paused = frame.paused;
    this.pause.textContent = frame.paused ? "\u25b6" : "\u275a\u275a";
    this.pause.setAttribute("aria-label", frame.paused ? "go on" : "pause");
    this.step.disabled = !frame.paused;
  }

  /** Does what a key asks for, if that is of this. */
  press(event: KeyboardEvent): boolean {
    if (event.key === " " && !(event.target as HTMLElement).closest("button, input, summary")) this.toggle();
    else if (event.code === "Period" || event.key === ".") this.steps(event.shiftKey ? kManySteps : kSteps);
    else if (event.key === "r" || event.key === "R") this.send({ do: "reset" });
    else if (event.key === "u" || event.key === "U") this.send({ do: "stand_up" });
    else return false;
    return true;
  }

  private toggle(): void {
    this.send({ do: "clock", paused: !this.paused });
  }

  private steps(steps: number): void {
    if (this.paused) this.send({ do: "clock", steps });
  }
}
