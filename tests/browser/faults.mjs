// Faults are told in a maker's words, once, and pass: `node tests/browser/faults.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { chooseFile, keyOnEdge, openDrawer, openSkirt, press, statusOf, twoFrames, undo, untilPanels, untilStatus } from "./acts.mjs";
import { assertClean, axeFaults, expectErrors, openTab, startPage, startService, TOKEN_TEST } from "./support.mjs";

const FIT_MS = 300_000;
const { page, record, browser, close } = await startPage();
after(close);

test("a check that failed is tried again when the service is back", async () => {
  const tooMany = { status: 429, contentType: "application/problem+json", body: "{}" };
  for (const fail of [(route) => route.abort(), (route) => route.fulfill(tooMany)]) {
    await page.route("**/seams/check", fail);
    await openSkirt(page);
    await untilStatus(page, "It is tried again");
    assert.match(await page.locator("#run-note").textContent(), /^The seams could not be checked/);
    await page.unroute("**/seams/check");
    await untilStatus(page, "seams can be sewn");
  }
  expectErrors(record, /(ERR_FAILED| 429 ).*\/seams\/check/, { least: 2 });
});

test("that a check failed is said no longer once it passed, also while a side is picked", async () => {
  await page.route("**/seams/check", (route) => route.abort());
  await press(page, "Top sample");
  await untilPanels(page, 2);
  await page.locator("path.edge").first().focus();
  await page.keyboard.press("Enter");
  await untilStatus(page, "First side");
  await untilStatus(page, "It is tried again");
  assert.ok(await page.locator("#status.bad").count());
  await page.unroute("**/seams/check");
  await page.waitForFunction(() => !document.getElementById("status").textContent.includes("tried again"));
  assert.match(await statusOf(page), /^First side/);
  assert.equal(await page.locator("#status.bad").count(), 0);
  await page.keyboard.press("Escape");
  await undo(page);
  await untilPanels(page, 3);
  expectErrors(record, /ERR_FAILED .*\/seams\/check/);
});

test("a measurement that no body has is refused at once", async () => {
  await page.getByLabel("Waist, cm").fill("20");
  await page.getByLabel("Waist, cm").press("Tab");
  assert.equal(await page.getByLabel("Waist, cm").inputValue(), "74");
  assert.match(await statusOf(page), /Waist is between 50 and 150 cm; it stays at 74 cm/);
});

test("the focus goes on from a measurement that was changed", async () => {
  await page.getByLabel("Waist, cm").fill("75");
  await page.getByLabel("Waist, cm").press("Tab");
  await twoFrames(page);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.key), "hip_m");
  await undo(page);
});

test("a garment file whose seam lacks a side is refused, and the page goes on", async () => {
  const before = await page.locator("#seam-count").textContent();
  const broken = { schema: "seamster/garment/1", seams: [{ id: "side", b: { panel: "skirt-front", from: 0, to: 1 } }] };
  await chooseFile(page, "broken.json", JSON.stringify({ ...broken, pattern: null }));
  await untilStatus(page, "seam side is not complete");
  assert.equal(await page.locator("#seam-count").textContent(), before);
  await page.getByLabel("Hip, cm").fill("99");
  await page.getByLabel("Hip, cm").press("Tab");
  await undo(page);
  await page.waitForFunction(() => document.querySelector('[data-key="hip_m"]').value === "98");
});

test("a painter that fails does not stop the others", async () => {
  const painted = await page.evaluate(async () => {
    const { update, watch } = await import("/state.js");
    let fails = false;
    let count = 0;
    watch(["pointed"], () => { if (fails) throw new Error("a painter that fails on purpose"); });
    watch(["pointed"], () => { count += 1; });
    fails = true;
    update({ pointed: "nothing" });
    await Promise.resolve();
    fails = false;
    update({ pointed: null });
    return count;
  });
  assert.equal(painted, 2);
  expectErrors(record, /on purpose/);
});

test("a pair of very different lengths has its reason, and no correction is offered", async () => {
  await openDrawer(page, "seams");
  await keyOnEdge(page, "skirt-front", 2, "Enter");
  await keyOnEdge(page, "waistband", 5, "Enter");
  await untilStatus(page, "cannot be sewn");
  const row = page.locator("#seam-list .seam.selected");
  await row.locator(".fault").first().waitFor();
  assert.equal(await row.getByRole("button", { name: /^Use the correction/ }).count(), 0);
  const seen = await page.evaluate(() => document.body.innerText);
  assert.doesNotMatch(seen, /`|\/seams\/\d|seam\/[a-z_]+/, "codes and pointers are behind Details");
  await row.locator(".code summary").first().click();
  assert.match(await row.locator(".code code").first().innerText(), /^seam\/\w+ at \/seams\/6/);
  assert.deepEqual(await axeFaults(page), []);
  await undo(page);
  await untilStatus(page, "All 6 seams can be sewn");
});

test("a doubt about a seam is said above the panes", async () => {
  await page.route("**/seams/check", async (route) => {
    const response = await route.fetch();
    const body = await response.json();
    body.seams[1].warnings.push({ code: "seam/likely_reversed", pointer: "/seams/1/b", detail: "seam `side-right` is likely reversed: pick the corners of side b in the other order, or set `match` to `auto`" });
    await route.fulfill({ response, json: body });
  });
  await page.locator('[data-key="choose side-right"]').click();
  await page.locator('[data-key="gather side-right"]').click();
  await untilStatus(page, "It can be sewn, but Seam side-right is likely reversed: pick the corners of the second side in the other order, or let the ends be found.");
  assert.ok(await page.locator("#status.warn").count());
  await page.unroute("**/seams/check");
  await undo(page);
  await untilStatus(page, "All 6 seams can be sewn");
});

test("a full queue is told in whole sentences, and the faults of one pattern go with it", async () => {
  const problem = { type: "about:blank", title: "Busy", status: 503, detail: "the queue is full: 3 jobs wait already" };
  await page.route("**/v1/fits", (route) => (route.request().method() === "POST"
    ? route.fulfill({ status: 503, headers: { "Retry-After": "5", "Content-Type": "application/problem+json" }, body: JSON.stringify(problem) })
    : route.continue()));
  await page.locator("#run").click();
  await untilStatus(page, "wait already. Try again in 5 s.");
  await openDrawer(page, "report");
  assert.match(await page.locator("#fit-faults").textContent(), /wait already\. Try again/);
  await page.unroute("**/v1/fits");
  await press(page, "Top sample");
  await untilPanels(page, 2);
  assert.equal(await page.locator("#fit-faults").textContent(), "");
  expectErrors(record, / 503 .*\/v1\/fits/);
});

test("a fit is followed again after the connection was lost, and the address keeps it", async () => {
  await openSkirt(page);
  await page.locator("#edge-length").selectOption("0.02");
  await untilStatus(page, "can be sewn");
  const lost = (url) => /\/v1\/fits\/[^/]+(\/events.*)?$/.test(url.pathname);
  await page.route(lost, (route) => route.abort());
  await page.locator("#run").click();
  await untilStatus(page, "The connection to the service is lost");
  assert.match(page.url(), /fit=/);
  await page.unroute(lost);
  await page.locator("#report .verdict").waitFor({ state: "attached", timeout: FIT_MS });
  assert.match(page.url(), /fit=/);
  assert.match(await statusOf(page), /came to rest/);
  expectErrors(record, /ERR_FAILED .*\/v1\/fits\//);
});

test("fabrics come with a token that is given late", TOKEN_TEST, async () => {
  const token = "a-token-for-this-test-alone";
  const guarded = await startService(process.env.SEAMSTER_BIN, { SEAMSTER_TOKENS: token });
  try {
    const { page: late, context, record: lateRecord } = await openTab(browser, guarded.url);
    await late.locator("#token-dialog[open]").waitFor();
    await late.locator("#token-cancel").click();
    await late.waitForFunction(() => !document.querySelector("#token-dialog[open]"));
    await press(late, "Skirt sample");
    await late.locator("#token-dialog[open]").waitFor();
    await late.getByLabel("Token", { exact: true }).fill(token);
    await late.keyboard.press("Enter");
    await late.waitForFunction(() => document.querySelectorAll("#default-fabric option").length >= 3);
    expectErrors(lateRecord, / 401 /);
    await context.close();
  } finally {
    await guarded.stop();
  }
});

test("nothing else failed", () => assertClean(record));
