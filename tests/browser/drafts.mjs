// Drafts of all tabs are kept, listed and let go: `node tests/browser/drafts.mjs`.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { chooseFile, otherFabric, pieces, press, statusOf, untilKept, untilPanels, untilSeams, untilStatus, untilTrue } from "./acts.mjs";
import { assertClean, startPage } from "./support.mjs";

const { page, context, record, service, close } = await startPage();
after(close);

/** Names of all drafts. */
const drafts = (where) => where.evaluate(async () => (await (await import("/drafts.js")).allDrafts()).map(({ tab }) => tab));

/** Waits until a draft is gone. */
const untilGone = (where, name) => untilTrue(where,
  async (gone) => !(await (await import("/drafts.js")).allDrafts()).some(({ tab }) => tab === gone), name);

test("a browser that cannot keep the work says so", async () => {
  const other = await context.newPage();
  await other.addInitScript(() => {
    IDBObjectStore.prototype.put = () => { throw new Error("there is no room"); };
  });
  await other.goto(service.url);
  await press(other, "Try the skirt");
  await untilStatus(other, "All 6 seams");
  await untilStatus(other, "This browser cannot keep the work of this tab: save the garment before you close it.");
  assert.match(await statusOf(other), /All 6 seams/, "whichever came first");
  await other.close();
});

test("work of a closed tab and earlier fits are listed and opened", async () => {
  await press(page, "Try the skirt");
  await untilSeams(page, 6);
  const id = await page.evaluate(async () => {
    const pattern = new URLSearchParams(location.hash.slice(1)).get("pattern");
    const garment = await (await fetch("/samples/skirt.garment.json")).json();
    const fit = await (await fetch("/v1/fits", {
      method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ ...garment, pattern }),
    })).json();
    const canceled = await fetch(`/v1/fits/${fit.id}`, { method: "DELETE" });
    return canceled.ok ? fit.id : null;
  });
  assert.ok(id);
  const third = await context.newPage();
  await third.goto(service.url);
  await third.locator("#open").click();
  const fits = third.locator("#open-recent ul").nth(1).locator(".entry");
  await fits.first().waitFor();
  assert.match(await fits.first().textContent(), /waiting|being sewn|canceled/);
  await fits.first().click();
  await untilSeams(third, 6);
  await third.waitForFunction((fit) => location.hash.includes(fit), id);
  await third.close();
});

test("work without seams is kept too where another pattern takes its place", async () => {
  await chooseFile(page, "bare.dxf", pieces([[300, 0], [300, 200], [500, 200], [500, 0]]));
  await untilPanels(page, 2);
  await page.locator("#default-fabric").selectOption(await otherFabric(page));
  await page.evaluate(async () => {
    const { state, update } = await import("/state.js");
    const [a, b] = state.pattern.panels.map(({ id }) => ({ panel: id, from: 0, to: 1 }));
    update({ offers: [{ id: "hem", confidence: 0.3, because: "", a, b }] });
  });
  await page.locator("#import-units").selectOption("cm");
  await page.waitForFunction(() => document.getElementById("pattern-facts").textContent.includes("cm"));
  assert.doesNotMatch(await statusOf(page), /Undo brings back/, "it is the same work");
  assert.match(await statusOf(page), /1 offer went: hem\. Undo brings all back\./);
  await untilKept(page);
  await press(page, "Skirt sample");
  await untilPanels(page, 3);
  await untilStatus(page, "can be sewn");
  assert.match(await statusOf(page), /Undo brings back bare/);
  await untilKept(page);
  await page.locator("#open").click();
  await page.locator("#open-recent .entry", { hasText: /bare\s*0 seams/ }).waitFor();
  await page.locator("#open-close").click();
});

test("the draft of an open tab stays, whatever others there are", async () => {
  const mine = await page.evaluate(async () => {
    const { allDrafts } = await import("/drafts.js");
    const tab = sessionStorage.getItem("seamster.tab");
    const draft = (await allDrafts()).find((one) => one.tab === tab);
    const later = Array.from({ length: 20 }, (_, i) => ({ ...draft, tab: `closed ${i}`, at: Date.now() + 60_000 + i }));
    await new Promise((done, failed) => {
      const request = indexedDB.open("seamster", 1);
      request.onerror = failed;
      request.onsuccess = () => {
        const transaction = request.result.transaction("drafts", "readwrite");
        for (const one of [...later, { ...draft, tab: "oldest", at: 0 }]) transaction.objectStore("drafts").put(one);
        transaction.oncomplete = done;
        transaction.onabort = failed;
      };
    });
    return tab;
  });
  const other = await context.newPage();
  await other.goto(service.url);
  await press(other, "Try the skirt");
  await untilGone(other, "oldest");
  assert.ok((await drafts(page)).includes(mine));
  await other.locator("#default-fabric").selectOption(await otherFabric(other));
  await untilKept(other);
  const left = await other.evaluate(() => sessionStorage.getItem("seamster.tab"));
  assert.ok((await drafts(page)).includes(left));
  await press(other, "Top sample");
  await untilGone(other, left);
  assert.ok((await drafts(page)).includes(mine));
  await other.close();
});

test("nothing else failed", () => assertClean(record));
