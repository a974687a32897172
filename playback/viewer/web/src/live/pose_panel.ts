// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { button, make } from "../elements";
import { rounded } from "../figures";
import type { DofFile, RobotFile } from "../scene";
import { AtMost } from "./at_most";
import type { Frame, Numbers, Send } from "./messages";
import { Slider } from "./slider";
import { kDegrees, scaleOf } from "./units";

const kPosesPerSecond = 30;
/** Range of a joint without limits. */
const kFreeTurn_deg = 180;
const kFreeShift_mm = 1000;
const kBaseShift_m = 1;

function jointSlider(dof: DofFile): Slider {
  const turns = dof.unit === "rad";
  const scale = scaleOf(dof), free = turns ? kFreeTurn_deg : kFreeShift_mm, unit = turns ? "\u00b0" : " mm";
  const end = (limit: number | null, none: string) => (limit === null ? none : rounded(scale * limit, 1) + unit);
  return new Slider({
    name: `joint:${dof.name}`, label: dof.name, title: dof.name, least: dof.lower === null ? -free : scale * dof.lower,
    most: dof.upper === null ? free : scale * dof.upper, step: 0.1, value: 0, words: (value) => rounded(value, 1) + unit,
    ends: [end(dof.lower, "\u2212\u221e"), end(dof.upper, "\u221e")],
  });
}

/** Posing: moving a slider holds the whole robot in the chosen pose, without physics. */
export class PosePanel {
  readonly root = make("section", "gw-section");
  private readonly joints: Slider[];
  private readonly places: Slider[];
  private readonly turns: Slider[];
  private readonly say: AtMost<number[]>;
  private readonly turn = new THREE.Quaternion();
  private readonly angles = new THREE.Euler();
  private q: number[] = [];
  private latest: Numbers = [];

  constructor(
    private readonly robot: RobotFile,
    send: Send,
  ) {
    this.say = new AtMost(kPosesPerSecond, (q) => send({ do: "pose", q }));
    this.joints = robot.dofs.map(jointSlider);
    const tall = 2.5 * robot.leg_length_m;
    this.places = ["x", "y", "height"].map((label, i) => new Slider({
      name: `base:${label}`, label, least: i < 2 ? -kBaseShift_m : 0, most: i < 2 ? kBaseShift_m : tall, step: 0.001, value: 0,
      words: (value) => `${rounded(value, 3)} m`, wanders: true,
    }));
    this.turns = ["roll", "pitch", "yaw"].map((label, i) => new Slider({
      name: `base:${label}`, label, least: i === 1 ? -90 : -180, most: i === 1 ? 90 : 180, step: 0.5, value: 0,
      words: (value) => `${rounded(value, 1)}\u00b0`,
    }));
    const standUp = button("Stand up", "back to physics, standing upright (U)", () => send({ do: "stand_up" }));
    const beside = make("div", "gw-beside");
    beside.append(make("p", "gw-note", "Moving a slider holds the robot in the chosen pose, without physics."), standUp);
    const [x, y, height] = this.places;
    const roots = (sliders: Slider[]) => sliders.map((slider) => slider.root);
    this.root.append(make("h2", "", "Pose"), beside, ...roots([height, ...this.turns, x, y]), make("h3", "", "Joints"), ...roots(this.joints));
    this.places.forEach((slider, i) => (slider.onMove = (value) => this.change((q) => (q[i] = value))));
    this.joints.forEach((slider, i) => (slider.onMove = (value) => this.change((q) => (q[7 + i] = value / scaleOf(robot.dofs[i])))));
    for (const slider of this.turns) slider.onMove = () => this.change((q) => this.putTurn(q));
  }

  show(frame: Frame): void {
    this.latest = frame.q;
    if (this.busy()) return;
    this.q = [];
    this.places.forEach((slider, i) => slider.follow(frame.q[i]));
    this.joints.forEach((slider, i) => slider.follow(scaleOf(this.robot.dofs[i]) * (frame.q[7 + i] ?? 0)));
    this.turn.fromArray(frame.q.slice(3, 7).map((x) => x ?? 0));
    const { x, y, z } = this.angles.setFromQuaternion(this.turn, "ZYX");
    this.turns.forEach((slider, i) => slider.follow(kDegrees * [x, y, z][i]));
  }

  private busy(): boolean {
    return [this.places, this.turns, this.joints].some((sliders) => sliders.some((slider) => slider.busy));
  }

  /** During posing, it continues from the last request, not from the program's answers. */
  private change(put: (q: number[]) => void): void {
    if (this.latest.length === 0) return;
    if (this.q.length === 0) this.q = this.start();
    put(this.q);
    this.say.put([...this.q]);
  }

  /**
   * The present pose, within the limits: physics may have a joint slightly beyond its limits, where poses are not
   * accepted.
   */
  private start(): number[] {
    const q = this.latest.map((x) => x ?? 0);
    this.robot.dofs.forEach(({ lower, upper }, i) => (q[7 + i] = Math.min(Math.max(q[7 + i], lower ?? -Infinity), upper ?? Infinity)));
    return q;
  }

  private putTurn(q: number[]): void {
    const [roll, pitch, yaw] = this.turns.map((slider) => slider.value / kDegrees);
    this.turn.setFromEuler(this.angles.set(roll, pitch, yaw, "ZYX"));
    [q[3], q[4], q[5], q[6]] = [this.turn.x, this.turn.y, this.turn.z, this.turn.w];
  }
}
