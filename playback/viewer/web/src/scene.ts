// SPDX-License-Identifier: BSD-3-Clause
// The data of a page, as the program writes them (docs/viewer.md): plain values, SI units, world z up.

/** Rows of numbers, one after the other: `columns` per row; base64 of little-endian values. */
export interface PackedColumns {
  columns: number;
  f32?: string;
  u8?: string;
  u32?: string;
}

/** x, y, z, then the quaternion x, y, z, w. */
export type PoseRow = [number, number, number, number, number, number, number];

export interface ShapeFile {
  body: number;
  type: "box" | "cylinder" | "sphere" | "capsule" | "hull" | "mesh";
  pose: PoseRow;
  /** box: edges; cylinder, capsule: radius, length; sphere: radius; mesh: scale. */
  size_m: number[];
  /** hull: its points; mesh: its index in `meshes`. */
  points_m?: PackedColumns;
  mesh?: number;
}

export interface JointFile {
  name: string;
  type: "revolute" | "continuous" | "prismatic";
  parent_body: number;
  pose: PoseRow;
  axis: [number, number, number];
  /** Position = multiplier * q[7 + dof] + offset. */
  dof: number;
  multiplier: number;
  offset: number;
}

export interface DofFile {
  name: string;
  unit: "rad" | "m";
  lower: number | null;
  upper: number | null;
  effort_limit: number | null;
}

export interface RobotFile {
  name: string;
  weight_n: number;
  leg_length_m: number;
  /** Joint i carries body i + 1; body 0 is the floating base. */
  bodies: string[];
  joints: JointFile[];
  dofs: DofFile[];
  feet: { name: string; body: number }[];
  shapes: ShapeFile[];
  meshes: { vertices_m: PackedColumns; triangles: PackedColumns }[];
}

export interface TerrainFile {
  name: string;
  patches: { name: string; pose: PoseRow; outline_m: [number, number][] }[];
  height_fields: {
    name: string;
    origin_m: [number, number];
    resolution_m: number;
    columns: number;
    rows: number;
    heights_m: PackedColumns;
  }[];
  obstacles: {
    name: string;
    type: "box" | "cylinder" | "hull";
    pose: PoseRow;
    size_m: number[];
    points_m?: PackedColumns;
  }[];
}

/** A motion by its samples; planned and measured motions have the same columns. Missing numbers are NaN. */
export interface TrackFile {
  q: PackedColumns;
  tau: PackedColumns;
  com_m: PackedColumns;
  dcm_m: PackedColumns;
  zmp_m: PackedColumns;
  zmp_margin_m: PackedColumns;
  /** Three numbers per foot: the origin of its contact frame, and the force on it. */
  foot_m: PackedColumns;
  force_n: PackedColumns;
  /** Per foot: height of its lowest point above the ground. */
  foot_height_m: PackedColumns;
  /** Per foot: whether it carries load. */
  contact: PackedColumns;
  /** Corners of the support polygon of sample k: rows support_first[k] to support_first[k + 1] of support_m. */
  support_first: PackedColumns;
  support_m: PackedColumns;
}

export interface MarkFile {
  at_s: number;
  kind: "fall" | "part" | "worst" | "contact";
  text: string;
}

export interface MotionFile {
  title: string;
  verdict: { pass: boolean; score: number; reason: string } | null;
  robot: RobotFile;
  terrain: TerrainFile;
  time_s: PackedColumns;
  planned: TrackFile | null;
  measured: TrackFile | null;
  /** Another motion of the same robot; without it, a log has its plan as a ghost. */
  ghost: { title: string; q: PackedColumns } | null;
  footholds: { foot: number; touchdown_s: number; liftoff_s: number; outline_m: [number, number, number][] }[];
  swings: { foot: number; start_s: number; end_s: number; points_m: PackedColumns }[];
  marks: MarkFile[];
}

export interface SceneFile {
  format: "gaitwright-scene";
  schema: 1;
  motions: MotionFile[];
}

/** A table of numbers, row after row. */
export interface Table {
  columns: number;
  rows: number;
  values: Float32Array | Uint8Array | Uint32Array;
}

export interface Track {
  q: Table;
  tau: Table;
  com: Table;
  dcm: Table;
  zmp: Table;
  margin: Table;
  foot: Table;
  force: Table;
  footHeight: Table;
  contact: Table;
  supportFirst: Table;
  support: Table;
}

/** A motion ready for display. */
export interface Motion {
  file: MotionFile;
  /** One per sample. */
  time: Float64Array;
  planned: Track | null;
  measured: Track | null;
  /** Postures of the translucent robot, one row per sample; NaN where it is not shown. */
  ghost: Table | null;
}

/** Maximum number of corners of a support polygon. */
export const kMostCorners = 64;

/** Times that differ by less are equal: the distance of samples is much larger. */
const kSameTime_s = 1e-5;

function bytesOf(base64: string): ArrayBuffer {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

export function unpack(packed: PackedColumns): Table {
  let values: Table["values"];
  if (packed.f32 !== undefined) values = new Float32Array(bytesOf(packed.f32));
  else if (packed.u32 !== undefined) values = new Uint32Array(bytesOf(packed.u32));
  else values = new Uint8Array(bytesOf(packed.u8 ?? ""));
  const columns = packed.columns;
  return { columns, rows: columns > 0 ? values.length / columns : 0, values };
}

function unpackTrack(file: TrackFile): Track {
  return {
    q: unpack(file.q),
    tau: unpack(file.tau),
    com: unpack(file.com_m),
    dcm: unpack(file.dcm_m),
    zmp: unpack(file.zmp_m),
    margin: unpack(file.zmp_margin_m),
    foot: unpack(file.foot_m),
    force: unpack(file.force_n),
    footHeight: unpack(file.foot_height_m),
    contact: unpack(file.contact),
    supportFirst: unpack(file.support_first),
    support: unpack(file.support_m),
  };
}

/** Restores packed times: 32 bits hold seven digits, and further digits are rounding errors. */
function unpackTimes(packed: PackedColumns): Float64Array {
  return Float64Array.from(unpack(packed).values, (t) => Number(t.toPrecision(7)));
}

/** Extracts the columns of a file and releases their texts. */
export function unpackMotion(file: MotionFile): Motion {
  const planned = file.planned && unpackTrack(file.planned);
  const measured = file.measured && unpackTrack(file.measured);
  const ghost = file.ghost ? unpack(file.ghost.q) : measured && planned ? planned.q : null;
  const motion = { file, time: unpackTimes(file.time_s), planned, measured, ghost };
  file.time_s = { columns: 1 };
  file.planned = file.measured = null;
  if (file.ghost) file.ghost.q = { columns: 1 };
  return motion;
}

/** Motions of one robot share it, so that its shapes are made only once. */
export function unpackScene(scene: SceneFile): Motion[] {
  const robots = new Map<string, RobotFile>();
  for (const motion of scene.motions) {
    const key = scene.motions.length > 1 ? JSON.stringify(motion.robot) : "";
    motion.robot = robots.get(key) ?? motion.robot;
    robots.set(key, motion.robot);
  }
  return scene.motions.map(unpackMotion);
}

/** Texts that distinguish several motions; empty for a single motion. */
export function namesOf(motions: readonly Motion[]): string[] {
  const titles = motions.map((motion) => motion.file.title);
  if (titles.length < 2) return titles.map(() => "");
  return titles.map((title, i) => (titles.indexOf(title) === titles.lastIndexOf(title) ? title : `${title} (${i + 1})`));
}

/** The measured motion if there is one, else the planned one. */
export function mainTrack(motion: Motion): Track {
  const track = motion.measured ?? motion.planned;
  if (!track) throw new Error("the motion has neither a plan nor a log");
  return track;
}

/** Row `k` of a table as a view of its numbers. */
export function row(table: Table, k: number): Float32Array {
  return (table.values as Float32Array).subarray(k * table.columns, (k + 1) * table.columns);
}

/** Index of the last sample at or before a time, with a tolerance for rounding; 0 before the first. */
export function sampleAt(time: Float64Array, t: number): number {
  const until = t + kSameTime_s;
  let low = 0;
  let high = time.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (time[middle] <= until) low = middle;
    else high = middle - 1;
  }
  return low;
}
