// SPDX-License-Identifier: BSD-3-Clause
import type { Theme } from "./colours";
import { FrameRate } from "./frame_rate";
import { Looks } from "./looks";
import { kOverlayNames, type Overlay } from "./overlays";
import type { Stage, View } from "./stage";

/** A page with stages: the interface for scripts, and the loop of its pictures. */
export abstract class ShownPage {
  readonly stages: Stage[] = [];
  protected readonly looks: Looks;
  private readonly frameRate = new FrameRate();
  private last_ms = 0;

  /**
   * @param onPaint  called when the colours change.
   * @param names  of the overlays in the legend.
   */
  protected constructor(
    root: HTMLElement,
    overlays: readonly Overlay[],
    onPaint: (theme: Theme) => void,
    names: Readonly<Record<Overlay, string>> = kOverlayNames,
  ) {
    root.classList.add("gw-viewer");
    this.looks = new Looks(root, this.stages, overlays.map((overlay) => [overlay, names[overlay]]), onPaint);
  }

  look(view: View): void {
    this.looks.look(view);
  }

  setDark(dark: boolean): void {
    this.looks.setDark(dark);
  }

  setOverlay(overlay: Overlay, visible: boolean): void {
    this.looks.setOverlay(overlay, visible);
  }

  /** Recent pictures per second, and the time that one picture takes. */
  rate(): { frames_per_s: number; calls: number; triangles: number } {
    return { frames_per_s: this.frameRate.perSecond(), ...(this.stages[0]?.cost() ?? { calls: 0, triangles: 0 }) };
  }

  /** Advances by the seconds since the last picture. @return whether anything was drawn in 3D. */
  protected abstract step(now_ms: number, seconds: number): boolean;

  protected begin(): void {
    requestAnimationFrame((now_ms) => {
      const seconds = this.last_ms > 0 ? (now_ms - this.last_ms) / 1000 : 0;
      this.last_ms = now_ms;
      if (this.step(now_ms, seconds)) this.frameRate.note(now_ms);
      this.begin();
    });
  }
}
