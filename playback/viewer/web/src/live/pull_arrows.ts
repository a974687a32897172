// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { ArrowMaker, type Arrow } from "../arrows";
import type { Theme } from "../colours";
import { make } from "../elements";
import { Palette } from "../palette";
import type { Stage } from "../stage";
import type { Frame, PullFile, Spring } from "./messages";
import type { Pull } from "./pull";
import { newtons } from "./words";

/** Weaker forces are not shown. */
const kLeast_n = 0.01;

/** An arrow with its force beside the tip. */
class Told {
  readonly label = make("span", "gw-pull");
  private readonly tip = new THREE.Vector3();

  constructor(
    readonly arrow: Arrow,
    private readonly stage: Stage,
  ) {
    this.hide();
  }

  get visible(): boolean {
    return this.arrow.root.visible;
  }

  /** @param force_n  null if it is not known yet. */
  show(from: THREE.Vector3, way: THREE.Vector3, force_n: number | null): void {
    this.arrow.root.visible = true;
    this.arrow.show(from, way, way.length());
    this.tip.copy(from).add(way);
    this.label.hidden = force_n === null || force_n < kLeast_n;
    if (force_n === null) return;
    const text = newtons(force_n);
    if (this.label.textContent !== text) this.label.textContent = text;
  }

  hide(): void {
    this.arrow.root.visible = false;
    this.label.hidden = true;
  }

  place(): void {
    if (this.label.hidden) return;
    const { x, y } = this.stage.seenAt(this.tip);
    this.label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  }
}

/** All forces that people apply to the robot: the pull of each page from its point, and the push on the base. */
export class PullArrows {
  /** Parent of the labels, which are placed over the picture. */
  readonly root = make("div");
  private readonly palette = new Palette();
  private readonly maker: ArrowMaker;
  private readonly all: Told[] = [];
  private readonly way = new THREE.Vector3();
  private readonly at = new THREE.Vector3();
  private shown = 0;

  constructor(
    private readonly stage: Stage,
    private readonly pull: Pull,
    private readonly spring: Spring,
  ) {
    this.maker = new ArrowMaker(stage.motion.file.robot.leg_length_m, this.palette.solid("pull"));
  }

  paint(theme: Theme): void {
    this.palette.paint(theme);
    this.stage.touch();
  }

  /** @param page  the number of this page: its own pull follows its pointer without waiting for an answer. */
  show(frame: Frame, page: number | null): void {
    const before = this.shown;
    this.shown = 0;
    for (const pull of frame.pulls) {
      if (pull.page !== page) this.add(this.stage.robot.fromBody(pull.body, this.at.fromArray(pull.at_m)), pull.force_n);
    }
    if (frame.push_n) this.add(this.stage.robot.bodyPosition(0), frame.push_n);
    this.addOwn(frame.pulls.find((pull) => pull.page === page));
    for (let i = this.shown; i < before; ++i) this.all[i].hide();
    if (this.shown > 0 || before > 0) this.stage.touch();
  }

  /** The camera may have moved: places the labels beside the tips. */
  place(): void {
    for (let i = 0; i < this.shown; ++i) this.all[i].place();
  }

  private add(from: THREE.Vector3, force_n: [number, number, number]): void {
    this.way.fromArray(force_n);
    const size_n = this.way.length();
    this.put(from, this.way.divideScalar(this.spring.n_per_m), size_n);
  }

  private addOwn(told: PullFile | undefined): void {
    const { hold } = this.pull;
    if (!hold) return;
    const from = this.stage.robot.fromBody(hold.body, hold.at_Body);
    this.way.copy(hold.by_W);
    if (told) this.way.add(this.at.fromArray(told.from_m)).sub(from);
    this.put(from, this.way, told ? Math.hypot(...told.force_n) : null);
  }

  private put(from: THREE.Vector3, way: THREE.Vector3, force_n: number | null): void {
    if (way.length() < 0.01 * this.stage.motion.file.robot.leg_length_m) return;
    if (this.shown === this.all.length) this.make();
    this.all[this.shown++].show(from, way, force_n);
  }

  private make(): void {
    const told = new Told(this.maker.make(), this.stage);
    this.all.push(told);
    this.stage.add(told.arrow.root);
    this.root.append(told.label);
  }
}
