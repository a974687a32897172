// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Theme } from "./colours";
import { Overlays, type Overlay } from "./overlays";
import { RobotView, setPose } from "./robot_view";
import { mainTrack, row, sampleAt, type Motion, type PoseRow } from "./scene";
import { TerrainView } from "./terrain_view";

export type View = "corner" | "side" | "front" | "top";

/** Places of the camera, as multiples of its distance from the robot. */
const kViews: Record<View, [number, number, number]> = {
  corner: [0.62, -0.92, 0.5],
  side: [0, -1.2, 0.18],
  front: [1.2, 0, 0.25],
  top: [-0.001, 0, 1.4],
};

/** Limits of the camera's distance in robot reaches: near enough for a foot, and not in the fog. */
const kNearest = 0.3;
const kFarthest = 24;
const kMostPixels = 2;

/** Smallest angle of the line of sight from straight down [rad]; at zero the heading would be undefined. */
const kSteepest = 1e-3;

/** Rate at which the camera approaches the robot [1/s]: the distance decays as exp(-rate t). */
const kFollowRate = 6;

/** One motion in 3D: ground, robot, ghost and overlays under one camera. */
export class Stage {
  readonly overlays: Overlays;
  readonly robot: RobotView;
  private readonly ghost: RobotView | null = null;
  private readonly terrain: TerrainView;
  private readonly renderer: THREE.WebGLRenderer;
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(36, 1, 0.05, 200);
  private readonly controls: OrbitControls;
  private readonly sun = new THREE.DirectionalLight(0xffffff, 2.1);
  private readonly sky = new THREE.HemisphereLight(0xffffff, 0x98a4b0, 1.5);
  private readonly centre = new THREE.Vector3();
  private readonly ray = new THREE.Raycaster();
  /** Distance of the robot's outermost point from its middle, as it first stands. */
  private readonly reach: number;
  private shown = 0;
  private shownAt = 0;
  private dirty = true;
  follow = true;

  /** @throws if the browser has no WebGL. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly motion: Motion,
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.camera.up.set(0, 0, 1);
    this.robot = new RobotView(motion.file.robot, false);
    this.terrain = new TerrainView(motion.file.terrain);
    this.overlays = new Overlays(motion);
    if (motion.ghost) {
      this.ghost = new RobotView(motion.file.robot, true);
      this.overlays.group("ghost").add(this.ghost.root);
    }
    this.scene.add(this.terrain.root, this.robot.root, this.overlays.root, this.sky, this.sun, this.sun.target);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = 0.495 * Math.PI;
    this.controls.addEventListener("change", () => (this.dirty = true));
    this.showSample(0, motion.time[0]);
    this.reach = new THREE.Box3().setFromObject(this.robot.root).getBoundingSphere(new THREE.Sphere()).radius;
    this.controls.minDistance = kNearest * this.reach;
    this.controls.maxDistance = kFarthest * this.reach;
    this.setUpSun();
    this.centre.copy(this.robotCentre());
    this.look("corner");
  }

  paint(theme: Theme): void {
    this.scene.background = new THREE.Color(theme.sky);
    this.scene.fog = new THREE.Fog(theme.sky, 25 * this.reach, 70 * this.reach);
    this.sky.intensity = theme.dark ? 1.0 : 1.5;
    this.terrain.paint(theme);
    this.robot.paint(theme);
    this.ghost?.paint(theme);
    this.overlays.paint(theme);
    this.dirty = true;
  }

  setVisible(overlay: Overlay, visible: boolean): void {
    this.overlays.setVisible(overlay, visible);
    this.showSample(this.shown, this.shownAt);
  }

  /** A camera at that side of the robot, at a distance that shows the whole robot. */
  look(view: View): void {
    const distance = 3.9 * this.reach;
    const [x, y, z] = kViews[view];
    this.controls.target.copy(this.centre);
    this.camera.position.set(x, y, z).multiplyScalar(distance).add(this.centre);
    this.controls.update();
    this.dirty = true;
  }

  /** Moves the camera about its target: around and down by angles [rad], and scales its distance by a factor. */
  orbit(around: number, down: number, farther: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const length = clamped(offset.length() * farther, this.controls.minDistance, this.controls.maxDistance);
    const fromUp = clamped(Math.acos(clamped(offset.z / offset.length(), -1, 1)) + down, kSteepest, this.controls.maxPolarAngle);
    const heading = Math.atan2(offset.y, offset.x) + around;
    const flat = Math.sin(fromUp);
    offset.set(flat * Math.cos(heading), flat * Math.sin(heading), Math.cos(fromUp)).multiplyScalar(length);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.dirty = true;
  }

  /** Shows the current sample of a time. */
  show(t: number): void {
    const k = sampleAt(this.motion.time, t);
    if (k === this.shown) return;
    this.showSample(k, t);
  }

  /** Shows the last sample again: for a motion that rolls on. */
  showLast(): void {
    const last = this.motion.time.length - 1;
    this.showSample(last, this.motion.time[last]);
  }

  /** Adds another object. */
  add(object: THREE.Object3D): void {
    this.scene.add(object);
  }

  /** An added object has changed. */
  touch(): void {
    this.dirty = true;
  }

  /** Moves the ground to a pose. */
  placeGround(pose: PoseRow): void {
    setPose(this.terrain.root, pose);
    this.dirty = true;
  }

  /** The point of the robot that is visible at a place of the window. */
  hit(x: number, y: number): { body: number; p_W: THREE.Vector3 } | null {
    this.aim(x, y);
    return this.robot.hit(this.ray);
  }

  /** The point at a place of the window that has the same depth from the camera as another point. */
  pointAt(x: number, y: number, asFarAs_W: THREE.Vector3): THREE.Vector3 {
    this.aim(x, y);
    const plane = new THREE.Plane().setFromNormalAndCoplanarPoint(this.camera.getWorldDirection(new THREE.Vector3()), asFarAs_W);
    return this.ray.ray.intersectPlane(plane, new THREE.Vector3()) ?? asFarAs_W.clone();
  }

  /** Place of a point in the picture, in pixels from the left and the top. */
  seenAt(p_W: THREE.Vector3): { x: number; y: number } {
    const p = p_W.clone().project(this.camera);
    return { x: 0.5 * (1 + p.x) * this.canvas.clientWidth, y: 0.5 * (1 - p.y) * this.canvas.clientHeight };
  }

  /** The camera follows the robot; at once if `seconds` is infinite. */
  goAfter(seconds: number): void {
    if (!this.follow) return;
    const step = this.robotCentre().sub(this.centre).multiplyScalar(1 - Math.exp(-kFollowRate * seconds));
    if (step.lengthSq() < 1e-14) return;
    this.centre.add(step);
    this.controls.target.add(step);
    this.camera.position.add(step);
    this.dirty = true;
  }

  /** Draws if anything has changed since the last time. */
  draw(): boolean {
    this.fit();
    if (!this.dirty) return false;
    this.dirty = false;
    this.sun.target.position.copy(this.centre);
    this.sun.position.copy(this.centre).add(new THREE.Vector3(1.6, -1.1, 4).multiplyScalar(this.reach));
    this.terrain.goWith(this.centre);
    this.renderer.render(this.scene, this.camera);
    return true;
  }

  /** Releases the browser's resources; afterwards it shows nothing. */
  dispose(): void {
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Draw calls and triangles of the last picture. */
  cost(): { calls: number; triangles: number } {
    return { calls: this.renderer.info.render.calls, triangles: this.renderer.info.render.triangles };
  }

  private showSample(k: number, t: number): void {
    this.shown = k;
    this.shownAt = t;
    this.robot.pose(row(mainTrack(this.motion).q, k));
    if (this.ghost && this.motion.ghost) this.showGhost(this.ghost, row(this.motion.ghost, k));
    this.overlays.show(k, t);
    this.dirty = true;
  }

  private showGhost(ghost: RobotView, q: Float32Array): void {
    ghost.root.visible = Number.isFinite(q[0]);
    if (ghost.root.visible) ghost.pose(q);
  }

  /** The ray of sight through a place of the window. */
  private aim(x: number, y: number): void {
    const box = this.canvas.getBoundingClientRect();
    this.ray.setFromCamera(new THREE.Vector2((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height), this.camera);
  }

  private robotCentre(): THREE.Vector3 {
    const q = row(mainTrack(this.motion).q, this.shown);
    return new THREE.Vector3(q[0], q[1], q[2] - 0.25 * this.reach);
  }

  private setUpSun(): void {
    const extent = 4 * this.reach;
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    Object.assign(this.sun.shadow.camera, { left: -extent, right: extent, top: extent, bottom: -extent, near: 0.01, far: 12 * this.reach });
    this.sun.shadow.normalBias = 0.01 * this.reach;
    this.sun.shadow.radius = 4;
  }

  /** Sets the picture to the size of its place in the page. */
  private fit(): void {
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    if (width === 0 || height === 0) return;
    const ratio = Math.min(window.devicePixelRatio, kMostPixels);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    else if (this.canvas.width === Math.floor(width * ratio) && this.canvas.height === Math.floor(height * ratio)) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.dirty = true;
  }
}

function clamped(value: number, lowest: number, highest: number): number {
  return Math.min(Math.max(value, lowest), highest);
}
