// SPDX-License-Identifier: BSD-3-Clause
// Messages between a live page and the program (docs/live.md): JSON, SI units, world z up.
import type { PoseRow, RobotFile, TerrainFile } from "../scene";

/** Numbers that are null where they are not finite. */
export type Numbers = (number | null)[];

export interface Pace {
  gait: string;
  speed_m_s: number;
  /** To the left. */
  lateral_speed_m_s: number;
  /** To the left. */
  yaw_rate_rad_s: number;
}

export const kStand: Pace = { gait: "stand", speed_m_s: 0, lateral_speed_m_s: 0, yaw_rate_rad_s: 0 };

/** An option of the controller. */
export interface OptionFile {
  value: number;
  lowest: number | null;
  highest: number | null;
  unit: string;
  meaning: string;
}

/** A pull: proportional to its length, up to a maximum. */
export interface Spring {
  n_per_m: number;
  most_n: number;
}

/** The first message, sent again when the robot changes. */
export interface Greeting {
  format: "gaitwright-live";
  schema: 1;
  /** Identifies one start of the program. */
  run: string;
  scene: { robot: RobotFile; terrain: TerrainFile };
  /** Physics engines available after a reset. */
  engines: string[];
  gaits: string[];
  usual_pace: Pace;
  step_s: number;
  spring: Spring;
  options: Record<string, OptionFile>;
}

export type Mode = "stands" | "walks" | "posed" | "fallen";

/** The balance of a robot, planned or measured. */
export interface Balance {
  com: Numbers;
  dcm: Numbers | null;
  zmp: Numbers | null;
  margin_m: number | null;
  support: Numbers[];
}

export interface Ground {
  engine: string;
  friction: number;
  slope_deg: number;
  slope_direction_deg: number;
  /** Pose to which the terrain has been moved. */
  pose: PoseRow;
}

/** The pull of a page at a point of a body, and its force. */
export interface PullFile {
  page: number;
  body: number;
  at_m: [number, number, number];
  /** Start of the hand's motion; it may move with the robot. */
  from_m: [number, number, number];
  force_n: [number, number, number];
}

/** The state at one time. */
export interface Frame {
  t: number;
  mode: Mode;
  paused: boolean;
  behind_s: number;
  pace: Pace;
  /** The walking command that is being planned. */
  wanted: Pace | null;
  heading_deg: number | null;
  /** The requested heading, until it is reached or given up. */
  wanted_heading_deg: number | null;
  q: Numbers;
  tau: Numbers;
  /** Target positions of the joints. */
  target: Numbers;
  /** Gains of joints that follow a position, [N m/rad] and [N m s/rad], or [N/m] and [N s/m]. */
  stiffness: Numbers;
  damping: Numbers;
  ghost: Numbers | null;
  measured: Balance | null;
  planned: Balance | null;
  feet: { p: Numbers; f: Numbers | null; touching: boolean }[];
  /** Of all pages, one per page. */
  pulls: PullFile[];
  /** Force on the base. */
  push_n: [number, number, number] | null;
  ground: Ground;
  /** In the order of the greeting. */
  options: Numbers;
  /** The latest notes, with increasing numbers. */
  notes: [number, string][];
}

/** Requests to the program. */
export type Saying =
  | ({ do: "pace" } & Pace)
  | { do: "heading"; heading_deg: number }
  | { do: "pull"; body: number; at_m: number[]; by_m: number[]; along: boolean }
  | { do: "push"; force_n: number[]; for_s: number }
  | { do: "let_go" | "stand_up" }
  | { do: "reset"; engine?: string }
  | { do: "clock"; paused?: boolean; steps?: number }
  | { do: "ground"; friction: number; slope_deg: number; slope_direction_deg: number }
  | { do: "options"; options: Record<string, number> }
  | { do: "pose"; q: number[] }
  | { do: "nudge"; dof: number; by: number; for_s: number };

/** @return whether it was sent. */
export type Send = (saying: Saying) => boolean;

/** After the greeting, a page receives its own number. */
export type Heard = { greeting: Greeting } | { page: number } | { frame: Frame } | { refused: string };

/** @throws if it is not a message of this version. */
export function heard(text: string): Heard {
  const message = JSON.parse(text) as Partial<Greeting & Frame & { refused: string; page: number }>;
  if (message.refused !== undefined) return { refused: message.refused };
  if (message.q !== undefined) return { frame: message as Frame };
  if (message.page !== undefined) return { page: message.page };
  if (message.format === "gaitwright-live" && message.schema === 1) return { greeting: message as Greeting };
  throw new Error("the program has another version than this page: reload the page");
}

export function isWalk(pace: Pace): boolean {
  return pace.gait !== "stand";
}

/** The mode that the robot changes to, or keeps. */
export function paceAhead(frame: Frame): Pace {
  return frame.wanted ?? frame.pace;
}
