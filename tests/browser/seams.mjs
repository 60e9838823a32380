// All kinds of seams by hand, and proposals: `node tests/browser/seams.mjs`.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFaults, openTab, startBrowser, startService } from "./support.mjs";

const { BASE, SEAMSTER_BIN } = process.env;

let service;
let browser;
let page;
let record;

before(async () => {
  if (!BASE && !SEAMSTER_BIN) throw new Error("set BASE to a running service or SEAMSTER_BIN to the binary");
  service = BASE ? { url: BASE, stop: async () => {} } : await startService(SEAMSTER_BIN);
  browser = await startBrowser();
  ({ page, record } = await openTab(browser, service.url));
  await page.setInputFiles("#open-file", new URL("../../static/samples/skirt.dxf", import.meta.url).pathname);
  await page.locator('path.edge[data-panel="skirt-front"]').first().waitFor({ state: "attached" });
  await page.locator("[data-drawer=seams]").click();
  await settle();
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

const settle = () => page.evaluate(() => new Promise((done) => { setTimeout(done, 120); }));
const status = () => page.locator("#status").textContent();

async function seams() {
  await settle();
  const waiting = page.waitForEvent("download");
  await page.locator("#save-garment").click();
  return JSON.parse(await readFile(await (await waiting).path())).seams;
}

const pointOf = (panel, edge, fraction = 0.5) => page.evaluate(([id, index, share]) => {
  const path = document.querySelector(`path.edge[data-panel="${id}"][data-edge="${index}"]`);
  const { x, y } = path.getPointAtLength(path.getTotalLength() * share).matrixTransform(path.getScreenCTM());
  return { x, y };
}, [panel, edge, fraction]);

async function click(panel, edge, fraction, { shift = false } = {}) {
  const { x, y } = await pointOf(panel, edge, fraction);
  if (shift) await page.keyboard.down("Shift");
  await page.mouse.click(x, y);
  if (shift) await page.keyboard.up("Shift");
}

async function drag(panel, edge, from, to) {
  const [start, end] = [await pointOf(panel, edge, from), await pointOf(panel, edge, to)];
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  for (let i = 1; i <= 8; i++) {
    const { x, y } = await pointOf(panel, edge, from + ((to - from) * i) / 8);
    await page.mouse.move(x, y);
  }
  await page.mouse.move(end.x, end.y);
  const tag = await page.locator(".edge-tag").textContent();
  await page.mouse.up();
  return tag;
}

const run = (panel, from, to, direction) => ({ panel, from, to, direction });
const undo = () => page.getByRole("button", { name: "Undo", exact: true }).click();

test("shift joins edges to one side, of the first side and of the seam just made", async () => {
  await click("waistband", 3, 0.2);
  await click("waistband", 4, 0.3, { shift: true });
  assert.match(await status(), /First side: WAISTBAND 3 → 5, \d+\.\d cm/);
  await click("skirt-back", 0, 0.2);
  await click("skirt-back", 1, 0.2, { shift: true });
  const [seam] = (await seams()).slice(-1);
  assert.deepEqual([seam.a, seam.b], [run("waistband", 3, 5, "cw"), run("skirt-back", 0, 2, "cw")]);
  await undo();
  assert.deepEqual((await seams()).at(-1).b, run("skirt-back", 0, 1, "cw"));
  await undo();
});

test("edges that do not touch make a list of runs, by keys", async () => {
  const key = async (panel, edge, name) => {
    await page.locator(`path.edge[data-panel="${panel}"][data-edge="${edge}"]`).focus();
    await page.keyboard.press(name);
  };
  await key("waistband", 0, "Enter");
  await key("skirt-front", 0, "Enter");
  await key("skirt-back", 0, "a");
  const [seam] = (await seams()).slice(-1);
  assert.deepEqual(seam.b, [run("skirt-front", 0, 1, "cw"), run("skirt-back", 0, 1, "cw")]);
  await undo();
  await undo();
});

test("a drag along an outline picks a part of it, caught by corners and notches, with its length", async () => {
  const tag = await drag("skirt-front", 1, 0.02, 0.7);
  assert.match(tag, /SKIRT FRONT 1 → .*, \d+\.\d cm/);
  await page.locator(".pending .seam-line").waitFor({ state: "attached" });
  const pieces = await page.evaluate(() => fetch(`/v1/patterns/${new URLSearchParams(location.hash.slice(1)).get("pattern")}`).then((response) => response.json()));
  const front = pieces.panels.find((panel) => panel.id === "skirt-front");
  const index = front.notches.findIndex((notch) => notch.edge === 3);
  await page.keyboard.press("Escape");
  await drag("skirt-front", 3, 0.98, front.notches[index].at + 0.01);
  await click("skirt-back", 2, 0.2);
  const [seam] = (await seams()).slice(-1);
  assert.deepEqual(seam.a, run("skirt-front", 0, { notch: index }, "ccw"));
  await undo();
});

test("a part is set by numbers", async () => {
  await click("skirt-front", 1, 0.2);
  await click("skirt-back", 4, 0.8);
  const field = page.getByLabel(/^First side to, cm/);
  const whole = Number(await field.inputValue());
  await field.fill(String(whole - 10));
  await field.press("Tab");
  const [seam] = (await seams()).slice(-1);
  assert.equal(seam.a.to.edge, 1);
  assert.ok(Math.abs(seam.a.to.at - (whole - 10) / whole) < 1e-3);
  await page.getByLabel(/^First side to, cm/).fill("0");
  await page.getByLabel(/^First side to, cm/).press("Tab");
  assert.deepEqual((await seams()).at(-1), seam, "no part has no length");
});

test("a seam is selected by its number on the drawing, renamed and deleted by key", async () => {
  await page.locator("#seam-list .choose").first().click();
  await settle();
  assert.equal(await page.locator("#seam-list .seam.selected").count(), 0);
  const badge = await page.locator("#sheet [data-badge]").first().boundingBox();
  await page.mouse.click(badge.x + badge.width / 2, badge.y + badge.height / 2);
  await page.locator("#seam-list .seam.selected").waitFor();
  const name = page.getByLabel("Name", { exact: true });
  await name.fill("left side");
  await name.press("Enter");
  assert.equal((await seams()).at(-1).id, "left side");
  assert.deepEqual(await axeFaults(page), []);
  await page.locator("#splitter").focus();
  await page.keyboard.press("Delete");
  assert.equal((await seams()).length, 0);
  await undo();
  assert.equal((await seams()).at(-1).id, "left side");
  await undo();
  await undo();
  await undo();
});

test("two clicks at two notches of an edge sew a dart", async () => {
  const dart = await page.evaluate(async () => {
    const { dartIn } = await import("/sides.js");
    const edge = { index: 0, from: 0, to: 1, points: [[0, 0], [0.1, 0], [0.12, -0.08], [0.14, 0], [0.3, 0]] };
    const panel = { id: "p", edges: [edge], notches: [{ edge: 0, at: 0.2 }, { edge: 0, at: 0.4 }] };
    const flat = { ...edge, points: [[0, 0], [0.3, 0]] };
    return {
      apex: dartIn(panel, edge, { direction: "cw" }, { direction: "ccw" }),
      notches: dartIn(panel, flat, { direction: "cw", notch: 1 }, { direction: "cw", notch: 0 }),
      none: dartIn(panel, flat, { direction: "cw" }, { direction: "ccw" }),
    };
  });
  assert.equal(dart.none, null);
  assert.deepEqual(dart.notches, {
    a: run("p", { notch: 0 }, { edge: 0, at: 0.30000000000000004 }, "cw"), b: run("p", { notch: 1 }, { edge: 0, at: 0.30000000000000004 }, "ccw"),
  });
  assert.equal(dart.apex.a.from, 0);
  assert.equal(dart.apex.b.from, 1);
});

test("a dart that is cut out is sewn by two clicks of its legs", async () => {
  const outline = [[0, 0], [0, 300], [90, 300], [100, 200], [110, 300], [200, 300], [200, 0]];
  const points = outline.map(([x, y]) => `10\n${x}\n20\n${y}\n`).join("");
  const dxf = `0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n1\n90\n${outline.length}\n70\n1\n${points}0\nENDSEC\n0\nEOF\n`;
  await page.setInputFiles("#open-file", { name: "dart.dxf", mimeType: "image/vnd.dxf", buffer: Buffer.from(dxf) });
  await page.waitForFunction(() => !document.querySelector('path.edge[data-panel="skirt-front"]') && document.querySelectorAll("path.edge").length === 7);
  await settle();
  const legs = await page.evaluate(() => [...document.querySelectorAll("path.edge")]
    .filter((path) => Math.abs(path.getTotalLength() - Math.hypot(0.01, 0.1)) < 1e-4).map((path) => [path.dataset.panel, Number(path.dataset.edge)]));
  assert.equal(legs.length, 2);
  const [first, second] = legs.sort((a, b) => a[1] - b[1]);
  await click(...first, 0.2);
  await click(...second, 0.8);
  const [{ a, b }] = await seams();
  assert.deepEqual(a.to, b.to, "both run to the point of the dart");
  assert.notDeepEqual(a.from, b.from);
  await page.waitForFunction(() => document.getElementById("status").textContent.includes("can be sewn"));
  await undo();
  await undo();
  await page.locator('path.edge[data-panel="skirt-front"]').first().waitFor({ state: "attached" });
  await settle();
});

test("a seam brings its twin on the other half", async () => {
  await page.getByRole("button", { name: "Mirror", exact: true }).click();
  await click("skirt-front", 1, 0.2);
  await click("skirt-back", 4, 0.8);
  const found = await seams();
  assert.equal(found.length, 2);
  assert.deepEqual([found[1].a, found[1].b], [run("skirt-front", 0, 3, "ccw"), run("skirt-back", 2, 3, "cw")]);
  await undo();
  assert.equal((await seams()).length, 0, "both at once");
  await page.getByRole("button", { name: "Mirror", exact: true }).click();
});

test("numbers and colors of seams stay when another goes", async () => {
  for (const [a, b] of [[["skirt-front", 1, 0.2], ["skirt-back", 4, 0.8]], [["skirt-front", 3, 0.8], ["skirt-back", 2, 0.2]]]) {
    await click(...a);
    await click(...b);
  }
  await settle();
  const badges = () => page.locator("#seam-list .badge").allTextContents();
  assert.deepEqual(await badges(), ["1", "2"]);
  await page.locator("#seam-list button[aria-label^='Delete']").first().click();
  await settle();
  assert.deepEqual(await badges(), ["2"]);
  assert.ok(await page.locator("#seam-list .seam.seam-c1").count());
  await undo();
  await settle();
  assert.deepEqual(await badges(), ["1", "2"]);
  await undo();
  await undo();
});

test("the tape measures between two points", async () => {
  await page.getByRole("button", { name: "Tape", exact: true }).click();
  await click("skirt-front", 1, 0);
  await click("skirt-front", 3, 1);
  await settle();
  assert.match(await page.locator(".tape text").textContent(), /^\d\d\.\d cm/);
  assert.equal(await page.locator(".pending").count(), 0);
  await page.getByRole("button", { name: "Tape", exact: true }).click();
  await settle();
  assert.equal(await page.locator(".tape").count(), 0);
});

test("proposals are drawn dashed and accepted or refused, offers are not sewn before", async () => {
  await page.route("**/seams/suggest", async (route) => {
    const response = await route.fetch();
    const body = await response.json();
    body.seams.at(-1).confidence = 0.4;
    await route.fulfill({ response, json: body });
  });
  await page.locator("#suggest").click();
  await page.locator(".seam-mark.proposed").first().waitFor();
  assert.match(await status(), /seams suggested, 1 more only offered.*\d of 3 panels understood/);
  const count = (await seams()).length;
  assert.equal(await page.locator(".seam-mark.proposed").count(), count);
  assert.equal(await page.locator("#seam-list .seam.offer").count(), 1);
  assert.deepEqual(await axeFaults(page), []);
  await page.locator("#seam-list button[aria-label^='Accept']").first().click();
  await settle();
  assert.equal(await page.locator(".seam-mark.proposed").count(), count - 1);
  await page.locator("#seam-list .offer button[aria-label^='Accept']").click();
  assert.equal((await seams()).length, count + 1);
  await undo();
  await page.locator("#seam-list .offer button[aria-label^='Refuse']").click();
  await settle();
  assert.equal(await page.locator("#seam-list .offer").count(), 0);
  await page.locator("#seam-list ol button[aria-label^='Refuse']").first().click();
  assert.equal((await seams()).length, count - 1);
  await page.getByRole("button", { name: "Accept all" }).click();
  await settle();
  assert.equal(await page.locator(".seam-mark.proposed").count(), 0);
  await page.unroute("**/seams/suggest");
});

test("nothing failed", () => assert.deepEqual(record, { foreign: [], errors: [], breaches: [] }));
