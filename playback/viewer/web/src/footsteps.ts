// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { standStill, type Palette } from "./palette";
import type { MotionFile } from "./scene";

type Foothold = MotionFile["footholds"][number];

/** An outline as pairs of points, one pair for each side. */
function sides(outline: Foothold["outline_m"], lift: number): number[] {
  const corner = (i: number) => {
    const [x, y, z] = outline[i % outline.length];
    return [x, y, z + lift];
  };
  return outline.flatMap((_, i) => [...corner(i), ...corner(i + 1)]);
}

/** Outlines of all soles; the outlines of standing feet are drawn again on top. */
export class Footsteps {
  readonly root = new THREE.Group();
  private readonly outlines: Float32Array[];
  private readonly present = new THREE.BufferGeometry();
  private shown: number[] = [];

  constructor(
    private readonly footholds: Foothold[],
    palette: Palette,
    lift: number,
  ) {
    this.outlines = footholds.map((foothold) => Float32Array.from(sides(foothold.outline_m, lift)));
    const all = new THREE.BufferGeometry();
    all.setAttribute("position", new THREE.Float32BufferAttribute(this.outlines.flatMap((outline) => [...outline]), 3));
    const material = palette.line("foot");
    material.transparent = true;  // draws it after the others
    const now = new THREE.LineSegments(this.present, material);
    now.renderOrder = 1;
    now.frustumCulled = false;
    this.root.add(standStill(new THREE.LineSegments(all, palette.line("muted", 0.55))), standStill(now));
  }

  show(t: number): void {
    const present: number[] = [];
    this.footholds.forEach(({ touchdown_s, liftoff_s }, i) => {
      if (t >= touchdown_s && t < liftoff_s) present.push(i);
    });
    if (present.length === this.shown.length && present.every((number, i) => number === this.shown[i])) return;
    this.shown = present;
    this.upload(present);
  }

  /** Reserves room for the largest number of feet that stand at once. */
  private upload(present: number[]): void {
    const size = present.reduce((sum, number) => sum + this.outlines[number].length, 0);
    let position = this.present.attributes.position as THREE.BufferAttribute | undefined;
    if (!position || position.array.length < size) {
      this.present.dispose();
      position = new THREE.BufferAttribute(new Float32Array(size), 3).setUsage(THREE.DynamicDrawUsage);
      this.present.setAttribute("position", position);
    }
    let at = 0;
    for (const number of present) {
      position.array.set(this.outlines[number], at);
      at += this.outlines[number].length;
    }
    position.needsUpdate = true;
    this.present.setDrawRange(0, size / 3);
  }
}
