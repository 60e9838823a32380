// Seams that the service suggests, as a user meets them: `node tests/browser/suggest.mjs`.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, test } from "node:test";
import { checkedAfter, chooseFile, deleteSeam, edgePath, holdBack, openDrawer, press, samplePath, seamRows, statusOf, undo, untilPanels, untilStatus } from "./acts.mjs";
import { assertAccessible, assertClean, expectErrors, startPage } from "./support.mjs";

const FIT_MS = 300_000;
const { page, record, close } = await startPage();
after(close);

const seams = () => seamRows(page);

const suggested = () => page.locator("#seam-list .tag");

/** Presses the button by keyboard; the answer of the service. */
async function suggest() {
  const answered = page.waitForResponse((response) => response.url().endsWith("/seams/suggest"));
  await page.getByRole("button", { name: "Suggest seams" }).press("Enter");
  return (await answered).json();
}

test("seams of a bare pattern are suggested with how sure they are and why, and undone", async () => {
  await page.setInputFiles("#open-file", samplePath("skirt.dxf"));
  await untilStatus(page, "have the seams suggested");
  await openDrawer(page, "seams");
  assert.equal(await seams().count(), 0);
  let found;
  const body = await checkedAfter(page, async () => { found = await suggest(); });
  const plain = found.seams.map(({ confidence, because, ...seam }) => seam);
  assert.ok(plain.length > 0);
  assert.deepEqual(body.seams, plain);
  for (const { id } of body.seams) assert.ok(found.seams.some((seam) => seam.id === id && seam.because));
  assert.deepEqual(body.panels, found.panels);
  await untilStatus(page, "can be sewn");
  assert.match(await statusOf(page), new RegExp(`^${plain.length} seams suggested`));
  assert.equal(await suggested().count(), plain.length);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.key), "suggest", "the focus stays on the button");
  const [first] = found.seams;
  const row = page.locator("#seam-list .seam").first();
  assert.equal(await row.locator(".choose").getAttribute("title"), first.because);
  await row.locator(".choose").click();
  assert.match(await row.locator(".more").textContent(), /Suggested, \d+ % sure: /);
  await assertAccessible(page);
  await undo(page);
  await page.waitForFunction(() => document.querySelectorAll("#seam-list .seam").length === 0);
  await checkedAfter(page, suggest);
  assert.equal(await suggested().count(), plain.length);
});

test("what was picked stays, and a suggestion that was changed is no longer one", async () => {
  await untilStatus(page, "can be sewn");
  const count = await seams().count();
  const id = (await page.locator("#seam-list .choose").first().getAttribute("data-key")).replace("choose ", "");
  await deleteSeam(page, id);
  const body = await checkedAfter(page, suggest);
  assert.equal(body.seams.length, count);
  await untilStatus(page, `1 seam suggested, ${count - 1} left as they were picked`);
  await suggest();
  await untilStatus(page, "Nothing to add");
  assert.equal(await seams().count(), count);
  await checkedAfter(page, () => page.getByRole("button", { name: `Reverse ${id}`, exact: true }).click());
  assert.equal(await suggested().count(), count - 1);
  await checkedAfter(page, () => undo(page));
  await page.waitForFunction((all) => document.querySelectorAll("#seam-list .tag").length === all, count);
});

test("suggested seams are sewn, and a reload still says that they were suggested", async () => {
  await page.locator("#edge-length").selectOption("0.02");
  const count = await seams().count();
  await press(page, "Sew and drape");
  await page.locator("#report .verdict").waitFor({ state: "attached", timeout: FIT_MS });
  await openDrawer(page, "report");
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
  await chooseFile(page, "top_specification.json", JSON.stringify(topWithSleeve()));
  await untilStatus(page, "have the seams suggested");
  assert.equal(await page.locator("#sheet [aria-label^='Panel ']").count(), 4);
  const body = await checkedAfter(page, suggest);
  await untilStatus(page, "can be sewn");
  assert.ok(JSON.stringify(body.seams).includes("sleeve~mirror"));
  assert.equal(await page.locator("#sheet [aria-label='Panel sleeve, mirrored']").count(), 1);
  assert.equal(await page.locator("#sheet [aria-label='Panel pole, left out']").count(), 1);
  const length = (panel) => edgePath(page, panel, 1).evaluate((path) => path.getTotalLength());
  assert.ok(Math.abs(await length("sleeve") - await length("sleeve~mirror")) < 1e-3);
  await edgePath(page, "sleeve~mirror", 0).focus();
  await page.keyboard.press("Enter");
  assert.match(await statusOf(page), /sleeve, mirrored 0 → 1, counter-clockwise/);
  await page.keyboard.press("Escape");
  await assertAccessible(page);
  const asked = page.waitForRequest((request) => request.url().endsWith("/v1/fits") && request.method() === "POST");
  await press(page, "Sew and drape");
  const request = await asked;
  assert.deepEqual(request.postDataJSON().pattern.panels.map((panel) => panel.id).sort(), ["back", "front", "sleeve"]);
  assert.equal((await request.response()).status(), 202);
  await press(page, "Cancel");
  await page.locator("#progress").waitFor({ state: "hidden", timeout: 10_000 });
  // There is no report unless it had a shape already.
  expectErrors(record, / 404 .*\/report/, { least: 0 });
});

test("a garment file that leaves its seams to the service has them suggested", async () => {
  const garment = JSON.parse(await readFile(samplePath("skirt.garment.json")));
  await press(page, "Skirt sample");
  await untilStatus(page, "All 6 seams can be sewn");
  await chooseFile(page, "suggest.json", JSON.stringify({ ...garment, seams: "suggest" }));
  await untilStatus(page, "seams suggested");
  assert.ok(await suggested().count() > 0);
});

test("seams are suggested for a pattern while the answer for the one before is awaited", async () => {
  const open = async (name, panels) => {
    await page.setInputFiles("#open-file", samplePath(name));
    await untilStatus(page, "have the seams suggested");
    await untilPanels(page, panels);
  };
  await open("skirt.dxf", 3);
  const release = await holdBack(page, "POST", /\/seams\/suggest$/, { least: 2 });
  let calls = 0;
  page.on("request", (request) => { calls += request.url().endsWith("/seams/suggest"); });
  await press(page, "Suggest seams");
  await open("top.dxf", 2);
  await press(page, "Suggest seams");
  await undo(page);
  await untilPanels(page, 3);
  await press(page, "Suggest seams");
  await press(page, "Redo");
  await untilPanels(page, 2);
  await release();
  await untilStatus(page, "of 2 panels understood");
  assert.equal(calls, 2, "one for each pattern");
});

test("nothing else failed", () => assertClean(record));
