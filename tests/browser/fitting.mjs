// The fit judged, sewn again and compared: `node tests/browser/fitting.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { chooseFile, fitOf, openDrawer, openSkirt, press, savedGarment, twoFrames, undo, untilSeams, untilShown, untilStatus } from "./acts.mjs";
import { assertAccessible, assertClean, difference, expectErrors, startPage } from "./support.mjs";

const { page, browser, record, close } = await startPage();
after(close);

const ofFit = (id, part = "") => page.evaluate((path) => fetch(path).then((response) => response.json()), `/v1/fits/${id}${part}`);

async function seen() {
  await twoFrames(page);
  return page.locator("#stage").screenshot();
}

/** Starts a run by a button: the body that is sent, and the id of the fit. */
async function run(button) {
  const answered = page.waitForResponse((response) => response.url().endsWith("/v1/fits") && response.request().method() === "POST" && response.ok());
  await page.locator(`${button}:enabled`).click();
  const response = await answered;
  return { sent: response.request().postDataJSON(), id: (await response.json()).id };
}

/** Waits until a fit is on the stage, with its measures. */
async function untilSewn(id) {
  await page.waitForFunction((fit) => document.getElementById("stage").dataset.shape === fit, id);
  await page.locator("#measures-shown table").waitFor({ state: "attached" });
}

/** Cancels the run; it may have come to rest before. */
async function cancel() {
  await press(page, "Cancel");
  await page.waitForFunction(() => /Canceled|Stopped|came to rest/.test(document.getElementById("status").textContent));
  // Without a shape there is no report.
  expectErrors(record, / 404 .*\/report$/, { least: 0 });
}

/** Rows of a table as texts. */
const rowsOf = (id) => page.locator(`#${id} tbody tr`).evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent.trim())));

const lights = (key) => page.locator(`[data-lights="${key}"]`);

test("rings are found where a height cuts cloth and where it ends free", async () => {
  const found = await page.evaluate(async () => {
    const [THREE, { girthLines, openingLines }] = [await import("three"), await import("/stage/rings.js")];
    const tube = (panel, x, bottom, radius, height, from, turn) => {
      const geometry = new THREE.CylinderGeometry(radius, radius, height, 48, 4, true, from, turn).translate(x, bottom + height / 2, 0);
      return Object.assign(new THREE.Mesh(geometry), { userData: { panel } });
    };
    // Trousers of two halves a leg, and a band of two halves.
    const meshes = [0.2, -0.2].flatMap((x) => [0, Math.PI].map((from, i) => tube(`leg ${x} ${i}`, x, 0, 0.1, 0.8, from, Math.PI)));
    meshes.push(...[0, Math.PI].map((from, i) => tube(`band ${i}`, 0, 0.9, 0.3, 0.1, from, Math.PI)));
    const length = (lines) => lines.reduce((sum, [a, b]) => sum + a.distanceTo(b), 0);
    const middle = (lines) => lines.reduce((sum, [a]) => sum + a.x, 0) / lines.length;
    const thigh = girthLines(meshes, { at: "right thigh", height_m: 0.43 });
    const waist = girthLines(meshes, { at: "waist", height_m: 0.93 });
    const hem = openingLines(meshes, { panels: ["leg 0.2 0", "leg 0.2 1"], height_m: 0, length_m: 0.62 });
    return { thigh: [length(thigh), middle(thigh)], waist: length(waist), hem: [length(hem), middle(hem)] };
  });
  const near = (a, b) => assert.ok(Math.abs(a - b) < 0.02, `${a} is not ${b}`);
  near(found.thigh[0], 0.2 * Math.PI);
  near(found.thigh[1], -0.2);
  near(found.waist, 0.6 * Math.PI);
  near(found.hem[0], 0.2 * Math.PI);
  near(found.hem[1], 0.2);
});

let first;

test("girths and ease are those of the service, and each lights its place", async () => {
  await openSkirt(page, "Try the skirt");
  const { sent, id } = await run("#run");
  first = id;
  assert.equal(sent.start_from, undefined);
  assert.deepEqual(sent.maps, ["strain", "pressure", "gap"]);
  await untilSewn(first);
  await openDrawer(page, "report");
  await page.locator("#measures-shown table").waitFor();
  const { girths } = await ofFit(first, "/measures");
  const centimeters = (meters) => `${(100 * meters).toFixed(1)} cm`;
  const shown = await rowsOf("measures-shown");
  assert.deepEqual(shown.map(([name]) => name), ["Waist", "Hip"]);
  for (const [i, [, cloth, body, ease]] of shown.entries()) {
    assert.deepEqual([cloth, body], [centimeters(girths[i].cloth_m), centimeters(girths[i].body_m)]);
    assert.ok(ease.startsWith(`+${centimeters(girths[i].ease_m)}`), ease);
  }
  const dark = await seen();
  await lights("girth hip").press("Enter");
  await page.locator('[data-lights="girth hip"][aria-pressed="true"]').waitFor();
  assert.ok(await difference(browser, dark, await seen()) > 0.001);
  await lights("girth hip").press("Enter");
  assert.ok(await difference(browser, dark, await seen()) < 0.0005, "it is put out again");
  await assertAccessible(page);
});

test("the verdict says what each opening goes round, and shows it", async () => {
  const { worn } = await ofFit(first, "/report");
  const report = page.locator("#report");
  assert.match(await report.textContent(), /Worn: .*The opening of WAISTBAND goes round the trunk: 76\.\d cm round/s);
  const dark = await seen();
  const shows = report.getByRole("button", { name: /^Show on the garment: The opening of/ });
  assert.equal(await shows.count(), worn.openings.length);
  await shows.first().click();
  assert.ok(await difference(browser, dark, await seen()) > 0.0005);
  await shows.first().click();
});

test("faults light their places", async () => {
  await page.route(/\/report$/, async (route) => {
    const response = await route.fetch();
    const report = await response.json();
    report.good = { ok: false, failed: ["body", "worn"], because: ["cloth passes through the body", "it hangs on one leg"] };
    report.intersections = [{ kind: "inside_body", panels: ["skirt-front", "skirt-front"], at: [0, 0.8, 0.16], count: 4 }];
    report.worn = { ok: false, because: "it hangs on one leg", openings: [{ ...report.worn.openings[0], goes_round: "the left leg" }] };
    await route.fulfill({ response, json: report });
  });
  await page.reload();
  await untilShown(page);
  await page.unrouteAll({ behavior: "wait" });
  await openDrawer(page, "report");
  const bad = page.locator("#report .findings .bad");
  await bad.first().waitFor();
  assert.deepEqual(await bad.evaluateAll((items) => items.map((item) => item.textContent.replace(/ Show$/, ""))), [
    "Cloth passes through the body.", "Not worn: it hangs on one leg.",
    "The opening of SKIRT FRONT, SKIRT BACK was placed round the trunk, but goes round the left leg.",
  ]);
  for (const i of [0, 2]) {
    const show = bad.nth(i).getByRole("button");
    await show.click();
    assert.equal(await show.getAttribute("aria-pressed"), "true");
  }
  await assertAccessible(page);
  await page.reload();
  await untilSewn(first);
});

test("a garment is sewn again from its last shape, in less time, and both are compared", async () => {
  const { sent, id: second } = await run("#run");
  assert.equal(sent.start_from, first);
  await untilSewn(second);
  await openDrawer(page, "report");
  await page.waitForFunction(() => document.querySelectorAll("#comparison tr").length > 4);
  const [before, now] = await Promise.all([first, second].map((id) => ofFit(id, "/report")));
  const rows = Object.fromEntries((await rowsOf("comparison")).map(([name, ...figures]) => [name, figures]));
  assert.deepEqual(rows.Verdict, ["Good", "Good"]);
  assert.deepEqual(rows["Sewn from"], ["flat panels", "the last shape"]);
  assert.deepEqual(rows.Computing, [before, now].map(({ cpu_s: { total } }) => `${total.toFixed(1)} s`));
  assert.match(rows.Hip.join(), /^102\.\d cm, ease 4\.\d cm,102\.\d cm, ease 4\.\d cm$/);
  console.log(`${before.cpu_s.total} s anew, ${now.cpu_s.total} s from the last shape`);
  assert.ok(now.cpu_s.total < 0.6 * before.cpu_s.total);
  await assertAccessible(page);
});

test("a garment can be sewn anew, and a run that is canceled is said to be so", async () => {
  const last = await fitOf(page);
  const { sent, id } = await run("#run-anew");
  assert.equal(sent.start_from, undefined);
  await cancel();
  assert.equal((await ofFit(id)).status, "canceled");
  await page.locator("#stage-caption", { hasText: /The shape of an earlier fit|Stopped before it came to rest/ }).waitFor();
  assert.equal((await run("#run")).sent.start_from, last, "it goes on from the last that succeeded");
  await cancel();
});

test("where the last shape cannot be gone on from, the garment is sewn anew and it is said why", async () => {
  const bodies = [];
  const isFits = (url) => url.pathname === "/v1/fits";
  const fault = { code: "garment/start_avatar", pointer: "/start_from", detail: "the earlier fit is worn on another body, or on none" };
  await page.route(isFits, (route) => {
    bodies.push(route.request().postDataJSON());
    if (bodies.length > 1) return route.continue();
    return route.fulfill({ status: 422, contentType: "application/problem+json", body: JSON.stringify({ title: "Invalid", status: 422, errors: [fault] }) });
  });
  await page.locator("#run").click();
  await untilStatus(page, "It starts anew: The earlier fit is worn on another body, or on none.");
  await page.unroute(isFits);
  assert.ok(bodies[0].start_from);
  assert.equal(bodies[1].start_from, undefined);
  expectErrors(record, / 422 .*\/v1\/fits$/);
  await cancel();
});

test("a fit that failed is shown as it ended, and nothing goes on from it", async () => {
  const garment = await savedGarment(page);
  garment.simulate = { edge_length_m: 0.02, time_limit_s: 0.05 };
  await chooseFile(page, "hasty.garment.json", JSON.stringify(garment));
  await untilSeams(page, 6);
  await page.waitForFunction(() => document.getElementById("run").textContent === "Sew and drape" && !document.getElementById("run").disabled);
  assert.ok(await page.locator("#run-anew").isHidden());
  const { sent, id } = await run("#run");
  assert.equal(sent.start_from, undefined);
  await untilSewn(id);
  assert.equal((await ofFit(id)).status, "failed");
  await untilStatus(page, "did not come to rest");
  assert.match(await page.locator("#stage-caption").textContent(), /^✗ The garment did not come to rest\./);
  assert.ok(await page.locator("#stage.bad").count());
  assert.ok(await page.locator("#run-anew").isHidden());
  await assertAccessible(page);
  await undo(page);
});

test("nothing else failed", () => {
  // Of runs that were canceled without a shape; the browser tells it late.
  expectErrors(record, / 404 .*\/report$/, { least: 0 });
  assertClean(record);
});
