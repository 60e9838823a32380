/** The scene of the stage: what draws it, and when. Frames are drawn only when something changed. */

import * as THREE from "three";
import { createCamera, frame, newCamera } from "./camera.js";
import { meshesIn } from "./cloth.js";
import { createFloor } from "./floor.js";
import { lights } from "./light.js";

const LABEL = "Garment in 3D. Arrow keys turn it, plus and minus zoom.";
const EXPOSURE = 0.86;
const PICTURE_SHARE = 0.9;

function createRenderer() {
  const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.autoUpdate = false;
  renderer.toneMapping = THREE.NeutralToneMapping;
  renderer.toneMappingExposure = EXPOSURE;
  renderer.setPixelRatio(Math.min(2, devicePixelRatio));
  return renderer;
}

function canvasOf(renderer, host) {
  const canvas = renderer.domElement;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", LABEL);
  host.prepend(canvas);
  return canvas;
}

export class StageScene {
  body = new THREE.Group();
  garment = new THREE.Group();
  marks = new THREE.Group();
  #scene = new THREE.Scene();
  #floor = createFloor();
  #ray = new THREE.Raycaster();
  #host;
  #request = 0;
  #isReshaped = true;

  /** A scene that fills `host`. Throws where the browser has no WebGL. */
  constructor(host) {
    this.#host = host;
    this.renderer = createRenderer();
    this.canvas = canvasOf(this.renderer, host);
    this.view = createCamera(this.canvas, () => this.draw());
    this.#scene.add(...lights(), this.#floor.mesh, this.body, this.garment, this.marks);
    this.body.userData.castsOnFloor = this.garment.userData.castsOnFloor = true;
    new ResizeObserver(() => this.#resize()).observe(host);
    this.#resize();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#colorFloor());
    this.#colorFloor();
  }

  /** Draws a frame soon. */
  draw() {
    this.#request ||= requestAnimationFrame(() => {
      this.#request = 0;
      this.paint(this.view.camera);
    });
  }

  /** Draws a frame soon, with shadows anew, because a shape changed. */
  reshape() {
    const { body, garment } = this;
    this.#isReshaped = true;
    this.#floor.mesh.visible = garment.children.length + body.children.length > 0;
    // A form without legs stands on it as on a table.
    const { min } = new THREE.Box3().setFromObject(body);
    this.#floor.moveTo(body.visible && Number.isFinite(min.y) ? min.y : 0);
    this.draw();
  }

  /** Draws a frame now. */
  paint(camera) {
    if (this.#isReshaped) {
      this.renderer.shadowMap.needsUpdate = true;
      this.#floor.darken(this.renderer, this.#scene);
      this.#isReshaped = false;
    }
    this.renderer.render(this.#scene, camera);
  }

  look(name) {
    this.view.look(name, this.#boxOf(name));
  }

  /** What a ray through a point of the canvas [px] meets first in a group that is shown. */
  hitIn(group, x, y) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.#ray.setFromCamera(new THREE.Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.view.camera);
    return this.#ray.intersectObjects(group.visible ? meshesIn(group) : [], false)[0];
  }

  /** Draws what is seen onto a canvas. */
  drawOnto(pen) {
    this.paint(this.view.camera);
    pen.drawImage(this.canvas, 0, 0, pen.canvas.width, pen.canvas.height);
  }

  /** Draws the whole onto a canvas, whatever is seen. */
  drawWholeOnto(pen) {
    const { width, height } = pen.canvas;
    const camera = newCamera();
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    frame(camera, this.#boxOf("whole"), "whole", PICTURE_SHARE);
    const { renderer } = this;
    const [size, ratio] = [renderer.getSize(new THREE.Vector2()), renderer.getPixelRatio()];
    renderer.setPixelRatio(1);
    renderer.setSize(width, height, false);
    this.paint(camera);
    pen.drawImage(this.canvas, 0, 0);
    renderer.setPixelRatio(ratio);
    renderer.setSize(size.x, size.y);
    this.paint(this.view.camera);
  }

  /** What a view holds in frame: all, or the garment alone. */
  #boxOf(name) {
    const box = new THREE.Box3().setFromObject(this.garment);
    if (name !== "whole" && !box.isEmpty()) return box;
    return this.body.visible ? box.union(new THREE.Box3().setFromObject(this.body)) : box;
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.#host;
    if (!width || !height) return;
    this.renderer.setSize(width, height);
    this.view.resize(width, height);
  }

  #colorFloor() {
    this.#floor.setColor(getComputedStyle(this.#host).getPropertyValue("--stage-floor").trim());
    this.draw();
  }
}
