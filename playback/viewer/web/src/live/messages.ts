// SPDX-License-Identifier: BSD-3-Clause
// What a live page is told by the program, and what it says to it (docs/live.md): JSON, SI units, world z up.
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

/** How a pull acts: by its length, and never harder than its most. */
export interface Spring {
  n_per_m: number;
  most_n: number;
}

/** The first message, and again where the robot is another. */
export interface Greeting {
  format: "gaitwright-live";
  schema: 1;
  /** Of one start of the program, and of no other. */
  run: string;
  scene: { robot: RobotFile; terrain: TerrainFile };
  /** Physics engines that the robot can stand in after a reset. */
  engines: string[];
  gaits: string[];
  usual_pace: Pace;
  step_s: number;
  spring: Spring;
  options: Record<string, OptionFile>;
}

export type Mode = "stands" | "walks" | "posed" | "fallen";

/** How a robot is balanced, as planned or as measured. */
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
  /** Where the terrain has been moved to. */
  pose: PoseRow;
}

/** A page that pulls at a point of a body, and how hard. */
export interface PullFile {
  page: number;
  body: number;
  at_m: [number, number, number];
  /** Where its hand took hold, which may walk along. */
  from_m: [number, number, number];
  force_n: [number, number, number];
}

/** How things stand at a moment. */
export interface Frame {
  t: number;
  mode: Mode;
  paused: boolean;
  behind_s: number;
  pace: Pace;
  /** The pace that is being planned. */
  wanted: Pace | null;
  heading_deg: number | null;
  /** The heading that was asked for, until it is reached or given up. */
  wanted_heading_deg: number | null;
  q: Numbers;
  tau: Numbers;
  /** What the joints are told. */
  target: Numbers;
  /** Of joints that follow a position, [N m/rad] and [N m s/rad], or [N/m] and [N s/m]. */
  stiffness: Numbers;
  damping: Numbers;
  ghost: Numbers | null;
  measured: Balance | null;
  planned: Balance | null;
  feet: { p: Numbers; f: Numbers | null; touching: boolean }[];
  /** Of all pages, one each. */
  pulls: PullFile[];
  /** On the base. */
  push_n: [number, number, number] | null;
  ground: Ground;
  /** In the order of the greeting's. */
  options: Numbers;
  /** The latest, by numbers that grow. */
  notes: [number, string][];
}

/** What the program can be asked for. */
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

/** @return whether it could be sent. */
export type Send = (saying: Saying) => boolean;

/** After the greeting a page is told its own number. */
export type Heard = { greeting: Greeting } | { page: number } | { frame: Frame } | { refused: string };

/** @throws for what is no message of this version. */
export function heard(text: string): Heard {
  const message = JSON.parse(text) as Partial<Greeting & Frame & { refused: string; page: number }>;
  if (message.refused !== undefined) return { refused: message.refused };
  if (message.q !== undefined) return { frame: message as Frame };
  if (message.page !== undefined) return { page: message.page };
  if (message.format === "gaitwright-live" && message.schema === 1) return { greeting: message as Greeting };
  throw new Error("the program is of another version than this page: load the page again");
}

export function isWalk(pace: Pace): boolean {
  return pace.gait !== "stand";
}

/** What the robot goes over to, or keeps. */
export function paceAhead(frame: Frame): Pace {
  return frame.wanted ?? frame.pace;
}
