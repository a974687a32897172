// SPDX-License-Identifier: BSD-3-Clause
import type uPlot from "uplot";
import type { Theme } from "./colours";

/** An axis in the colours of the page. */
export function plotAxis(theme: Theme, size: number): uPlot.Axis {
  return {
    stroke: theme.soft,
    grid: { stroke: theme.rule, width: 1 },
    ticks: { stroke: theme.rule, width: 1 },
    font: "12px system-ui, sans-serif",
    size,
  };
}
