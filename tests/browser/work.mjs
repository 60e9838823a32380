// Nothing that was done is lost: `node tests/browser/work.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { chooseFile, fitOf, holdBack, openDrawer, otherFabric, pieces, press, savedGarment, statusOf, undo, untilKept, untilPanels, untilSeams, untilStatus } from "./acts.mjs";
import { assertClean, axeFaults, expectErrors, startPage } from "./support.mjs";

const { page, context, record, close } = await startPage();
after(close);

/** The garment as the page would save it, without its pattern. */
async function garment(where = page) {
  const { pattern, ...rest } = await savedGarment(where);
  return rest;
}

/** Changes of every kind, one step each. */
const CHANGES = {
  fabric: async () => {
    await page.locator("#default-fabric").selectOption(await otherFabric(page));
  },
  "fabric of one panel": async () => {
    if (!await page.getByLabel("Fabric of WAISTBAND").isVisible()) await page.locator("[data-row=waistband] summary").click();
    await page.getByLabel("Fabric of WAISTBAND").selectOption("cotton-poplin");
  },
  measurement: async () => {
    await page.getByLabel("Hip, cm").fill("101");
    await page.getByLabel("Hip, cm").press("Tab");
  },
  mesh: () => page.locator("#edge-length").selectOption("0.008"),
  "deleted seam": () => press(page, "Delete side-left"),
  "turned seam": () => press(page, "Reverse side-right"),
};

test("every change is undone and made again, by button and by key", async () => {
  await press(page, "Try the skirt");
  await untilSeams(page, 6);
  await openDrawer(page, "seams");
  const steps = [await garment()];
  for (const [name, change] of Object.entries(CHANGES)) {
    await change();
    await untilKept(page);
    steps.push(await garment());
    assert.notDeepEqual(steps.at(-1), steps.at(-2), name);
  }
  for (const [i, step] of steps.slice(0, -1).reverse().entries()) {
    if (i % 2) await undo(page);
    else {
      await page.locator("#splitter").focus();
      await page.keyboard.press("Control+z");
    }
    await untilKept(page);
    assert.deepEqual(await garment(), step);
    assert.match(await statusOf(page), /^Undone: /);
  }
  assert.ok(await page.locator("#undo").isDisabled());
  for (const step of steps.slice(1)) {
    await press(page, "Redo");
    await untilKept(page);
    assert.deepEqual(await garment(), step);
  }
  assert.ok(await page.locator("#redo").isDisabled());
  for (const _ of steps.slice(1)) await undo(page);
  await untilKept(page);
});

test("seams, fabric and body stay when the pattern is read in other units", async () => {
  await CHANGES.measurement();
  const kept = await garment();
  await page.locator("#import-units").selectOption("cm");
  await page.waitForFunction(() => document.getElementById("pattern-facts").textContent.includes("cm"));
  await untilSeams(page, 6);
  assert.deepEqual(await garment(), kept);
  assert.equal(await page.locator("#import-units").inputValue(), "cm");
  await undo(page);
  await page.waitForFunction(() => document.getElementById("import-units").value === "");
  assert.deepEqual(await garment(), kept);
});

test("seams go where their edges are others, and are named", async () => {
  const { kept, lost, fabric } = await page.evaluate(async () => {
    const { keepSeams } = await import("/kept_seams.js");
    const panel = (id, lengths) => ({ id, edges: lengths.map((length_m) => ({ length_m })) });
    const run = (id) => ({ panel: id, from: 0, to: 1 });
    const before = { panels: [panel("front", [1, 2, 1, 2]), panel("back", [1, 2, 1, 2]), panel("cuff", [1, 1, 1])] };
    const now = { panels: [panel("front", [1.1, 2.2, 1.1, 2.2]), panel("back", [1.1, 2.2, 1.1, 2.2]), panel("cuff", [1, 1, 0.5, 0.5])] };
    const seams = [{ id: "side", a: run("front"), b: run("back~mirror") }, { id: "wrist", a: run("front"), b: [run("cuff")] }];
    const found = keepSeams({ seams, panels: { front: { fabric: "denim" }, gone: {} } }, before, now);
    return { kept: found.garment.seams.map((seam) => seam.id), lost: found.lost, fabric: found.garment.panels };
  });
  assert.deepEqual([kept, lost, fabric], [["side"], ["wrist"], { front: { fabric: "denim" } }]);
});

test("work that a sample takes the place of is named, and comes back with its fit", async () => {
  const before = await garment();
  await press(page, "Top sample");
  await untilPanels(page, 2);
  await page.waitForFunction(() => document.getElementById("undo").title.startsWith("Undo: opening"));
  await undo(page);
  await untilPanels(page, 3);
  assert.deepEqual(await garment(), before);
  await press(page, "Redo");
  await untilPanels(page, 2);
  await undo(page);
  await untilPanels(page, 3);
  await chooseFile(page, "two.dxf", pieces([[300, 0], [300, 200], [500, 200], [500, 0]]));
  await untilStatus(page, "Undo brings back");
  await undo(page);
  await untilPanels(page, 3);
});

test("a reload keeps the work of this tab, and a second tab has its own", async () => {
  await press(page, "Delete side-left");
  await untilSeams(page, 5);
  const mine = await garment();
  await page.reload();
  await untilSeams(page, 5);
  assert.deepEqual(await garment(), mine);
  assert.ok(await page.locator("#import-units").isEnabled(), "the file can be read in another way still");
  const second = await context.newPage();
  await second.goto(page.url());
  await untilPanels(second, 3);
  await untilStatus(second, "open in another tab");
  await untilStatus(page, "open in another tab");
  const answered = page.evaluate(() => new Promise((done) => { new BroadcastChannel("seamster").onmessage = done; }).then(() => {}));
  await second.reload();
  await answered;
  await untilStatus(second, "open in another tab");
  assert.equal((await statusOf(page)).split("open in another tab").length, 2, "it is said once");
  assert.ok(await page.locator("#status.warn").count());
  await second.locator("#default-fabric").selectOption(await otherFabric(second));
  await untilKept(second);
  await page.reload();
  await untilSeams(page, 5);
  assert.deepEqual(await garment(), mine, "the first tab has what it had");
  await second.locator("#open").click();
  const entries = second.locator("#open-recent .entry");
  await entries.nth(1).waitFor();
  assert.deepEqual(await axeFaults(second), []);
  await entries.filter({ hasText: "5 seams" }).first().click();
  await untilSeams(second, 5);
  await second.close();
});

test("work that another pattern takes the place of is kept over a reload, and opens from its file", async () => {
  await openDrawer(page, "seams");
  await press(page, "Delete side-right");
  await untilSeams(page, 4);
  await untilKept(page);
  const left = await garment();
  await press(page, "Top sample");
  await untilPanels(page, 2);
  await untilKept(page);
  await page.reload();
  await untilPanels(page, 2);
  const missing = (url) => /\/v1\/patterns\/[^/]+$/.test(url.pathname);
  await page.route(missing, (route) => route.fulfill({ status: 404, contentType: "application/problem+json", body: "{}" }));
  await page.locator("#open").click();
  await page.locator("#open-recent .entry", { hasText: /A-LINE SKIRT\s*4 seams/ }).click();
  await untilPanels(page, 3);
  await page.unroute(missing);
  expectErrors(record, / 404 .*\/v1\/patterns\//);
  assert.deepEqual(await garment(), left);
});

test("the answer of a fit that comes late does not land on another pattern", async () => {
  const release = await holdBack(page, "POST", /\/v1\/fits$/);
  await page.locator("#run").click();
  await press(page, "Top sample");
  await untilPanels(page, 2);
  await release();
  await untilStatus(page, "is being sewn: Open lists it");
  assert.equal(await fitOf(page), null);
  assert.ok(await page.locator("#cancel").isHidden());
  await undo(page);
  await untilPanels(page, 3);
});

test("a fit comes back with its pattern, also when that was left before the fit was there", async () => {
  await page.locator("#run").click();
  await press(page, "Cancel");
  await page.waitForFunction(() => document.getElementById("status").textContent.startsWith("Canceled"));
  const id = await fitOf(page);
  assert.ok(id);
  await press(page, "Top sample");
  await untilPanels(page, 2);
  const release = await holdBack(page, "GET", /\/v1\/fits\/[^/]+$/);
  await undo(page);
  await untilPanels(page, 3);
  await press(page, "Redo");
  await untilPanels(page, 2);
  await release();
  assert.equal(await fitOf(page), null);
  const looked = page.waitForResponse((response) => response.url().endsWith(`${id}/report`));
  await undo(page);
  await looked;
  await page.waitForFunction((fit) => location.hash.includes(fit), id);
  // It was canceled before it had a shape, so it has no report.
  expectErrors(record, / 404 .*\/report$/, { least: 2 });
});

test("another garment of the same pattern does not take its fit", async () => {
  const id = await fitOf(page);
  const count = (await garment()).seams.length;
  await chooseFile(page, "bare.json", JSON.stringify({ schema: "seamster/garment/1", seams: [] }));
  await untilSeams(page, 0);
  assert.equal(await fitOf(page), null);
  const looked = page.waitForResponse((response) => response.url().endsWith(`${id}/report`));
  await undo(page);
  await untilSeams(page, count);
  await looked;
  assert.equal(await fitOf(page), id);
  expectErrors(record, / 404 .*\/report$/);
});

test("a fit stays in the address and the draft until it came, or is known to be gone", async () => {
  const id = await fitOf(page);
  const release = await holdBack(page, "GET", /\/v1\/fits\/[^/]+$/);
  for (let i = 0; i < 2; i++) {
    await page.reload();
    await untilPanels(page, 3);
    await page.locator("#default-fabric").selectOption(await otherFabric(page));
    await untilKept(page);
    assert.equal(await fitOf(page), id, "while it is fetched");
  }
  const looked = page.waitForResponse((response) => response.url().endsWith(`${id}/report`));
  await release();
  await looked;
  const isFit = (url) => url.pathname.endsWith(`/v1/fits/${id}`);
  for (const status of [503, 429, 403, 404]) {
    await page.route(isFit, (route) => route.fulfill({ status, contentType: "application/problem+json", body: "{}" }));
    await page.reload();
    await untilStatus(page, `The service answered ${status}.`);
    assert.equal(await fitOf(page), status === 404 ? null : id);
    await page.unroute(isFit);
  }
  expectErrors(record, / (4\d\d|503) .*\/v1\/fits\//, { least: 5 });
});

test("the faults of a fit go with its pattern", async () => {
  await press(page, "Top sample");
  await untilPanels(page, 2);
  await page.route("**/v1/fits", (route) => route.fulfill({ status: 503, contentType: "application/problem+json", body: "{}" }));
  await page.locator("#run:enabled").click();
  await page.locator("#fit-faults .fault").waitFor({ state: "attached" });
  await page.unroute("**/v1/fits");
  await undo(page);
  await untilPanels(page, 3);
  assert.equal(await page.locator("#fit-faults .fault").count(), 0);
  expectErrors(record, / 503 .*\/v1\/fits/);
});

test("a fit that may not be followed any longer stays in the address, and another can be sewn", async () => {
  const isEvents = (url) => url.pathname.endsWith("/events");
  await page.route(isEvents, (route) => route.fulfill({ status: 403, contentType: "application/problem+json", body: "{}" }));
  await page.locator("#run:enabled").click();
  await untilStatus(page, "The service answered 403.");
  await page.locator("#run:enabled").waitFor();
  const id = await fitOf(page);
  assert.ok(id);
  await page.unroute(isEvents);
  await page.evaluate((fit) => fetch(`/v1/fits/${fit}`, { method: "DELETE" }), id);
  expectErrors(record, / 403 .*\/events$/);
});

test("what was said last stays before a verdict that comes late", async () => {
  const release = await holdBack(page, "POST", /\/seams\/check$/);
  await press(page, "Skirt sample");
  await untilStatus(page, "Undo brings back");
  await release();
  await untilStatus(page, "All 6 seams can be sewn");
  assert.match(await statusOf(page), /Undo brings back .*All 6 seams can be sewn/);
  if (!await page.getByLabel("Face of WAISTBAND").isVisible()) await page.locator("[data-row=waistband] summary").click();
  await page.getByLabel("Face of WAISTBAND").selectOption("down");
  await page.waitForFunction(() => document.getElementById("status").textContent === "All 6 seams can be sewn.");
});

/** Types into a field of the shown garment while the skirt sample comes. */
async function typeWhileOpened(field, text) {
  const release = await holdBack(page, "POST", /\/v1\/patterns$/);
  await press(page, "Skirt sample");
  await field.fill(text);
  await release();
  await untilStatus(page, "Undo brings back");
  await page.keyboard.press("Tab");
}

test("what is typed while a garment is opened goes into the garment that it was typed for", async () => {
  await typeWhileOpened(page.getByLabel("Hip, cm"), "101");
  assert.equal((await garment()).avatar.form.hip_m, 0.98);
  await undo(page);
  assert.equal((await garment()).avatar.form.hip_m, 1.01);
  await openDrawer(page, "seams");
  await page.locator("#seam-list .choose").first().click();
  const { id } = (await garment()).seams[0];
  await typeWhileOpened(page.getByLabel("Sewn in step"), "3");
  const stageOf = async () => (await garment()).seams.find((seam) => seam.id === id).stage;
  assert.notEqual(await stageOf(), 3);
  await undo(page);
  assert.equal(await stageOf(), 3);
});

test("a pattern that is opened again is checked again", async () => {
  const checked = () => page.waitForResponse((response) => response.url().endsWith("/seams/check") && response.ok());
  for (let i = 0; i < 2; i++) {
    const answer = checked();
    await press(page, "Skirt sample");
    await answer;
  }
  await untilStatus(page, "can be sewn");
});

test("another address that is entered opens what it names", async () => {
  const address = page.url();
  await press(page, "Top sample");
  await untilPanels(page, 2);
  await page.evaluate((entered) => { location.href = entered; }, address);
  await untilPanels(page, 3);
});

test("nothing else failed", () => assertClean(record));
