// SPDX-License-Identifier: BSD-3-Clause
import { button, disable, make, tell, write } from "../elements";
import type { Frame, Send } from "./messages";

/** Time steps per press of the step button, and with Shift. */
const kSteps = 1;
const kManySteps = 10;

export const kTimeHelp = "Space pause or continue \u00b7 . one time step (Shift ten) \u00b7 R reset \u00b7 U stand up";

/** Controls for time, and for a robot that fell or walked away. */
export class TimeBar {
  readonly root = make("span", "gw-times");
  private readonly pause = button("", "pause or continue (Space)", () => this.toggle(), "gw-play");
  private readonly step = button("step", "one time step, if paused (.)", () => this.steps(kSteps));
  private paused = false;

  constructor(private readonly send: Send) {
    const reset = button("reset", "returns to the start (R)", () => send({ do: "reset" }));
    const standUp = button("stand up", "stands upright at its place (U)", () => send({ do: "stand_up" }));
    [this.pause, this.step, reset, standUp].forEach((made, i) => (made.name = ["pause", "step", "reset", "stand_up"][i]));
    const group = make("span", "gw-group");
    group.append(reset, standUp);
    this.root.append(this.pause, this.step, group);
  }

  show(frame: Frame): void {
    this.paused = frame.paused;
    write(this.pause, frame.paused ? "\u25b6" : "\u275a\u275a");
    tell(this.pause, "aria-label", frame.paused ? "continue" : "pause");
    disable(this.step, frame.paused ? "" : "one time step (.): pause first (Space)");
  }

  /** Handles a key, if it belongs to this bar. */
  press(event: KeyboardEvent): boolean {
    const act = this.actOf(event);
    if (!act) return false;
    if (!event.repeat || act === this.goOn) act(event);
    return true;
  }

  /** A key that is held down does not repeat pause, reset and stand up. */
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
