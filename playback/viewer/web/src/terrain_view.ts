// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import type { Theme } from "./colours";
import { standStill } from "./palette";
import { setPose } from "./robot_view";
import { unpack, type TerrainFile } from "./scene";
import { shapeGeometry } from "./shapes";

const kSolidDepth = 1.0;
const kPlaneSize = 60;
const kTile = 0.5;
/** Distance of the robot from the middle of a plane's piece beyond which the piece moves along. */
const kAstray = 10;

/** A square tile with an edge, repeated. */
class Tiles {
  readonly texture: THREE.CanvasTexture;
  private readonly canvas = document.createElement("canvas");

  constructor() {
    this.canvas.width = this.canvas.height = 256;
    this.texture = new THREE.CanvasTexture(this.canvas);
    this.texture.wrapS = this.texture.wrapT = THREE.RepeatWrapping;
    this.texture.repeat.set(kPlaneSize / kTile, kPlaneSize / kTile);
    this.texture.anisotropy = 8;
    this.texture.colorSpace = THREE.SRGBColorSpace;
  }

  paint(theme: Theme): void {
    const context = this.canvas.getContext("2d");
    if (!context) return;
    context.fillStyle = theme.groundLine;
    context.fillRect(0, 0, 256, 256);
    context.fillStyle = theme.ground;
    context.fillRect(2, 2, 252, 252);
    this.texture.needsUpdate = true;
  }
}

/** The ground and the obstacles on it. */
export class TerrainView {
  readonly root = new THREE.Group();
  private readonly planes: THREE.Mesh[] = [];
  private readonly tiles = new Tiles();
  private readonly ground = new THREE.MeshStandardMaterial({ roughness: 0.95, map: this.tiles.texture });
  private readonly block = new THREE.MeshStandardMaterial({
    roughness: 0.95, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  private readonly obstacle = new THREE.MeshStandardMaterial({ roughness: 0.9 });
  private readonly line = new THREE.LineBasicMaterial({ transparent: true, opacity: 0.9 });

  constructor(terrain: TerrainFile) {
    for (const patch of terrain.patches) {
      if (patch.outline_m.length === 0) this.addPlane(patch);
      else this.addPatch(patch);
    }
    for (const field of terrain.height_fields) this.addField(field);
    for (const obstacle of terrain.obstacles) {
      const mesh = new THREE.Mesh(
        shapeGeometry(obstacle.type, obstacle.size_m, obstacle.points_m),
        this.obstacle,
      );
      setPose(mesh, obstacle.pose);
      this.add(mesh);
      this.addEdges(mesh);
    }
  }

  paint(theme: Theme): void {
    this.tiles.paint(theme);
    this.block.color.set(theme.block);
    this.obstacle.color.set(theme.obstacle);
    this.line.color.set(theme.groundLine);
  }

  /** The visible pieces of infinite planes move with the robot, by whole tiles. */
  goWith(p_W: THREE.Vector3): void {
    for (const plane of this.planes) {
      const p = (plane.parent as THREE.Object3D).worldToLocal(p_W.clone()).setZ(0);
      if (p.distanceTo(plane.position) > kAstray) plane.position.copy(p.divideScalar(kTile).round().multiplyScalar(kTile));
    }
  }

  private add(mesh: THREE.Mesh): void {
    mesh.receiveShadow = true;
    this.root.add(standStill(mesh));
  }

  private addEdges(mesh: THREE.Mesh): void {
    const edges = new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, 20), this.line);
    edges.position.copy(mesh.position);
    edges.quaternion.copy(mesh.quaternion);
    this.root.add(standStill(edges));
  }

  /** An infinite plane: a large piece of it, with tiles of half a metre that make motion visible. */
  private addPlane(patch: TerrainFile["patches"][number]): void {
    const plane = new THREE.Mesh(new THREE.PlaneGeometry(kPlaneSize, kPlaneSize), this.ground);
    plane.receiveShadow = true;
    const frame = new THREE.Group().add(plane);
    setPose(frame, patch.pose);
    this.planes.push(plane);
    this.root.add(standStill(frame));
  }

  /** A bounded piece of plane and the solid straight below it. */
  private addPatch(patch: TerrainFile["patches"][number]): void {
    const frame = new THREE.Object3D();
    setPose(frame, patch.pose);
    frame.updateMatrixWorld();
    const top = patch.outline_m.map(([x, y]) => new THREE.Vector3(x, y, 0).applyMatrix4(frame.matrixWorld));
    const bottom = top.map((p) => new THREE.Vector3(p.x, p.y, p.z - kSolidDepth));
    const positions: number[] = [];
    const triangle = (a: THREE.Vector3, b: THREE.Vector3, c: THREE.Vector3) =>
      positions.push(...a.toArray(), ...b.toArray(), ...c.toArray());
    for (let i = 1; i + 1 < top.length; ++i) triangle(top[0], top[i], top[i + 1]);
    top.forEach((corner, i) => {
      const j = (i + 1) % top.length;
      triangle(corner, bottom[i], bottom[j]);
      triangle(corner, bottom[j], top[j]);
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
    geometry.computeVertexNormals();
    this.add(new THREE.Mesh(geometry, this.block));
    this.root.add(standStill(new THREE.LineLoop(new THREE.BufferGeometry().setFromPoints(top), this.line)));
  }

  private addField(field: TerrainFile["height_fields"][number]): void {
    const heights = unpack(field.heights_m).values;
    const positions = new Float32Array(3 * field.columns * field.rows);
    for (let j = 0; j < field.rows; ++j) {
      for (let i = 0; i < field.columns; ++i) {
        const k = j * field.columns + i;
        positions[3 * k] = field.origin_m[0] + i * field.resolution_m;
        positions[3 * k + 1] = field.origin_m[1] + j * field.resolution_m;
        positions[3 * k + 2] = heights[k];
      }
    }
    const triangles = new Uint32Array(6 * Math.max(field.rows - 1, 0) * Math.max(field.columns - 1, 0));
    let n = 0;
    for (let j = 0; j + 1 < field.rows; ++j) {
      for (let i = 0; i + 1 < field.columns; ++i) {
        const k = j * field.columns + i;
        triangles[n++] = k;
        triangles[n++] = k + 1;
        triangles[n++] = k + field.columns + 1;
        triangles[n++] = k;
        triangles[n++] = k + field.columns + 1;
        triangles[n++] = k + field.columns;
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    geometry.computeVertexNormals();
    this.add(new THREE.Mesh(geometry, this.block));
  }
}
