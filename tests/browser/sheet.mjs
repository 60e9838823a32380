// The sheet under mouse, wheel and keys: `node tests/browser/sheet.mjs`.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, test } from "node:test";
import { openSkirt, pointOnEdge, press, twoFrames, undo } from "./acts.mjs";
import { assertClean, startPage } from "./support.mjs";

const { SEAMSTER_TEST_DATA } = process.env;
const { page, record, close } = await startPage();
after(close);
await openSkirt(page);

/** The view as `{x, y, k}`. */
async function view() {
  await twoFrames(page);
  return page.locator(".cloth-layer").evaluate((layer) => {
    const { a, e, f } = layer.getCTM();
    return { x: e, y: f, k: a };
  });
}

const middleOf = async (selector) => {
  const box = await page.locator(selector).boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};

const near = (a, b, within = 0.6) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test("the wheel zooms at the pointer", async () => {
  const before = await view();
  const at = await pointOnEdge(page, "skirt-front", 1, 0.3);
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, -400);
  const now = await view();
  assert.ok(now.k > 1.5 * before.k, `${before.k} to ${now.k}`);
  const moved = await pointOnEdge(page, "skirt-front", 1, 0.3);
  near(moved.x, at.x, 1);
  near(moved.y, at.y, 1);
  await press(page, "Fit");
  near((await view()).k, before.k, 0.05 * before.k);
});

for (const way of ["the middle button", "the space bar", "a drag from free ground"]) {
  test(`${way} moves the sheet and picks nothing`, async () => {
    const before = await view();
    const sheet = await page.locator("#sheet").boundingBox();
    const free = { x: sheet.x + sheet.width / 2, y: sheet.y + sheet.height - 6 };
    const start = way.startsWith("a drag") ? free : await pointOnEdge(page, "skirt-front", 1);
    await page.mouse.move(start.x, start.y);
    if (way === "the space bar") {
      await page.locator('path.edge[data-panel="skirt-front"][data-edge="0"]').focus();
      await page.keyboard.down("Space");
    }
    const button = way === "the middle button" ? "middle" : "left";
    await page.mouse.down({ button });
    await page.mouse.move(start.x + 20, start.y - 10, { steps: 4 });
    await page.mouse.move(start.x + 60, start.y - 40, { steps: 4 });
    await page.mouse.up({ button });
    if (way === "the space bar") await page.keyboard.up("Space");
    const now = await view();
    near(now.x - before.x, 60);
    near(now.y - before.y, -40);
    near(now.k, before.k, 1e-6);
    assert.equal(await page.locator(".pending").count(), 0);
    await press(page, "Fit");
  });
}

test("a double click fits a panel", async () => {
  const sheet = await page.locator("#sheet").boundingBox();
  const at = await middleOf('[data-of="waistband"] .cloth');
  await page.mouse.dblclick(at.x, at.y);
  await twoFrames(page);
  const box = await page.locator('[data-of="waistband"] .cloth').boundingBox();
  assert.ok(box.width > 0.6 * sheet.width && box.width < sheet.width, `${box.width} of ${sheet.width}`);
  await page.keyboard.press("Escape");
});

test("labels never lie on each other, at any zoom", async () => {
  const overlaps = () => page.evaluate(() => {
    const boxes = [...document.querySelectorAll("#sheet .labels .label")].map((label) => label.getBoundingClientRect());
    let count = 0;
    for (let i = 0; i < boxes.length; i++) {
      for (let j = 0; j < i; j++) {
        const [a, b] = [boxes[i], boxes[j]];
        // The line box of a text is a little higher than its letters.
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        count += across > 2 && down > 4;
      }
    }
    return { labels: boxes.length, count };
  });
  const files = SEAMSTER_TEST_DATA ? ["valentina_maleshirt_aama_r12.dxf", "gc_pencil_skirt__r12_aama.dxf"] : [];
  for (const file of [null, ...files]) {
    if (file) {
      await page.setInputFiles("#open-file", join(SEAMSTER_TEST_DATA, "dxf", file));
      await page.waitForFunction(() => !document.querySelector('path.edge[data-panel="skirt-front"]') && document.querySelector("path.edge"));
    }
    const middle = await middleOf("#sheet");
    await page.mouse.move(middle.x, middle.y);
    for (const turn of [0, 300, -600, -300, -600]) {
      await page.mouse.wheel(0, turn);
      await twoFrames(page);
      const { labels, count } = await overlaps();
      assert.ok(labels > 0);
      assert.equal(count, 0, `${file ?? "skirt"} after ${turn}`);
    }
  }
  await openSkirt(page);
});

test("a tag says edge and length, and how it compares with the first side", async () => {
  const tag = () => page.locator(".edge-tag").textContent();
  const edge = await pointOnEdge(page, "skirt-front", 1, 0.3);
  await page.mouse.move(edge.x, edge.y);
  assert.match(await tag(), /^SKIRT FRONT, edge 1, \d+\.\d cm$/);
  await page.mouse.click(edge.x, edge.y);
  const partner = await pointOnEdge(page, "skirt-back", 4, 0.7);
  await page.mouse.move(partner.x, partner.y);
  assert.match(await tag(), /SKIRT BACK, edge 4, .* : .* cm, [+−]\d+\.\d cm \(\d+ %\)they match$/);
  assert.ok(await page.locator(".edge-tag .grade-same").count() > 0);
  const other = await pointOnEdge(page, "skirt-back", 0, 0.4);
  await page.mouse.move(other.x, other.y);
  assert.match(await tag(), /−\d+\.\d cm \(\d+ %\)far shorter, hardly a pair$/);
  assert.ok(await page.locator(".edge-tag .grade-no").count() > 0);
  const label = await page.locator('path.edge[data-panel="skirt-back"][data-edge="4"]').getAttribute("aria-label");
  assert.match(label, /they match$/, "a screen reader is told too");
  await page.keyboard.press("Escape");
});

test("the sheet stays where it is while seams are picked", async () => {
  await page.keyboard.press("Escape");
  const before = await view();
  const one = await pointOnEdge(page, "skirt-front", 2, 0.3);
  await page.mouse.click(one.x, one.y);
  assert.deepEqual(await view(), before);
  const two = await pointOnEdge(page, "skirt-back", 3, 0.7);
  await page.mouse.click(two.x, two.y);
  await page.locator(".pending").waitFor({ state: "detached" });
  assert.equal(await page.locator("#seam-list .seam").count(), 7);
  assert.deepEqual(await view(), before);
  await undo(page);
  assert.deepEqual(await view(), before);
});

test("edges without a seam that are as long as the first side are shown", async () => {
  const one = await pointOnEdge(page, "skirt-front", 2, 0.3);
  await page.mouse.click(one.x, one.y);
  const likely = await page.locator("path.edge.likely").evaluateAll((paths) => paths.map((path) => `${path.dataset.panel} ${path.dataset.edge}`));
  assert.deepEqual(likely, ["skirt-back 3"]);
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => !document.querySelector("path.edge.likely"));
});

test("two fingers zoom about their middle, one moves the sheet", async () => {
  const client = await page.context().newCDPSession(page);
  await press(page, "Fit");
  const before = await view();
  const { x, y } = await middleOf("#sheet");
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([dx, dy], id) => ({ x: x + dx, y: y + dy, id })) });
  await touch("touchStart", [-40, 0], [40, 0]);
  for (const spread of [50, 60, 70, 80]) await touch("touchMove", [-spread, 0], [spread, 0]);
  await touch("touchEnd");
  const zoomed = await view();
  near(zoomed.k / before.k, 2, 0.1);
  await touch("touchStart", [0, 0]);
  for (const step of [10, 20, 30]) await touch("touchMove", [step, step]);
  await touch("touchEnd");
  const moved = await view();
  near(moved.k, zoomed.k, 1e-6);
  near(moved.x - zoomed.x, 30, 2);
  assert.equal(await page.locator(".pending").count(), 0);
  await press(page, "Fit");
});

test("a press that is let go outside of the sheet, or by another button, picks nothing", async () => {
  const before = await view();
  const at = await pointOnEdge(page, "skirt-front", 1, 0.3);
  const outside = await middleOf("#head-sheet");
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(outside.x, outside.y);
  await page.mouse.up();
  await page.mouse.move(at.x, at.y);
  await page.mouse.move(at.x + 40, at.y + 30, { steps: 4 });
  assert.deepEqual(await view(), before);
  assert.equal(await page.locator("#sheet.grabbing").count() + await page.locator(".preview").count(), 0, "the pointer is up");
  await page.keyboard.press("Escape");
  const end = await pointOnEdge(page, "skirt-front", 1, 0.6);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down({ button: "right" });
  await page.mouse.move(end.x, end.y, { steps: 4 });
  await page.mouse.up({ button: "right" });
  await twoFrames(page);
  assert.equal(await page.locator(".pending").count(), 0);
});

test("letters are keys in the work alone, in either case", async () => {
  const rail = page.locator("#rail");
  await page.locator("#open").focus();
  await page.keyboard.press("b");
  assert.ok(await rail.isVisible(), "not in the bar");
  await page.locator("#splitter").focus();
  await page.keyboard.press("Shift+B");
  await rail.waitFor({ state: "hidden" });
  await page.keyboard.press("b");
  await rail.waitFor();
});

test("the tape takes the place of the run that a click would pick", async () => {
  const at = await pointOnEdge(page, "skirt-front", 1, 0.3);
  await page.locator('path.edge[data-panel="skirt-front"][data-edge="0"]').focus();
  await twoFrames(page);
  await page.mouse.move(at.x, at.y);
  assert.equal(await page.locator(".preview").count(), 1);
  await page.keyboard.press("t");
  await twoFrames(page);
  assert.equal(await page.locator(".preview, .edge-tag, .edge.hovered").count(), 0);
  await page.keyboard.press("t");
});

test("nothing failed", () => assertClean(record));
