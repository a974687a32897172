// SPDX-License-Identifier: BSD-3-Clause
// Every element with `data-scene="ID"` becomes a viewer of the scene in the script element with that id. Every element
// with `data-live="PATH"` becomes the page of a live robot at the WebSocket of that path.
import "uplot/dist/uPlot.min.css";
import "./viewer.css";
import "./live/live.css";
import { LivePage } from "./live/live_page";
import type { SceneFile } from "./scene";
import { Viewer } from "./viewer";

declare global {
  interface Window {
    /** The viewers and live pages of the page, in document order: for scripts that make pictures, and for tests. */
    gaitwright: { viewers: Viewer[]; live: LivePage[]; opened_ms: number };
  }
}

function sceneOf(id: string): SceneFile {
  const scene = JSON.parse(document.getElementById(id)?.textContent ?? "null") as SceneFile | null;
  if (scene?.format !== "gaitwright-scene" || scene.schema !== 1) throw new Error(`element '${id}' does not contain a scene`);
  return scene;
}

function start(): void {
  const viewers: Viewer[] = [];
  for (const element of document.querySelectorAll<HTMLElement>("[data-scene]")) {
    viewers.push(new Viewer(element, sceneOf(element.dataset.scene ?? "")));
  }
  const live = Array.from(document.querySelectorAll<HTMLElement>("[data-live]"), (element) => new LivePage(element));
  window.gaitwright = { viewers, live, opened_ms: performance.now() };
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
