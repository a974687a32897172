// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { ArrowMaker, type Arrow } from "../arrows";
import type { Theme } from "../colours";
import { make } from "../elements";
import { Palette } from "../palette";
import type { Stage } from "../stage";
import type { Frame } from "./messages";
import type { Pull } from "./pull";
import { reachOf } from "./spring";

/** The pull on the robot: an arrow from the point that is held to where it is pulled, and its force. */
export class PullArrow {
  readonly label = make("span", "gw-pull");
  private readonly palette = new Palette();
  private readonly arrow: Arrow;
  private readonly from = new THREE.Vector3();
  private readonly way = new THREE.Vector3();
  private readonly tip = new THREE.Vector3();
  private readonly size: number;

  constructor(
    private readonly stage: Stage,
    private readonly pull: Pull,
  ) {
    this.size = stage.motion.file.robot.leg_length_m;
    this.arrow = new ArrowMaker(this.size, this.palette.solid("pull")).make();
    this.arrow.root.visible = false;
    this.label.hidden = true;
    stage.add(this.arrow.root);
  }

  paint(theme: Theme): void {
    this.palette.paint(theme);
    this.stage.touch();
  }

  show(frame: Frame): void {
    // What is told while it is paused is of the last step: the robot may have been let go since.
    const told = frame.paused && !this.pull.hold ? null : frame.pull_n;
    const force = told && new THREE.Vector3(...(told as [number, number, number]));
    this.point(force);
    const length = this.way.length();
    const visible = (force !== null || this.pull.hold !== null) && length > 0.01 * this.size;
    if (!visible && !this.arrow.root.visible) return;
    this.arrow.root.visible = visible;
    this.label.hidden = !force || !visible;
    if (visible) this.arrow.show(this.from, this.way, Math.max(length - 0.1 * this.size, 0));
    if (force) this.label.textContent = `${force.length().toFixed(0)} N`;
    this.stage.touch();
  }

  /** The camera may have moved: the label is beside the tip. */
  place(): void {
    if (this.label.hidden) return;
    const { x, y } = this.stage.seenAt(this.tip.copy(this.from).add(this.way));
    this.label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }

  /** From where to where; of a pull that another page does its force alone is known, and is shown at the base. */
  private point(force: THREE.Vector3 | null): void {
    const { hold } = this.pull;
    this.way.set(0, 0, 0);
    if (hold) {
      this.from.copy(this.stage.robot.fromBody(hold.body, hold.at_Body));
      this.way.copy(hold.to_W).sub(this.from);
    } else if (force) {
      this.from.copy(this.stage.robot.bodyPosition(0));
      this.way.copy(force).normalize().multiplyScalar(reachOf(this.stage.motion.file.robot, force.length()));
    }
  }
}
