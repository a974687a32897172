// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import type { Theme } from "./colours";
import { standStill } from "./palette";
import type { PoseRow, RobotFile, ShapeFile } from "./scene";
import { shapesOf } from "./shapes";

export function setPose(object: THREE.Object3D, pose: PoseRow): void {
  object.position.set(pose[0], pose[1], pose[2]);
  object.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
}

type Part = "trunk" | "limb" | "limbAlternate" | "sole";

/** A robot in the scene, moved by its q. */
export class RobotView {
  readonly root = new THREE.Group();
  private readonly bodies: THREE.Group[] = [];
  private readonly axes: THREE.Vector3[];
  private readonly rest: { p: THREE.Vector3; R: THREE.Quaternion }[];
  private readonly materials: { material: THREE.MeshStandardMaterial; part: Part }[] = [];
  private readonly turn = new THREE.Quaternion();
  private readonly shift = new THREE.Vector3();

  constructor(
    readonly robot: RobotFile,
    private readonly ghost: boolean,
  ) {
    for (const name of robot.bodies) {
      const body = new THREE.Group();
      body.name = name;
      this.bodies.push(body);
    }
    this.root.add(this.bodies[0]);
    robot.joints.forEach((joint, i) => this.bodies[joint.parent_body].add(this.bodies[i + 1]));
    this.axes = robot.joints.map((joint) => new THREE.Vector3().fromArray(joint.axis));
    this.rest = robot.joints.map((joint) => ({
      p: new THREE.Vector3().fromArray(joint.pose),
      R: new THREE.Quaternion().fromArray(joint.pose, 3),
    }));
    const depths = this.depths();
    const feet = new Set(robot.feet.map((foot) => foot.body));
    const geometries = shapesOf(robot);
    robot.shapes.forEach((shape, i) => {
      const limb = depths[shape.body] % 2 === 1 ? "limb" : "limbAlternate";
      const part = shape.body === 0 ? "trunk" : feet.has(shape.body) && shape.type === "sphere" ? "sole" : limb;
      this.addShape(shape, geometries[i], part);
    });
  }

  /** Moves base and joints to a configuration q: position, quaternion x y z w, joints. */
  pose(q: ArrayLike<number>): void {
    this.bodies[0].position.set(q[0], q[1], q[2]);
    this.bodies[0].quaternion.set(q[3], q[4], q[5], q[6]).normalize();
    this.robot.joints.forEach((joint, i) => {
      const position = joint.multiplier * q[7 + joint.dof] + joint.offset;
      const body = this.bodies[i + 1];
      const rest = this.rest[i];
      if (joint.type === "prismatic") {
        body.quaternion.copy(rest.R);
        body.position.copy(rest.p).add(this.shift.copy(this.axes[i]).multiplyScalar(position).applyQuaternion(rest.R));
      } else {
        body.position.copy(rest.p);
        body.quaternion.copy(rest.R).multiply(this.turn.setFromAxisAngle(this.axes[i], position));
      }
    });
  }

  /** Origin of a body's frame in W. */
  bodyPosition(body: number): THREE.Vector3 {
    return this.bodies[body].getWorldPosition(new THREE.Vector3());
  }

  /** First hit of a ray on the robot, if any. */
  hit(ray: THREE.Raycaster): { body: number; p_W: THREE.Vector3 } | null {
    const [first] = ray.intersectObject(this.root);
    return first ? { body: this.bodies.indexOf(first.object.parent as THREE.Group), p_W: first.point } : null;
  }

  /** Converts a point from W to a body's frame. */
  toBody(body: number, p_W: THREE.Vector3): THREE.Vector3 {
    return this.bodies[body].worldToLocal(p_W.clone());
  }

  /** Converts a point from a body's frame to W. */
  fromBody(body: number, p_Body: THREE.Vector3): THREE.Vector3 {
    return this.bodies[body].localToWorld(p_Body.clone());
  }

  paint(theme: Theme): void {
    for (const { material, part } of this.materials) {
      material.color.set(this.ghost ? theme.ink.com : theme[part]);
    }
  }

  private depths(): number[] {
    const depths = [0];
    this.robot.joints.forEach((joint, i) => {
      depths[i + 1] = depths[joint.parent_body] + 1;
    });
    return depths;
  }

  private addShape(shape: ShapeFile, geometry: THREE.BufferGeometry, part: Part): void {
    const material = new THREE.MeshStandardMaterial({
      roughness: 0.75,
      metalness: 0.05,
      transparent: this.ghost,
      opacity: this.ghost ? 0.28 : 1,
      depthWrite: !this.ghost,
      // Where robot and ghost coincide, the robot is visible.
      polygonOffset: this.ghost,
      polygonOffsetFactor: 4,
      polygonOffsetUnits: 16,
    });
    this.materials.push({ material, part });
    const mesh = new THREE.Mesh(geometry, material);
    setPose(mesh, shape.pose);
    mesh.castShadow = !this.ghost;
    mesh.receiveShadow = !this.ghost;
    this.bodies[shape.body].add(standStill(mesh));
  }
}
