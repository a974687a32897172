// SPDX-License-Identifier: BSD-3-Clause
import type { Theme } from "../colours";
import { make } from "../elements";
import type { PoseRow } from "../scene";
import { Stage } from "../stage";
import { GainsPanel } from "./gains_panel";
import { Grip } from "./grip";
import { GroundPanel } from "./ground_panel";
import { MarginPlot } from "./margin_plot";
import type { Frame, Greeting, Send } from "./messages";
import { PlanView } from "./plan_view";
import { PosePanel } from "./pose_panel";
import { Pull } from "./pull";
import { PullArrows } from "./pull_arrows";
import { PushPanel } from "./push_panel";
import { ResponsePlot } from "./response_plot";
import { RollingMotion } from "./rolling_motion";
import { StatusLine } from "./status_line";
import { Tabs } from "./tabs";
import { WalkPanel } from "./walk_panel";

const kPanelsEvery_ms = 66;

/** Everything that a page shows of one robot, from its greeting on. */
export class Session {
  readonly stage: Stage | null;
  readonly pull: Pull;
  readonly pushes: PushPanel;
  readonly plan: PlanView;
  readonly stageBox = make("figure", "gw-stage");
  readonly plots = make("div", "gw-strip");
  readonly tabs: Tabs;
  /** The program's number for this page. */
  page: number | null = null;
  private readonly rolling: RollingMotion;
  private readonly status: StatusLine;
  private readonly walk: WalkPanel;
  private readonly panels: { root: HTMLElement; show(frame: Frame): void }[];
  private readonly margin = new MarginPlot();
  private readonly response: ResponsePlot;
  private readonly grip: Grip | null = null;
  private readonly arrows: PullArrows | null = null;
  private connected = true;
  private frame: Frame;
  private ground = "";
  private fresh = true;
  private panels_ms = 0;

  constructor(greeting: Greeting, first: Frame, send: Send) {
    const { robot, terrain } = greeting.scene;
    this.frame = first;
    this.rolling = new RollingMotion(robot, terrain, first);
    this.pull = new Pull(send);
    this.status = new StatusLine(robot);
    this.walk = new WalkPanel(greeting, send);
    this.pushes = new PushPanel(robot, greeting.spring, send);
    this.response = new ResponsePlot(robot, send);
    this.plan = new PlanView(this.rolling.motion);
    const others = [new GroundPanel(greeting.engines, send), new PosePanel(robot, send), new GainsPanel(greeting.options, send)];
    const walking = make("div", "gw-panel");
    walking.append(this.walk.root, this.pushes.root);
    this.panels = [{ root: walking, show: (frame) => this.walk.show(frame) }, ...others];
    this.tabs = new Tabs("controls", ["Walk", "Ground", "Pose", "Gains"].map((title, i) => ({ title, root: this.panels[i].root })));
    this.tabs.onShow = () => this.showPanels();
    this.plots.append(this.plan.root, this.margin.root, this.response.root);
    this.stage = this.makeStage(robot.name);
    if (this.stage) {
      this.grip = new Grip(this.stageBox, this.stage, this.pull);
      this.arrows = new PullArrows(this.stage, this.pull, greeting.spring);
      this.stageBox.append(this.arrows.root);
    }
    this.pushes.show(first);
    this.showPanels();
  }

  /** Stores the current state; it is drawn with the next picture. */
  take(frame: Frame): void {
    this.frame = frame;
    this.rolling.push(frame);
    this.margin.push(frame);
    this.response.push(frame);
    this.pushes.show(frame);
    this.allowGrip();
    this.fresh = true;
  }

  /** The program has restarted with the same robot: earlier data do not belong to the new motion. */
  beginAnew(): void {
    this.rolling.forget();
    this.margin.clear();
    this.response.clear();
  }

  /**
   * While the connection is lost, nothing can be requested, and this page does not hold the robot; the program does the
   * same.
   */
  setConnected(connected: boolean): void {
    this.connected = connected;
    for (const part of [this.tabs.root, this.plots]) part.inert = !connected;
    this.allowGrip();
  }

  /** Draws new data. @return whether the picture of the robot was drawn. */
  draw(now_ms: number, seconds: number): boolean {
    if (this.fresh) this.showFrame();
    if (now_ms - this.panels_ms > kPanelsEvery_ms) this.showPanels(now_ms);
    this.margin.draw(now_ms);
    this.response.draw(now_ms);
    if (!this.stage) return false;
    if (this.grip?.holds) this.arrows?.show(this.frame, this.page);
    this.stage.goAfter(seconds);
    const drawn = this.stage.draw();
    if (drawn) this.arrows?.place();
    return drawn;
  }

  paint(theme: Theme): void {
    this.walk.paint(theme);
    this.arrows?.paint(theme);
    this.margin.paint(theme);
    this.response.paint(theme);
    this.plan.paint(theme);
    this.fresh = true;
  }

  dispose(): void {
    this.grip?.dispose();
    this.margin.dispose();
    this.response.dispose();
    this.stage?.dispose();
  }

  /** A posed robot is not pulled. */
  private allowGrip(): void {
    if (!this.grip) return;
    this.grip.allowed = this.connected && this.frame.mode !== "posed";
    if (!this.grip.allowed) this.grip.letGo();
  }

  private makeStage(name: string): Stage | null {
    const canvas = make("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${name}, in 3D`);
    this.stageBox.append(canvas, this.status.root);
    try {
      return new Stage(canvas, this.rolling.motion);
    } catch (error) {
      canvas.replaceWith(make("p", "gw-sorry", `3D is not available in this browser (${String(error)}). Controls and plots work.`));
      return null;
    }
  }

  private showFrame(): void {
    this.fresh = false;
    this.placeGround(this.frame.ground.pose);
    this.stage?.showLast();
    this.arrows?.show(this.frame, this.page);
    this.plan.draw(this.frame, this.rolling.now);
    this.status.show(this.frame);
  }

  private placeGround(pose: PoseRow): void {
    const text = pose.join();
    if (text === this.ground) return;
    this.ground = text;
    this.stage?.placeGround(pose);
  }

  /**
   * The visible controls. Updated all of the time, since a control that was held follows the program again after a
   * while.
   */
  private showPanels(now_ms = performance.now()): void {
    this.panels_ms = now_ms;
    for (const panel of this.panels) if (!panel.root.hidden) panel.show(this.frame);
  }
}
