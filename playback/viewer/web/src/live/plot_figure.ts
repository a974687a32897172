// SPDX-License-Identifier: BSD-3-Clause
import { inkVariable, type Ink } from "../colours";
import { make } from "../elements";

/** Appearance of marks in titles: a line, a broad pale line, a dashed line, a ring, a filled circle, an area. */
export type Mark = "\u2014" | "\u25ac" | "\u2504" | "\u25cb" | "\u25cf" | "\u25a0";

/** A plot with its title and the meanings of its colours. */
export function plotFigure(title: string, marks: [Mark, Ink, string][], plot: HTMLElement, ...beside: HTMLElement[]): HTMLElement {
  const figure = make("figure", "gw-live-plot");
  const head = make("figcaption");
  head.append(make("b", "", title), ...beside);
  for (const [mark, ink, text] of marks) {
    const words = make("span", "", `${mark} ${text}`);
    words.style.color = `var(${inkVariable(ink)})`;
    head.append(words);
  }
  figure.append(head, plot);
  return figure;
}
