// SPDX-License-Identifier: BSD-3-Clause
import { inkVariable, kInks, themeOf, wordColour, type Theme } from "./colours";
import { button, make, tickBox } from "./elements";
import { kOverlayInk, type Overlay } from "./overlays";
import type { Stage, View } from "./stage";

const kViewKeys: Record<string, View> = { "1": "corner", "2": "side", "3": "front", "4": "top" };

/** Steps of the camera keys [rad], around and down, and the factor on its distance. */
const kTurn = Math.PI / 24;
const kNearer = 0.9;
const kOrbitKeys: Record<string, [number, number, number]> = {
  a: [-kTurn, 0, 1],
  d: [kTurn, 0, 1],
  w: [0, -kTurn, 1],
  s: [0, kTurn, 1],
  e: [0, 0, kNearer],
  q: [0, 0, 1 / kNearer],
};

/** The keys of this file, for the help line. */
export const kLooksHelp = "1 2 3 4 views \u00b7 A D W S turn \u00b7 E Q nearer, farther \u00b7 F follow \u00b7 G ghost \u00b7 T light or dark \u00b7 drag turns, wheel zooms, right drag shifts";

/** How a page shows its stages: camera, overlays, light or dark; by button, check box and key. */
export class Looks {
  /** Buttons for cameras and theme, for a bar. */
  readonly controls: HTMLElement[];
  readonly legend = make("div", "gw-legend");
  private readonly follow = tickBox("follow");
  private readonly overlayBoxes = new Map<Overlay, HTMLInputElement>();
  private dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  /** Whether light or dark was chosen: then the system's theme is not followed any more. */
  private chosen = false;

  /**
   * @param root  gets `data-theme`, and the theme's colours as variables.
   * @param stages  of the page; for stages that are added later, call `apply`.
   * @param overlays  with their names in the legend.
   * @param onPaint  called when the colours change.
   */
  constructor(
    private readonly root: HTMLElement,
    private readonly stages: readonly Stage[],
    overlays: readonly [Overlay, string][],
    private readonly onPaint: (theme: Theme) => void,
  ) {
    const views = make("span", "gw-group");
    for (const [key, view] of Object.entries(kViewKeys)) views.append(button(view, `camera view (${key})`, () => this.look(view)));
    this.follow.label.title = "the camera follows the robot (F)";
    this.follow.box.addEventListener("change", () => this.setFollow(this.follow.box.checked));
    this.controls = [views, this.follow.label, button("\u25d0", "light or dark (T)", () => this.setDark(!this.dark))];
    for (const [overlay, name] of overlays) this.addToLegend(overlay, name);
    this.legend.append(make("span", "gw-note", "rings and broad pale lines: planned; filled and thin lines: measured"));
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", (event) => this.goWithSystem(event.matches));
  }

  get theme(): Theme {
    return themeOf(this.dark);
  }

  look(view: View): void {
    for (const stage of this.stages) stage.look(view);
  }

  setDark(dark: boolean): void {
    this.chosen = true;
    this.dark = dark;
    this.paint();
  }

  setOverlay(overlay: Overlay, visible: boolean): void {
    const box = this.overlayBoxes.get(overlay);
    if (box) box.checked = visible;
    for (const stage of this.stages) stage.setVisible(overlay, visible);
  }

  setFollow(follow: boolean): void {
    this.follow.box.checked = follow;
    for (const stage of this.stages) stage.follow = follow;
  }

  paint(): void {
    const { theme } = this;
    this.root.dataset.theme = this.dark ? "dark" : "light";
    const variables = { "--gw-paper": theme.paper, "--gw-ink": theme.text, "--gw-soft": theme.soft };
    for (const [name, colour] of Object.entries(variables)) this.root.style.setProperty(name, colour);
    for (const ink of kInks) this.root.style.setProperty(inkVariable(ink), wordColour(theme, ink));
    for (const stage of this.stages) stage.paint(theme);
    this.onPaint(theme);
  }

  /** Applies the present choices to new stages. */
  apply(): void {
    for (const [overlay, box] of this.overlayBoxes) this.setOverlay(overlay, box.checked);
    this.setFollow(this.follow.box.checked);
    this.paint();
  }

  /** Handles a key, if it belongs to this file. */
  press(key: string): boolean {
    const view = kViewKeys[key], orbit = kOrbitKeys[key.toLowerCase()];
    if (view) this.look(view);
    else if (orbit) for (const stage of this.stages) stage.orbit(...orbit);
    else if (key === "f" || key === "F") this.setFollow(!this.follow.box.checked);
    else if (key === "g" || key === "G") this.setOverlay("ghost", !this.overlayBoxes.get("ghost")?.checked);
    else if (key === "t" || key === "T") this.setDark(!this.dark);
    else return false;
    return true;
  }

  private goWithSystem(dark: boolean): void {
    if (this.chosen) return;
    this.dark = dark;
    this.paint();
  }

  private addToLegend(overlay: Overlay, name: string): void {
    const { label, box } = tickBox(name);
    label.style.color = `var(${inkVariable(kOverlayInk[overlay])})`;
    box.addEventListener("change", () => this.setOverlay(overlay, box.checked));
    this.overlayBoxes.set(overlay, box);
    this.legend.append(label);
  }
}
