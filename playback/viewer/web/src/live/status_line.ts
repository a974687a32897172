// SPDX-License-Identifier: BSD-3-Clause
import { make, write } from "../elements";
import type { RobotFile } from "../scene";
import type { Frame } from "./messages";
import { kModeWords, paceWords } from "./words";

const kBehind_s = 0.1;

/** The robot's state, in a line over the picture. */
export class StatusLine {
  readonly root = make("figcaption", "gw-status");
  private readonly mode = make("b", "gw-mode");
  private readonly time = make("span", "gw-time");
  private readonly pace = make("span");
  private readonly wanted = make("span", "gw-wanted");
  private readonly feet = make("span", "gw-bearing");
  private readonly behind = make("span", "gw-behind");

  constructor(private readonly robot: RobotFile) {
    this.root.append(this.mode, make("b", "", robot.name), this.time, this.pace, this.wanted, this.behind, this.feet);
  }

  show(frame: Frame): void {
    this.mode.dataset.mode = frame.mode;
    write(this.mode, kModeWords[frame.mode] + (frame.paused ? ", paused" : ""));
    write(this.time, `${frame.t.toFixed(frame.paused ? 3 : 1)} s`);
    write(this.pace, frame.mode === "walks" ? paceWords(frame.pace) : "");
    write(this.wanted, frame.wanted ? `planning: ${paceWords(frame.wanted)}` : "");
    write(this.behind, frame.behind_s > kBehind_s ? `behind real time by ${frame.behind_s.toFixed(1)} s` : "");
    const touching = this.robot.feet.filter((_, i) => frame.feet[i]?.touching).map((foot) => foot.name);
    write(this.feet, `on ${touching.join(", ") || "no foot"}`);
  }
}
