// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import type { Clock } from "./clock";
import { kFootColours, type Ink, type Theme } from "./colours";
import { plotAxis } from "./plot_axis";
import { mainTrack, type Motion, type Table } from "./scene";

interface Line {
  label: string;
  values: (theme: Theme) => string;
  data: Float32Array | number[];
  planned: boolean;
  width?: number;
  /** Shaded down to the line before. */
  band?: boolean;
}

interface Panel {
  title: string;
  unit: string;
  lines: Line[];
}

const kPlotHeight = 150;

function column(table: Table, c: number, scale = 1): Float32Array {
  const values = new Float32Array(table.rows);
  for (let k = 0; k < table.rows; ++k) values[k] = scale * table.values[k * table.columns + c];
  return values;
}

function line(label: string, ink: Ink, planned: boolean, data: Float32Array): Line {
  return { label, values: (theme) => theme.ink[ink], data, planned };
}

/** Least and largest coordinate of the support at each sample. */
function supportExtent(motion: Motion, axis: number): [Float32Array, Float32Array] {
  const { supportFirst, support } = mainTrack(motion);
  const low = new Float32Array(motion.time.length).fill(Number.NaN);
  const high = new Float32Array(motion.time.length).fill(Number.NaN);
  for (let k = 0; k < motion.time.length; ++k) {
    for (let i = supportFirst.values[k]; i < supportFirst.values[k + 1]; ++i) {
      const at = support.values[i * support.columns + axis];
      if (!(low[k] <= at)) low[k] = at;
      if (!(high[k] >= at)) high[k] = at;
    }
  }
  return [low, high];
}

function balancePanel(motion: Motion, axis: number): Panel {
  const name = axis === 0 ? "x" : "y";
  const [low, high] = supportExtent(motion, axis);
  const lines: Line[] = [
    { label: "support from", values: (theme) => theme.ink.support, data: low, planned: true, width: 0.5 },
    { label: "support to", values: (theme) => theme.ink.support, data: high, planned: true, width: 0.5, band: true },
  ];
  for (const [track, planned] of [[motion.planned, true], [motion.measured, false]] as const) {
    if (!track) continue;
    const suffix = planned ? " planned" : "";
    lines.push(line("CoM" + suffix, "com", planned, column(track.com, axis)));
    lines.push(line("ZMP" + suffix, "zmp", planned, column(track.zmp, axis)));
    lines.push(line("DCM" + suffix, "dcm", planned, column(track.dcm, axis)));
  }
  return { title: `Balance, ${name}`, unit: "m", lines };
}

function figurePanel(motion: Motion, title: string, unit: string, ink: Ink, of: (track: NonNullable<Motion["planned"]>) => Float32Array): Panel {
  const lines: Line[] = [];
  if (motion.planned) lines.push(line("planned", ink, true, of(motion.planned)));
  if (motion.measured) lines.push(line("measured", ink, false, of(motion.measured)));
  return { title, unit, lines };
}

function footPanel(motion: Motion, title: string, unit: string, of: (foot: number) => Float32Array): Panel {
  const lines = motion.file.robot.feet.map((foot, i) => ({
    label: foot.name,
    values: () => kFootColours[i % kFootColours.length],
    data: of(i),
    planned: false,
  }));
  return { title, unit, lines };
}

/** The plots beside the 3D view; all share the page's time. */
export class Plots {
  private readonly plots: { plot: uPlot; cursor: HTMLElement }[] = [];
  private readonly jointMenu = document.createElement("select");
  private theme: Theme;

  constructor(
    private readonly root: HTMLElement,
    private readonly motion: Motion,
    private readonly clock: Clock,
    theme: Theme,
  ) {
    this.theme = theme;
    motion.file.robot.dofs.forEach((dof, i) => this.jointMenu.add(new Option(dof.name, String(i))));
    this.jointMenu.setAttribute("aria-label", "joint that is plotted");
    this.jointMenu.addEventListener("change", () => this.build());
    this.build();
    new ResizeObserver(() => this.fit()).observe(root);
    clock.onChange((t) => this.showTime(t));
  }

  paint(theme: Theme): void {
    this.theme = theme;
    this.build();
  }

  private panels(): Panel[] {
    const track = mainTrack(this.motion);
    const joint = Number(this.jointMenu.value || 0);
    const dof = this.motion.file.robot.dofs[joint];
    return [
      balancePanel(this.motion, 0),
      balancePanel(this.motion, 1),
      figurePanel(this.motion, "ZMP margin", "mm", "zmp", (t) => column(t.margin, 0, 1e3)),
      figurePanel(this.motion, "Base height", "m", "com", (t) => column(t.q, 2)),
      footPanel(this.motion, "Vertical force of the feet", "N", (i) => column(track.force, 3 * i + 2)),
      footPanel(this.motion, "Height of the feet over the ground", "mm", (i) => column(track.footHeight, i, 1e3)),
      figurePanel(this.motion, "Position of", dof.unit, "joint", (t) => column(t.q, 7 + joint)),
      figurePanel(this.motion, "Torque of", dof.unit === "m" ? "N" : "N m", "limit", (t) => column(t.tau, joint)),
    ];
  }

  private build(): void {
    for (const { plot } of this.plots) plot.destroy();
    this.plots.length = 0;
    this.root.replaceChildren();
    for (const panel of this.panels()) this.add(panel);
    this.showTime(this.clock.time);
  }

  private add(panel: Panel): void {
    const box = document.createElement("section");
    box.className = "gw-plot";
    const title = document.createElement("h3");
    title.textContent = `${panel.title} `;
    if (panel.title === "Position of") title.append(this.jointMenu);
    if (panel.title === "Torque of") title.append(this.jointMenu.selectedOptions[0]?.text ?? "");
    title.append(Object.assign(document.createElement("small"), { textContent: ` [${panel.unit}]` }));
    box.append(title);
    this.root.append(box);
    const plot = new uPlot(this.options(panel, box), [Array.from(this.motion.time), ...panel.lines.map((l) => this.gapped(l.data))], box);
    const cursor = document.createElement("div");
    cursor.className = "gw-now";
    plot.over.append(cursor);
    this.seekBy(plot);
    this.plots.push({ plot, cursor });
  }

  /** uPlot takes null for what is not there. */
  private gapped(data: ArrayLike<number>): (number | null)[] {
    return Array.from(data, (value) => (Number.isFinite(value) ? value : null));
  }

  private options(panel: Panel, box: HTMLElement): uPlot.Options {
    return {
      width: Math.max(box.clientWidth, 200),
      height: kPlotHeight,
      cursor: { sync: { key: "gaitwright" }, drag: { setScale: false, x: false, y: false }, y: false },
      legend: { live: true },
      scales: { x: { time: false } },
      axes: [plotAxis(this.theme, 28), plotAxis(this.theme, 54)],
      bands: panel.lines.flatMap((l, i) => (l.band ? [{ series: [i + 1, i] as [number, number], fill: this.theme.ink.support + "44" }] : [])),
      series: [
        { label: "time [s]", value: (_, v) => (v == null ? "" : v.toFixed(3)) },
        ...panel.lines.map((l): uPlot.Series => ({
          label: l.label,
          stroke: l.values(this.theme) + (l.planned ? "99" : ""),
          width: l.width ?? (l.planned ? 3 : 1.25),
          points: { show: false },
          spanGaps: false,
          value: (_, v) => (v == null ? "\u2013" : v.toPrecision(4)),
        })),
      ],
    };
  }

  /** A press or a drag in a plot sets the time. */
  private seekBy(plot: uPlot): void {
    const seek = (event: PointerEvent) => {
      const at = event.clientX - plot.over.getBoundingClientRect().left;
      this.clock.set(plot.posToVal(at, "x"));
    };
    plot.over.addEventListener("pointerdown", (event) => {
      this.clock.pause();
      plot.over.setPointerCapture(event.pointerId);
      seek(event);
    });
    plot.over.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) seek(event);
    });
  }

  private showTime(t: number): void {
    for (const { plot, cursor } of this.plots) cursor.style.transform = `translateX(${plot.valToPos(t, "x")}px)`;
  }

  private fit(): void {
    for (const { plot } of this.plots) {
      const width = plot.root.parentElement?.clientWidth ?? 0;
      if (width > 0 && width !== plot.width) plot.setSize({ width, height: kPlotHeight });
    }
    this.showTime(this.clock.time);
  }
}
