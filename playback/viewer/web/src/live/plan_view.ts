// SPDX-License-Identifier: BSD-3-Clause
import type { Theme } from "../colours";
import { button, make, tell } from "../elements";
import { row, type Motion } from "../scene";
import { fitCanvas } from "./fit_canvas";
import type { Balance, Frame, Numbers } from "./messages";
import { plotFigure } from "./plot_figure";

/** Visible distance from the middle up and down, in leg lengths. */
const kShown = 0.85;
const kGrid_m = 0.1;
/** Height of a picture with marks of normal size; marks are larger in a larger picture. */
const kUsualHeight = 160;
const kLargestMarks = 2;

/** The key of this file, for the help line. */
export const kPlanHelp = "P large view from above";

/** The balance from above, with the robot in the middle: the world's x axis is up, its y axis is left. */
export class PlanView {
  readonly root: HTMLElement;
  private readonly canvas = make("canvas", "gw-plan");
  private readonly enlarger = button("enlarge", "large, for a lecture hall, or normal size (P)", () => this.enlarge());
  private readonly size: number;
  private theme: Theme | null = null;
  private context: CanvasRenderingContext2D | null = null;
  /** Pixels per metre; the middle of the picture. */
  private scale = 1;
  /** Scale of marks and lines. */
  private thick = 1;
  private middle: [number, number] = [0, 0];

  constructor(private readonly motion: Motion) {
    this.size = motion.file.robot.leg_length_m;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "zero-moment point and support polygon from above");
    this.root = plotFigure(
      "From above",
      [
        ["\u25cb", "zmp", "ZMP planned"], ["\u25cf", "zmp", "measured"], ["\u25cf", "com", "CoM"], ["\u25cf", "foot", "feet"],
        ["\u2504", "muted", "support planned"], ["\u25a0", "support", "measured"],
      ],
      this.canvas,
      this.enlarger,
    );
    this.enlarger.name = "enlarge";
    tell(this.enlarger, "aria-pressed", "false");
  }

  /** Makes it the largest picture of the page, or restores its size. */
  enlarge(): void {
    const large = this.root.classList.toggle("gw-large");
    tell(this.enlarger, "aria-pressed", String(large));
    this.enlarger.textContent = large ? "make small" : "enlarge";
  }

  /** Handles a key, if it belongs to this view. */
  press(key: string): boolean {
    if (key.toLowerCase() !== "p") return false;
    this.enlarge();
    return true;
  }

  paint(theme: Theme): void {
    this.theme = theme;
  }

  /** @param now  row of the motion. */
  draw(frame: Frame, now: number): void {
    const context = fitCanvas(this.canvas);
    if (!context || !this.theme) return;
    this.context = context;
    this.thick = Math.min(Math.max(this.canvas.clientHeight / kUsualHeight, 1), kLargestMarks);
    this.scale = (0.5 * this.canvas.clientHeight) / (kShown * this.size);
    this.middle = [frame.q[0] ?? 0, frame.q[1] ?? 0];
    const { ink } = this.theme;
    this.grid(this.theme);
    this.polygon(frame.planned, null, ink.muted, [4, 4]);
    this.polygon(frame.measured, ink.support + "55", ink.support, []);
    for (const foot of frame.feet) this.circle(foot.p, 5, ink.foot, foot.touching);
    this.circle(frame.measured?.com ?? null, 4, ink.com, true);
    this.trail(now, ink.zmp);
    this.circle(frame.planned?.zmp ?? null, 7, ink.zmp, false);
    this.circle(frame.measured?.zmp ?? null, 5, ink.zmp, true);
  }

  /** In pixels; points outside are drawn at the edge. */
  private place(x: number, y: number, inside = false): [number, number] {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const at: [number, number] = [0.5 * width - (y - this.middle[1]) * this.scale, 0.5 * height - (x - this.middle[0]) * this.scale];
    return inside ? [Math.min(Math.max(at[0], 4), width - 4), Math.min(Math.max(at[1], 4), height - 4)] : at;
  }

  private grid(theme: Theme): void {
    const context = this.context!, { clientWidth: width, clientHeight: height } = this.canvas;
    context.strokeStyle = theme.rule;
    context.lineWidth = 1;
    context.beginPath();
    const most = [(0.5 * height) / this.scale, (0.5 * width) / this.scale];
    for (const axis of [0, 1]) {
      for (let i = Math.ceil((this.middle[axis] - most[axis]) / kGrid_m); i * kGrid_m < this.middle[axis] + most[axis]; ++i) {
        const at = axis === 0 ? this.place(i * kGrid_m, 0)[1] : this.place(0, i * kGrid_m)[0];
        context.moveTo(axis === 0 ? 0 : at, axis === 0 ? at : 0);
        context.lineTo(axis === 0 ? width : at, axis === 0 ? at : height);
      }
    }
    context.stroke();
    context.fillStyle = theme.soft;
    context.font = `${11 * this.thick}px system-ui, sans-serif`;
    context.fillText("grid 0.1 m", 4, height - 5);
  }

  private polygon(balance: Balance | null, fill: string | null, stroke: string, dash: number[]): void {
    if (!balance || balance.support.length < 2) return;
    const context = this.context!;
    context.beginPath();
    for (const corner of balance.support) context.lineTo(...this.place(corner[0] ?? 0, corner[1] ?? 0));
    context.closePath();
    if (fill) {
      context.fillStyle = fill;
      context.fill();
    }
    context.setLineDash(dash);
    context.lineWidth = 1.5 * this.thick;
    context.strokeStyle = stroke;
    context.stroke();
    context.setLineDash([]);
  }

  private circle(p: Numbers | null, radius: number, colour: string, filled: boolean): void {
    if (p?.[0] == null || p[1] == null) return;
    const context = this.context!;
    context.beginPath();
    context.arc(...this.place(p[0], p[1], true), radius * this.thick, 0, 2 * Math.PI);
    context.lineWidth = 2 * this.thick;
    [context.fillStyle, context.strokeStyle] = [colour, colour];
    if (filled) context.fill();
    else context.stroke();
  }

  /** The path of the measured ZMP in the last second. */
  private trail(now: number, colour: string): void {
    const zmp = this.motion.measured?.zmp;
    if (!zmp) return;
    const context = this.context!;
    let drawing = false;
    context.beginPath();
    for (let k = 0; k <= now; ++k) {
      const p = row(zmp, k), there = Number.isFinite(p[0]);
      if (there) context[drawing ? "lineTo" : "moveTo"](...this.place(p[0], p[1]));
      drawing = there;
    }
    [context.strokeStyle, context.lineWidth] = [colour, 1.25 * this.thick];
    context.stroke();
  }
}
