// SPDX-License-Identifier: BSD-3-Clause

/** Meanings of colours; the same as in the report's plots, which document their contrast for colour-blind readers. */
export const kInks = ["zmp", "com", "dcm", "foot", "joint", "limit", "support", "muted", "pull"] as const;
export type Ink = (typeof kInks)[number];

export interface Theme {
  dark: boolean;
  ink: Record<Ink, string>;
  /** Text colours for meanings whose drawing colour is too pale for text. */
  words: Partial<Record<Ink, string>>;
  /** Colours of the feet's lines, each with a contrast to the paper of at least 3. */
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
    zmp: "#da7e1b", com: "#0073e7", dcm: "#791483", foot: "#009558", joint: "#0073e7",
    limit: "#6e2f05", support: "#70bbfd", muted: "#8691a2", pull: "#1f2730",
  },
  words: { zmp: "#9a5200", foot: "#007a47", support: "#2b6a9e", muted: "#56616d" },
  feet: ["#0073e7", "#da7e1b", "#009558", "#791483", "#6e2f05", "#2f97cc", "#8691a2", "#a70064"],
  paper: "#ffffff", text: "#1f2730", soft: "#56616d", rule: "#e4e8ec",
  sky: "#eef2f5", ground: "#dfe5ea", groundLine: "#aeb9c3", block: "#c9d3db", obstacle: "#b7a58f",
  trunk: "#f7f9fa", limb: "#8c9aa8", limbAlternate: "#aab6c1", sole: "#3b4650",
};

const kDark: Theme = {
  dark: true,
  ink: {
    zmp: "#fc7c23", com: "#0592f9", dcm: "#dba0da", foot: "#44d18a", joint: "#0592f9",
    limit: "#f8c068", support: "#005c90", muted: "#6d7072", pull: "#ffffff",
  },
  words: { support: "#8fb0c8", muted: "#a3adb8" },
  feet: ["#0592f9", "#fc7c23", "#44d18a", "#dba0da", "#f8c068", "#f0f032", "#6d7072", "#ed2646"],
  paper: "#14181d", text: "#dfe5ec", soft: "#a3adb8", rule: "#2c343d",
  sky: "#171c22", ground: "#222a32", groundLine: "#3d4955", block: "#2e3842", obstacle: "#5b5145",
  trunk: "#c3ccd6", limb: "#6d7b89", limbAlternate: "#8795a3", sole: "#2b333b",
};

export function themeOf(dark: boolean): Theme {
  return dark ? kDark : kLight;
}

/** Feet differ by colour and by dash pattern, so that either is sufficient; in pixels, on and off. */
export const kFootDashes = [[], [7, 3], [2, 3], [9, 3, 2, 3], [4, 4], [12, 4], [2, 2, 6, 2], [9, 2, 2, 2, 2, 2]];

/** The colour of text for a meaning, and its name in style sheets. */
export function wordColour(theme: Theme, ink: Ink): string {
  return theme.words[ink] ?? theme.ink[ink];
}

export function inkVariable(ink: Ink): string {
  return `--gw-ink-${ink}`;
}
