/**
 * The garment in 3D: orbit by pointer or arrow keys. Frames are drawn only when something changed.
 */

import * as THREE from "three";
import { OrbitControls } from "./node_modules/three/examples/jsm/controls/OrbitControls.js";
import { GLTFLoader } from "./node_modules/three/examples/jsm/loaders/GLTFLoader.js";

/** Place of the viewer for each side, as [x, z]; the body faces +z with its left at +x. */
const SIDES = { front: [0, 1], back: [0, -1], left: [1, 0], right: [-1, 0] };
const KEY_TURN = Math.PI / 18;

/** Muted cloth colors, one for each fabric in the garment. */
const CLOTH = [0x8fa9bf, 0xc79a86, 0x9db08e, 0xb9a3c4, 0xc9b37e, 0x86b1ad];
const BODY = 0xb9b1a8;

/**
 * The body is drawn some 3 mm further away, so that its facets do not show through cloth that lies
 * on it. The report has the true depth.
 */
const BODY_BEHIND = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 600 };
const SEAM_LINE = 0x2c3338;
const MARK = 0xd0342c;
/** Radius of the mark of a place [m]. */
const MARK_RADIUS = 0.007;

function lights() {
  const key = new THREE.DirectionalLight(0xfff6ea, 2.1);
  key.position.set(1.6, 2.9, 2.4);
  key.castShadow = true;
  key.shadow.mapSize.set(1024, 1024);
  Object.assign(key.shadow.camera, { left: -1.2, right: 1.2, top: 1.4, bottom: -1.4, near: 0.5, far: 7 });
  key.shadow.normalBias = 0.012;
  key.target.position.set(0, 0.9, 0);
  const fill = new THREE.DirectionalLight(0xdde8ff, 0.9);
  fill.position.set(-2, 1.4, -1.8);
  return [new THREE.HemisphereLight(0xffffff, 0x8a8378, 1.15), key, key.target, fill];
}

function dispose(group) {
  group.traverse((object) => {
    object.geometry?.dispose();
    for (const material of [object.material ?? []].flat()) material.dispose();
  });
  group.clear();
}

/** Cloth from the loaded file: both faces, colored by fabric, edges of panels drawn. */
function dress(model) {
  const fabrics = [];
  model.traverse((object) => {
    if (!object.isMesh) return;
    const name = object.material.name;
    if (!fabrics.includes(name)) fabrics.push(name);
    const color = CLOTH[fabrics.indexOf(name) % CLOTH.length];
    const textured = object.material.map;
    object.material = new THREE.MeshStandardMaterial({
      name, map: textured, color: textured ? 0xffffff : color, roughness: 0.9, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    });
    object.castShadow = true;
    object.receiveShadow = true;
    if (!object.geometry.attributes.normal) object.geometry.computeVertexNormals();
  });
  const lines = [];
  model.traverse((object) => {
    if (!object.isMesh) return;
    // An angle that no fold reaches leaves the border of the panel.
    const border = new THREE.LineSegments(new THREE.EdgesGeometry(object.geometry, 179), new THREE.LineBasicMaterial({ color: SEAM_LINE, transparent: true, opacity: 0.55 }));
    lines.push([object, border]);
  });
  for (const [object, border] of lines) object.add(border);
}

function bodyMaterial(model) {
  model.traverse((object) => {
    if (!object.isMesh) return;
    object.material = new THREE.MeshStandardMaterial({ color: BODY, roughness: 0.75, ...BODY_BEHIND });
    object.castShadow = true;
    object.receiveShadow = true;
    if (!object.geometry.attributes.normal) object.geometry.computeVertexNormals();
  });
}

/** A view inside `host`. Throws where the browser has no WebGL. */
export function createViewer(host) {
  const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  renderer.shadowMap.enabled = true;
  renderer.setPixelRatio(Math.min(2, devicePixelRatio));
  const canvas = renderer.domElement;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", "Garment in 3D. Arrow keys turn it, plus and minus zoom.");
  host.append(canvas);

  const scene = new THREE.Scene();
  const body = new THREE.Group();
  const garment = new THREE.Group();
  const marks = new THREE.Group();
  scene.add(...lights(), body, garment, marks);
  const camera = new THREE.PerspectiveCamera(32, 1, 0.05, 50);
  const controls = new OrbitControls(camera, canvas);
  controls.minDistance = 0.3;
  controls.maxDistance = 8;

  let frame = 0;
  const draw = () => {
    frame ||= requestAnimationFrame(() => {
      frame = 0;
      renderer.render(scene, camera);
    });
  };
  controls.addEventListener("change", draw);

  const look = (side) => {
    const box = new THREE.Box3().setFromObject(garment);
    if (box.isEmpty()) box.setFromObject(body);
    if (box.isEmpty()) return;
    const middle = box.getCenter(new THREE.Vector3());
    const size = box.getSize(new THREE.Vector3());
    const [x, z] = SIDES[side];
    const across = x ? size.z : size.x;
    const half = Math.tan((camera.fov * Math.PI) / 360);
    const away = 1.35 * Math.max(size.y / 2 / half, across / 2 / half / camera.aspect) + (x ? size.x : size.z) / 2;
    camera.position.set(middle.x + x * away, middle.y + 0.12 * away, middle.z + z * away);
    controls.target.copy(middle);
    controls.update();
    draw();
  };

  const resize = () => {
    const { clientWidth: width, clientHeight: height } = host;
    if (!width || !height) return;
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    draw();
  };
  new ResizeObserver(resize).observe(host);
  resize();

  const turn = (around, up, nearer) => {
    const offset = new THREE.Spherical().setFromVector3(camera.position.clone().sub(controls.target));
    offset.theta += around;
    offset.phi = Math.min(Math.PI - 0.05, Math.max(0.05, offset.phi + up));
    offset.radius = Math.min(controls.maxDistance, Math.max(controls.minDistance, offset.radius * nearer));
    camera.position.setFromSpherical(offset).add(controls.target);
    controls.update();
    draw();
  };
  const keys = {
    ArrowLeft: [-KEY_TURN, 0, 1], ArrowRight: [KEY_TURN, 0, 1], ArrowUp: [0, -KEY_TURN, 1], ArrowDown: [0, KEY_TURN, 1],
    "+": [0, 0, 0.88], "=": [0, 0, 0.88], "-": [0, 0, 1 / 0.88],
  };
  canvas.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    turn(...keys[event.key]);
  });

  const loader = new GLTFLoader();
  const read = async (bytes) => (await loader.parseAsync(bytes, "")).scene;
  let first = true;

  return {
    look,
    setBodyVisible(visible) {
      body.visible = visible;
      draw();
    },
    /** The model of a file, to be shown as body or garment. */
    read,
    showBody(model) {
      dispose(body);
      if (model) {
        bodyMaterial(model);
        body.add(model);
      }
      draw();
    },
    /** The camera stays where it was when a garment is sewn again. */
    showGarment(model) {
      dispose(garment);
      dress(model);
      garment.add(model);
      if (first) look("front");
      first = false;
      draw();
    },
    /** Marks places, seen through all that is before them. */
    mark(places) {
      dispose(marks);
      const material = new THREE.MeshBasicMaterial({ color: MARK, transparent: true, opacity: 0.7, depthTest: false });
      const ball = new THREE.SphereGeometry(MARK_RADIUS, 12, 8);
      for (const at of places) {
        const mark = new THREE.Mesh(ball, material);
        mark.position.set(...at);
        marks.add(mark);
      }
      draw();
    },
    clear() {
      dispose(garment);
      dispose(marks);
      first = true;
      draw();
    },
  };
}
