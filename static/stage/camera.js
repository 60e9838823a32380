/** The camera of the stage: views that hold a box in frame, turns by keys. */

import * as THREE from "three";
import { OrbitControls } from "../node_modules/three/examples/jsm/controls/OrbitControls.js";

/** Each view as azimuth from the front to the wearer's left and elevation [deg]. */
const VIEWS = { whole: [32, 7], front: [0, 5], back: [180, 5], left: [90, 5], right: [-90, 5] };
const FIELD_DEG = 30;
/** Height of the tools over and under the picture [px], which cover nothing of what is in frame. */
const TOOLS_PX = 96;
const LEAST_SHARE = 0.6;
const KEY_TURN = Math.PI / 18;
const KEY_ZOOM = 0.88;

const KEYS = {
  ArrowLeft: [-KEY_TURN, 0, 1], ArrowRight: [KEY_TURN, 0, 1], ArrowUp: [0, -KEY_TURN, 1], ArrowDown: [0, KEY_TURN, 1],
  "+": [0, 0, KEY_ZOOM], "=": [0, 0, KEY_ZOOM], "-": [0, 0, 1 / KEY_ZOOM],
};

function cornersOf({ min, max }) {
  return [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new THREE.Vector3(x, y, z))));
}

/** Moves a camera so that a box fills its frame, `share` of the height at most. */
export function frame(camera, box, view, share) {
  const [azimuth, elevation] = VIEWS[view].map(THREE.MathUtils.degToRad);
  const away = new THREE.Vector3(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation));
  const right = new THREE.Vector3(Math.cos(azimuth), 0, -Math.sin(azimuth));
  const up = new THREE.Vector3().crossVectors(away, right);
  const middle = box.getCenter(new THREE.Vector3());
  const high = Math.tan(THREE.MathUtils.degToRad(FIELD_DEG / 2)) * share;
  const wide = Math.tan(THREE.MathUtils.degToRad(FIELD_DEG / 2)) * camera.aspect * 0.94;
  const distances = cornersOf(box).map((corner) => {
    const from = corner.sub(middle);
    return from.dot(away) + Math.max(Math.abs(from.dot(right)) / wide, Math.abs(from.dot(up)) / high);
  });
  camera.position.copy(middle).addScaledVector(away, Math.max(...distances));
  camera.lookAt(middle);
  return middle;
}

export const newCamera = () => new THREE.PerspectiveCamera(FIELD_DEG, 1, 0.05, 50);

/** The share of the height that the tools leave free. */
const freeShare = (height) => Math.max(LEAST_SHARE, 1 - TOOLS_PX / height);

/** A camera that a person turns: `look(view, box)`, `resize`; `onChange` draws. */
export function createCamera(canvas, onChange) {
  const camera = newCamera();
  const controls = new OrbitControls(camera, canvas);
  controls.minDistance = 0.3;
  controls.maxDistance = 9;
  controls.addEventListener("change", onChange);

  const turn = (around, up, nearer) => {
    const offset = new THREE.Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    offset.theta += around;
    offset.phi = Math.min(Math.PI - 0.05, Math.max(0.05, offset.phi + up));
    offset.radius = Math.min(controls.maxDistance, Math.max(controls.minDistance, offset.radius * nearer));
    camera.position.setFromSpherical(offset).add(controls.target);
    controls.update();
    onChange();
  };
  canvas.addEventListener("keydown", (event) => {
    if (!KEYS[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    turn(...KEYS[event.key]);
  });
  return {
    camera,
    look(view, box) {
      if (box.isEmpty()) return;
      controls.target.copy(frame(camera, box, view, freeShare(canvas.clientHeight)));
      controls.update();
      onChange();
    },
    resize(width, height) {
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      onChange();
    },
  };
}
