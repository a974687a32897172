// SPDX-License-Identifier: BSD-3-Clause
import type { Theme } from "../colours";
import { make } from "../elements";
import { fitCanvas } from "./fit_canvas";

/** An angle in degrees, between -180 and 180. */
export function wrapped(angle_deg: number): number {
  return angle_deg - 360 * Math.round(angle_deg / 360);
}

/**
 * A compass seen from above: the world's x axis is up, the needle is the robot's heading, the mark at the rim the
 * wanted one.
 */
export class HeadingDial {
  readonly canvas = make("canvas", "gw-dial");
  /** While a person turns the dial [degrees]. */
  onTurn: (heading_deg: number) => void = () => {};
  onSet: (heading_deg: number) => void = () => {};
  /** The pointer that turns the dial; -1 for none. */
  private pointer = -1;
  private heading_deg = 0;
  private wanted_deg = 0;
  private theme: Theme | null = null;

  constructor() {
    this.canvas.setAttribute("aria-hidden", "true");
    this.canvas.title = "press to set the heading";
    this.canvas.addEventListener("pointerdown", (event) => this.take(event));
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.pointerId === this.pointer) this.onTurn(this.angleAt(event));
    });
    this.canvas.addEventListener("pointerup", (event) => {
      if (this.release(event)) this.onSet(this.angleAt(event));
    });
    for (const end of ["pointercancel", "lostpointercapture"] as const) this.canvas.addEventListener(end, (event) => this.release(event));
  }

  get held(): boolean {
    return this.pointer >= 0;
  }

  show(heading_deg: number, wanted_deg: number): void {
    if (heading_deg === this.heading_deg && wanted_deg === this.wanted_deg) return;
    this.heading_deg = heading_deg;
    this.wanted_deg = wanted_deg;
    this.draw();
  }

  paint(theme: Theme): void {
    this.theme = theme;
    this.draw();
  }

  private take(event: PointerEvent): void {
    if (this.held || event.button !== 0) return;
    this.pointer = event.pointerId;
    this.canvas.setPointerCapture(event.pointerId);
    this.onTurn(this.angleAt(event));
  }

  /** @return whether that pointer turned the dial. */
  private release(event: PointerEvent): boolean {
    if (event.pointerId !== this.pointer) return false;
    this.pointer = -1;
    return true;
  }

  private angleAt(event: PointerEvent): number {
    const box = this.canvas.getBoundingClientRect();
    const ahead = 0.5 * (box.top + box.bottom) - event.clientY;
    const left = 0.5 * (box.left + box.right) - event.clientX;
    return Math.round((Math.atan2(left, ahead) * 180) / Math.PI);
  }

  private draw(): void {
    const context = fitCanvas(this.canvas);
    const { theme } = this;
    if (!context || !theme) return;
    const r = 0.5 * Math.min(this.canvas.clientWidth, this.canvas.clientHeight) - 3;
    context.translate(0.5 * this.canvas.clientWidth, 0.5 * this.canvas.clientHeight);
    context.strokeStyle = theme.soft;
    for (let i = 0; i < 8; ++i) {
      context.rotate(Math.PI / 4);
      context.beginPath();
      context.moveTo(0, -r);
      context.lineTo(0, -r * (i % 2 === 1 ? 0.8 : 0.9));
      context.stroke();
    }
    context.beginPath();
    context.arc(0, 0, r, 0, 2 * Math.PI);
    context.stroke();
    this.needle(context, this.heading_deg, theme.ink.com, (0.72 * r) / 10);
    this.mark(context, this.wanted_deg, theme.text, r);
  }

  private needle(context: CanvasRenderingContext2D, angle_deg: number, colour: string, scale: number): void {
    context.save();
    context.rotate((-angle_deg * Math.PI) / 180);
    context.scale(scale, scale);
    context.fillStyle = colour;
    context.fill(new Path2D("M0 -10 L5 8 L0 5 L-5 8 Z"));
    context.restore();
  }

  private mark(context: CanvasRenderingContext2D, angle_deg: number, colour: string, r: number): void {
    context.save();
    context.rotate((-angle_deg * Math.PI) / 180);
    context.fillStyle = colour;
    context.beginPath();
    context.arc(0, -r, 3, 0, 2 * Math.PI);
    context.fill();
    context.restore();
  }
}
