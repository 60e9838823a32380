// Places and sizes of all parts, measured: `node tests/browser/layout.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import * as acts from "./acts.mjs";
import { assertClean, axeFaults, openTab, startSuite } from "./support.mjs";

const SIZES = [{ width: 1280, height: 800 }, { width: 1920, height: 1080 }, { width: 820, height: 1180 }];
const TAB_STOPS_TO_SEW = 8;

const { service, browser, close } = await startSuite();
after(close);

/** A tab of its own with the sample in it. */
async function openSkirt(viewport, options = {}) {
  const tab = await openTab(browser, service.url, { viewport, ...options });
  await acts.openSkirt(tab.page, "Try the skirt");
  return tab;
}

const boxOf = (page, selector) => page.locator(selector).boundingBox();
const near = (a, b, what) => assert.ok(Math.abs(a - b) <= 1, `${what} is ${a}, not ${b}`);

for (const viewport of SIZES) {
  const { width, height } = viewport;
  const isNarrow = width < 1000;

  test(`at ${width} x ${height} each part has its size`, async () => {
    const { page, context } = await openSkirt(viewport);
    const screen = width * height;
    const share = async (selector) => {
      const box = await boxOf(page, selector);
      return (box.width * box.height) / screen;
    };
    near((await boxOf(page, ".bar")).height, 48, "the bar");
    near((await boxOf(page, "#drawer")).height, 36, "the closed drawer");
    assert.equal(await page.locator("#rail").isVisible(), !isNarrow);
    if (!isNarrow) near((await boxOf(page, "#rail")).width, 220, "the rail");
    const [stage, sheet] = [await share("#stage"), await share("#sheet")];
    assert.ok(stage >= 0.35, `the garment takes ${stage}`);
    assert.ok(sheet >= 0.3, `the pattern takes ${sheet}`);
    console.log(`${width} x ${height}: garment ${(100 * stage).toFixed(1)} %, pattern ${(100 * sheet).toFixed(1)} % of the screen`);
    const [above, below] = [await boxOf(page, "#stage"), await boxOf(page, "#sheet")];
    if (isNarrow) assert.ok(above.y + above.height <= below.y, "the garment stands over the pattern");
    else assert.ok(below.x + below.width <= above.x, "the pattern stands beside the garment");
    await acts.openDrawer(page, "seams");
    assert.ok((await boxOf(page, "#drawer")).height <= 0.35 * height + 1);
    const sides = await page.evaluate(() => [document.documentElement.scrollWidth - innerWidth, document.documentElement.scrollHeight - innerHeight]);
    assert.deepEqual(sides, [0, 0], "the page itself does not scroll");
    await context.close();
  });

  test(`at ${width} x ${height} sewing is in sight and ${TAB_STOPS_TO_SEW} stops away`, async () => {
    const { page, context } = await openSkirt(viewport);
    await page.locator("#run:enabled").waitFor();
    const box = await boxOf(page, "#run");
    assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height);
    await page.evaluate(() => { document.activeElement.blur(); getSelection().removeAllRanges(); document.body.tabIndex = -1; document.body.focus(); });
    let stops = 0;
    do {
      await page.keyboard.press("Tab");
      stops += 1;
    } while (stops < 60 && await page.evaluate(() => document.activeElement.id) !== "run");
    assert.ok(stops <= TAB_STOPS_TO_SEW, `${stops} stops`);
    await context.close();
  });

  for (const colorScheme of ["light", "dark"]) {
    test(`at ${width} x ${height} in ${colorScheme} nothing is inaccessible`, async () => {
      const { page, record, context } = await openSkirt(viewport, { colorScheme });
      assert.deepEqual(await axeFaults(page), []);
      await acts.openDrawer(page, "seams");
      if (isNarrow) await page.locator("#rail-toggle").click();
      assert.deepEqual(await axeFaults(page), []);
      assertClean(record);
      await context.close();
    });
  }
}

test("on a phone sewing is in sight", async () => {
  const { page, context } = await openSkirt({ width: 390, height: 800 });
  await page.locator("#run:enabled").waitFor();
  const box = await boxOf(page, "#run");
  assert.ok(box.x >= 0 && box.x + box.width <= 390, `it ends at ${box.x + box.width}`);
  assert.deepEqual(await axeFaults(page), []);
  await context.close();
});

test("there are two sizes of type beside headings", async () => {
  const { page, context } = await openSkirt(SIZES[0]);
  await acts.openDrawer(page, "seams");
  await page.locator("#seam-list .choose").first().click();
  await page.locator(".help summary").click();
  const sizes = await page.evaluate(() => {
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const found = new Set();
    while (texts.nextNode()) {
      const parent = texts.currentNode.parentElement;
      if (texts.currentNode.data.trim() && parent.checkVisibility() && !parent.closest("h1, h2, h3, option")) found.add(getComputedStyle(parent).fontSize);
    }
    return [...found].sort();
  });
  assert.deepEqual(sizes, ["12px", "13px"]);
  await context.close();
});

test("the rail folds, panes fill the work, and the splitter moves by mouse and keys", async () => {
  const { page, context } = await openSkirt(SIZES[0]);
  const sheet = () => boxOf(page, "#sheet");
  const before = await sheet();
  await page.keyboard.press("b");
  await page.locator("#rail").waitFor({ state: "hidden" });
  assert.ok((await sheet()).width > before.width);
  await page.keyboard.press("2");
  await acts.twoFrames(page);
  near((await sheet()).width, 1280, "the pattern alone");
  assert.equal(await page.locator("#stage").isVisible(), false);
  await page.keyboard.press("3");
  await acts.twoFrames(page);
  near((await boxOf(page, "#stage")).width, 1280, "the garment alone");
  await page.keyboard.press("3");
  await page.keyboard.press("b");
  await acts.twoFrames(page);
  near((await sheet()).width, before.width, "the pattern beside the garment");
  await page.locator("#splitter").focus();
  await page.keyboard.press("ArrowRight");
  await acts.twoFrames(page);
  const wider = await sheet();
  assert.ok(wider.width > before.width + 10);
  const bar = await boxOf(page, "#splitter");
  await page.mouse.move(bar.x + 2, bar.y + 200);
  await page.mouse.down();
  await page.mouse.move(bar.x - 98, bar.y + 200, { steps: 5 });
  await page.mouse.up();
  await acts.twoFrames(page);
  assert.ok(Math.abs((await sheet()).width - (wider.width - 100)) < 5);
  await page.reload();
  await page.locator('path.edge[data-panel="skirt-front"]').first().waitFor({ state: "attached" });
  assert.ok(Math.abs((await sheet()).width - (wider.width - 100)) < 5, "the layout is kept");
  await context.close();
});

test("on a tablet the rail is a sheet that Escape puts away", async () => {
  const { page, context } = await openSkirt(SIZES[2]);
  const before = await boxOf(page, "#sheet");
  await page.locator("#rail-toggle").click();
  await page.locator("#rail").waitFor();
  assert.deepEqual(await boxOf(page, "#sheet"), before, "it lies over the work");
  await page.keyboard.press("Escape");
  await page.locator("#rail").waitFor({ state: "hidden" });
  await context.close();
});

test("a file dropped anywhere is opened, and a garment told from a pattern", async () => {
  const { page, context } = await openSkirt(SIZES[0]);
  const drop = (name, text) => page.evaluate(([title, content]) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], title));
    for (const type of ["dragenter", "dragover", "drop"]) {
      document.getElementById("stage").dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }
  }, [name, text]);
  const id = await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("pattern"));
  await drop("one.json", JSON.stringify({ schema: "seamster/garment/1", pattern: id, seams: [] }));
  await acts.untilSeams(page, 0);
  const top = await page.evaluate(() => fetch("/samples/top.dxf").then((response) => response.text()));
  await drop("top.dxf", top);
  await acts.untilPanels(page, 2);
  await context.close();
});
