// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import type { Ink, Theme } from "./colours";

type Painted = THREE.Material & { color: THREE.Color };

/** Materials by meaning, coloured again when the theme changes. */
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

  /** Lines of any width in pixels. */
  wide(ink: Ink, width: number, opacity: number): LineMaterial {
    return this.keep(new LineMaterial({ linewidth: width, transparent: true, opacity, depthWrite: false }), ink);
  }

  paint(theme: Theme): void {
    for (const { material, ink } of this.all) material.color.set(theme.ink[ink]);
  }

  private keep<M extends Painted>(material: M, ink: Ink): M {
    this.all.push({ material, ink });
    return material;
  }
}

/** An object that never moves within its parent. */
export function standStill<O extends THREE.Object3D>(object: O): O {
  object.updateMatrix();
  object.matrixAutoUpdate = false;
  return object;
}

/** Drawn on top of nearer objects: a centre of mass is inside a trunk, a ZMP below a sole. */
export function seenThrough(object: THREE.Mesh | THREE.Line, material: THREE.Material): void {
  object.renderOrder = 2;
  material.depthTest = false;
  material.transparent = true;
}
