// The page in a browser, as a user has it: `node tests/browser/page.mjs`.
// BASE is the address of a running service; without it SEAMSTER_BIN is started on a free port.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFaults, difference, openTab, startBrowser, startService } from "./support.mjs";

const FIT_MS = 300_000;
const { BASE, SEAMSTER_BIN } = process.env;

let service;
let browser;
let tab;
let page;
let emptyStage;

before(async () => {
  if (!BASE && !SEAMSTER_BIN) throw new Error("set BASE to a running service or SEAMSTER_BIN to the binary");
  service = BASE ? { url: BASE, stop: async () => {}, log: () => "" } : await startService(SEAMSTER_BIN);
  browser = await startBrowser();
  tab = await openTab(browser, service.url);
  page = tab.page;
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

const status = () => page.locator("#status").textContent();
const seams = () => page.locator("#seam-list .seam");
const edge = (panel, index) => page.locator(`path.edge[data-panel="${panel}"][data-edge="${index}"]`);
/** Opens a page of the drawer. */
async function openDrawer(name) {
  const tab = page.locator(`[data-drawer="${name}"]`);
  if (await tab.getAttribute("aria-expanded") === "false") await tab.click();
}
const until = (text) => page.waitForFunction((part) => document.getElementById("status").textContent.includes(part), text);

/** The body of the next check that the page asks for. */
async function checkedAfter(act) {
  const asked = page.waitForRequest((request) => request.url().endsWith("/seams/check"));
  await act();
  const request = await asked;
  assert.equal((await request.response()).status(), 200);
  return request.postDataJSON();
}

/** Clicks an edge at a fraction of its length, clockwise. */
async function clickEdge(panel, index, fraction) {
  const at = await edge(panel, index).evaluate((path, share) => {
    const { x, y } = path.getPointAtLength(path.getTotalLength() * share).matrixTransform(path.getScreenCTM());
    return { x, y };
  }, fraction);
  await page.mouse.click(at.x, at.y);
}

async function deleteSeam(id) {
  const count = await seams().count();
  const body = await checkedAfter(() => page.locator(`button[aria-label="Delete ${id}"], button[aria-label="Refuse ${id}"]`).click());
  assert.equal(body.seams.length, count - 1);
  assert.ok(!body.seams.some((seam) => seam.id === id));
}

/** Side A and B of a sample's seam with directions as the page states them. */
const SIDE = {
  a: { panel: "skirt-front", from: 1, to: 2, direction: "cw" },
  b: { panel: "skirt-back", from: 0, to: 4, direction: "ccw" },
};

async function assertNoAxeFaults() {
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    assert.deepEqual(await axeFaults(page), [], colorScheme);
  }
  await page.emulateMedia({ colorScheme: "light" });
}

test("the page opens and offers samples and fabrics", async () => {
  await page.waitForFunction(() => document.querySelectorAll("#default-fabric option").length >= 3);
  assert.equal(await page.title(), "Seamster");
  assert.ok(await page.locator("#run").isDisabled());
  await assertNoAxeFaults();
});

test("a file that is no pattern is refused with its reason", async () => {
  await page.setInputFiles("#open-file", { name: "letter.dxf", mimeType: "image/vnd.dxf", buffer: Buffer.from("Dear Sir or Madam") });
  await page.locator("#pattern-faults .fault code").first().waitFor({ state: "attached" });
  assert.match(await page.locator("#pattern-faults").textContent(), /pattern\//);
  const expected = tab.record.errors.splice(0);
  assert.ok(expected.every((text) => / 422 /.test(text)), expected.join("\n"));
});

test("the skirt sample shows its panels, corners and edges", async () => {
  await page.getByRole("button", { name: "Skirt sample" }).click();
  await until("seams can be sewn");
  assert.equal(await page.locator("#sheet [aria-label^='Panel ']").count(), 3);
  const pattern = await page.evaluate(() => fetch(`/v1/patterns/${new URLSearchParams(location.hash.slice(1)).get("pattern")}`).then((r) => r.json()));
  for (const { id, corners, edges } of pattern.panels) {
    assert.equal(await page.locator(`path.edge[data-panel="${id}"]`).count(), edges.length);
    assert.equal(edges.length, corners.length);
  }
  await openDrawer("seams");
  assert.equal(await seams().count(), 6);
  assert.equal(await page.locator(".seam-mark").count(), 6);
  assert.ok(await page.locator("#run").isEnabled());
});

test("the drawing is y up and clockwise", async () => {
  const area = await page.evaluate(() => [...document.querySelectorAll("path.cloth")].map((path) => {
    const points = path.getAttribute("d").match(/-?[\d.]+/g).map(Number);
    let sum = 0;
    for (let i = 0; i < points.length; i += 2) {
      const j = (i + 2) % points.length;
      sum += points[i] * points[j + 1] - points[j] * points[i + 1];
    }
    return sum;
  }));
  // With y down on the screen a clockwise outline has a positive area.
  assert.ok(area.every((sum) => sum > 0), String(area));
});

test("a seam is deleted and picked again by keyboard", async () => {
  await deleteSeam("side-left");
  await edge("skirt-front", 0).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  assert.match(await status(), /First side: .* 1 → 2, clockwise/);
  await page.locator(".pending .arrow").waitFor({ state: "attached" });
  await edge("skirt-back", 0).focus();
  await page.keyboard.press("ArrowLeft");
  const body = await checkedAfter(() => page.keyboard.press("Shift+Enter"));
  const { a, b } = body.seams.at(-1);
  assert.deepEqual({ a, b }, SIDE);
  await until("It can be sewn");
  assert.equal(await seams().count(), 6);
  assert.equal(await page.locator(".seam-mark.selected .thread").count(), 2);
  assert.equal(await page.locator(".seam-mark.selected .arrow").count(), 2);
});

test("a seam is deleted and picked again by pointer, the nearer end first", async () => {
  const name = await page.locator("#seam-list .seam.selected .choose").getAttribute("data-key");
  await deleteSeam(name.replace("choose ", ""));
  await clickEdge("skirt-front", 1, 0.2);
  assert.match(await status(), /1 → 2, clockwise/);
  const body = await checkedAfter(() => clickEdge("skirt-back", 4, 0.8));
  const { a, b } = body.seams.at(-1);
  assert.deepEqual({ a, b }, SIDE);
  await until("It can be sewn");
  await assertNoAxeFaults();
});

test("escape lets go of the first edge", async () => {
  await clickEdge("skirt-front", 2, 0.2);
  await page.locator(".pending").waitFor({ state: "attached" });
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.querySelectorAll(".pending").length === 0);
  assert.equal(await seams().count(), 6);
});

test("a bad pair says why and keeps the garment from being sewn", async () => {
  await clickEdge("skirt-front", 2, 0.2);
  await checkedAfter(() => clickEdge("waistband", 5, 0.2));
  await until("cannot be sewn");
  const faults = page.locator("#seam-list .seam.selected .fault");
  assert.ok(await faults.count() > 0);
  assert.match(await faults.first().textContent(), /seam\/\w+ at \/seams\/6/);
  assert.ok(await page.locator("#run").isDisabled());
  await assertNoAxeFaults();
  await checkedAfter(() => page.getByRole("button", { name: "Undo" }).click());
  await until("All 6 seams can be sewn");
  assert.ok(await page.locator("#run").isEnabled());
});

test("a seam picked the wrong way round offers its correction", async () => {
  await checkedAfter(() => page.getByRole("button", { name: "Reverse side-right", exact: true }).click());
  await until("cannot be sewn");
  const body = await checkedAfter(() => page.getByRole("button", { name: /^Use the correction/ }).first().click());
  const right = body.seams.find((seam) => seam.id === "side-right");
  assert.deepEqual([right.a.from, right.a.to, right.b.from, right.b.to], [0, 3, 2, 3]);
  await until("can be sewn.");
  assert.equal(await page.locator("#seam-list .seam.bad").count(), 0);
});

test("seams are put in another order of sewing", async () => {
  const ids = () => page.locator("#seam-list .choose").evaluateAll((rows) => rows.map((row) => row.dataset.key));
  const [first, second] = await ids();
  await page.getByRole("button", { name: `Sew later ${first.replace("choose ", "")}`, exact: true }).click();
  await page.waitForFunction((key) => document.querySelector("#seam-list .choose").dataset.key === key, second);
  assert.deepEqual((await ids()).slice(0, 2), [second, first]);
});

test("fabric and body go into the garment that is sewn, and the fit runs to the end", async () => {
  await page.locator("#stage-note").evaluate((note) => { note.style.visibility = "hidden"; });
  emptyStage = await page.locator("#stage").screenshot();
  await page.locator("#edge-length").selectOption("0.02");
  await page.locator("[data-row=waistband] summary").click();
  await page.getByLabel("Fabric of WAISTBAND").selectOption("cotton-poplin");
  // A skirt does not touch the bust: the shape stays the sample's.
  const bust = page.getByLabel("Bust, cm");
  await bust.fill("93");
  await bust.press("Tab");
  const asked = page.waitForRequest((request) => request.url().endsWith("/v1/fits") && request.method() === "POST");
  await page.getByRole("button", { name: "Sew and drape" }).press("Enter");
  const body = (await asked).postDataJSON();
  assert.equal(body.panels.waistband.fabric, "cotton-poplin");
  assert.equal(body.avatar.form.bust_m, 0.93);
  assert.equal(body.simulate.edge_length_m, 0.02);
  await page.locator("#progress").waitFor({ state: "visible" });
  assert.equal(await page.evaluate(() => document.activeElement.id), "cancel", "the focus stays where the button was");
  await page.locator("#report .verdict").waitFor({ state: "attached", timeout: FIT_MS });
  await openDrawer("report");
  assert.equal(await page.locator("#fit-faults").textContent(), "");
  assert.match(await page.locator("#report").textContent(), /The garment came to rest.*All seams are closed/s);
  await page.locator("#stage canvas").waitFor();
});

test("the garment is seen in 3D from its sides", async () => {
  const view = async (name) => {
    await page.getByRole("button", { name, exact: true }).click();
    await page.waitForTimeout(1500);
    return page.locator("#stage").screenshot();
  };
  await page.locator("#stage-note").waitFor({ state: "hidden" });
  const [front, left] = [await view("Front"), await view("Left")];
  // The garment fills at least a tenth of the stage, whatever the shape of the window.
  assert.ok(await difference(browser, emptyStage, front) > 0.1);
  assert.ok(await difference(browser, front, left) > 0.01);
  await page.locator("#show-body").uncheck();
  const alone = await view("Left");
  assert.ok(await difference(browser, left, alone) > 0.005);
  assert.ok(await difference(browser, emptyStage, alone) > 0.05);
  await page.locator("#show-body").check();
  await page.locator("#stage canvas").focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForTimeout(1500);
  assert.ok(await difference(browser, left, await page.locator("#stage").screenshot()) > 0.005);
  await assertNoAxeFaults();
});

test("the result and the garment file are downloaded", async () => {
  const download = async (name) => {
    const waiting = page.waitForEvent("download");
    await (name === "Save garment" ? page : page.locator("#downloads")).getByRole("button", { name, exact: true }).click();
    return readFile(await (await waiting).path());
  };
  const glb = await download("GLB");
  assert.equal(glb.subarray(0, 4).toString(), "glTF");
  assert.equal(glb.readUInt32LE(8), glb.length);
  assert.match((await download("OBJ")).toString(), /^v /m);
  assert.equal(JSON.parse(await download("JSON")).panels.length, 3);
  assert.equal(JSON.parse(await download("Report")).converged, true);
  const garment = JSON.parse(await download("Save garment"));
  assert.equal(garment.seams.length, 6);
  assert.equal(garment.pattern.panels.length, 3);
});

test("a reload shows the same fit and garment", async () => {
  await page.reload();
  await page.locator("#report .verdict").waitFor({ state: "attached" });
  assert.equal(await seams().count(), 6);
  assert.equal(await page.getByLabel("Bust, cm").inputValue(), "93");
  await page.locator("#stage canvas").waitFor();
  assert.equal(await page.locator("#run-note").textContent(), "");
});

test("a change asks for another run, which can be canceled", async () => {
  await page.locator("#edge-length").selectOption("0.008");
  await page.waitForFunction(() => document.getElementById("run-note").textContent.startsWith("Changed since"));
  await page.getByRole("button", { name: "Sew again" }).click();
  await page.getByRole("button", { name: "Cancel", exact: true }).click();
  await page.locator("#progress").waitFor({ state: "hidden", timeout: 10_000 });
  const id = await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("fit"));
  const fit = await page.evaluate((of) => fetch(`/v1/fits/${of}`).then((response) => response.json()), id);
  assert.equal(fit.status, "canceled");
  await page.locator("#stage-caption", { hasText: /earlier fit|Stopped/ }).waitFor();
  assert.ok(await page.locator("#run").isEnabled());
  const missing = tab.record.errors.splice(0);
  assert.ok(missing.every((text) => / 404 /.test(text)), missing.join("\n"));
});

test("a saved garment opens again", async () => {
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save garment" }).click();
  const file = await (await waiting).path();
  await openDrawer("seams");
  await deleteSeam("side-right");
  await page.setInputFiles("#open-file", { name: "skirt.garment.json", mimeType: "application/json", buffer: await readFile(file) });
  await until("All 6 seams can be sewn");
  assert.equal(await seams().count(), 6);
});

const suggested = () => page.locator("#seam-list .tag");

async function choosePattern(name, buffer) {
  await page.setInputFiles("#open-file", { name, mimeType: "application/octet-stream", buffer });
}

/** Presses the button by keyboard; the answer of the service. */
async function suggest() {
  const answered = page.waitForResponse((response) => response.url().endsWith("/seams/suggest"));
  await page.getByRole("button", { name: "Suggest seams" }).press("Enter");
  return (await answered).json();
}

test("seams of a bare pattern are suggested with how sure they are and why, and undone", async () => {
  await choosePattern("skirt.dxf", await readFile(new URL("../../static/samples/skirt.dxf", import.meta.url)));
  await until("have the seams suggested");
  assert.equal(await seams().count(), 0);
  let found;
  const body = await checkedAfter(async () => { found = await suggest(); });
  const plain = found.seams.map(({ confidence, because, ...seam }) => seam);
  assert.ok(plain.length > 0);
  assert.deepEqual(body.seams, plain);
  for (const { id } of body.seams) assert.ok(found.seams.some((seam) => seam.id === id && seam.because));
  assert.deepEqual(body.panels, found.panels);
  await until("can be sewn");
  assert.match(await status(), new RegExp(`^${plain.length} seams suggested`));
  assert.equal(await suggested().count(), plain.length);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.key), "suggest", "the focus stays on the button");
  const [first] = found.seams;
  const row = page.locator("#seam-list .seam").first();
  assert.equal(await row.locator(".choose").getAttribute("title"), first.because);
  await row.locator(".choose").click();
  assert.match(await row.locator(".more").textContent(), /Suggested, \d+ % sure: /);
  await assertNoAxeFaults();
  await page.getByRole("button", { name: "Undo" }).click();
  await page.waitForFunction(() => document.querySelectorAll("#seam-list .seam").length === 0);
  await checkedAfter(suggest);
  assert.equal(await suggested().count(), plain.length);
});

test("what was picked stays, and a suggestion that was changed is no longer one", async () => {
  await until("can be sewn");
  const count = await seams().count();
  const id = (await page.locator("#seam-list .choose").first().getAttribute("data-key")).replace("choose ", "");
  await deleteSeam(id);
  const body = await checkedAfter(suggest);
  assert.equal(body.seams.length, count);
  await until(`1 seam suggested, ${count - 1} left as they were picked`);
  await suggest();
  await until("Nothing to add");
  assert.equal(await seams().count(), count);
  await checkedAfter(() => page.getByRole("button", { name: `Reverse ${id}`, exact: true }).click());
  assert.equal(await suggested().count(), count - 1);
  await checkedAfter(() => page.getByRole("button", { name: "Undo" }).click());
  await page.waitForFunction((all) => document.querySelectorAll("#seam-list .tag").length === all, count);
});

test("suggested seams are sewn, and a reload still says that they were suggested", async () => {
  await page.locator("#edge-length").selectOption("0.02");
  const count = await seams().count();
  await page.getByRole("button", { name: "Sew and drape" }).click();
  await page.locator("#report .verdict").waitFor({ state: "attached", timeout: FIT_MS });
  await openDrawer("report");
  assert.match(await page.locator("#report").textContent(), /The garment came to rest.*All seams are closed/s);
  await page.reload();
  await page.locator("#report .verdict").waitFor({ state: "attached" });
  assert.equal(await suggested().count(), count);
  assert.equal(await page.locator("#run-note").textContent(), "");
});

/** A top with one sleeve drawn and a pole beside it, as GarmentCode writes it [cm]. */
function topWithSleeve() {
  const edge = (from, count, curve) => ({ endpoints: [from, (from + 1) % count], ...(curve && { curvature: { type: "quadratic", params: [curve] } }) });
  const half = [[-24, 0], [-24, 42], [-18, 64], [-8, 68], [8, 68], [18, 64], [24, 42], [24, 0]];
  const hollow = { 1: [0.5, -0.15], 5: [0.5, -0.15] };
  const panel = (vertices, curves = {}, z = 0) => ({
    translation: [0, 90, z], rotation: [0, 0, 0], vertices,
    edges: vertices.map((_, i) => edge(i, vertices.length, curves[i])),
  });
  const front = panel(half, { ...hollow, 3: [0.5, -0.4] }, 25);
  const back = panel(half, { ...hollow, 3: [0.5, -0.1] }, -25);
  const sleeve = panel([[-15, 0], [-20, 12], [0, 27], [20, 12], [15, 0]], { 1: [0.5, 0.12], 2: [0.5, 0.12] });
  const pole = panel([[0, 0], [3, 40], [1, -10]]);
  return { pattern: { panels: { front, back, sleeve, pole }, stitches: [] }, properties: { units_in_meter: 100 } };
}

test("a specification opens, its sleeve is mirrored and its spare panel left out", async () => {
  await choosePattern("top_specification.json", Buffer.from(JSON.stringify(topWithSleeve())));
  await until("have the seams suggested");
  assert.equal(await page.locator("#sheet [aria-label^='Panel ']").count(), 4);
  const body = await checkedAfter(suggest);
  await until("can be sewn");
  assert.ok(JSON.stringify(body.seams).includes("sleeve~mirror"));
  assert.equal(await page.locator("#sheet [aria-label='Panel sleeve, mirrored']").count(), 1);
  assert.equal(await page.locator("#sheet [aria-label='Panel pole, left out']").count(), 1);
  const length = (panel) => edge(panel, 1).evaluate((path) => path.getTotalLength());
  assert.ok(Math.abs(await length("sleeve") - await length("sleeve~mirror")) < 1e-3);
  await edge("sleeve~mirror", 0).focus();
  await page.keyboard.press("Enter");
  assert.match(await status(), /sleeve, mirrored 0 → 1, counter-clockwise/);
  await page.keyboard.press("Escape");
  await assertNoAxeFaults();
  const asked = page.waitForRequest((request) => request.url().endsWith("/v1/fits") && request.method() === "POST");
  await page.getByRole("button", { name: "Sew and drape" }).click();
  const request = await asked;
  assert.deepEqual(request.postDataJSON().pattern.panels.map((panel) => panel.id).sort(), ["back", "front", "sleeve"]);
  assert.equal((await request.response()).status(), 202);
  await page.getByRole("button", { name: "Cancel", exact: true }).click();
  await page.locator("#progress").waitFor({ state: "hidden", timeout: 10_000 });
  const missing = tab.record.errors.splice(0);
  assert.ok(missing.every((text) => / 404 /.test(text)), missing.join("\n"));
});

test("a garment file that leaves its seams to the service has them suggested", async () => {
  const garment = JSON.parse(await readFile(new URL("../../static/samples/skirt.garment.json", import.meta.url)));
  await page.getByRole("button", { name: "Skirt sample" }).click();
  await until("All 6 seams can be sewn");
  const buffer = Buffer.from(JSON.stringify({ ...garment, seams: "suggest" }));
  await page.setInputFiles("#open-file", { name: "suggest.json", mimeType: "application/json", buffer });
  await until("seams suggested");
  assert.ok(await suggested().count() > 0);
});

test("a nest of sizes is read by size, or as drawn lines where the user says so", async () => {
  const outline = (k) => [[-200, 300], [200, 300], [260, -300], [-260, -300]].map(([x, y]) => `10\n${k * x}\n20\n${k * y}\n`).join("");
  const sizes = [0.96, 1, 1.04].map((k, i) => `0\nLWPOLYLINE\n8\n${38 + 2 * i}\n90\n4\n70\n1\n${outline(k)}`).join("");
  const dxf = `0\nSECTION\n2\nENTITIES\n${sizes}0\nENDSEC\n0\nEOF\n`;
  await page.setInputFiles("#open-file", { name: "nest.dxf", mimeType: "image/vnd.dxf", buffer: Buffer.from(dxf) });
  await page.waitForFunction(() => document.querySelectorAll("#import-size option").length >= 3);
  const sent = page.waitForRequest((request) => request.url().includes("/v1/patterns?"));
  await page.locator("#reading summary").click();
  await page.getByLabel("Outlines inside others").selectOption("lines");
  const request = await sent;
  assert.ok(request.url().includes("outlines=lines"));
  const pattern = await (await request.response()).json();
  assert.deepEqual([pattern.source.sizes.length, pattern.panels.length], [0, 1]);
  assert.equal(pattern.panels[0].internal_lines.length, 2);
  await assertNoAxeFaults();
});

test("names from files are text, never markup", async () => {
  const pattern = await page.evaluate(() => fetch(`/v1/patterns/${new URLSearchParams(location.hash.slice(1)).get("pattern")}`).then((r) => r.json()));
  pattern.name = "<img src=x onerror=document.title='broken'>";
  delete pattern.id;
  for (const panel of pattern.panels) panel.name = "<b id=injected>x</b>";
  const buffer = Buffer.from(JSON.stringify({ schema: "seamster/garment/1", pattern, seams: [] }));
  await page.setInputFiles("#open-file", { name: "odd.json", mimeType: "application/json", buffer });
  await page.waitForFunction(() => document.getElementById("pattern-facts").textContent.includes("<img src=x"));
  assert.equal(await page.locator("#injected, main img").count(), 0);
  assert.equal(await page.title(), "Seamster");
});

test("nothing left the origin, broke the policy or failed", () => {
  // A fit that was canceled before it had a shape has no report.
  tab.record.errors = tab.record.errors.filter((text) => !/ 404 .*\/report/.test(text));
  assert.deepEqual(tab.record, { foreign: [], errors: [], breaches: [] });
});

test("no part is cut off at 800, 1280 and 1920 pixels", async () => {
  for (const viewport of [{ width: 800, height: 900 }, { width: 1280, height: 800 }, { width: 1920, height: 1080 }]) {
    await page.setViewportSize(viewport);
    await page.waitForTimeout(300);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `${viewport.width}: ${wide} px too wide`);
    const scrolled = await page.evaluate(() => [...document.querySelectorAll(".bar, .rail, .pane-head, .drawer")]
      .filter((step) => step.scrollWidth > step.clientWidth).map((step) => step.className));
    assert.deepEqual(scrolled, [], `${viewport.width}: wider than their columns`);
    assert.deepEqual(await axeFaults(page), []);
  }
});

test("a service with tokens is used after the token was given once", { skip: BASE ? "BASE names a service without tokens" : false }, async () => {
  const token = "a-token-for-this-test-alone";
  const guarded = await startService(SEAMSTER_BIN, { SEAMSTER_TOKENS: token });
  try {
    const { page: tokenPage, record, context } = await openTab(browser, guarded.url);
    await tokenPage.locator("#token-dialog[open]").waitFor();
    assert.deepEqual(await axeFaults(tokenPage), []);
    await tokenPage.getByLabel("Token", { exact: true }).fill("wrong");
    await tokenPage.keyboard.press("Enter");
    await tokenPage.locator("#token-why", { hasText: "refused" }).waitFor();
    await tokenPage.getByLabel("Token", { exact: true }).fill(token);
    await tokenPage.keyboard.press("Enter");
    await tokenPage.getByRole("button", { name: "Top sample" }).click();
    await tokenPage.waitForFunction(() => document.getElementById("status").textContent.includes("can be sewn"));
    assert.equal(await tokenPage.locator("#sheet [aria-label^='Panel ']").count(), 2);
    assert.ok(record.errors.every((text) => / 401 /.test(text)), record.errors.join("\n"));
    assert.deepEqual([record.foreign, record.breaches], [[], []]);
    await context.close();
  } finally {
    await guarded.stop();
  }
});
