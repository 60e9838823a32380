/**
 * Garment and body in 3D: orbit by pointer or arrow keys. Frames are drawn only when something
 * changed.
 */

import * as THREE from "three";
import { GLTFLoader } from "../node_modules/three/examples/jsm/loaders/GLTFLoader.js";
import { createCamera, frame, newCamera } from "./camera.js";
import { dispose, dress, dressBody, meshesIn, panelOfMesh, restyle } from "./cloth.js";
import { createFloor } from "./floor.js";
import { lights } from "./light.js";
import { extentOf, mapMaterial, setValues, valueAt } from "./mapped.js";
import { litLines } from "./lit.js";
import { marksAt } from "./marks.js";
import { girthLines, openingLines } from "./rings.js";

const LABEL = "Garment in 3D. Arrow keys turn it, plus and minus zoom.";
const PICTURE_SHARE = 0.9;
/** Cloth this little behind the body is looked at all the same: it lies on it [m]. */
const ON_BODY_M = 0.01;

function createRenderer() {
  const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.autoUpdate = false;
  renderer.toneMapping = THREE.NeutralToneMapping;
  renderer.toneMappingExposure = 0.86;
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

/** Groups of the scene by name; the shadow on the floor is that of garment and body. */
function createGroups(scene) {
  const groups = { body: new THREE.Group(), garment: new THREE.Group(), marks: new THREE.Group() };
  for (const group of Object.values(groups)) scene.add(group);
  groups.body.userData.castsOnFloor = groups.garment.userData.castsOnFloor = true;
  return groups;
}

/** A view inside `host`. Throws where the browser has no WebGL. */
export function createViewer(host) {
  const renderer = createRenderer();
  const canvas = canvasOf(renderer, host);
  const scene = new THREE.Scene();
  const floor = createFloor();
  scene.add(...lights(), floor.mesh);
  const { body, garment, marks } = createGroups(scene);

  let request = 0;
  let isReshaped = true;
  const paint = (camera) => {
    if (isReshaped) {
      renderer.shadowMap.needsUpdate = true;
      floor.darken(renderer, scene);
      isReshaped = false;
    }
    renderer.render(scene, camera);
  };
  const draw = () => {
    request ||= requestAnimationFrame(() => {
      request = 0;
      paint(view.camera);
    });
  };
  const view = createCamera(canvas, draw);
  const reshape = () => {
    isReshaped = true;
    floor.mesh.visible = garment.children.length + body.children.length > 0;
    // A form without legs stands on it as on a table.
    const { min } = new THREE.Box3().setFromObject(body);
    floor.moveTo(body.visible && Number.isFinite(min.y) ? min.y : 0);
    draw();
  };

  const resize = () => {
    const { clientWidth: width, clientHeight: height } = host;
    if (!width || !height) return;
    renderer.setSize(width, height);
    view.resize(width, height);
  };
  new ResizeObserver(resize).observe(host);
  resize();

  const boxOf = (name) => {
    const box = new THREE.Box3().setFromObject(garment);
    if (name !== "whole" && !box.isEmpty()) return box;
    return body.visible ? box.union(new THREE.Box3().setFromObject(body)) : box;
  };
  const look = (name) => view.look(name, boxOf(name));
  const readFloor = () => {
    floor.setColor(getComputedStyle(host).getPropertyValue("--stage-floor").trim());
    draw();
  };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", readFloor);
  readFloor();

  const ray = new THREE.Raycaster();
  const hitIn = (group) => ray.intersectObjects(group.visible ? meshesIn(group) : [], false)[0];

  const loader = new GLTFLoader();
  let isFirst = true;

  return {
    canvas,
    look,
    setBodyVisible(visible) {
      body.visible = visible;
      reshape();
    },
    /** The model of a file, to be shown as body or garment. */
    read: async (bytes) => (await loader.parseAsync(bytes, "")).scene,
    showBody(model) {
      dispose(body);
      if (model) {
        dressBody(model);
        body.add(model);
      }
      reshape();
    },
    /** The camera stays where it was when a garment is sewn again. */
    showGarment(model, lookOf) {
      dispose(garment);
      dress(model, lookOf);
      garment.add(model);
      if (isFirst) look("whole");
      isFirst = false;
      reshape();
    },
    /** Gives the cloth the looks that `lookOf(panel)` says. */
    restyle(lookOf) {
      restyle(meshesIn(garment), lookOf);
      draw();
    },
    /** Colors the cloth by a map, or as it is with null: the range of the colors, or null. */
    showMap(map) {
      const meshes = meshesIn(garment);
      const isMapped = map !== null && meshes.length > 0 && setValues(meshes, map);
      const range = isMapped ? map.range(extentOf(meshes)) : null;
      const material = isMapped ? mapMaterial({ ...map, range }) : null;
      for (const old of new Set(meshes.map((mesh) => mesh.material))) if (old.isShaderMaterial) old.dispose();
      for (const mesh of meshes) mesh.material = material ?? mesh.userData.cloth;
      draw();
      return range;
    },
    /** The panel at a point of the canvas [px], with its value on the shown map; null if none. */
    probe(x, y) {
      ray.setFromCamera(new THREE.Vector2((2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight), view.camera);
      const [hit, before] = [hitIn(garment), hitIn(body)];
      if (!hit || (before && before.distance < hit.distance - ON_BODY_M)) return null;
      return { panel: panelOfMesh(hit.object), value: hit.object.material.isShaderMaterial ? valueAt(hit) : null };
    },
    /** Marks places, by kind: `{cloth: [[x, y, z]…], body: […]}`, and lights what is asked for. */
    mark(places, { girth, opening } = {}) {
      dispose(marks);
      for (const [kind, at] of Object.entries(places)) {
        if (at.length > 0) marks.add(marksAt(at, kind, renderer.getPixelRatio()));
      }
      if (girth) marks.add(...litLines(girthLines(meshesIn(garment), girth)));
      if (opening) marks.add(...litLines(openingLines(meshesIn(garment), opening)));
      draw();
    },
    /** Draws what is seen onto a canvas. */
    drawOnto(pen) {
      paint(view.camera);
      pen.drawImage(canvas, 0, 0, pen.canvas.width, pen.canvas.height);
    },
    /** Draws the whole onto a canvas, whatever is seen. */
    drawWholeOnto(pen) {
      const { width, height } = pen.canvas;
      const camera = newCamera();
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      frame(camera, boxOf("whole"), "whole", PICTURE_SHARE);
      const size = renderer.getSize(new THREE.Vector2());
      const ratio = renderer.getPixelRatio();
      renderer.setPixelRatio(1);
      renderer.setSize(width, height, false);
      paint(camera);
      pen.drawImage(canvas, 0, 0);
      renderer.setPixelRatio(ratio);
      renderer.setSize(size.x, size.y);
      paint(view.camera);
    },
    clear() {
      dispose(garment);
      dispose(marks);
      isFirst = true;
      reshape();
    },
  };
}
