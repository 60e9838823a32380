// Earlier fits with pictures, named, found and erased: `node tests/browser/gallery.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { fitOf, openDrawer, openSkirt, press, untilShown, untilStatus } from "./acts.mjs";
import { assertAccessible, assertClean, expectErrors, startPage } from "./support.mjs";

const { page, record, close } = await startPage();
after(close);

const cards = () => page.locator("#gallery .card");
const nameOf = (fit) => page.locator(`#gallery [data-row="${fit}"] input`);

/** Waits until so many fits are kept. */
const untilCards = (count) => page.waitForFunction((many) => document.querySelectorAll("#gallery .card").length === many, count);

/** Runs the garment to its end: the id of the fit. */
async function sew() {
  const answered = page.waitForResponse((response) => response.url().endsWith("/v1/fits") && response.request().method() === "POST");
  await page.locator("#run:enabled").click();
  const { id } = await (await answered).json();
  await page.waitForFunction((fit) => document.getElementById("stage").dataset.shape === fit, id);
  return id;
}

let first;
let second;

test("a fit that was shown is kept with a picture, its verdict and its time", async () => {
  await openSkirt(page, "Try the skirt");
  await openDrawer(page, "fits");
  await page.locator("#gallery-note", { hasText: "are kept with a picture" }).waitFor();
  first = await sew();
  await untilCards(1);
  assert.equal(await nameOf(first).inputValue(), "A-LINE SKIRT");
  assert.match(await cards().textContent(), /✓ The garment came to rest, and nothing is wrong with it\. \d+(\.\d)? s/);
  const picture = await page.locator("#gallery img").evaluate(async (image) => {
    await image.decode();
    const pen = new OffscreenCanvas(image.naturalWidth, image.naturalHeight).getContext("2d");
    pen.drawImage(image, 0, 0);
    const shade = (x, y) => pen.getImageData(x * image.naturalWidth, y * image.naturalHeight, 1, 1).data;
    const [cloth, beside] = [shade(0.5, 0.5), shade(0.05, 0.5)];
    return { size: [image.naturalWidth, image.naturalHeight], isBlue: cloth[2] > cloth[0] + 20, isGrey: Math.abs(beside[2] - beside[0]) < 20 };
  });
  assert.deepEqual(picture, { size: [264, 330], isBlue: true, isGrey: true });
  await assertAccessible(page);
});

test("a fit is named, and its name is text, kept over a reload and a second showing", async () => {
  await nameOf(first).fill("<b>First</b> skirt");
  await nameOf(first).press("Tab");
  await page.getByRole("button", { name: "Show <b>First</b> skirt" }).waitFor();
  await page.reload();
  await untilShown(page);
  await openDrawer(page, "fits");
  await page.getByRole("button", { name: "Show <b>First</b> skirt" }).waitFor();
});

test("fits are found by name", async () => {
  second = await sew();
  await untilCards(2);
  const search = page.getByLabel("Search");
  await search.fill("first");
  await untilCards(1);
  await search.fill("no such");
  await page.locator("#gallery-note", { hasText: "No fit has such a name." }).waitFor();
  await search.fill("");
  await untilCards(2);
});

test("an earlier fit is opened with its garment, beside the one before", async () => {
  await page.getByRole("button", { name: "Show <b>First</b> skirt" }).press("Enter");
  await page.waitForFunction((fit) => document.getElementById("stage").dataset.shape === fit, first);
  assert.equal(await fitOf(page), first);
  assert.equal(await page.locator("#seam-count").textContent(), "6");
  await untilCards(2);
  await openDrawer(page, "report");
  const times = page.locator("#comparison tr", { hasText: "Sewn from" });
  await times.waitFor();
  assert.match(await times.textContent(), /the last shape.*flat panels/, "it is compared with the one that was shown");
  await openDrawer(page, "fits");
});

test("picture and name of a fit are erased, also for the next visit", async () => {
  await page.locator(`#gallery [data-row="${second}"]`).getByRole("button", { name: /^Erase/ }).click();
  await untilStatus(page, "is out of the gallery");
  await untilCards(1);
  await page.reload();
  await untilShown(page);
  await openDrawer(page, "fits");
  await untilCards(1);
  assert.equal(await nameOf(first).inputValue(), "<b>First</b> skirt");
});

test("a run that is canceled before it had a shape is not kept", async () => {
  await page.locator("#run-anew").click();
  await press(page, "Cancel");
  await page.waitForFunction(() => /Canceled|Stopped/.test(document.getElementById("status").textContent));
  const hasShape = /Stopped/.test(await page.locator("#status").textContent());
  await untilCards(hasShape ? 2 : 1);
  expectErrors(record, / 404 .*\/report$/, { least: 0 });
});

test("nothing else failed", () => {
  // Of runs that were canceled without a shape; the browser tells it late.
  expectErrors(record, / 404 .*\/report$/, { least: 0 });
  assertClean(record);
});
