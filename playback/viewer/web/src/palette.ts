// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import type { Ink, Theme } from "./colours";

type Painted = THREE.Material & { color: THREE.Color };

/** Materials by what they stand for, painted anew when the theme changes. */
export class Palette {
  private readonly all: { material: Painted; ink: Ink }[] = [];

  line(ink: Ink, opacity = 1): THREE.LineBasicMaterial {
    return this.keep(new THREE.LineBasicMaterial({ transparent: opacity < 1, opacity }), ink);
  }

  solid(ink: Ink, opacity = 1): THREE.MeshBasicMaterial {
    return this.keep(
      new THREE.MeshBasicMaterial({ transparent: opacity < 1, opacity, depthWrite: opacity === 1, side: THREE.DoubleSide }),
      ink,
    );
  }

  paint(theme: Theme): void {
    for (const { material, ink } of this.all) material.color.set(theme.ink[ink]);
  }

  private keep<M extends Painted>(material: M, ink: Ink): M {
    this.all.push({ material, ink });
    return material;
  }
}

/** Drawn over what is before it: a centre of mass is within a trunk, a ZMP below a sole. */
export function seenThrough(object: THREE.Mesh | THREE.Line, material: THREE.Material): void {
  object.renderOrder = 2;
  material.depthTest = false;
  material.transparent = true;
}
