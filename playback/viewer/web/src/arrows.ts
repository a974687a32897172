// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { seenThrough } from "./palette";

const kUp = new THREE.Vector3(0, 0, 1);

/** Makes arrows of one thickness and colour, which can be seen through the robot. */
export class ArrowMaker {
  private readonly shaft: THREE.BufferGeometry;
  private readonly head: THREE.BufferGeometry;

  /** @param size  of the robot [m]: a head is a tenth of it long. */
  constructor(
    size: number,
    private readonly material: THREE.Material,
  ) {
    this.shaft = new THREE.CylinderGeometry(0.012 * size, 0.012 * size, 1, 12).translate(0, 0.5, 0).rotateX(Math.PI / 2);
    this.head = new THREE.ConeGeometry(0.04 * size, 0.1 * size, 16).translate(0, 0.05 * size, 0).rotateX(Math.PI / 2);
  }

  make(): Arrow {
    return new Arrow(new THREE.Mesh(this.shaft, this.material), new THREE.Mesh(this.head, this.material), this.material);
  }
}

/** A shaft along z, one metre long, and a head at its end. */
export class Arrow {
  readonly root = new THREE.Group();
  private readonly along = new THREE.Vector3();

  constructor(
    private readonly shaft: THREE.Mesh,
    private readonly head: THREE.Mesh,
    material: THREE.Material,
  ) {
    for (const part of [shaft, head]) {
      seenThrough(part, material);
      this.root.add(part);
    }
  }

  /** Points along a vector, its head beyond so much length. */
  show(from: THREE.Vector3, direction: THREE.Vector3, length: number): void {
    this.root.position.copy(from);
    this.root.quaternion.setFromUnitVectors(kUp, this.along.copy(direction).normalize());
    this.shaft.scale.set(1, 1, length);
    this.head.position.set(0, 0, length);
  }
}
