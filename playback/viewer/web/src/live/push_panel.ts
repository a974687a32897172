// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { button, make } from "../elements";
import type { RobotFile } from "../scene";
import type { Frame } from "./messages";
import type { Pull } from "./pull";
import { Slider } from "./slider";
import { kMostWeights, reachOf } from "./spring";

const kPush_s = 0.15;
const kUsualWeights = 0.5;

export type Side = "ahead" | "left" | "right" | "back";

/** Seen from the robot: x ahead, y to the left. */
const kSides: Record<Side, [number, number]> = { ahead: [1, 0], left: [0, 1], right: [0, -1], back: [-1, 0] };
const kSideKeys: Record<string, Side> = { ArrowUp: "ahead", ArrowLeft: "left", ArrowRight: "right", ArrowDown: "back" };

/** Short pushes at the base, by button and key, of a force that can be chosen. */
export class PushPanel {
  readonly root = make("section", "gw-section");
  private readonly force: Slider;
  private push: { direction: [number, number]; from_s: number } | null = null;
  private frame: Frame | null = null;

  constructor(
    private readonly robot: RobotFile,
    private readonly pull: Pull,
  ) {
    const step = Number((0.05 * robot.weight_n).toPrecision(1));
    const usual = step * Math.round((kUsualWeights * robot.weight_n) / step);
    this.force = new Slider({
      name: "push_n", label: "Force", title: `of the pushes; the robot weighs ${robot.weight_n.toFixed(0)} N`, least: step,
      most: kMostWeights * robot.weight_n, step, value: usual, words: (value) => `${value.toFixed(0)} N`,
    });
    const cross = make("div", "gw-cross");
    for (const side of Object.keys(kSides) as Side[]) {
      const push = button(side, `push it ${side} for ${kPush_s} s (Shift + arrow)`, () => this.start(side), `gw-${side}`);
      push.name = `push_${side}`;
      cross.append(push);
    }
    const words = make("p", "gw-note", "Or drag the robot in the picture: it is pulled as by a rubber band.");
    const beside = make("div", "gw-beside");
    beside.append(cross, words);
    this.root.append(make("h2", "", "Push"), this.force.root, beside);
  }

  /** Pushes while the robot goes on for so long; where it is paused the push waits for its steps. */
  start(side: Side): void {
    const held = this.pull.hold !== null && this.push === null;
    if (!this.frame || this.frame.mode === "posed" || held) return;
    this.push = { direction: kSides[side], from_s: this.frame.t };
    this.goOn();
  }

  /** Somebody else pulls now. */
  stop(): void {
    this.push = null;
  }

  /** Does what a key asks for, if that is of this. */
  press(event: KeyboardEvent): boolean {
    const side = kSideKeys[event.key];
    if (!side || !event.shiftKey || (event.target as HTMLElement).closest("input")) return false;
    if (!event.repeat) this.start(side);
    return true;
  }

  show(frame: Frame): void {
    this.frame = frame;
    this.goOn();
  }

  /** The base is pulled to a place that goes with it, so that the force stays. */
  private goOn(): void {
    const { push, frame } = this;
    if (!push || !frame) return;
    const since_s = frame.t - push.from_s;
    if (since_s >= kPush_s || since_s < 0 || frame.mode === "posed") {
      this.push = null;
      this.pull.letGo();
      return;
    }
    const yaw = ((frame.heading_deg ?? 0) * Math.PI) / 180, reach = reachOf(this.robot, this.force.value);
    const way = new THREE.Vector3(push.direction[0], push.direction[1], 0).applyAxisAngle(new THREE.Vector3(0, 0, 1), yaw).multiplyScalar(reach);
    const p_W = new THREE.Vector3(frame.q[0] ?? 0, frame.q[1] ?? 0, frame.q[2] ?? 0);
    this.pull.to({ body: 0, at_Body: new THREE.Vector3(), to_W: p_W.add(way) });
  }
}
