// What goes wrong is told in a maker's words, once, and passes: `node tests/browser/faults.mjs`.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFaults, openTab, startBrowser, startService } from "./support.mjs";

const { BASE, SEAMSTER_BIN } = process.env;
const FIT_MS = 300_000;

let service;
let browser;
let page;
let record;

before(async () => {
  if (!BASE && !SEAMSTER_BIN) throw new Error("set BASE to a running service or SEAMSTER_BIN to the binary");
  service = BASE ? { url: BASE, stop: async () => {} } : await startService(SEAMSTER_BIN);
  browser = await startBrowser();
  ({ page, record } = await openTab(browser, service.url));
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

const until = (text, where = page) => where.waitForFunction((part) => document.getElementById("status").textContent.includes(part), text);
const status = () => page.locator("#status").textContent();

async function openSkirt(where = page) {
  await where.getByRole("button", { name: "Skirt sample" }).click();
  await where.locator('path.edge[data-panel="skirt-front"]').first().waitFor({ state: "attached" });
}

/** Picks an edge by keyboard. */
async function pick(panel, edge, key) {
  await page.locator(`path.edge[data-panel="${panel}"][data-edge="${edge}"]`).focus();
  await page.keyboard.press(key);
}

test("a check that failed is tried again when the service is back", async () => {
  await page.route("**/seams/check", (route) => route.abort());
  await openSkirt();
  await until("It is tried again");
  await page.unroute("**/seams/check");
  await until("seams can be sewn");
  record.errors.length = 0;
});

test("a measurement that no body has is refused at once", async () => {
  await page.getByLabel("Waist, cm").fill("20");
  await page.getByLabel("Waist, cm").press("Tab");
  assert.equal(await page.getByLabel("Waist, cm").inputValue(), "74");
  assert.match(await status(), /Waist is between 50 and 150 cm; it stays at 74 cm/);
});

test("a pair of very different lengths has its reason, and no correction is offered", async () => {
  await page.locator("[data-drawer=seams]").click();
  await pick("skirt-front", 2, "Enter");
  await pick("waistband", 5, "Enter");
  await until("cannot be sewn");
  const row = page.locator("#seam-list .seam.selected");
  await row.locator(".fault").first().waitFor();
  assert.equal(await row.getByRole("button", { name: /^Use the correction/ }).count(), 0);
  const seen = await page.evaluate(() => document.body.innerText);
  assert.doesNotMatch(seen, /`|\/seams\/\d|seam\/[a-z_]+/, "codes and pointers are behind Details");
  await row.locator(".code summary").first().click();
  assert.match(await row.locator(".code code").first().innerText(), /^seam\/\w+ at \/seams\/6/);
  assert.deepEqual(await axeFaults(page), []);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await until("All 6 seams can be sewn");
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
  await until("It can be sewn, but Seam side-right is likely reversed: pick the corners of the second side in the other order, or let the ends be found.");
  assert.ok(await page.locator("#status.warn").count());
  await page.unroute("**/seams/check");
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await until("All 6 seams can be sewn");
});

test("a full queue is told in whole sentences, and the faults of one pattern go with it", async () => {
  const problem = { type: "about:blank", title: "Busy", status: 503, detail: "the queue is full: 3 jobs wait already" };
  await page.route("**/v1/fits", (route) => (route.request().method() === "POST"
    ? route.fulfill({ status: 503, headers: { "Retry-After": "5", "Content-Type": "application/problem+json" }, body: JSON.stringify(problem) })
    : route.continue()));
  await page.locator("#run").click();
  await until("wait already. Try again in 5 s.");
  await page.locator("[data-drawer=report]").click();
  assert.match(await page.locator("#fit-faults").textContent(), /wait already\. Try again/);
  await page.unroute("**/v1/fits");
  await page.getByRole("button", { name: "Top sample" }).click();
  await page.waitForFunction(() => document.querySelectorAll("#sheet [aria-label^='Panel ']").length === 2);
  assert.equal(await page.locator("#fit-faults").textContent(), "");
  record.errors.length = 0;
});

test("a fit is followed again after the connection was lost, and the address keeps it", async () => {
  await openSkirt();
  await page.locator("#edge-length").selectOption("0.02");
  await until("can be sewn");
  const lost = (url) => /\/v1\/fits\/[^/]+(\/events.*)?$/.test(url.pathname);
  await page.route(lost, (route) => route.abort());
  await page.locator("#run").click();
  await until("The connection to the service is lost");
  assert.match(page.url(), /fit=/);
  await page.unroute(lost);
  await page.locator("#report .verdict").waitFor({ state: "attached", timeout: FIT_MS });
  assert.match(page.url(), /fit=/);
  assert.match(await status(), /came to rest/);
  record.errors.length = 0;
});

test("fabrics come with a token that is given late", { skip: BASE ? "BASE names a service without tokens" : false }, async () => {
  const token = "a-token-for-this-test-alone";
  const guarded = await startService(SEAMSTER_BIN, { SEAMSTER_TOKENS: token });
  try {
    const { page: late, context } = await openTab(browser, guarded.url);
    await late.locator("#token-dialog[open]").waitFor();
    await late.locator("#token-cancel").click();
    await late.waitForFunction(() => !document.querySelector("#token-dialog[open]"));
    await late.getByRole("button", { name: "Skirt sample" }).click();
    await late.locator("#token-dialog[open]").waitFor();
    await late.getByLabel("Token", { exact: true }).fill(token);
    await late.keyboard.press("Enter");
    await late.waitForFunction(() => document.querySelectorAll("#default-fabric option").length >= 3);
    await context.close();
  } finally {
    await guarded.stop();
  }
});

test("nothing left the origin or broke the policy", () => assert.deepEqual(record, { foreign: [], errors: [], breaches: [] }));
