// Pictures of a garment: node tests/browser/render.mjs GARMENT.glb [OPTIONS], see USAGE below.
//
// Draws with three in a headless Chromium (WebGL in software), so that a picture needs no graphics
// card. The file's own normals and colors are used; the inside of the cloth is drawn darker, so that
// a panel with its face in stands out.
import { createServer } from "node:http";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { basename, dirname, join, normalize, sep } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";

const USAGE = `usage: node render.mjs GARMENT.glb [OPTIONS]
  --avatar FILE.glb   a body to draw with it, in grey (a node "avatar" in the garment's file is drawn so too)
  --out DIR           folder for NAME-VIEW.png and NAME-sheet.png        (.)
  --views LIST        of front, left, back, right, three-quarter, three-quarter-back, above, below
                      (front,left,back,right,three-quarter); left is the wearer's left side
  --size PX           width of a picture, height is 5/4 of it            (600)
  --colours WHAT      fabric: as the file has it; panel: one a panel     (fabric)
  --wire              draw the edges of the triangles
  --frame WHAT        garment or all: what fills the picture             (garment)
CHROMIUM names the browser (/usr/bin/chromium).`;

// Azimuth from the front towards the wearer's left, and elevation [degrees].
const VIEWS = {
  front: [0, 4],
  left: [90, 4],
  back: [180, 4],
  right: [-90, 4],
  "three-quarter": [38, 12],
  "three-quarter-back": [180 + 38, 12],
  above: [0, 75],
  below: [20, -45],
};

function asked() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      avatar: { type: "string" },
      out: { type: "string", default: "." },
      views: { type: "string", default: "front,left,back,right,three-quarter" },
      size: { type: "string", default: "600" },
      colours: { type: "string", default: "fabric" },
      wire: { type: "boolean", default: false },
      frame: { type: "string", default: "garment" },
    },
  });
  if (positionals.length !== 1) throw new Error("name one GARMENT.glb");
  const views = values.views.split(",").map((name) => name.trim());
  const unknown = views.filter((name) => !Object.hasOwn(VIEWS, name));
  if (unknown.length > 0) throw new Error(`no such view: ${unknown.join(", ")}`);
  const size = Number(values.size);
  if (!Number.isInteger(size) || size < 32 || size > 4000) throw new Error("--size is 32 to 4000");
  for (const [option, words] of [["colours", ["fabric", "panel"]], ["frame", ["garment", "all"]]]) {
    if (!words.includes(values[option])) throw new Error(`--${option} is ${words.join(" or ")}`);
  }
  return { ...values, garment: positionals[0], views, size };
}

const here = dirname(fileURLToPath(import.meta.url));
const three = join(here, "../../static/node_modules/three");

const PAGE = `<!doctype html><meta charset="utf-8"><title>render</title>
<script type="importmap">{"imports":{"three":"/three/build/three.module.js"}}</script>
<script type="module" src="/scene.js"></script>`;

/** Serves the page, three and the files; answers with its port. */
async function serve(files) {
  const own = { "/": ["text/html", PAGE], "/scene.js": ["text/javascript", `(${scene})();`] };
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    try {
      const [type, body] =
        own[pathname] ??
        (pathname.startsWith("/three/")
          ? ["text/javascript", await readFile(inside(three, pathname.slice("/three/".length)))]
          : ["model/gltf-binary", await readFile(files[pathname])]);
      response.writeHead(200, { "content-type": type }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return server;
}

function inside(folder, path) {
  const file = normalize(join(folder, path));
  if (!file.startsWith(folder + sep)) throw new Error("outside");
  return file;
}

/** Runs in the page, as a module: defines window.load and window.picture. */
async function scene() {
  const THREE = await import("three");
  const { GLTFLoader } = await import("/three/examples/jsm/loaders/GLTFLoader.js");
  const PANEL_COLOURS = [0x4f76a3, 0xc0714f, 0x7c9a5c, 0xd0a13f, 0x8a5a86, 0x5aa39b, 0xa8656f, 0x8d8468];
  const world = new THREE.Scene();
  world.background = new THREE.Color(0xe9e7e3);
  const camera = new THREE.PerspectiveCamera(22, 4 / 5, 0.05, 30);
  let renderer, centre, distance;

  const matte = (colour, more) => new THREE.MeshStandardMaterial({ color: colour, roughness: 0.85, ...more });

  /** Cloth: the outside in its colour, the inside darker. */
  function dress(mesh, colour, wire) {
    // Pushed back a little so that the wires lie on top.
    const back = { polygonOffset: wire, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    mesh.material = matte(colour, { side: THREE.FrontSide, ...back });
    const lining = matte(colour.clone().multiplyScalar(0.42), { side: THREE.BackSide, ...back });
    const extra = [new THREE.Mesh(mesh.geometry, lining)];
    if (wire) {
      const edges = new THREE.WireframeGeometry(mesh.geometry);
      extra.push(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({ color: 0x1c1c1c })));
    }
    return extra;
  }

  /** Light that goes with the camera: from every side the key comes from the upper left at a low angle, which shows folds. */
  function light() {
    const rig = new THREE.Group();
    const lamp = (colour, strength, x, y, z) => {
      const lamp = new THREE.DirectionalLight(colour, strength);
      lamp.position.set(x, y, z);
      rig.add(lamp, lamp.target);
    };
    lamp(0xfff6ea, 2.7, -1.8, 1.1, 0.7);
    lamp(0xdfe9ff, 0.7, 1.8, 0.2, 0.4);
    lamp(0xffffff, 0.35, 0, 0.2, 2);
    camera.add(rig);
    world.add(camera, new THREE.HemisphereLight(0xf4f6ff, 0x6f675e, 0.7));
  }

  window.load = async ({ avatar, width, height, colours, wire, frame }) => {
    const loader = new GLTFLoader();
    const garment = (await loader.loadAsync("/garment")).scene;
    world.add(garment);
    const body = avatar ? (await loader.loadAsync("/avatar")).scene : new THREE.Group();
    world.add(body);
    const cloth = [];
    garment.traverse((node) => node.isMesh && node.name !== "avatar" && cloth.push(node));
    const bodies = [];
    world.traverse((node) => node.isMesh && !cloth.includes(node) && bodies.push(node));
    for (const mesh of bodies) mesh.material = matte(0xa3a19e, { roughness: 1 });
    const box = new THREE.Box3();
    let vertices = 0, triangles = 0;
    for (const [i, mesh] of cloth.entries()) {
      const panel = new THREE.Color(PANEL_COLOURS[i % PANEL_COLOURS.length]);
      mesh.add(...dress(mesh, colours === "panel" ? panel : mesh.material.color.clone(), wire));
      box.expandByObject(mesh);
      vertices += mesh.geometry.attributes.position.count;
      triangles += (mesh.geometry.index?.count ?? 0) / 3;
    }
    if (cloth.length === 0 || frame === "all") for (const mesh of bodies) box.expandByObject(mesh);
    if (box.isEmpty()) throw new Error("nothing to draw");
    if (![...box.min, ...box.max].every(Number.isFinite)) throw new Error("positions that are not finite");
    light();
    // Far enough for the box from every side.
    const size = box.getSize(new THREE.Vector3());
    const across = Math.hypot(size.x, size.z);
    const half = Math.tan(THREE.MathUtils.degToRad(camera.fov / 2));
    centre = box.getCenter(new THREE.Vector3());
    distance = (1.1 * Math.max(size.y, across / camera.aspect)) / (2 * half) + across / 2;
    renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    renderer.setSize(2 * width, 2 * height, false);
    const { min, max } = box;
    return { panels: cloth.length, vertices, triangles, min: [...min], max: [...max] };
  };

  const sheet = [];
  const sized = (width, height) => Object.assign(document.createElement("canvas"), { width, height });

  /** Draws a view, twice as large and then reduced, as a data URL. */
  window.picture = ({ azimuth, elevation, width, height, name }) => {
    const [a, e] = [azimuth, elevation].map(THREE.MathUtils.degToRad);
    const from = new THREE.Vector3(Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e));
    camera.position.copy(centre).addScaledVector(from, distance);
    camera.lookAt(centre);
    renderer.render(world, camera);
    const canvas = sized(width, height);
    const pen = canvas.getContext("2d");
    pen.imageSmoothingQuality = "high";
    pen.drawImage(renderer.domElement, 0, 0, width, height);
    sheet.push({ canvas, name });
    return canvas.toDataURL("image/png");
  };

  /** All views so far beside each other, with their names. */
  window.sheet = ({ width, height }) => {
    const columns = Math.min(sheet.length, 5);
    const rows = Math.ceil(sheet.length / columns);
    const canvas = sized(columns * width, rows * height);
    const pen = canvas.getContext("2d");
    pen.font = `${Math.max(11, Math.round(width / 30))}px sans-serif`;
    pen.fillStyle = "#333";
    for (const [i, { canvas: view, name }] of sheet.entries()) {
      const [x, y] = [(i % columns) * width, Math.floor(i / columns) * height];
      pen.drawImage(view, x, y);
      pen.fillText(name, x + width / 40, y + height - width / 40);
    }
    return canvas.toDataURL("image/png");
  };
  window.ready = true;
}

const save = (file, dataUrl) => writeFile(file, Buffer.from(dataUrl.split(",")[1], "base64"));

async function draw(page, options) {
  const { views, size: width, out } = options;
  const height = Math.round(width * 1.25);
  const stem = basename(options.garment).replace(/\.[^.]*$/, "");
  await mkdir(out, { recursive: true });
  const shape = await page.evaluate((o) => window.load(o), { ...options, avatar: Boolean(options.avatar), width, height });
  const span = shape.min.map((low, k) => `${low.toFixed(3)}..${shape.max[k].toFixed(3)}`);
  console.log(`${shape.panels} panels, ${shape.vertices} vertices, ${shape.triangles} triangles, x ${span[0]} y ${span[1]} z ${span[2]} m`);
  for (const name of views) {
    const [azimuth, elevation] = VIEWS[name];
    const file = join(out, `${stem}-${name}.png`);
    await save(file, await page.evaluate((o) => window.picture(o), { azimuth, elevation, width, height, name }));
    console.log(file);
  }
  const file = join(out, `${stem}-sheet.png`);
  await save(file, await page.evaluate((o) => window.sheet(o), { width, height }));
  console.log(file);
}

async function main(options) {
  const files = { "/garment": options.garment, "/avatar": options.avatar };
  for (const file of Object.values(files)) if (file) await readFile(file);
  const server = await serve(files);
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
  });
  try {
    const page = await browser.newPage();
    page.on("pageerror", (error) => console.error(`page: ${error.message}`));
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    await page.waitForFunction(() => window.ready === true, null, { timeout: 60_000 });
    await draw(page, options);
  } finally {
    await browser.close();
    server.close();
  }
}

let options;
try {
  options = asked();
} catch (error) {
  console.error(`${error.message}\n${USAGE}`);
  process.exit(2);
}
try {
  await main(options);
} catch (error) {
  console.error(error.message);
  process.exit(1);
}
