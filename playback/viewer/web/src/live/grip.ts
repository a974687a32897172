// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import type { Stage } from "../stage";
import type { Pull } from "./pull";

const kLookEvery_ms = 50;

/**
 * Holds the robot with mouse or finger, and pulls it.
 *
 * Presses on the robot do not reach the canvas, so that the camera does not move; all others turn the camera.
 */
export class Grip {
  private pointer = -1;
  private x = 0;
  private y = 0;
  private looked_ms = 0;
  /** Whether the robot can be held now. */
  allowed = true;

  /** @param box  element around the canvas: it receives presses first. */
  constructor(
    private readonly box: HTMLElement,
    private readonly stage: Stage,
    private readonly pull: Pull,
  ) {
    box.addEventListener("pointerdown", (event) => this.take(event), { capture: true });
    box.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) box.addEventListener(end, (event) => this.end(event));
    window.addEventListener("blur", this.letGo);
    window.addEventListener("pagehide", this.letGo);
  }

  get holds(): boolean {
    return this.pointer >= 0;
  }

  readonly letGo = (): void => {
    if (!this.holds) return;
    const { pointer } = this;
    this.pointer = -1;
    if (this.box.hasPointerCapture(pointer)) this.box.releasePointerCapture(pointer);
    this.box.classList.remove("gw-holds");
    this.pull.letGo();
  };

  dispose(): void {
    this.letGo();
    window.removeEventListener("blur", this.letGo);
    window.removeEventListener("pagehide", this.letGo);
  }

  private take(event: PointerEvent): void {
    if (!this.allowed || this.holds || event.button !== 0 || event.target !== this.stage.canvas) return;
    const hit = this.stage.hit(event.clientX, event.clientY);
    if (!hit) return;
    event.stopPropagation();
    event.preventDefault();
    [this.pointer, this.x, this.y] = [event.pointerId, event.clientX, event.clientY];
    this.box.setPointerCapture(event.pointerId);
    this.box.classList.add("gw-holds");
    const at_Body = this.stage.robot.toBody(hit.body, hit.p_W);
    this.pull.to({ body: hit.body, at_Body, by_W: new THREE.Vector3(), along: this.stage.follow });
  }

  private move(event: PointerEvent): void {
    if (event.pointerId === this.pointer) this.shift(event.clientX, event.clientY);
    else if (!this.holds && event.buttons === 0) this.look(event);
  }

  private end(event: PointerEvent): void {
    if (event.pointerId === this.pointer) this.letGo();
  }

  /** The cursor becomes a hand over the robot to show that it can be held. */
  private look(event: PointerEvent): void {
    if (event.timeStamp - this.looked_ms < kLookEvery_ms) return;
    this.looked_ms = event.timeStamp;
    const can = this.allowed && event.target === this.stage.canvas && this.stage.hit(event.clientX, event.clientY) !== null;
    this.box.classList.toggle("gw-can-hold", can);
  }

  /**
   * The hand moves with the pointer in the picture, independent of the camera: the camera follows the robot, which the
   * hand moves, with a delay.
   */
  private shift(x: number, y: number): void {
    const { hold } = this.pull;
    if (!hold) return;
    const held_W = this.stage.robot.fromBody(hold.body, hold.at_Body);
    const way_W = this.stage.pointAt(x, y, held_W).sub(this.stage.pointAt(this.x, this.y, held_W));
    [this.x, this.y] = [x, y];
    this.pull.to({ ...hold, by_W: hold.by_W.clone().add(way_W) });
  }
}
