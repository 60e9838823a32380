// Nothing that was done is lost: `node tests/browser/work.mjs`.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { axeFaults, openTab, startBrowser, startService } from "./support.mjs";

const { BASE, SEAMSTER_BIN } = process.env;

let service;
let browser;
let tab;
let page;

before(async () => {
  if (!BASE && !SEAMSTER_BIN) throw new Error("set BASE to a running service or SEAMSTER_BIN to the binary");
  service = BASE ? { url: BASE, stop: async () => {} } : await startService(SEAMSTER_BIN);
  browser = await startBrowser();
  tab = await openTab(browser, service.url);
  page = tab.page;
});

after(async () => {
  await browser?.close();
  await service?.stop();
});

const seamCount = (count, where = page) => where.waitForFunction((text) => document.getElementById("seam-count").textContent.replace(/^\d+ of (\d+).*/, "$1") === text, String(count));
const status = (where = page) => where.locator("#status").textContent();
const panelsDrawn = (count, where = page) => where.waitForFunction((many) => document.querySelectorAll("#sheet [aria-label^='Panel ']").length === many, count);
const settle = () => page.evaluate(() => new Promise((done) => { setTimeout(done, 150); }));

/** The garment as the page would save it, without its pattern. */
async function garment(where = page) {
  const waiting = where.waitForEvent("download");
  await where.locator("#save-garment").click();
  const { pattern, ...rest } = JSON.parse(await readFile(await (await waiting).path()));
  return rest;
}

/** A fabric that is not the chosen one. */
const otherFabric = (where) => where.locator("#default-fabric").evaluate((select) => [...select.options].find((option) => !option.selected).value);

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
  "deleted seam": () => page.getByRole("button", { name: "Delete side-left", exact: true }).click(),
  "turned seam": () => page.getByRole("button", { name: "Reverse side-right", exact: true }).click(),
};

test("every change is undone and made again, by button and by key", async () => {
  await page.getByRole("button", { name: "Try the skirt" }).click();
  await seamCount(6);
  await page.locator("[data-drawer=seams]").click();
  const steps = [await garment()];
  for (const [name, change] of Object.entries(CHANGES)) {
    await change();
    await settle();
    steps.push(await garment());
    assert.notDeepEqual(steps.at(-1), steps.at(-2), name);
  }
  for (const [i, step] of steps.slice(0, -1).reverse().entries()) {
    if (i % 2) await page.getByRole("button", { name: "Undo", exact: true }).click();
    else {
      await page.locator("#splitter").focus();
      await page.keyboard.press("Control+z");
    }
    await settle();
    assert.deepEqual(await garment(), step);
    assert.match(await status(), /^Undone: /);
  }
  assert.ok(await page.locator("#undo").isDisabled());
  for (const step of steps.slice(1)) {
    await page.getByRole("button", { name: "Redo", exact: true }).click();
    await settle();
    assert.deepEqual(await garment(), step);
  }
  assert.ok(await page.locator("#redo").isDisabled());
  for (const _ of steps.slice(1)) await page.getByRole("button", { name: "Undo", exact: true }).click();
  await settle();
});

test("seams, fabric and body stay when the pattern is read in other units", async () => {
  await CHANGES.measurement();
  const kept = await garment();
  await page.locator("#import-units").selectOption("cm");
  await page.waitForFunction(() => document.getElementById("pattern-facts").textContent.includes("cm"));
  await seamCount(6);
  assert.deepEqual(await garment(), kept);
  assert.equal(await page.locator("#import-units").inputValue(), "cm");
  await page.getByRole("button", { name: "Undo", exact: true }).click();
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

/** Two pieces in one file. */
function pieces(corners) {
  const line = (points) => `0\nLWPOLYLINE\n8\n1\n90\n${points.length}\n70\n1\n${points.map(([x, y]) => `10\n${x}\n20\n${y}\n`).join("")}`;
  return `0\nSECTION\n2\nENTITIES\n${line([[0, 0], [0, 300], [200, 300], [200, 0]])}${line(corners)}0\nENDSEC\n0\nEOF\n`;
}

test("work that a sample takes the place of is named, and comes back with its fit", async () => {
  const before = await garment();
  await page.getByRole("button", { name: "Top sample" }).click();
  await panelsDrawn(2);
  await page.waitForFunction(() => document.getElementById("undo").title.startsWith("Undo: opening"));
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await panelsDrawn(3);
  assert.deepEqual(await garment(), before);
  await page.getByRole("button", { name: "Redo", exact: true }).click();
  await panelsDrawn(2);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await panelsDrawn(3);
  await page.setInputFiles("#open-file", { name: "two.dxf", mimeType: "image/vnd.dxf", buffer: Buffer.from(pieces([[300, 0], [300, 200], [500, 200], [500, 0]])) });
  await page.waitForFunction(() => document.getElementById("status").textContent.includes("Undo brings back"));
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await panelsDrawn(3);
});

test("a reload keeps the work of this tab, and a second tab has its own", async () => {
  await page.getByRole("button", { name: "Delete side-left", exact: true }).click();
  await seamCount(5);
  const mine = await garment();
  await page.reload();
  await seamCount(5);
  assert.deepEqual(await garment(), mine);
  assert.ok(await page.locator("#import-units").isEnabled(), "the file can be read in another way still");
  const second = await tab.context.newPage();
  await second.goto(page.url());
  await panelsDrawn(3, second);
  await second.waitForFunction(() => /other work on this pattern|open in another tab/.test(document.getElementById("status").textContent));
  await page.waitForFunction(() => document.getElementById("status").textContent.includes("open in another tab"));
  await second.locator("#default-fabric").selectOption(await otherFabric(second));
  await settle();
  await page.reload();
  await seamCount(5);
  assert.deepEqual(await garment(), mine, "the first tab has what it had");
  await second.locator("#open").click();
  const entries = second.locator("#open-recent .entry");
  await entries.nth(1).waitFor();
  assert.deepEqual(await axeFaults(second), []);
  await entries.filter({ hasText: "5 seams" }).first().click();
  await seamCount(5, second);
  await second.close();
});

test("work of a closed tab and earlier fits are listed and opened", async () => {
  const id = await page.evaluate(async () => {
    const pattern = new URLSearchParams(location.hash.slice(1)).get("pattern");
    const garment = await (await fetch("/samples/skirt.garment.json")).json();
    const fit = await (await fetch("/v1/fits", {
      method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ ...garment, pattern }),
    })).json();
    await fetch(`/v1/fits/${fit.id}/cancel`, { method: "POST" });
    return fit.id;
  });
  const third = await tab.context.newPage();
  await third.goto(service.url);
  await third.locator("#open").click();
  const fits = third.locator("#open-recent ul").nth(1).locator(".entry");
  await fits.first().waitFor();
  assert.match(await fits.first().textContent(), /waiting|being sewn|canceled/);
  await fits.first().click();
  await seamCount(6, third);
  await third.waitForFunction((fit) => location.hash.includes(fit), id);
  await third.close();
});

test("nothing failed but what was asked for", () => {
  tab.record.errors = tab.record.errors.filter((text) => !/ 404 | 409 /.test(text));
  assert.deepEqual(tab.record, { foreign: [], errors: [], breaches: [] });
});
