// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { ConvexGeometry } from "three/addons/geometries/ConvexGeometry.js";
import type { Theme } from "./colours";
import { unpack, type PackedColumns, type PoseRow, type RobotFile, type ShapeFile } from "./scene";

export function setPose(object: THREE.Object3D, pose: PoseRow): void {
  object.position.set(pose[0], pose[1], pose[2]);
  object.quaternion.set(pose[3], pose[4], pose[5], pose[6]);
}

export function pointsOf(packed: PackedColumns): THREE.Vector3[] {
  const table = unpack(packed);
  const points: THREE.Vector3[] = [];
  for (let i = 0; i < table.rows; ++i) points.push(new THREE.Vector3().fromArray(table.values, 3 * i));
  return points;
}

/** Cylinders and capsules lie along z, in three.js along y. */
function alongZ(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  return geometry.rotateX(Math.PI / 2);
}

function meshGeometry(robot: RobotFile, shape: ShapeFile): THREE.BufferGeometry {
  const mesh = robot.meshes[shape.mesh ?? 0];
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(unpack(mesh.vertices_m).values as Float32Array, 3));
  geometry.setIndex(new THREE.BufferAttribute(unpack(mesh.triangles).values as Uint32Array, 1));
  const flat = geometry.toNonIndexed();
  flat.scale(shape.size_m[0], shape.size_m[1], shape.size_m[2]);
  flat.computeVertexNormals();
  return flat;
}

export function shapeGeometry(
  type: ShapeFile["type"],
  size: number[],
  points: PackedColumns | undefined,
): THREE.BufferGeometry {
  switch (type) {
    case "box":
      return new THREE.BoxGeometry(size[0], size[1], size[2]);
    case "cylinder":
      return alongZ(new THREE.CylinderGeometry(size[0], size[0], size[1], 32));
    case "capsule":
      return alongZ(new THREE.CapsuleGeometry(size[0], size[1], 8, 24));
    case "sphere":
      return new THREE.SphereGeometry(size[0], 24, 16);
    default:
      return points ? new ConvexGeometry(pointsOf(points)) : new THREE.BufferGeometry();
  }
}

/** A robot in the scene, moved by its q. */
export class RobotView {
  readonly root = new THREE.Group();
  private readonly bodies: THREE.Group[] = [];
  private readonly axes: THREE.Vector3[];
  private readonly rest: { p: THREE.Vector3; R: THREE.Quaternion }[];
  private readonly materials: { material: THREE.MeshStandardMaterial; part: "trunk" | "limb" | "limbAlternate" | "sole" }[] = [];
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
    for (const shape of robot.shapes) {
      const part = shape.body === 0 ? "trunk" : feet.has(shape.body) && shape.type === "sphere" ? "sole" : depths[shape.body] % 2 === 1 ? "limb" : "limbAlternate";
      this.addShape(shape, part);
    }
  }

  /** Puts base and joints where a q has them: place, quaternion x y z w, joints. */
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

  /** Where a body's frame is, in W. */
  bodyPosition(body: number): THREE.Vector3 {
    return this.bodies[body].getWorldPosition(new THREE.Vector3());
  }

  /** What of the robot a ray meets first, if anything. */
  hit(ray: THREE.Raycaster): { body: number; p_W: THREE.Vector3 } | null {
    const [first] = ray.intersectObject(this.root);
    return first ? { body: this.bodies.indexOf(first.object.parent as THREE.Group), p_W: first.point } : null;
  }

  /** A point of W in a body's frame. */
  toBody(body: number, p_W: THREE.Vector3): THREE.Vector3 {
    return this.bodies[body].worldToLocal(p_W.clone());
  }

  /** A point of a body's frame in W. */
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

  private addShape(shape: ShapeFile, part: "trunk" | "limb" | "limbAlternate" | "sole"): void {
    const material = new THREE.MeshStandardMaterial({
      roughness: 0.75,
      metalness: 0.05,
      transparent: this.ghost,
      opacity: this.ghost ? 0.28 : 1,
      depthWrite: !this.ghost,
      // Where both are in one place the robot is seen.
      polygonOffset: this.ghost,
      polygonOffsetFactor: 4,
      polygonOffsetUnits: 16,
    });
    this.materials.push({ material, part });
    const geometry = shape.type === "mesh" ? meshGeometry(this.robot, shape) : shapeGeometry(shape.type, shape.size_m, shape.points_m);
    const mesh = new THREE.Mesh(geometry, material);
    setPose(mesh, shape.pose);
    mesh.castShadow = !this.ghost;
    mesh.receiveShadow = !this.ghost;
    this.bodies[shape.body].add(mesh);
  }
}
