// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import type { Clock } from "./clock";
import { kFootDashes, type Ink, type Theme } from "./colours";
import { make, menu } from "./elements";
import { rounded } from "./figures";
import { plotAxis } from "./plot_axis";
import { mainTrack, type Motion, type Table, type Track } from "./scene";

interface Line {
  label: string;
  colour: (theme: Theme) => string;
  data: Column;
  planned: boolean;
  width?: number;
  dash?: number[];
  /** Shaded down to the previous line. */
  band?: boolean;
}

interface Panel {
  title: string;
  unit: string;
  lines: Line[];
}

/** uPlot uses null for missing values. */
type Column = (number | null)[];

/** A panel in the page; its contents may change. */
interface Shown {
  panel: Panel;
  box: HTMLElement;
  name: HTMLElement;
  unit: HTMLElement;
  plot: uPlot | null;
  cursor: HTMLElement;
}

const kPlotHeight = 150;
/** Decimals by unit; one more if all forces are below 10 N. */
const kDigits: Record<string, number> = { m: 4, rad: 4, mm: 1, N: 0, "N m": 2 };
const kSmallForce_n = 10;

function column(table: Table, c: number, scale = 1): Column {
  return Array.from({ length: table.rows }, (_, k) => {
    const value = scale * table.values[k * table.columns + c];
    return Number.isFinite(value) ? value : null;
  });
}

function line(label: string, ink: Ink, planned: boolean, data: Column): Line {
  return { label, colour: (theme) => theme.ink[ink], data, planned };
}

function digitsOf({ unit, lines }: Panel): number {
  const small = unit === "N" && lines.every(({ data }) => data.every((value) => value === null || Math.abs(value) < kSmallForce_n));
  return (kDigits[unit] ?? 3) + (small ? 1 : 0);
}

/** Least and largest coordinate of the support at each sample. */
function supportExtent(motion: Motion, axis: number): [Column, Column] {
  const { supportFirst, support } = mainTrack(motion);
  const low: Column = new Array<number | null>(motion.time.length).fill(null);
  const high: Column = [...low];
  for (let k = 0; k < motion.time.length; ++k) {
    for (let i = supportFirst.values[k]; i < supportFirst.values[k + 1]; ++i) {
      const at = support.values[i * support.columns + axis];
      low[k] = Math.min(low[k] ?? at, at);
      high[k] = Math.max(high[k] ?? at, at);
    }
  }
  return [low, high];
}

function balancePanel(motion: Motion, axis: number): Panel {
  const name = axis === 0 ? "x" : "y";
  const [low, high] = supportExtent(motion, axis);
  const lines: Line[] = [
    { label: "support from", colour: (theme) => theme.ink.support, data: low, planned: true, width: 0.5 },
    { label: "support to", colour: (theme) => theme.ink.support, data: high, planned: true, width: 0.5, band: true },
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

function figurePanel(motion: Motion, title: string, unit: string, ink: Ink, of: (track: Track) => Column): Panel {
  const lines: Line[] = [];
  if (motion.planned) lines.push(line("planned", ink, true, of(motion.planned)));
  if (motion.measured) lines.push(line("measured", ink, false, of(motion.measured)));
  return { title, unit, lines };
}

function footPanel(motion: Motion, title: string, unit: string, of: (foot: number) => Column): Panel {
  const lines = motion.file.robot.feet.map((foot, i) => ({
    label: foot.name,
    colour: (theme: Theme) => theme.feet[i % theme.feet.length],
    dash: kFootDashes[i % kFootDashes.length],
    data: of(i),
    planned: false,
  }));
  return { title, unit, lines };
}

/** The plots beside the 3D view; all share the page's time. */
export class Plots {
  private readonly plots: Shown[];
  private readonly jointMenu = menu("joint that is plotted");
  private readonly time: number[];
  private theme: Theme | null = null;

  /** They are drawn once colours are set. */
  constructor(
    root: HTMLElement,
    private readonly motion: Motion,
    private readonly clock: Clock,
  ) {
    motion.file.robot.dofs.forEach((dof, i) => this.jointMenu.add(new Option(dof.name, String(i))));
    this.time = Array.from(motion.time);
    this.plots = [...this.panels(), ...this.jointPanels()].map((panel) => this.makeBox(panel));
    root.append(...this.plots.map(({ box }) => box));
    this.plots[this.plots.length - 2].name.append(this.jointMenu);
    this.jointMenu.addEventListener("change", () => this.changeJoint());
    this.nameJoint();
    new ResizeObserver(() => this.fit()).observe(root);
    clock.onChange((t) => this.showTime(t));
  }

  paint(theme: Theme): void {
    this.theme = theme;
    for (const shown of this.plots) this.draw(shown, theme);
    this.showTime(this.clock.time);
  }

  private panels(): Panel[] {
    const track = mainTrack(this.motion);
    return [
      balancePanel(this.motion, 0),
      balancePanel(this.motion, 1),
      figurePanel(this.motion, "ZMP margin", "mm", "zmp", (t) => column(t.margin, 0, 1e3)),
      figurePanel(this.motion, "Base height", "m", "com", (t) => column(t.q, 2)),
      footPanel(this.motion, "Vertical force of the feet", "N", (i) => column(track.force, 3 * i + 2)),
      footPanel(this.motion, "Height of the feet over the ground", "mm", (i) => column(track.footHeight, i, 1e3)),
    ];
  }

  /** Panels of the chosen joint. */
  private jointPanels(): Panel[] {
    const joint = Number(this.jointMenu.value || 0);
    const unit = this.motion.file.robot.dofs[joint]?.unit ?? "rad";
    return [
      figurePanel(this.motion, "Position of", unit, "joint", (t) => column(t.q, 7 + joint)),
      figurePanel(this.motion, "Torque of", unit === "m" ? "N" : "N m", "limit", (t) => column(t.tau, joint)),
    ];
  }

  /** The plots get new data; the rest of the page stays. */
  private changeJoint(): void {
    const shown = this.plots.slice(-2);
    this.jointPanels().forEach((panel, i) => {
      const digits = digitsOf(shown[i].panel);
      shown[i].panel = panel;
      if (this.theme && digits !== digitsOf(panel)) this.draw(shown[i], this.theme);
      else shown[i].plot?.setData(this.dataOf(panel));
    });
    this.nameJoint();
    this.showTime(this.clock.time);
  }

  private nameJoint(): void {
    const [position, torque] = this.plots.slice(-2);
    torque.name.textContent = this.jointMenu.selectedOptions[0]?.text ?? "";
    for (const { unit, panel } of [position, torque]) unit.textContent = ` [${panel.unit}]`;
  }

  private makeBox(panel: Panel): Shown {
    const box = make("section", "gw-plot"), title = make("h3", "", `${panel.title} `);
    const name = make("span"), unit = make("small", "", ` [${panel.unit}]`);
    title.append(name, unit);
    box.append(title);
    return { panel, box, name, unit, plot: null, cursor: make("div", "gw-now") };
  }

  /** The new plot is added before the old one is removed, so that the page does not scroll. */
  private draw(shown: Shown, theme: Theme): void {
    const old = shown.plot;
    const plot = new uPlot(this.options(shown, theme), this.dataOf(shown.panel), shown.box);
    plot.over.append(shown.cursor);
    this.seekBy(plot);
    shown.plot = plot;
    old?.destroy();
  }

  private dataOf(panel: Panel): uPlot.AlignedData {
    return [this.time, ...panel.lines.map(({ data }) => data)];
  }

  private options({ panel, box }: Shown, theme: Theme): uPlot.Options {
    const digits = digitsOf(panel);
    return {
      width: Math.max(box.clientWidth, 200),
      height: kPlotHeight,
      cursor: { sync: { key: "gaitwright" }, drag: { setScale: false, x: false, y: false }, y: false },
      legend: { live: true, markers: { dash: (_, i) => (panel.lines[i - 1]?.dash?.length ? "dashed" : "solid") } },
      scales: { x: { time: false } },
      axes: [plotAxis(theme, 28), plotAxis(theme, 54)],
      bands: panel.lines.flatMap((l, i) => (l.band ? [{ series: [i + 1, i] as [number, number], fill: theme.ink.support + "44" }] : [])),
      series: [
        { label: "time [s]", value: (_, v) => (v == null ? "" : v.toFixed(3)) },
        ...panel.lines.map((l): uPlot.Series => ({
          label: l.label,
          stroke: l.colour(theme) + (l.planned ? "99" : ""),
          width: l.width ?? (l.planned ? 3 : 1.25),
          dash: l.dash,
          points: { show: false },
          spanGaps: false,
          value: (_, v) => (v == null ? "\u2013" : rounded(v, digits)),
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

  /** At a time outside this motion there is no cursor. */
  private showTime(t: number): void {
    const within = t >= this.time[0] && t <= this.time[this.time.length - 1];
    for (const { plot, cursor } of this.plots) {
      if (!plot) continue;
      cursor.hidden = !within;
      if (within) cursor.style.transform = `translateX(${plot.valToPos(t, "x")}px)`;
    }
  }

  private fit(): void {
    for (const { plot, box } of this.plots) {
      const width = box.clientWidth;
      if (plot && width > 0 && width !== plot.width) plot.setSize({ width, height: kPlotHeight });
    }
    this.showTime(this.clock.time);
  }
}
