// All kinds of seams by hand, and proposals: `node tests/browser/seams.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { chooseFile, clickEdge, edgePath, holdBack, keyOnEdge, openDrawer, pointOnEdge, press, samplePath, savedGarment, shownPattern, statusOf, twoFrames, undo, untilStatus } from "./acts.mjs";
import { assertClean, axeFaults, startPage } from "./support.mjs";

const { page, record, close } = await startPage();
after(close);
await page.setInputFiles("#open-file", samplePath("skirt.dxf"));
await edgePath(page, "skirt-front", 0).waitFor({ state: "attached" });
await openDrawer(page, "seams");

async function seams() {
  await twoFrames(page);
  return (await savedGarment(page)).seams;
}

const click = (panel, edge, fraction, options) => clickEdge(page, panel, edge, fraction, options);

async function drag(panel, edge, from, to) {
  const [start, end] = [await pointOnEdge(page, panel, edge, from), await pointOnEdge(page, panel, edge, to)];
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  for (let i = 1; i <= 8; i++) {
    const { x, y } = await pointOnEdge(page, panel, edge, from + ((to - from) * i) / 8);
    await page.mouse.move(x, y);
  }
  await page.mouse.move(end.x, end.y);
  const tag = await page.locator(".edge-tag").textContent();
  await page.mouse.up();
  return tag;
}

const run = (panel, from, to, direction) => ({ panel, from, to, direction });

test("shift joins edges to one side, of the first side and of the seam just made", async () => {
  await click("waistband", 3, 0.2);
  await click("waistband", 4, 0.3, { shift: true });
  assert.match(await statusOf(page), /First side: WAISTBAND 3 → 5, \d+\.\d cm/);
  await click("skirt-back", 0, 0.2);
  await click("skirt-back", 1, 0.2, { shift: true });
  const [seam] = (await seams()).slice(-1);
  assert.deepEqual([seam.a, seam.b], [run("waistband", 3, 5, "cw"), run("skirt-back", 0, 2, "cw")]);
  await undo(page);
  assert.deepEqual((await seams()).at(-1).b, run("skirt-back", 0, 1, "cw"));
  await undo(page);
});

test("edges that do not touch make a list of runs, by keys", async () => {
  await keyOnEdge(page, "waistband", 0, "Enter");
  await keyOnEdge(page, "skirt-front", 0, "Enter");
  await keyOnEdge(page, "skirt-back", 0, "a");
  const [seam] = (await seams()).slice(-1);
  assert.deepEqual(seam.b, [run("skirt-front", 0, 1, "cw"), run("skirt-back", 0, 1, "cw")]);
  await undo(page);
  await undo(page);
});

test("a drag along an outline picks a part of it, caught by corners and notches, with its length", async () => {
  const tag = await drag("skirt-front", 1, 0.02, 0.7);
  assert.match(tag, /SKIRT FRONT 1 → .*, \d+\.\d cm/);
  await page.locator(".pending .seam-line").waitFor({ state: "attached" });
  const front = (await shownPattern(page)).panels.find((panel) => panel.id === "skirt-front");
  const index = front.notches.findIndex((notch) => notch.edge === 3);
  await page.keyboard.press("Escape");
  await drag("skirt-front", 3, 0.98, front.notches[index].at + 0.01);
  await click("skirt-back", 2, 0.2);
  const [seam] = (await seams()).slice(-1);
  assert.deepEqual(seam.a, run("skirt-front", 0, { notch: index }, "ccw"));
  await undo(page);
});

test("a part is set by numbers", async () => {
  await click("skirt-front", 1, 0.2);
  await click("skirt-back", 4, 0.8);
  const field = page.getByLabel(/^First side to, cm/);
  const whole = Number(await field.inputValue());
  await field.fill(String(whole - 10));
  await field.press("Tab");
  await twoFrames(page);
  assert.match(await page.evaluate(() => document.activeElement.dataset.key), /^b from /, "the focus goes to the next field");
  const [seam] = (await seams()).slice(-1);
  assert.equal(seam.a.to.edge, 1);
  assert.ok(Math.abs(seam.a.to.at - (whole - 10) / whole) < 1e-3);
  await page.getByLabel(/^First side to, cm/).fill("0");
  await page.getByLabel(/^First side to, cm/).press("Tab");
  assert.deepEqual((await seams()).at(-1), seam, "no part has no length");
});

test("a text that is being typed stays while the check answers", async () => {
  let release;
  const gate = new Promise((done) => { release = done; });
  await page.route("**/seams/check", async (route) => {
    await gate;
    await route.continue();
  });
  await page.getByRole("checkbox", { name: "Gather" }).click();
  const name = page.getByLabel("Name", { exact: true });
  await name.fill("");
  await name.pressSequentially("left");
  const answer = page.waitForResponse((response) => response.url().endsWith("/seams/check"));
  release();
  await answer;
  await twoFrames(page);
  await name.pressSequentially(" side");
  assert.equal(await name.inputValue(), "left side");
  await name.press("Enter");
  assert.equal((await seams()).at(-1).id, "left side");
  await page.unroute("**/seams/check");
  await undo(page);
  await undo(page);
});

test("what is held down by mouse or space bar is not painted anew before it is let go", async () => {
  const found = async () => (await seams()).map(({ gather = false, ...seam }) => ({ ...seam, gather }));
  const before = await found();
  const reverse = page.locator("#seam-list button[aria-label^='Reverse']");
  const gather = page.locator("#seam-list label", { hasText: "Gather" });
  const byMouse = async (target) => {
    const { x, y, width, height } = await target.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    return () => page.mouse.up();
  };
  const bySpace = async (target) => {
    await target.focus();
    await page.keyboard.down("Space");
    return () => page.keyboard.up("Space");
  };
  for (const [hold, target] of [[byMouse, reverse], [bySpace, reverse], [byMouse, gather]]) {
    await page.locator("#seam-list .choose").click();
    const release = await holdBack(page, "POST", /\/seams\/check$/);
    await target.click();
    await twoFrames(page);
    const held = await target.elementHandle();
    const letGo = await hold(target);
    await release();
    assert.ok(await held.evaluate((node) => node.isConnected));
    await letGo();
    assert.deepEqual(await found(), before, "it was clicked twice, so all is as it was");
    await page.waitForFunction((node) => !node.isConnected, held);
    await undo(page);
    await undo(page);
  }
  assert.deepEqual(await found(), before);
});

test("a seam is selected by its number on the drawing, renamed and deleted by key", async () => {
  assert.equal(await page.locator("#seam-list .seam.selected").count(), 0);
  const badge = await page.locator("#sheet [data-badge]").first().boundingBox();
  await page.mouse.click(badge.x + badge.width / 2, badge.y + badge.height / 2);
  await page.locator("#seam-list .seam.selected").waitFor();
  const name = page.getByLabel("Name", { exact: true });
  await name.fill("left side");
  await name.press("Enter");
  assert.equal((await seams()).at(-1).id, "left side");
  assert.deepEqual(await axeFaults(page), []);
  await page.locator("#splitter").focus();
  await page.keyboard.press("Delete");
  assert.equal((await seams()).length, 0);
  await undo(page);
  assert.equal((await seams()).at(-1).id, "left side");
  await undo(page);
  await undo(page);
  await undo(page);
});

test("the sides of a dart run to its apex, or to the middle between two notches", async () => {
  const dart = await page.evaluate(async () => {
    const { dartIn } = await import("/sides.js");
    const edge = { index: 0, from: 0, to: 1, points: [[0, 0], [0.1, 0], [0.12, -0.08], [0.14, 0], [0.3, 0]] };
    const panel = { id: "p", edges: [edge], notches: [{ edge: 0, at: 0.2 }, { edge: 0, at: 0.4 }] };
    const flat = { ...edge, points: [[0, 0], [0.3, 0]] };
    return {
      apex: dartIn(panel, edge, { direction: "cw" }, { direction: "ccw" }),
      notches: dartIn(panel, flat, { direction: "cw", notch: 1 }, { direction: "cw", notch: 0 }),
      none: dartIn(panel, flat, { direction: "cw" }, { direction: "ccw" }),
    };
  });
  assert.equal(dart.none, null);
  assert.deepEqual(dart.notches, {
    a: run("p", { notch: 0 }, { edge: 0, at: 0.30000000000000004 }, "cw"), b: run("p", { notch: 1 }, { edge: 0, at: 0.30000000000000004 }, "ccw"),
  });
  assert.equal(dart.apex.a.from, 0);
  assert.equal(dart.apex.b.from, 1);
});

test("two clicks at two notches of an edge sew a dart", async () => {
  const pattern = await shownPattern(page);
  delete pattern.id;
  const front = pattern.panels.find((panel) => panel.id === "skirt-front");
  front.notches = [{ edge: 2, at: 0.3 }, { edge: 2, at: 0.5 }];
  await chooseFile(page, "notched.json", JSON.stringify({ schema: "seamster/garment/1", pattern, seams: [] }));
  await untilStatus(page, "does not hold this pattern");
  await twoFrames(page);
  await click("skirt-front", 2, 0.5);
  await click("skirt-front", 2, 0.3);
  const [{ a, b }] = await seams();
  assert.deepEqual([a, b], [run("skirt-front", { notch: 0 }, { edge: 2, at: 0.4 }, "cw"), run("skirt-front", { notch: 1 }, { edge: 2, at: 0.4 }, "ccw")]);
  await undo(page);
  await undo(page);
  await page.waitForFunction(() => !document.getElementById("suggest").disabled);
  await twoFrames(page);
});

test("a dart that is cut out is sewn by two clicks of its legs", async () => {
  const outline = [[0, 0], [0, 300], [90, 300], [100, 200], [110, 300], [200, 300], [200, 0]];
  const points = outline.map(([x, y]) => `10\n${x}\n20\n${y}\n`).join("");
  const dxf = `0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n1\n90\n${outline.length}\n70\n1\n${points}0\nENDSEC\n0\nEOF\n`;
  await chooseFile(page, "dart.dxf", dxf);
  await page.waitForFunction(() => !document.querySelector('path.edge[data-panel="skirt-front"]') && document.querySelectorAll("path.edge").length === 7);
  await twoFrames(page);
  const legs = await page.evaluate(() => [...document.querySelectorAll("path.edge")]
    .filter((path) => Math.abs(path.getTotalLength() - Math.hypot(0.01, 0.1)) < 1e-4).map((path) => [path.dataset.panel, Number(path.dataset.edge)]));
  assert.equal(legs.length, 2);
  const [first, second] = legs.sort((a, b) => a[1] - b[1]);
  await click(...first, 0.2);
  await click(...second, 0.8);
  const [{ a, b }] = await seams();
  assert.deepEqual(a.to, b.to, "both run to the point of the dart");
  assert.notDeepEqual(a.from, b.from);
  await untilStatus(page, "can be sewn");
  await undo(page);
  await undo(page);
  await edgePath(page, "skirt-front", 0).waitFor({ state: "attached" });
  await twoFrames(page);
});

test("a seam brings its twin on the other half", async () => {
  await press(page, "Mirror");
  await click("skirt-front", 1, 0.2);
  await click("skirt-back", 4, 0.8);
  const found = await seams();
  assert.equal(found.length, 2);
  assert.deepEqual([found[1].a, found[1].b], [run("skirt-front", 0, 3, "ccw"), run("skirt-back", 2, 3, "cw")]);
  await undo(page);
  assert.equal((await seams()).length, 0, "both at once");
  await press(page, "Mirror");
});

test("numbers and colors of seams stay when another goes", async () => {
  for (const [a, b] of [[["skirt-front", 1, 0.2], ["skirt-back", 4, 0.8]], [["skirt-front", 3, 0.8], ["skirt-back", 2, 0.2]]]) {
    await click(...a);
    await click(...b);
  }
  await twoFrames(page);
  const badges = () => page.locator("#seam-list .badge").allTextContents();
  assert.deepEqual(await badges(), ["1", "2"]);
  await page.locator("#seam-list button[aria-label^='Delete']").first().click();
  await twoFrames(page);
  assert.deepEqual(await badges(), ["2"]);
  assert.ok(await page.locator("#seam-list .seam.seam-c1").count());
  await undo(page);
  await twoFrames(page);
  assert.deepEqual(await badges(), ["1", "2"]);
  await undo(page);
  await undo(page);
});

test("a seam does not take the number of one that has another's old name", async () => {
  const side = [["skirt-front", 1, 0.2], ["skirt-back", 4, 0.8]];
  const other = [["skirt-front", 3, 0.8], ["skirt-back", 2, 0.2]];
  const waist = [["waistband", 3, 0.2], ["skirt-back", 0, 0.2]];
  const badges = async () => {
    await twoFrames(page);
    return page.locator("#seam-list .badge").allTextContents();
  };
  for (const [a, b] of [side, other]) {
    await click(...a);
    await click(...b);
  }
  await twoFrames(page);
  await page.locator("#seam-list button[aria-label^='Delete']").nth(1).click();
  for (const [a, b] of [waist, other]) {
    await click(...a);
    await click(...b);
  }
  assert.deepEqual(await badges(), ["1", "2", "3"]);
  for (let i = 0; i < 5; i++) await undo(page);
  assert.deepEqual(await badges(), []);
});

test("the tape measures between two points", async () => {
  await press(page, "Tape");
  await click("skirt-front", 1, 0);
  await click("skirt-front", 3, 1);
  await twoFrames(page);
  assert.match(await page.locator(".tape text").textContent(), /^\d\d\.\d cm/);
  assert.equal(await page.locator(".pending").count(), 0);
  await press(page, "Tape");
  await twoFrames(page);
  assert.equal(await page.locator(".tape").count(), 0);
});

test("proposals are drawn dashed and accepted or refused, offers are not sewn before", async () => {
  await page.route("**/seams/suggest", async (route) => {
    const response = await route.fetch();
    const body = await response.json();
    body.seams.at(-1).confidence = 0.4;
    await route.fulfill({ response, json: body });
  });
  await page.locator("#suggest").click();
  await page.locator(".seam-mark.proposed").first().waitFor();
  assert.match(await statusOf(page), /seams suggested, 1 more only offered.*\d of 3 panels understood/);
  const count = (await seams()).length;
  assert.equal(await page.locator(".seam-mark.proposed").count(), count);
  assert.equal(await page.locator("#seam-list .seam.offer").count(), 1);
  assert.deepEqual(await axeFaults(page), []);
  const chosen = () => page.evaluate(() => document.activeElement.dataset.key);
  const [first] = await seams();
  await page.getByRole("button", { name: `Accept ${first.id}`, exact: true }).press("Enter");
  await twoFrames(page);
  assert.equal(await chosen(), `choose ${first.id}`, "the focus stays in the row");
  assert.equal(await page.locator(".seam-mark.proposed").count(), count - 1);
  await page.locator("#seam-list .offer button[aria-label^='Accept']").click();
  assert.equal((await seams()).length, count + 1);
  await undo(page);
  await page.locator("#seam-list .offer button[aria-label^='Refuse']").click();
  await twoFrames(page);
  assert.equal(await page.locator("#seam-list .offer").count(), 0);
  const [, refused, behind] = await seams();
  await page.getByRole("button", { name: `Refuse ${refused.id}`, exact: true }).press("Enter");
  await twoFrames(page);
  assert.equal(await chosen(), `choose ${behind.id}`, "the focus goes to the next row");
  assert.equal((await seams()).length, count - 1);
  await press(page, "Accept all");
  await twoFrames(page);
  assert.equal(await page.locator(".seam-mark.proposed").count(), 0);
  await page.unroute("**/seams/suggest");
});

test("nothing failed", () => assertClean(record));
