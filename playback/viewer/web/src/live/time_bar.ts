// SPDX-License-Identifier: BSD-3-Clause
import { button, disable, make, tell, write } from "../elements";
import type { Frame, Send } from "./messages";

/** So many time steps a press of the step button does, and with Shift. */
const kSteps = 1;
const kManySteps = 10;

export const kTimeHelp = "Space pause or go on \u00b7 . one time step (Shift ten) \u00b7 R reset \u00b7 U stand up";

/** What is done to time, and to a robot that has gone astray. */
export class TimeBar {
  readonly root = make("span", "gw-times");
  private readonly pause = button("", "pause or go on (Space)", () => this.toggle(), "gw-play");
  private readonly step = button("step", "one time step while it is paused (.)", () => this.steps(kSteps));
  private paused = false;

  constructor(private readonly send: Send) {
    const reset = button("reset", "back to the beginning (R)", () => send({ do: "reset" }));
    const standUp = button("stand up", "upright, where it is (U)", () => send({ do: "stand_up" }));
    [this.pause, this.step, reset, standUp].forEach((made, i) => (made.name = ["pause", "step", "reset", "stand_up"][i]));
    const group = make("span", "gw-group");
    group.append(reset, standUp);
    this.root.append(this.pause, this.step, group);
  }

  show(frame: Frame): void {
    this.paused = frame.paused;
    write(this.pause, frame.paused ? "\u25b6" : "\u275a\u275a");
    tell(this.pause, "aria-label", frame.paused ? "go on" : "pause");
    disable(this.step, frame.paused ? "" : "one time step (.): pause it first (Space)");
  }

  /** Does what a key asks for, if that is of this. */
  press(event: KeyboardEvent): boolean {
    const act = this.actOf(event);
    if (!act) return false;
    if (!event.repeat || act === this.goOn) act(event);
    return true;
  }

  /** A key that is held down does not pause, reset and stand up over and over. */
  private actOf(event: KeyboardEvent): ((event: KeyboardEvent) => void) | null {
    if (event.key === " ") return () => this.toggle();
    if (event.code === "Period" || event.key === ".") return this.goOn;
    const saying = ({ r: "reset", u: "stand_up" } as const)[event.key.toLowerCase()];
    return saying ? () => this.send({ do: saying }) : null;
  }

  private readonly goOn = (event: KeyboardEvent) => this.steps(event.shiftKey ? kManySteps : kSteps);

  private toggle(): void {
    this.send({ do: "clock", paused: !this.paused });
  }

  private steps(steps: number): void {
    if (this.paused) this.send({ do: "clock", steps });
  }
}
