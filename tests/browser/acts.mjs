// Acts of a user on the page, and waits for what they bring, for all suites.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { setTimeout as pause } from "node:timers/promises";
import { fileURLToPath } from "node:url";

/** The file of a sample. */
export const samplePath = (name) => fileURLToPath(new URL(`../../static/samples/${name}`, import.meta.url));

export const statusOf = (page) => page.locator("#status").textContent();

/** Waits until the status says a text. */
export const untilStatus = (page, text) =>
  page.waitForFunction((part) => document.getElementById("status").textContent.includes(part), text);

/** Waits until so many panels are drawn. */
export const untilPanels = (page, count) =>
  page.waitForFunction((many) => document.querySelectorAll("#sheet [aria-label^='Panel ']").length === many, count);

/** Waits until the garment has so many seams. */
export const untilSeams = (page, count) =>
  page.waitForFunction((text) => document.getElementById("seam-count").textContent.replace(/^\d+ of (\d+).*/, "$1") === text, String(count));

/** Waits until all that changed is painted. */
export const twoFrames = (page) =>
  page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));

export const press = (page, name) => page.getByRole("button", { name, exact: true }).click();

export const undo = (page) => press(page, "Undo");

/** Opens the sample by a button; the check of its seams may come later. */
export async function openSkirt(page, button = "Skirt sample") {
  await press(page, button);
  await page.waitForFunction(() => !document.getElementById("status").textContent.startsWith("Reading"));
  await page.locator('path.edge[data-panel="skirt-front"]').first().waitFor({ state: "attached" });
  await twoFrames(page);
}

/** Opens a page of the drawer. */
export async function openDrawer(page, name) {
  const handle = page.locator(`[data-drawer="${name}"]`);
  if (await handle.getAttribute("aria-expanded") === "false") await handle.click();
}

/** Chooses a file whose content is given. */
export const chooseFile = (page, name, content) =>
  page.setInputFiles("#open-file", { name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });

/** The garment as the page would save it. */
export async function savedGarment(page) {
  const waiting = page.waitForEvent("download");
  await press(page, "Save garment");
  return JSON.parse(await readFile(await (await waiting).path()));
}

export const edgePath = (page, panel, edge) => page.locator(`path.edge[data-panel="${panel}"][data-edge="${edge}"]`);

/** A point of an edge on the screen, at a fraction of its length, clockwise. */
export const pointOnEdge = (page, panel, edge, fraction = 0.5) => edgePath(page, panel, edge).evaluate((path, share) => {
  const { x, y } = path.getPointAtLength(path.getTotalLength() * share).matrixTransform(path.getScreenCTM());
  return { x, y };
}, fraction);

/** Clicks an edge at a fraction of its length. */
export async function clickEdge(page, panel, edge, fraction, { shift = false } = {}) {
  const { x, y } = await pointOnEdge(page, panel, edge, fraction);
  if (shift) await page.keyboard.down("Shift");
  await page.mouse.click(x, y);
  if (shift) await page.keyboard.up("Shift");
}

/** Presses a key on an edge. */
export async function keyOnEdge(page, panel, edge, key) {
  await edgePath(page, panel, edge).focus();
  await page.keyboard.press(key);
}

/** The body of the next check that the page asks for, once it is answered. */
export async function checkedAfter(page, act) {
  const asked = page.waitForRequest((request) => request.url().endsWith("/seams/check"));
  await act();
  const request = await asked;
  assert.equal((await request.response()).status(), 200);
  return request.postDataJSON();
}

/** The seams of the list, offers among them. */
export const seamRows = (page) => page.locator("#seam-list .seam");

/** Deletes a seam, or refuses it where it is suggested, and waits for the check of the others. */
export async function deleteSeam(page, id) {
  const count = await page.locator("#seam-list .seam:not(.offer)").count();
  const body = await checkedAfter(page, () => page.locator(`button[aria-label="Delete ${id}"], button[aria-label="Refuse ${id}"]`).click());
  assert.equal(body.seams.length, count - 1);
  assert.ok(!body.seams.some((seam) => seam.id === id));
}

/**
 * Holds the answers of a call back: `release()` waits until at least `least` are held, lets them
 * come or see that the page gave them up, and waits until what they bring is painted. It ends all
 * other routes of the page too.
 */
export async function holdBack(page, method, path, { least = 1 } = {}) {
  let release;
  const gate = new Promise((done) => { release = done; });
  const held = [];
  await page.route((url) => path.test(url.pathname), async (route) => {
    if (route.request().method() !== method) return route.fallback();
    const response = await route.fetch();
    held.push(route.request());
    await gate;
    return route.fulfill({ response }).catch(() => {});
  });
  return async () => {
    for (let i = 0; held.length < least; i++) {
      assert.ok(i < 600, `${held.length} of ${least} calls of ${path} were made`);
      await pause(100);
    }
    release();
    await Promise.all(held.map((request) => request.response()));
    await page.unrouteAll({ behavior: "wait" });
    await twoFrames(page);
  };
}

/** The pattern that the page shows, as the service has it. */
export const shownPattern = (page) => page.evaluate(() =>
  fetch(`/v1/patterns/${new URLSearchParams(location.hash.slice(1)).get("pattern")}`).then((response) => response.json()));

/** Id of the fit that the address names, or null. */
export const fitOf = (page) => page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("fit"));

/** Waits until the shape of the fit that the address names is on the stage. */
export const untilShown = (page) => page.waitForFunction(() => {
  const { shape } = document.getElementById("stage").dataset;
  return shape !== undefined && shape === new URLSearchParams(location.hash.slice(1)).get("fit");
});

/**
 * Waits until the promise of a function in the page is true: `waitForFunction` takes a promise for
 * true.
 */
export async function untilTrue(page, predicate, argument) {
  for (let i = 0; !await page.evaluate(predicate, argument); i++) {
    assert.ok(i < 600, `it did not come true: ${predicate}`);
    await pause(50);
  }
}

/** Waits until the draft of a tab has what the tab shows. */
export const untilKept = (page) => untilTrue(page, async () => {
  const [{ allDrafts }, { fitId, state }] = await Promise.all([import("/drafts.js"), import("/state.js")]);
  const draft = (await allDrafts()).find(({ tab }) => tab === sessionStorage.getItem("seamster.tab"));
  const parts = (patternId, garment, fit, colors) => JSON.stringify([patternId, garment, fit, colors]);
  return draft && parts(draft.patternId, draft.garment, draft.fit, draft.colors) === parts(state.pattern.id, state.garment, fitId(), state.colors);
});

/** A fabric that is not the chosen one. */
export const otherFabric = (page) => page.locator("#default-fabric").evaluate((select) => [...select.options].find((option) => !option.selected).value);

/** A file of two pieces: an oblong and one with the given corners. */
export function pieces(corners) {
  const line = (points) => `0\nLWPOLYLINE\n8\n1\n90\n${points.length}\n70\n1\n${points.map(([x, y]) => `10\n${x}\n20\n${y}\n`).join("")}`;
  return `0\nSECTION\n2\nENTITIES\n${line([[0, 0], [0, 300], [200, 300], [200, 0]])}${line(corners)}0\nENDSEC\n0\nEOF\n`;
}
