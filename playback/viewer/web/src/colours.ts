// SPDX-License-Identifier: BSD-3-Clause

/** What a colour stands for; the same as in the report's plots. Told apart by people who are colour-blind (Okabe and Ito). */
export const kInks = ["zmp", "com", "dcm", "foot", "joint", "limit", "support", "bad", "muted", "pull"] as const;
export type Ink = (typeof kInks)[number];

export interface Theme {
  dark: boolean;
  ink: Record<Ink, string>;
  /** Of words, where what is drawn is too pale for them. */
  words: Partial<Record<Ink, string>>;
  /** Of each foot's line, with three times the paper's contrast at least. */
  feet: string[];
  paper: string;
  text: string;
  soft: string;
  rule: string;
  sky: string;
  ground: string;
  groundLine: string;
  block: string;
  obstacle: string;
  trunk: string;
  limb: string;
  limbAlternate: string;
  sole: string;
}

const kLight: Theme = {
  dark: false,
  ink: {
    zmp: "#d55e00", com: "#0072b2", dcm: "#b0568c", foot: "#009e73", joint: "#0072b2",
    limit: "#8a4b00", support: "#7a9ab0", bad: "#c2185b", muted: "#6b7580", pull: "#1f2730",
  },
  words: { zmp: "#b85000", foot: "#007a59", support: "#4f7288", muted: "#56616d" },
  feet: ["#0072b2", "#d55e00", "#009e73", "#b0568c", "#8a4b00", "#2f97cc", "#6b7580", "#c2185b"],
  paper: "#ffffff", text: "#1f2730", soft: "#56616d", rule: "#e4e8ec",
  sky: "#eef2f5", ground: "#dfe5ea", groundLine: "#aeb9c3", block: "#c9d3db", obstacle: "#b7a58f",
  trunk: "#f7f9fa", limb: "#8c9aa8", limbAlternate: "#aab6c1", sole: "#3b4650",
};

const kDark: Theme = {
  dark: true,
  ink: {
    zmp: "#ff8c42", com: "#5ab4f0", dcm: "#e39ac4", foot: "#2fd0a2", joint: "#5ab4f0",
    limit: "#e6a94a", support: "#6f8fa8", bad: "#ff6f9f", muted: "#9aa5b1", pull: "#ffffff",
  },
  words: { support: "#8fb0c8", muted: "#a3adb8" },
  feet: ["#5ab4f0", "#ff8c42", "#2fd0a2", "#e39ac4", "#b0803a", "#a5dcff", "#9aa5b1", "#ff6f9f"],
  paper: "#14181d", text: "#dfe5ec", soft: "#a3adb8", rule: "#2c343d",
  sky: "#171c22", ground: "#222a32", groundLine: "#3d4955", block: "#2e3842", obstacle: "#5b5145",
  trunk: "#c3ccd6", limb: "#6d7b89", limbAlternate: "#8795a3", sole: "#2b333b",
};

export function themeOf(dark: boolean): Theme {
  return dark ? kDark : kLight;
}

/** Feet differ by colour and by dash, so that neither is needed alone; in pixels, on and off. */
export const kFootDashes = [[], [7, 3], [2, 3], [9, 3, 2, 3], [4, 4], [12, 4], [2, 2, 6, 2], [9, 2, 2, 2, 2, 2]];

/** The colour of words, and the name by which style sheets have it. */
export function wordColour(theme: Theme, ink: Ink): string {
  return theme.words[ink] ?? theme.ink[ink];
}

export function inkVariable(ink: Ink): string {
  return `--gw-ink-${ink}`;
}
