// The list of panels: `node tests/browser/panels.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { openSkirt, press, undo, untilPanels, untilSeams, untilStatus } from "./acts.mjs";
import { assertAccessible, assertClean, expectErrors, startPage } from "./support.mjs";

const { page, record, close } = await startPage();
after(close);
await openSkirt(page, "Try the skirt");
await untilStatus(page, "seams can be sewn");

const row = (id) => page.locator(`[data-row="${id}"]`);
const seamCount = () => page.locator("#seam-count").textContent();
const focused = () => page.evaluate(() => document.activeElement.dataset.key);

/** The garment that would be sewn; the request goes nowhere. */
async function sent() {
  await page.route("**/v1/fits", (route) => route.abort(), { times: 1 });
  const asked = page.waitForRequest((request) => request.url().endsWith("/v1/fits"));
  await page.locator("#run:enabled").click();
  const body = (await asked).postDataJSON();
  await page.locator("#fit-faults .fault").waitFor({ state: "attached" });
  expectErrors(record, /ERR_FAILED .*\/v1\/fits/);
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
  await press(page, "Flip: SKIRT FRONT");
  await untilStatus(page, "the other side is out");
  await untilStatus(page, "can be sewn");
  assert.equal((await sent()).panels["skirt-front"].face, "down");
  await undo(page);
  await untilStatus(page, "All 6 seams can be sewn");
  assert.equal((await sent()).panels["skirt-front"].face, undefined);
});

test("a mirrored copy comes and goes", async () => {
  await row("waistband").locator("summary").click();
  await press(page, "Mirrored copy: WAISTBAND");
  await untilPanels(page, 4);
  await row("waistband~mirror").locator("summary").click();
  await page.getByRole("button", { name: "Take away: WAISTBAND, mirrored" }).press("Enter");
  await untilPanels(page, 3);
  assert.equal(await focused(), "panel waistband", "the focus goes to the row before");
  await undo(page);
  await untilPanels(page, 4);
  await undo(page);
  await untilPanels(page, 3);
});

test("a panel is left out with its seams, and taken in again", async () => {
  await page.getByRole("button", { name: "Leave out: WAISTBAND" }).press("Enter");
  await untilStatus(page, "WAISTBAND is left out, with 4 seams");
  assert.equal(await focused(), "in or out waistband", "the focus stays on the button");
  assert.equal(await seamCount(), "2");
  const ends = await row("waistband").evaluate((one) => {
    one.querySelector(".name").textContent = "A NAME THAT IS LONGER THAN THE RAIL IS WIDE";
    return [one.querySelector("small"), document.getElementById("rail")].map((part) => part.getBoundingClientRect().right);
  });
  assert.ok(ends[0] <= ends[1], `a long name pushes the note out of the rail: ${ends}`);
  await untilStatus(page, "can be sewn");
  assert.deepEqual((await sent()).pattern.panels.map((panel) => panel.id).sort(), ["skirt-back", "skirt-front"]);
  await press(page, "Take in: WAISTBAND");
  await untilStatus(page, "WAISTBAND is sewn with the others");
  await undo(page);
  await undo(page);
  await untilSeams(page, 6);
});

test("a panel of the list is shown large", async () => {
  await press(page, "Show: WAISTBAND");
  await page.waitForFunction(() => {
    const sheet = document.getElementById("sheet").getBoundingClientRect();
    return document.querySelector('[data-of="waistband"] .cloth').getBoundingClientRect().width > 0.6 * sheet.width;
  });
  await assertAccessible(page);
});

test("nothing else failed", () => assertClean(record));
