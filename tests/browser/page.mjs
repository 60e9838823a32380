// The page in a browser, as a user has it: `node tests/browser/page.mjs`.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, test } from "node:test";
import { checkedAfter, chooseFile, clickEdge, deleteSeam, edgePath, fitOf, openDrawer, press, seamRows, shownPattern, statusOf, undo, untilStatus } from "./acts.mjs";
import { assertAccessible, assertClean, axeFaults, difference, expectErrors, openTab, startPage, startService, TOKEN_TEST } from "./support.mjs";

const FIT_MS = 300_000;
const { page, record, browser, close } = await startPage();
after(close);
let emptyStage;

const seams = () => seamRows(page);

/** Side A and B of a sample's seam with directions as the page states them. */
const SIDE = {
  a: { panel: "skirt-front", from: 1, to: 2, direction: "cw" },
  b: { panel: "skirt-back", from: 0, to: 4, direction: "ccw" },
};

test("the page opens and offers samples and fabrics", async () => {
  await page.waitForFunction(() => document.querySelectorAll("#default-fabric option").length >= 3);
  assert.equal(await page.title(), "Seamster");
  assert.ok(await page.locator("#run").isDisabled());
  await assertAccessible(page);
});

test("a file that is no pattern is refused with its reason", async () => {
  await chooseFile(page, "letter.dxf", "Dear Sir or Madam");
  await page.locator("#pattern-faults .fault code").first().waitFor({ state: "attached" });
  assert.match(await page.locator("#pattern-faults").textContent(), /pattern\//);
  expectErrors(record, / 422 .*\/v1\/patterns/);
});

test("the skirt sample shows its panels, corners and edges", async () => {
  await press(page, "Skirt sample");
  await untilStatus(page, "seams can be sewn");
  assert.equal(await page.locator("#sheet [aria-label^='Panel ']").count(), 3);
  const pattern = await shownPattern(page);
  for (const { id, corners, edges } of pattern.panels) {
    assert.equal(await page.locator(`path.edge[data-panel="${id}"]`).count(), edges.length);
    assert.equal(edges.length, corners.length);
  }
  await openDrawer(page, "seams");
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
  await deleteSeam(page, "side-left");
  await edgePath(page, "skirt-front", 0).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  assert.match(await statusOf(page), /First side: .* 1 → 2, clockwise/);
  await page.locator(".pending .arrow").waitFor({ state: "attached" });
  await edgePath(page, "skirt-back", 0).focus();
  await page.keyboard.press("ArrowLeft");
  const body = await checkedAfter(page, () => page.keyboard.press("Shift+Enter"));
  const { a, b } = body.seams.at(-1);
  assert.deepEqual({ a, b }, SIDE);
  await untilStatus(page, "It can be sewn");
  assert.equal(await seams().count(), 6);
  assert.equal(await page.locator(".seam-mark.selected .thread").count(), 2);
  assert.equal(await page.locator(".seam-mark.selected .arrow").count(), 2);
});

test("a seam is deleted and picked again by pointer, the nearer end first", async () => {
  const name = await page.locator("#seam-list .seam.selected .choose").getAttribute("data-key");
  await deleteSeam(page, name.replace("choose ", ""));
  await clickEdge(page, "skirt-front", 1, 0.2);
  assert.match(await statusOf(page), /1 → 2, clockwise/);
  const body = await checkedAfter(page, () => clickEdge(page, "skirt-back", 4, 0.8));
  const { a, b } = body.seams.at(-1);
  assert.deepEqual({ a, b }, SIDE);
  await untilStatus(page, "It can be sewn");
  await assertAccessible(page);
});

test("escape lets go of the first edge", async () => {
  await clickEdge(page, "skirt-front", 2, 0.2);
  await page.locator(".pending").waitFor({ state: "attached" });
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.querySelectorAll(".pending").length === 0);
  assert.equal(await seams().count(), 6);
});

test("a bad pair says why and keeps the garment from being sewn", async () => {
  await clickEdge(page, "skirt-front", 2, 0.2);
  await checkedAfter(page, () => clickEdge(page, "waistband", 5, 0.2));
  await untilStatus(page, "cannot be sewn");
  const faults = page.locator("#seam-list .seam.selected .fault");
  assert.ok(await faults.count() > 0);
  assert.match(await faults.first().textContent(), /seam\/\w+ at \/seams\/6/);
  assert.ok(await page.locator("#run").isDisabled());
  await assertAccessible(page);
  await checkedAfter(page, () => undo(page));
  await untilStatus(page, "All 6 seams can be sewn");
  assert.ok(await page.locator("#run").isEnabled());
});

test("a seam picked the wrong way round offers its correction", async () => {
  await checkedAfter(page, () => press(page, "Reverse side-right"));
  await untilStatus(page, "cannot be sewn");
  const body = await checkedAfter(page, () => page.getByRole("button", { name: /^Use the correction/ }).first().click());
  const right = body.seams.find((seam) => seam.id === "side-right");
  assert.deepEqual([right.a.from, right.a.to, right.b.from, right.b.to], [0, 3, 2, 3]);
  await untilStatus(page, "can be sewn.");
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
  await openDrawer(page, "report");
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
  await assertAccessible(page);
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
  await press(page, "Sew again");
  await press(page, "Cancel");
  await page.locator("#progress").waitFor({ state: "hidden", timeout: 10_000 });
  const id = await fitOf(page);
  const fit = await page.evaluate((of) => fetch(`/v1/fits/${of}`).then((response) => response.json()), id);
  assert.equal(fit.status, "canceled");
  await page.locator("#stage-caption", { hasText: /earlier fit|Stopped/ }).waitFor();
  assert.ok(await page.locator("#run").isEnabled());
  // There is no report unless it had a shape already.
  expectErrors(record, / 404 .*\/report/, { least: 0 });
});

test("a saved garment opens again", async () => {
  const waiting = page.waitForEvent("download");
  await press(page, "Save garment");
  const file = await (await waiting).path();
  await openDrawer(page, "seams");
  await deleteSeam(page, "side-right");
  await chooseFile(page, "skirt.garment.json", await readFile(file));
  await untilStatus(page, "All 6 seams can be sewn");
  assert.equal(await seams().count(), 6);
});

test("a nest of sizes is read by size, or as drawn lines where the user says so", async () => {
  const outline = (k) => [[-200, 300], [200, 300], [260, -300], [-260, -300]].map(([x, y]) => `10\n${k * x}\n20\n${k * y}\n`).join("");
  const sizes = [0.96, 1, 1.04].map((k, i) => `0\nLWPOLYLINE\n8\n${38 + 2 * i}\n90\n4\n70\n1\n${outline(k)}`).join("");
  const dxf = `0\nSECTION\n2\nENTITIES\n${sizes}0\nENDSEC\n0\nEOF\n`;
  await chooseFile(page, "nest.dxf", dxf);
  await page.waitForFunction(() => document.querySelectorAll("#import-size option").length >= 3);
  const sent = page.waitForRequest((request) => request.url().includes("/v1/patterns?"));
  await page.locator("#reading summary").click();
  await page.getByLabel("Outlines inside others").selectOption("lines");
  const request = await sent;
  assert.ok(request.url().includes("outlines=lines"));
  const pattern = await (await request.response()).json();
  assert.deepEqual([pattern.source.sizes.length, pattern.panels.length], [0, 1]);
  assert.equal(pattern.panels[0].internal_lines.length, 2);
  await assertAccessible(page);
});

test("names from files are text, never markup", async () => {
  const pattern = await shownPattern(page);
  pattern.name = "<img src=x onerror=document.title='broken'>";
  delete pattern.id;
  for (const panel of pattern.panels) panel.name = "<b id=injected>x</b>";
  await chooseFile(page, "odd.json", JSON.stringify({ schema: "seamster/garment/1", pattern, seams: [] }));
  await page.waitForFunction(() => document.getElementById("pattern-facts").textContent.includes("<img src=x"));
  assert.equal(await page.locator("#injected, main img").count(), 0);
  assert.equal(await page.title(), "Seamster");
});

test("nothing left the origin, broke the policy or failed", () => assertClean(record));

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

test("a service with tokens is used after the token was given once", TOKEN_TEST, async () => {
  const token = "a-token-for-this-test-alone";
  const guarded = await startService(process.env.SEAMSTER_BIN, { SEAMSTER_TOKENS: token });
  try {
    const { page: tokenPage, record: tokenRecord, context } = await openTab(browser, guarded.url);
    await tokenPage.locator("#token-dialog[open]").waitFor();
    assert.deepEqual(await axeFaults(tokenPage), []);
    await tokenPage.getByLabel("Token", { exact: true }).fill("wrong");
    await tokenPage.keyboard.press("Enter");
    await tokenPage.locator("#token-why", { hasText: "refused" }).waitFor();
    await tokenPage.getByLabel("Token", { exact: true }).fill(token);
    await tokenPage.keyboard.press("Enter");
    await press(tokenPage, "Top sample");
    await untilStatus(tokenPage, "can be sewn");
    assert.equal(await tokenPage.locator("#sheet [aria-label^='Panel ']").count(), 2);
    expectErrors(tokenRecord, / 401 /);
    assertClean(tokenRecord);
    await context.close();
  } finally {
    await guarded.stop();
  }
});
