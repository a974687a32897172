// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import type { Ink, Theme } from "../colours";
import { make } from "../elements";
import { plotAxis } from "../plot_axis";
import { CalmRange } from "./calm_range";

const kWindow_s = 4;
/** For 60 pictures per second, with a margin. */
const kRows = 260;
/** Data older than this are dropped when new data arrive. */
const kJump_s = kWindow_s;
const kDrawEvery_ms = 33;

export interface RollingLine {
  label: string;
  ink: Ink;
  /** Drawn broad and pale. */
  planned?: boolean;
  /** Belongs to the right-hand axis. */
  right?: boolean;
}

/** Lines over the last seconds. */
export class RollingPlot {
  readonly root = make("div", "gw-rolling");
  private readonly data: (number | null)[][];
  private readonly times = new Float64Array(kRows);
  /** Ranges of the left and of the right axis. */
  private readonly ranges: CalmRange[];
  private plot: uPlot | null = null;
  private theme: Theme | null = null;
  private fresh = false;
  private drawn_ms = 0;

  /** @param spans  smallest range of the left and of the right axis. */
  constructor(
    private readonly lines: RollingLine[],
    spans: [number, number?],
    withZero = false,
  ) {
    this.ranges = spans.map((span) => new CalmRange(span ?? 1, withZero));
    this.data = [Array.from(this.times), ...lines.map(() => new Array<number | null>(kRows).fill(null))];
    this.clear(0);
    new ResizeObserver(() => this.fit()).observe(this.root);
  }

  push(t: number, values: (number | null)[]): void {
    const last = this.times[kRows - 1];
    if (t < last || t > last + kJump_s) this.clear(t);
    else if (t > last) {
      this.times.copyWithin(0, 1);
      for (const line of this.data) line.copyWithin(0, 1);
    }
    this.times[kRows - 1] = t;
    values.forEach((value, i) => (this.data[i + 1][kRows - 1] = value));
    this.fresh = true;
  }

  clear(t = this.times[kRows - 1]): void {
    for (let i = 0; i < kRows; ++i) this.times[i] = t - kWindow_s - 0.001 * (kRows - i);
    this.times[kRows - 1] = t;
    for (let i = 1; i < this.data.length; ++i) this.data[i].fill(null);
    for (const range of this.ranges) range.clear();
    this.fresh = true;
  }

  /** Draws new data, at a limited rate. */
  draw(now_ms: number): void {
    if (!this.fresh || !this.plot || now_ms - this.drawn_ms < kDrawEvery_ms) return;
    this.fresh = false;
    this.drawn_ms = now_ms;
    for (let i = 0; i < kRows; ++i) this.data[0][i] = this.times[i] - this.times[kRows - 1];
    this.plot.setData(this.data as uPlot.AlignedData);
  }

  paint(theme: Theme): void {
    this.theme = theme;
    this.dispose();
    this.fit();
  }

  dispose(): void {
    this.plot?.destroy();
    this.plot = null;
  }

  private fit(): void {
    const size = { width: this.root.clientWidth, height: this.root.clientHeight };
    if (size.width < 50 || size.height < 50 || !this.theme) return;
    if (!this.plot) this.plot = new uPlot({ ...this.options(this.theme), ...size }, this.data as uPlot.AlignedData, this.root);
    else if (this.plot.width !== size.width || this.plot.height !== size.height) this.plot.setSize(size);
    this.fresh = true;
  }

  private options(theme: Theme): Omit<uPlot.Options, "width" | "height"> {
    const [left, right] = this.ranges;
    const rangeOf = (ends: CalmRange): uPlot.Scale => ({ range: (_, low, high) => ends.around(low, high, performance.now()) });
    const scales: uPlot.Scales = { x: { time: false, range: [-kWindow_s, 0] }, y: rangeOf(left) };
    if (right) scales.right = rangeOf(right);
    return {
      cursor: { show: false },
      legend: { show: false },
      padding: [6, right ? 0 : 8, 0, 0],
      scales,
      axes: [
        { ...plotAxis(theme, 27), values: (_, ticks) => ticks.map((tick) => `${tick} s`), splits: [-4, -3, -2, -1, 0] },
        plotAxis(theme, 56),
        ...(right ? [{ ...plotAxis(theme, 40), scale: "right", side: 1, grid: { show: false } }] : []),
      ],
      series: [{}, ...this.lines.map((line) => this.series(line, theme))],
    };
  }

  private series(line: RollingLine, theme: Theme): uPlot.Series {
    return {
      label: line.label,
      scale: line.right ? "right" : "y",
      stroke: theme.ink[line.ink] + (line.planned ? "77" : ""),
      width: line.planned ? 4 : 1.75,
      points: { show: false },
    };
  }
}
