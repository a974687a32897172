// SPDX-License-Identifier: BSD-3-Clause
import type { Theme } from "../colours";
import type { Frame } from "./messages";
import { plotFigure } from "./plot_figure";
import { RollingPlot } from "./rolling_plot";

const kLeastSpan_mm = 20;

function inMillimetres(metres: number | null | undefined): number | null {
  return metres == null ? null : 1000 * metres;
}

/** Distance of the ZMP inside the support, over the last seconds. */
export class MarginPlot {
  readonly root: HTMLElement;
  private readonly plot = new RollingPlot(
    [
      { label: "planned", ink: "zmp", planned: true },
      { label: "measured", ink: "zmp" },
    ],
    [kLeastSpan_mm],
    true,
  );

  constructor() {
    this.root = plotFigure("ZMP margin [mm]", [["\u25ac", "zmp", "planned"], ["\u2014", "zmp", "measured"]], this.plot.root);
  }

  push(frame: Frame): void {
    this.plot.push(frame.t, [inMillimetres(frame.planned?.margin_m), inMillimetres(frame.measured?.margin_m)]);
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
}
