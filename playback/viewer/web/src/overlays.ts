// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import type { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { ArrowMaker, type Arrow } from "./arrows";
import type { Ink, Theme } from "./colours";
import { Footsteps } from "./footsteps";
import { Palette, seenThrough, standStill } from "./palette";
import { kMostCorners, mainTrack, row, unpack, type Motion, type Table, type Track } from "./scene";

/** The overlays of the robot, in the order of the legend. */
export const kOverlays = ["ghost", "support", "zmp", "com", "dcm", "forces", "footsteps", "swings"] as const;
export type Overlay = (typeof kOverlays)[number];

export const kOverlayNames: Record<Overlay, string> = {
  ghost: "plan as a ghost",
  support: "support polygon",
  zmp: "zero-moment point",
  com: "centre of mass",
  dcm: "divergent component",
  forces: "contact forces",
  footsteps: "footsteps",
  swings: "swings",
};

export const kOverlayInk: Record<Overlay, Ink> = {
  ghost: "com", support: "support", zmp: "zmp", com: "com", dcm: "dcm", forces: "foot", footsteps: "muted", swings: "foot",
};

/** Height above the ground, which avoids flicker. */
const kLift = 0.003;
const kTrailSeconds = 1.0;
/** Width of trails in pixels, planned and measured. */
const kBroad = 4.5;
const kThin = 1.5;

/** A geometry whose points change with time. */
function movingPoints(most: number): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * most), 3).setUsage(THREE.DynamicDrawUsage));
  geometry.setDrawRange(0, 0);
  return geometry;
}

function upload(geometry: THREE.BufferGeometry, points: number): void {
  geometry.setDrawRange(0, points);
  geometry.attributes.position.needsUpdate = true;
}

/** A point on the ground with its path in the last second. */
class Trace {
  readonly root = new THREE.Group();
  private readonly marker: THREE.Mesh;
  private readonly trail = new LineSegmentsGeometry();
  /** Both ends of each piece of the trail. */
  private readonly ends: THREE.InstancedInterleavedBuffer;
  private readonly most: number;

  constructor(
    motion: Motion,
    private readonly table: Table,
    geometry: THREE.BufferGeometry,
    material: THREE.Material,
    trail: LineMaterial,
    private readonly lift: number,
  ) {
    const step = motion.time.length > 1 ? motion.time[1] - motion.time[0] : 1;
    this.most = Math.max(2, Math.min(motion.time.length, Math.ceil(kTrailSeconds / step) + 1));
    this.marker = new THREE.Mesh(geometry, material);
    this.trail.setPositions(new Float32Array(6 * (this.most - 1)));
    this.ends = (this.trail.attributes.instanceStart as THREE.InterleavedBufferAttribute).data as THREE.InstancedInterleavedBuffer;
    this.ends.setUsage(THREE.DynamicDrawUsage);
    const line = new LineSegments2(this.trail, trail);
    line.frustumCulled = false;
    seenThrough(this.marker, material);
    seenThrough(line, trail);
    this.root.add(this.marker, standStill(line));
  }

  show(k: number): void {
    const at = row(this.table, k);
    this.marker.visible = Number.isFinite(at[0]);
    if (this.marker.visible) this.marker.position.set(at[0], at[1], at[2] + this.lift);
    let pieces = 0;
    for (let i = Math.max(0, k - this.most + 1); i < k; ++i) if (this.addPiece(pieces, i)) ++pieces;
    this.trail.instanceCount = pieces;
    this.ends.needsUpdate = true;
  }

  /** Path from one sample to the next. @return whether the point exists at both. */
  private addPiece(piece: number, i: number): boolean {
    const { values } = this.table, from = 3 * i;
    if (!Number.isFinite(values[from]) || !Number.isFinite(values[from + 3])) return false;
    const ends = this.ends.array as Float32Array;
    for (let c = 0; c < 6; ++c) ends[6 * piece + c] = values[from + c] + (c % 3 === 2 ? this.lift : 0);
    return true;
  }
}

/** Everything that is drawn in addition to robot and ground. */
export class Overlays {
  readonly root = new THREE.Group();
  private readonly groups = new Map<Overlay, THREE.Group>();
  private readonly palette = new Palette();
  private readonly traces: Trace[] = [];
  private readonly track: Track;
  private readonly size: number;
  private readonly supportFill: THREE.Mesh;
  private readonly supportEdge: THREE.LineLoop;
  private readonly drop: THREE.Line;
  private readonly arrows: Arrow[] = [];
  private readonly footsteps: Footsteps;
  private readonly force = new THREE.Vector3();
  private readonly at = new THREE.Vector3();

  constructor(private readonly motion: Motion) {
    this.track = mainTrack(motion);
    this.size = motion.file.robot.leg_length_m;
    for (const name of kOverlays) {
      const group = new THREE.Group();
      group.name = name;
      this.groups.set(name, group);
      this.root.add(group);
    }
    this.supportFill = new THREE.Mesh(movingPoints(3 * kMostCorners), this.palette.solid("support", 0.45));
    this.supportEdge = new THREE.LineLoop(movingPoints(kMostCorners), this.palette.line("support"));
    this.supportFill.frustumCulled = this.supportEdge.frustumCulled = false;
    this.group("support").add(standStill(this.supportFill), standStill(this.supportEdge));
    this.drop = new THREE.Line(movingPoints(2), this.palette.line("com", 0.6));
    this.drop.frustumCulled = false;
    this.addPoints();
    this.addArrows();
    this.footsteps = new Footsteps(motion.file.footholds, this.palette, kLift);
    this.group("footsteps").add(this.footsteps.root);
    this.addSwings();
  }

  group(name: Overlay): THREE.Group {
    return this.groups.get(name) as THREE.Group;
  }

  setVisible(name: Overlay, visible: boolean): void {
    this.group(name).visible = visible;
  }

  paint(theme: Theme): void {
    this.palette.paint(theme);
  }

  show(k: number, t: number): void {
    if (this.group("support").visible) this.showSupport(k);
    for (const trace of this.traces) if (trace.root.parent?.visible) trace.show(k);
    if (this.group("com").visible) this.showDrop(k);
    if (this.group("forces").visible) this.showForces(k);
    if (this.group("footsteps").visible) this.footsteps.show(t);
  }

  /** Planned points are rings with broad pale trails; measured points are filled, with thin trails. */
  private addPoints(): void {
    const r = 0.05 * this.size;
    const disc = new THREE.CircleGeometry(r, 32);
    const ring = new THREE.RingGeometry(1.1 * r, 1.6 * r, 40);
    const ball = new THREE.SphereGeometry(0.9 * r, 24, 16);
    const { planned, measured } = this.motion;
    const add = (overlay: Overlay, table: Table, shape: THREE.BufferGeometry, isPlan: boolean, lift: number) => {
      const ink = kOverlayInk[overlay], opacity = isPlan && measured ? 0.6 : 0.95;
      const trail = isPlan ? this.palette.wide(ink, kBroad, 0.4) : this.palette.wide(ink, kThin, 0.95);
      const trace = new Trace(this.motion, table, shape, this.palette.solid(ink, opacity), trail, lift);
      this.traces.push(trace);
      this.group(overlay).add(trace.root);
    };
    if (planned) {
      add("zmp", planned.zmp, ring, true, 2 * kLift);
      add("dcm", planned.dcm, ring, true, 3 * kLift);
      if (!measured) add("com", planned.com, ball, true, 0);
    }
    if (measured) {
      add("zmp", measured.zmp, disc, false, 4 * kLift);
      add("dcm", measured.dcm, disc, false, 5 * kLift);
      add("com", measured.com, ball, false, 0);
    }
    this.group("com").add(standStill(this.drop));
  }

  private addArrows(): void {
    const maker = new ArrowMaker(this.size, this.palette.solid("foot", 0.9));
    for (let i = 0; i < this.motion.file.robot.feet.length; ++i) {
      const arrow = maker.make();
      this.arrows.push(arrow);
      this.group("forces").add(arrow.root);
    }
  }

  private addSwings(): void {
    const points: number[] = [];
    for (const swing of this.motion.file.swings) {
      const { values, rows } = unpack(swing.points_m);
      for (let i = 0; i + 1 < rows; ++i) for (let c = 0; c < 6; ++c) points.push(values[3 * i + c]);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
    this.group("swings").add(standStill(new THREE.LineSegments(geometry, this.palette.line("foot", 0.7))));
  }

  private showSupport(k: number): void {
    const first = this.track.supportFirst.values[k];
    const n = Math.min(this.track.supportFirst.values[k + 1] - first, kMostCorners);
    const edge = this.supportEdge.geometry.attributes.position.array as Float32Array;
    const fill = this.supportFill.geometry.attributes.position.array as Float32Array;
    const corner = (to: Float32Array, at: number, i: number) => {
      const p = row(this.track.support, first + i);
      to[3 * at] = p[0];
      to[3 * at + 1] = p[1];
      to[3 * at + 2] = p[2] + kLift;
    };
    for (let i = 0; i < n; ++i) corner(edge, i, i);
    let filled = 0;
    for (let i = 1; i + 1 < n; ++i) {
      corner(fill, filled++, 0);
      corner(fill, filled++, i);
      corner(fill, filled++, i + 1);
    }
    upload(this.supportEdge.geometry, n > 1 ? n : 0);
    upload(this.supportFill.geometry, filled);
  }

  /** The line from the centre of mass straight down to the plane of its divergent component. */
  private showDrop(k: number): void {
    const com = row(this.track.com, k);
    const ground = row(this.track.dcm, k)[2];
    const positions = this.drop.geometry.attributes.position.array as Float32Array;
    positions.set([com[0], com[1], com[2], com[0], com[1], Number.isFinite(ground) ? ground : 0]);
    upload(this.drop.geometry, 2);
  }

  /** The robot's weight is drawn as an arrow of 0.8 leg lengths. */
  private showForces(k: number): void {
    const metresPerNewton = (0.8 * this.size) / this.motion.file.robot.weight_n;
    const forces = row(this.track.force, k);
    const feet = row(this.track.foot, k);
    this.arrows.forEach((arrow, i) => {
      this.force.fromArray(forces, 3 * i);
      const length = this.force.length() * metresPerNewton;
      arrow.root.visible = Number.isFinite(length) && length > 0.02 * this.size;
      if (arrow.root.visible) arrow.show(this.at.fromArray(feet, 3 * i), this.force, length);
    });
  }
}
