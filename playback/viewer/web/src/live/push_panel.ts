// SPDX-License-Identifier: BSD-3-Clause
import { button, disable, make } from "../elements";
import type { RobotFile } from "../scene";
import type { Frame, Send, Spring } from "./messages";
import { Slider } from "./slider";
import { newtons } from "./words";

const kPush_s = 0.15;
const kUsualWeights = 0.5;

export type Side = "ahead" | "left" | "right" | "back";

/** In the robot's axes: x forward, y to the left. */
const kSides: Record<Side, [number, number]> = { ahead: [1, 0], left: [0, 1], right: [0, -1], back: [-1, 0] };
const kSideKeys: Record<string, Side> = { ArrowUp: "ahead", ArrowLeft: "left", ArrowRight: "right", ArrowDown: "back" };

/** Reason for which a push has no effect; "" if it has one. */
function whyNot(frame: Frame): string {
  return frame.mode === "posed" ? "no push while the robot is held in a pose: press U to stand it up first" : "";
}

/** Short pushes on the base, by button and key, with a force that can be chosen. */
export class PushPanel {
  readonly root = make("section", "gw-section");
  /** Called when a key requests an impossible action. */
  onRefuse: (why: string) => void = () => {};
  private readonly force: Slider;
  private readonly buttons: HTMLButtonElement[] = [];
  private frame: Frame | null = null;

  constructor(
    robot: RobotFile,
    spring: Spring,
    private readonly send: Send,
  ) {
    const step = Number((0.05 * robot.weight_n).toPrecision(1));
    const usual = step * Math.round((kUsualWeights * robot.weight_n) / step);
    this.force = new Slider({
      name: "push_n", label: "Force", title: `of the pushes; the robot weighs ${newtons(robot.weight_n)}`, least: step,
      most: spring.most_n, step, value: usual, words: newtons,
    });
    const cross = make("div", "gw-cross");
    for (const side of Object.keys(kSides) as Side[]) {
      const push = button(side, `push ${side} for ${kPush_s} s (Shift + arrow)`, () => this.start(side), `gw-${side}`);
      push.name = `push_${side}`;
      this.buttons.push(push);
      cross.append(push);
    }
    const words = make("p", "gw-note", "Or drag the robot in the picture: a spring pulls it.");
    const beside = make("div", "gw-beside");
    beside.append(cross, words);
    this.root.append(make("h2", "", "Push"), this.force.root, beside);
  }

  start(side: Side): void {
    if (!this.frame) return;
    if (whyNot(this.frame)) return this.onRefuse(whyNot(this.frame));
    const [ahead, left] = kSides[side], yaw = ((this.frame.heading_deg ?? 0) * Math.PI) / 180, force = this.force.value;
    const x = Math.cos(yaw) * ahead - Math.sin(yaw) * left, y = Math.sin(yaw) * ahead + Math.cos(yaw) * left;
    this.send({ do: "push", force_n: [force * x, force * y, 0], for_s: kPush_s });
  }

  /** Handles a key, if it belongs to this panel. */
  press(event: KeyboardEvent): boolean {
    const side = kSideKeys[event.key];
    if (!side || !event.shiftKey) return false;
    if (!event.repeat) this.start(side);
    return true;
  }

  show(frame: Frame): void {
    this.frame = frame;
    for (const push of this.buttons) disable(push, whyNot(frame));
  }
}
