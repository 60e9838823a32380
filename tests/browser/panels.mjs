// The list of panels: `node tests/browser/panels.mjs`.
import assert from "node:assert/strict";
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
  await page.getByRole("button", { name: "Try the skirt" }).click();
  await until("seams can be sewn");
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

const until = (text) => page.waitForFunction((part) => document.getElementById("status").textContent.includes(part), text);
const row = (id) => page.locator(`[data-row="${id}"]`);
const undo = () => page.getByRole("button", { name: "Undo", exact: true }).click();
const seamCount = () => page.locator("#seam-count").textContent();
const drawn = (count) => page.waitForFunction((many) => document.querySelectorAll("#sheet [aria-label^='Panel ']").length === many, count);

/** What would be sewn; the request goes nowhere. */
async function sent() {
  await page.route("**/v1/fits", (route) => route.abort(), { times: 1 });
  const asked = page.waitForRequest((request) => request.url().endsWith("/v1/fits"));
  await page.locator("#run:enabled").click();
  const body = (await asked).postDataJSON();
  return body;
}

test("each panel has its picture and its name", async () => {
  assert.deepEqual(await page.locator("[data-row] .name").allTextContents(), ["SKIRT FRONT", "SKIRT BACK", "WAISTBAND"]);
  assert.equal(await page.locator("[data-row] svg path").count(), 3);
});

test("a panel is marked in the list and on the sheet, from either", async () => {
  await row("waistband").locator("summary").hover();
  await page.locator('[data-of="waistband"].pointed').waitFor({ state: "attached" });
  const cloth = await page.locator('[data-of="skirt-front"] .cloth').boundingBox();
  await page.mouse.move(cloth.x + cloth.width / 2, cloth.y + cloth.height / 2);
  await page.locator('[data-row="skirt-front"].pointed').waitFor();
  assert.equal(await page.locator("[data-row].pointed").count(), 1);
});

test("a panel is flipped, which can be undone", async () => {
  await row("skirt-front").locator("summary").click();
  await page.getByRole("button", { name: "Flip: SKIRT FRONT" }).click();
  await until("the other side is out");
  await until("can be sewn");
  assert.equal((await sent()).panels["skirt-front"].face, "down");
  await undo();
  await until("All 6 seams can be sewn");
  assert.equal((await sent()).panels["skirt-front"].face, undefined);
});

test("a mirrored copy comes and goes", async () => {
  await row("waistband").locator("summary").click();
  await page.getByRole("button", { name: "Mirrored copy: WAISTBAND" }).click();
  await drawn(4);
  await row("waistband~mirror").locator("summary").click();
  await page.getByRole("button", { name: "Take away: WAISTBAND, mirrored" }).click();
  await drawn(3);
  await undo();
  await drawn(4);
  await undo();
  await drawn(3);
});

test("a panel is left out with its seams, and taken in again", async () => {
  await page.getByRole("button", { name: "Leave out: WAISTBAND" }).click();
  await until("WAISTBAND is left out, with 4 seams");
  assert.equal(await seamCount(), "2");
  await until("can be sewn");
  assert.deepEqual((await sent()).pattern.panels.map((panel) => panel.id).sort(), ["skirt-back", "skirt-front"]);
  await page.getByRole("button", { name: "Take in: WAISTBAND" }).click();
  await until("WAISTBAND is sewn with the others");
  await undo();
  await undo();
  await page.waitForFunction(() => document.getElementById("seam-count").textContent === "6");
});

test("a panel of the list is shown large", async () => {
  await page.getByRole("button", { name: "Show: WAISTBAND" }).click();
  await page.waitForFunction(() => {
    const sheet = document.getElementById("sheet").getBoundingClientRect();
    return document.querySelector('[data-of="waistband"] .cloth').getBoundingClientRect().width > 0.6 * sheet.width;
  });
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    assert.deepEqual(await axeFaults(page), []);
  }
});

test("nothing failed but what was made to fail", () => {
  record.errors = record.errors.filter((text) => !text.includes("/v1/fits"));
  assert.deepEqual(record, { foreign: [], errors: [], breaches: [] });
});
