// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { seenThrough } from "./palette";

const kUp = new THREE.Vector3(0, 0, 1);

/** Makes arrows of one thickness and colour, which are visible through the robot. */
export class ArrowMaker {
  private readonly shaft: THREE.BufferGeometry;
  private readonly head: THREE.BufferGeometry;
  private readonly headLength: number;

  /** @param size  of the robot [m]: an arrow head is a tenth of it long. */
  constructor(
    size: number,
    private readonly material: THREE.Material,
  ) {
    this.headLength = 0.1 * size;
    this.shaft = new THREE.CylinderGeometry(0.012 * size, 0.012 * size, 1, 12).translate(0, 0.5, 0).rotateX(Math.PI / 2);
    this.head = new THREE.ConeGeometry(0.04 * size, this.headLength, 16).translate(0, 0.5 * this.headLength, 0).rotateX(Math.PI / 2);
  }

  make(): Arrow {
    return new Arrow(new THREE.Mesh(this.shaft, this.material), new THREE.Mesh(this.head, this.material), this.headLength, this.material);
  }
}

/** A shaft along z, one metre long, and a head at its end. */
export class Arrow {
  readonly root = new THREE.Group();
  private readonly along = new THREE.Vector3();

  constructor(
    private readonly shaft: THREE.Mesh,
    private readonly head: THREE.Mesh,
    private readonly headLength: number,
    material: THREE.Material,
  ) {
    for (const part of [shaft, head]) {
      seenThrough(part, material);
      this.root.add(part);
    }
  }

  /** Sets an arrow along a vector, with this length from end to tip. An arrow shorter than two heads is scaled down. */
  show(from: THREE.Vector3, direction: THREE.Vector3, length: number): void {
    this.root.position.copy(from);
    this.root.quaternion.setFromUnitVectors(kUp, this.along.copy(direction).normalize());
    const scale = Math.min(1, length / (2 * this.headLength));
    const shaft = length - scale * this.headLength;
    this.shaft.scale.set(scale, scale, shaft);
    this.head.scale.setScalar(scale);
    this.head.position.set(0, 0, shaft);
  }
}
