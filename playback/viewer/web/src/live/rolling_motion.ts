// SPDX-License-Identifier: BSD-3-Clause
import { kMostCorners, type Motion, type MotionFile, type RobotFile, type Table, type TerrainFile, type Track } from "../scene";
import type { Balance, Frame, Numbers } from "./messages";

/** One second at 60 pictures per second, plus the current one. */
const kRows = 61;
const kWindow_s = 1.0;

function emptyTable(columns: number, rows = kRows): Table {
  return { columns, rows, values: new Float32Array(columns * rows).fill(Number.NaN) };
}

function emptyTrack(robot: RobotFile): Track {
  const feet = robot.feet.length;
  return {
    q: emptyTable(7 + robot.dofs.length),
    tau: emptyTable(robot.dofs.length),
    com: emptyTable(3),
    dcm: emptyTable(3),
    zmp: emptyTable(3),
    margin: emptyTable(1),
    foot: emptyTable(3 * feet),
    force: emptyTable(3 * feet),
    footHeight: emptyTable(feet),
    contact: { columns: feet, rows: kRows, values: new Uint8Array(feet * kRows) },
    supportFirst: { columns: 1, rows: kRows + 1, values: new Uint32Array(kRows + 1) },
    support: emptyTable(3, kMostCorners),
  };
}

/** Writes numbers to a row from a column on; NaN for missing numbers. */
function put(table: Table, row: number, numbers: Numbers | null | undefined, from = 0, count = table.columns): void {
  for (let i = 0; i < count; ++i) table.values[row * table.columns + from + i] = numbers?.[i] ?? Number.NaN;
}

function putBalance(track: Track, row: number, balance: Balance | null): void {
  put(track.com, row, balance?.com);
  put(track.dcm, row, balance?.dcm);
  put(track.zmp, row, balance?.zmp);
  put(track.margin, row, balance ? [balance.margin_m] : null);
  const corners = Math.min(balance?.support.length ?? 0, kMostCorners);
  for (let i = 0; i < corners; ++i) put(track.support, i, balance?.support[i]);
  // All corners belong to the last row.
  track.supportFirst.values[row + 1] = corners;
}

/** The last second of a moving robot, as a motion whose last row is the present. */
export class RollingMotion {
  readonly motion: Motion;
  readonly now = kRows - 1;
  private readonly planned: Track;
  private readonly measured: Track;
  /** Times of the rows; those of the motion are relative to now. */
  private readonly times: Float64Array;
  private readonly shifted: Table[];

  constructor(robot: RobotFile, terrain: TerrainFile, first: Frame) {
    this.planned = emptyTrack(robot);
    this.measured = emptyTrack(robot);
    this.shifted = [this.planned, this.measured].flatMap((t) => [t.q, t.tau, t.com, t.dcm, t.zmp, t.margin, t.foot, t.force, t.contact]);
    this.times = new Float64Array(kRows).fill(Number.NEGATIVE_INFINITY);
    const time = Float64Array.from(this.times, (_, i) => (i - this.now) / this.now);
    const file: MotionFile = {
      title: robot.name, verdict: null, robot, terrain, planned: null, measured: null, ghost: null, footholds: [], swings: [], marks: [],
      time_s: { columns: 1 },
    };
    this.motion = { file, time, planned: this.planned, measured: this.measured, ghost: this.planned.q };
    for (let row = 0; row < kRows; ++row) put(this.measured.q, row, first.q);
    this.push(first);
  }

  /**
   * Adds the newest frame. If time has not advanced, it replaces the last one; if time jumps, the earlier ones are
   * erased.
   */
  push(frame: Frame): void {
    const last = this.times[this.now];
    if (frame.t < last || frame.t > last + kWindow_s) this.forget();
    if (frame.t !== last) this.shift();
    this.times[this.now] = frame.t;
    put(this.planned.q, this.now, frame.ghost);
    put(this.measured.q, this.now, frame.q);
    put(this.measured.tau, this.now, frame.tau);
    putBalance(this.planned, this.now, frame.planned);
    putBalance(this.measured, this.now, frame.measured);
    frame.feet.forEach((foot, i) => {
      put(this.measured.foot, this.now, foot.p, 3 * i, 3);
      put(this.measured.force, this.now, foot.f, 3 * i, 3);
      this.measured.contact.values[this.now * frame.feet.length + i] = foot.touching ? 1 : 0;
    });
    for (let row = 0; this.times[row] < frame.t - kWindow_s; ++row) this.erase(row);
  }

  private shift(): void {
    this.times.copyWithin(0, 1);
    for (const table of this.shifted) table.values.copyWithin(0, table.columns);
  }

  /** Erases all earlier rows. */
  forget(): void {
    for (let row = 0; row < this.now; ++row) this.erase(row);
    this.times.fill(Number.NEGATIVE_INFINITY);
  }

  /** Erases the values that are drawn as trails. */
  private erase(row: number): void {
    for (const track of [this.planned, this.measured]) for (const table of [track.com, track.dcm, track.zmp]) put(table, row, null);
  }
}
