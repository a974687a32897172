// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { ConvexGeometry } from "three/addons/geometries/ConvexGeometry.js";
import { unpack, type PackedColumns, type RobotFile, type ShapeFile, type Table } from "./scene";

function pointsOf(packed: PackedColumns): THREE.Vector3[] {
  const table = unpack(packed);
  const points: THREE.Vector3[] = [];
  for (let i = 0; i < table.rows; ++i) points.push(new THREE.Vector3().fromArray(table.values, 3 * i));
  return points;
}

/** Cylinders and capsules have their axis along z, in three.js along y. */
function alongZ(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  return geometry.rotateX(Math.PI / 2);
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

/** Triangles of a mesh, corner by corner. A mirroring scale reverses their order, so that outsides stay outside. */
export function meshPositions(vertices: Table, triangles: Table, scale: number[]): Float32Array {
  const corners = triangles.values;
  const mirrored = scale[0] * scale[1] * scale[2] < 0;
  const positions = new Float32Array(3 * corners.length);
  for (let i = 0; i < corners.length; ++i) {
    const of = i % 3, corner = corners[mirrored && of > 0 ? i + (of === 1 ? 1 : -1) : i];
    for (let c = 0; c < 3; ++c) positions[3 * i + c] = scale[c] * vertices.values[3 * corner + c];
  }
  return positions;
}

function meshGeometry(vertices: Table, triangles: Table, scale: number[]): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(meshPositions(vertices, triangles, scale), 3));
  geometry.computeVertexNormals();
  return geometry;
}

const made = new WeakMap<RobotFile, THREE.BufferGeometry[]>();

/** The shapes of a robot, in its order; made once for all viewers. */
export function shapesOf(robot: RobotFile): THREE.BufferGeometry[] {
  const known = made.get(robot);
  if (known) return known;
  const meshes = robot.meshes.map((mesh) => ({ vertices: unpack(mesh.vertices_m), triangles: unpack(mesh.triangles) }));
  const shapes = robot.shapes.map((shape) => {
    if (shape.type !== "mesh") return shapeGeometry(shape.type, shape.size_m, shape.points_m);
    const { vertices, triangles } = meshes[shape.mesh ?? 0];
    return meshGeometry(vertices, triangles, shape.size_m);
  });
  made.set(robot, shapes);
  return shapes;
}
