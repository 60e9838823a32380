// The stage, what it shows and how it looks: `node tests/browser/stage.mjs`.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, test } from "node:test";
import { openSkirt, press, savedGarment, twoFrames, undo, untilKept, untilShown, untilStatus } from "./acts.mjs";
import { assertAccessible, assertClean, difference, startPage } from "./support.mjs";

const { page, browser, record, close } = await startPage();
after(close);

const stage = () => page.locator("#stage");

/** The stage as it is drawn at last. */
async function seen() {
  await twoFrames(page);
  return stage().screenshot();
}

test("an empty stage has nothing to turn or to take a picture of", async () => {
  for (const name of ["Whole", "Front", "Picture"]) assert.ok(await page.getByRole("button", { name, exact: true }).isDisabled(), name);
});

test("every view holds garment and body in frame, in windows of any shape", async () => {
  const outside = await page.evaluate(async () => {
    const [THREE, { frame, newCamera }] = [await import("three"), await import("/stage/camera.js")];
    const box = new THREE.Box3(new THREE.Vector3(-0.3, 0, -0.2), new THREE.Vector3(0.3, 1.6, 0.25));
    const found = [];
    for (const aspect of [0.4, 0.8, 1, 2.5]) for (const view of ["whole", "front", "back", "left", "right"]) {
      const camera = newCamera();
      camera.aspect = aspect;
      camera.updateProjectionMatrix();
      frame(camera, box, view, 0.8);
      camera.updateMatrixWorld();
      const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => new THREE.Vector3(x * 0.3, 0.8 + y * 0.8, z * 0.2))));
      const reach = corners.map((corner) => corner.project(camera)).map(({ x, y }) => Math.max(Math.abs(x), Math.abs(y) / 0.8));
      if (Math.max(...reach) > 1 || Math.max(...reach) < 0.6) found.push([aspect, view, Math.max(...reach)]);
    }
    return found;
  });
  assert.deepEqual(outside, []);
});

test("the whole body stands on a floor that it darkens", async () => {
  await openSkirt(page, "Try the skirt");
  await page.locator("#run:enabled").click();
  await untilShown(page);
  await untilStatus(page, "came to rest");
  const whole = await seen();
  // Below the feet the floor is darker than beside them.
  const [under, beside] = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
    pen.drawImage(image, 0, 0);
    const shade = (x, y) => {
      const { data } = pen.getImageData(Math.round(x * image.width), Math.round(y * image.height), 8, 4);
      return data[0] + data[1] + data[2];
    };
    return [shade(0.5, 0.91), shade(0.06, 0.91)];
  }, whole.toString("base64"));
  assert.ok(under < beside - 30, `${under} under the body, ${beside} beside it`);
  await press(page, "Front");
  assert.ok(await difference(browser, whole, await seen()) > 0.02);
  await press(page, "Whole");
  // The button under the pointer looks other than it did.
  assert.ok(await difference(browser, whole, await seen()) < 0.008, "the whole comes back");
});

test("a picture of what is seen is downloaded", async () => {
  const waiting = page.waitForEvent("download");
  await press(page, "Picture");
  const download = await waiting;
  assert.equal(download.suggestedFilename(), "A-LINE-SKIRT.png");
  const picture = await readFile(await download.path());
  const box = await stage().boundingBox();
  assert.deepEqual([picture.readUInt32BE(16), picture.readUInt32BE(20)], [Math.round(box.width), Math.round(box.height)]);
  const caption = await page.locator("#stage-caption").textContent();
  assert.equal(caption, "", "nothing is wrong");
  assert.ok(picture.length > 10_000);
});

const view = (name) => page.locator(`[data-fit-view="${name}"]`);
const legend = () => page.locator("#legend");

test("scales of color go from dark to light, or to dark at both ends", async () => {
  const scales = await page.evaluate(async () => {
    const { colorsOf } = await import("/stage/palette.js");
    return ["sequence", "diverging"].map((scale) => {
      const bytes = colorsOf(scale, 65);
      return Array.from({ length: 65 }, (_, i) => 0.21 * bytes[4 * i] + 0.72 * bytes[4 * i + 1] + 0.07 * bytes[4 * i + 2]);
    });
  });
  const rises = (shades) => shades.every((shade, i) => i === 0 || shade > shades[i - 1]);
  const [sequence, diverging] = scales;
  assert.ok(rises(sequence));
  assert.ok(rises(diverging.slice(0, 33)) && rises(diverging.slice(32).reverse()));
});

test("the maps of the fit are seen on the cloth, with units, error and words", async () => {
  await press(page, "Front");
  const cloth = await seen();
  const said = {
    strain_warp: /^-\d.*%.*± \d.*by the mesh.*(Stretched most: \+.* %, in [A-Z ]+|stretched nowhere)/,
    strain_share: /^0\.0 %50 %100 %over.*± .*At most \d.*% of what the fabric gives, in [A-Z ]+.*: there is room to move\./,
    pressure: /^0\.00 kPa.*± .* kPa by the mesh.*Presses most with .* kPa, in /,
    gap: /^0 mm.*± .* mm by the mesh.*On average from the waist \d+ mm, hip \d+ mm/,
  };
  for (const [name, words] of Object.entries(said)) {
    await view(name).press("Enter");
    await page.locator(`[data-fit-view="${name}"][aria-pressed="true"]`).waitFor();
    await page.waitForFunction((text) => new RegExp(text).test(document.getElementById("legend").textContent), words.source);
    assert.ok(await difference(browser, cloth, await seen()) > 0.05, name);
  }
  await assertAccessible(page);
});

test("a picture of a map has its colors and ends", async () => {
  await view("pressure").click();
  await page.waitForFunction(() => document.getElementById("legend").textContent.includes("kPa"));
  const waiting = page.waitForEvent("download");
  await press(page, "Picture");
  const picture = await readFile(await (await waiting).path());
  const colors = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
    pen.drawImage(image, 0, 0);
    // Three lines below the bar: name, error, words.
    return [16, 208].map((x) => [...pen.getImageData(x, image.height - 12 - 3 * 20 - 5, 1, 1).data.slice(0, 3)]);
  }, picture.toString("base64"));
  const near = (color, other) => color.every((one, i) => Math.abs(one - other[i]) < 24);
  assert.ok(near(colors[0], [0x44, 0x01, 0x54]) && near(colors[1], [0xfd, 0xe7, 0x25]), JSON.stringify(colors));
  await view("gap").click();
  await page.waitForFunction(() => document.getElementById("legend").textContent.includes("On average"));
});

test("a probe says panel and value under the pointer, and the panel is pointed at", async () => {
  const { x, y, width, height } = await stage().boundingBox();
  await page.mouse.move(x + width / 2, y + height * 0.6);
  const probe = page.locator("#probe:not([hidden])");
  await probe.waitFor();
  const text = await probe.textContent();
  const [, gap] = /^SKIRT FRONT: ([\d.]+) mm from the body$/.exec(text) ?? assert.fail(text);
  assert.ok(Number(gap) >= 0 && Number(gap) < 300);
  assert.equal(await page.locator(".panel-row.pointed").getAttribute("data-row"), "skirt-front");
  await page.mouse.move(x + 12, y + height / 2);
  await probe.waitFor({ state: "hidden" });
});

test("the place of the largest value is shown", async () => {
  await view("strain_share").click();
  const words = legend().getByRole("button");
  await words.waitFor();
  const before = await seen();
  await words.press("Enter");
  await twoFrames(page);
  assert.ok(await difference(browser, before, await seen()) > 0.0005);
  await view("cloth").click();
  await legend().waitFor({ state: "hidden" });
});

test("the kind of a fabric is told by its name, else by its figures", async () => {
  const kinds = await page.evaluate(async () => {
    const [{ kindOf }, { fabrics }] = [await import("/fabric/looks.js"), await (await fetch("/v1/fabrics")).json()];
    const stiff = { name: "Number 7", stretch_warp_n_m: 9000, stretch_weft_n_m: 4000 };
    const soft = { ...stiff, stretch_warp_n_m: 90, stretch_weft_n_m: 200 };
    return { ...Object.fromEntries(fabrics.map(({ id, ...fabric }) => [id, kindOf(id, fabric)])), stiff: kindOf("x", stiff), soft: kindOf("x", soft) };
  });
  const { "denim-11oz": denim, "jersey-knit": jersey, "silk-satin": satin, "cotton-poplin": poplin, chiffon, stiff, soft } = kinds;
  assert.deepEqual([denim, jersey, satin, poplin, chiffon, stiff, soft], ["denim", "knit", "satin", "woven", "sheer", "woven", "knit"]);
});

test("the inside of cloth is lighter, satin shines where a weave does not, and near by a weave is seen", async () => {
  const { outside, inside, satin, threads, plain } = await page.evaluate(async () => {
    const [THREE, { clothMaterial }] = [await import("three"), await import("/stage/materials.js")];
    const renderer = new THREE.WebGLRenderer();
    renderer.setSize(64, 64);
    const camera = new THREE.PerspectiveCamera(40, 1, 0.001, 10);
    /** Shades of a piece of cloth a meter wide, seen from a distance. */
    const shades = (kind, { turned = 0, away = 1.2 } = {}) => {
      const [scene, lamp] = [new THREE.Scene(), new THREE.DirectionalLight(0xffffff, 1)];
      lamp.position.set(0, 0.05, 1);
      const cloth = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), clothMaterial({ kind, color: "#8a98a8" }));
      cloth.rotation.y = turned;
      camera.position.z = away;
      scene.add(new THREE.AmbientLight(0xffffff, 1), lamp, cloth);
      renderer.render(scene, camera);
      const pixels = new Uint8Array(64 * 64 * 4);
      const gl = renderer.getContext();
      gl.readPixels(0, 0, 64, 64, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return Array.from({ length: 32 * 32 }, (_, i) => pixels[4 * (64 * (16 + (i >> 5)) + 16 + (i & 31)) + 1]);
    };
    const mean = (all) => all.reduce((sum, one) => sum + one) / all.length;
    const spread = (all) => (Math.max(...all) - Math.min(...all)) / mean(all);
    return {
      outside: mean(shades("woven")), inside: mean(shades("woven", { turned: Math.PI })), satin: mean(shades("satin")),
      threads: spread(shades("denim", { away: 0.02 })), plain: spread(shades("leather", { away: 0.02 })),
    };
  });
  assert.ok(inside > outside + 10, `${inside} inside, ${outside} outside`);
  assert.ok(satin > outside + 5, `${satin} of satin, ${outside} of poplin`);
  assert.ok(threads > plain + 0.1, `${threads} of denim, ${plain} of leather`);
});

test("a color is seen at once, undone, kept over a reload, and sent to nobody", async () => {
  let sent = 0;
  const count = (request) => { sent += request.method() === "POST"; };
  const before = await seen();
  const garment = await savedGarment(page);
  page.on("request", count);
  const brick = page.getByRole("button", { name: "Cotton poplin in Brick" });
  await brick.click();
  const colored = await seen();
  assert.ok(await difference(browser, before, colored) > 0.05);
  await undo(page);
  assert.ok(await difference(browser, before, await seen()) < 0.008);
  await press(page, "Redo");
  const field = page.getByLabel("Color of Cotton poplin");
  await field.evaluate((input) => {
    for (const [color, type] of [["#112233", "input"], ["#3f7f84", "input"], ["#3f7f84", "change"]]) {
      input.value = color;
      input.dispatchEvent(new Event(type, { bubbles: true }));
    }
  });
  await undo(page);
  assert.equal(await field.inputValue(), "#9c4a3c", "what was tried is one change");
  assert.deepEqual(await savedGarment(page), garment);
  page.off("request", count);
  assert.equal(sent, 0);
  await untilKept(page);
  await page.reload();
  await untilShown(page);
  assert.equal(await field.inputValue(), "#9c4a3c");
  assert.equal(await page.locator("#run-note").textContent(), "", "the result is up to date still");
  await press(page, "Front");
  assert.ok(await difference(browser, colored, await seen()) < 0.01);
  await assertAccessible(page);
});

test("another fabric is seen at once on the shape that there is", async () => {
  const before = await seen();
  await page.locator("#default-fabric").selectOption("denim-11oz");
  await page.locator("#stage-caption", { hasText: "As it was before the last changes" }).waitFor();
  assert.ok(await difference(browser, before, await seen()) > 0.05);
  assert.equal(await page.locator(".fabric-row small").textContent(), "denim");
  await undo(page);
});

test("maps that a fit does not have are not offered, and it is said why", async () => {
  for (const [kept, why] of [[[], "This fit has no maps"], [["strain_warp", "strain_share"], "without a body"]]) {
    await page.route(/\/report$/, async (route) => {
      const response = await route.fetch();
      const report = await response.json();
      report.maps = report.maps.filter(({ name }) => kept.includes(name));
      await route.fulfill({ response, json: report });
    });
    await page.reload();
    await untilShown(page);
    await page.unrouteAll({ behavior: "wait" });
    assert.match(await page.locator("#fit-views-why").textContent(), new RegExp(why));
    const names = await page.locator("[data-fit-view]").evaluateAll((buttons) => buttons.map((button) => button.dataset.fitView));
    assert.deepEqual(names, kept.length > 0 ? ["cloth", ...kept] : []);
  }
});

test("crossings are marked where the report has them, and the stage says that the result is not good", async () => {
  const before = await seen();
  await page.route(/\/report$/, async (route) => {
    const response = await route.fetch();
    const report = await response.json();
    report.good = { ok: false, failed: ["crossings", "body"], because: ["cloth passes through cloth at 2 places", "cloth passes through the body"] };
    const at = (kind, x, y) => ({ kind, panels: ["skirt-front", "skirt-back"], at: [x, y, 0.15], count: 3 });
    report.intersections = [at("cloth", 0, 0.9), at("degenerate", 0.05, 0.6), at("inside_body", -0.1, 0.8)];
    await route.fulfill({ response, json: report });
  });
  await page.reload();
  await untilShown(page);
  await page.unrouteAll({ behavior: "wait" });
  assert.equal(await page.locator("#stage-caption").textContent(),
    "✗ The garment came to rest, but it is not right. · ○ 2 places where cloth crosses cloth · □ 1 place where cloth crosses the body");
  await untilStatus(page, "Cloth passes through cloth at 2 places");
  assert.ok(await page.locator("#stage.bad").count());
  assert.ok(await page.locator("#status.bad").count());
  assert.ok(await difference(browser, before, await seen()) > 0.002);
  await assertAccessible(page);
  await page.reload();
  await untilShown(page);
  assert.equal(await page.locator("#stage.bad").count(), 0);
});

test("ten thousand vertices keep no script busy for 100 ms", async () => {
  const slow = await page.evaluate(async () => {
    const [THREE, { Viewer }, { MAPS }, rings] = await Promise.all(
      ["three", "/stage/viewer.js", "/stage/maps.js", "/stage/rings.js"].map((path) => import(path)));
    const host = document.body.appendChild(document.createElement("div"));
    host.style.cssText = "width: 200px; height: 200px";
    const viewer = new Viewer(host);
    const quarter = (i) => {
      const geometry = new THREE.CylinderGeometry(0.2, 0.3, 0.8, 50, 49, true, (i * Math.PI) / 2, Math.PI / 2).translate(0, 0.9, 0);
      for (const [name, size] of [["_strain", 2], ["_strain_share", 1], ["_pressure", 1], ["_gap", 1]]) {
        geometry.setAttribute(name, new THREE.BufferAttribute(Float32Array.from({ length: size * geometry.attributes.position.count }, Math.random), size));
      }
      return Object.assign(new THREE.Mesh(geometry, new THREE.MeshStandardMaterial()), { userData: { panel: `p${i}` } });
    };
    const model = new THREE.Group().add(...[0, 1, 2, 3].map(quarter));
    const look = () => ({ kind: "knit", color: "#8fb0cf" });
    const acts = {
      show: () => viewer.showGarment(model.clone(), look),
      restyle: () => viewer.restyle(look),
      map: () => viewer.showMap(MAPS.pressure),
      probe: () => viewer.probe(100, 100),
      girth: () => rings.girthLines(model.children, { at: "waist", height_m: 1 }),
      opening: () => rings.openingLines(model.children, { panels: ["p0"], height_m: 1.3, length_m: 1 }),
    };
    const times = Object.entries(acts).map(([name, act]) => [name, Math.min(...[0, 1, 2].map(() => {
      const start = performance.now();
      act();
      return performance.now() - start;
    }))]);
    host.remove();
    return times.filter(([, time]) => time >= 100);
  });
  assert.deepEqual(slow, []);
});

test("all that the page loads is 400 KB compressed", async () => {
  const weight = await page.evaluate(async () => {
    const sizeOf = async (url) => {
      const zipped = (await fetch(url)).body.pipeThrough(new CompressionStream("gzip"));
      return (await new Response(zipped).arrayBuffer()).byteLength;
    };
    const own = performance.getEntriesByType("resource").map(({ name }) => name).filter((name) => /\.(js|css|svg)$/.test(name));
    const sizes = await Promise.all([...new Set([...own, location.pathname])].map(sizeOf));
    return { count: sizes.length, bytes: sizes.reduce((sum, size) => sum + size) };
  });
  console.log(`${weight.count} files, ${(weight.bytes / 1024).toFixed(0)} KB compressed`);
  assert.ok(weight.count > 60 && weight.bytes <= 400 * 1024, JSON.stringify(weight));
});

test("nothing else failed", () => assertClean(record));
