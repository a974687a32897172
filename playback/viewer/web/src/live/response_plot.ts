// SPDX-License-Identifier: BSD-3-Clause
import type { Theme } from "../colours";
import { button, disable, make, menu, write } from "../elements";
import { rounded } from "../figures";
import type { DofFile, RobotFile } from "../scene";
import type { Frame, Send } from "./messages";
import { plotFigure } from "./plot_figure";
import { RollingPlot } from "./rolling_plot";
import { scaleOf } from "./units";

const kKnock_rad = 0.1;
const kKnock_m = 0.02;
const kKnock_s = 0.5;
const kLeastSpan = 2;
const kLeastEffort = 2;

/** The joint that carries the first foot's leg: a joint that moves much. */
function nextToFoot(robot: RobotFile): number {
  const body = robot.feet[0]?.body ?? 0;
  return robot.joints[body - 1]?.dof ?? 0;
}

/** Response of one joint: target, position and torque, over the last seconds. */
export class ResponsePlot {
  readonly root: HTMLElement;
  private readonly plot = new RollingPlot(
    [
      { label: "torque", ink: "limit", right: true },
      { label: "target", ink: "joint", planned: true },
      { label: "position", ink: "joint" },
    ],
    [kLeastSpan, kLeastEffort],
  );
  private readonly dofs: DofFile[];
  private readonly menu = menu("joint whose response is plotted");
  private readonly knocker = button("knock", `moves its target for ${kKnock_s} s`, () => this.knock());
  private readonly unit = make("span", "gw-note");
  private readonly gains = make("span", "gw-note gw-drive");

  constructor(
    robot: RobotFile,
    private readonly send: Send,
  ) {
    this.dofs = robot.dofs;
    const first = nextToFoot(robot);
    robot.dofs.forEach((dof, i) => this.menu.add(new Option(dof.name, String(i), i === first, i === first)));
    this.menu.name = "response_joint";
    this.menu.addEventListener("change", () => this.choose());
    this.knocker.name = "knock";
    this.root = plotFigure(
      "Response", [["\u25ac", "joint", "target"], ["\u2014", "joint", "position"], ["\u2014", "limit", "torque"]], this.plot.root,
      this.menu, this.knocker, this.unit, this.gains,
    );
    this.choose();
  }

  push(frame: Frame): void {
    const dof = this.dof, scale = this.dofs[dof] ? scaleOf(this.dofs[dof]) : 1;
    const scaled = (value: number | null | undefined) => (value == null ? null : scale * value);
    this.plot.push(frame.t, [frame.tau[dof] ?? null, scaled(frame.target[dof]), scaled(frame.q[7 + dof])]);
    this.showGains(frame.stiffness[dof], frame.damping[dof]);
    const down = frame.mode === "posed" || frame.mode === "fallen";
    disable(this.knocker, down ? "the joints follow no target now: press U to stand it up first" : "");
  }

  clear(): void {
    this.plot.clear();
  }

  draw(now_ms: number): void {
    this.plot.draw(now_ms);
  }

  paint(theme: Theme): void {
    this.plot.paint(theme);
  }

  dispose(): void {
    this.plot.dispose();
  }

  private get dof(): number {
    return Number(this.menu.value);
  }

  /** Gains with which the joint follows its target; a stance leg is moved by torques. */
  private showGains(stiffness: number | null | undefined, damping: number | null | undefined): void {
    if (stiffness == null || damping == null) return write(this.gains, "");
    const [kp, kd] = this.dofs[this.dof]?.unit === "m" ? ["N/m", "N s/m"] : ["N m/rad", "N m s/rad"];
    write(this.gains, `kp ${rounded(stiffness, 1)} ${kp}, kd ${rounded(damping, 2)} ${kd}`);
  }

  private choose(): void {
    this.unit.textContent = this.dofs[this.dof]?.unit === "m" ? "[mm, N]" : "[degrees, N m]";
    this.plot.clear();
  }

  private knock(): void {
    this.send({ do: "nudge", dof: this.dof, by: this.dofs[this.dof].unit === "m" ? kKnock_m : kKnock_rad, for_s: kKnock_s });
  }
}
