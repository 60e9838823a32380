// Set-up of the suites: a service on a free port, a browser that keeps a record, pixels, axe.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { mkdtemp, rm } from "node:fs/promises";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";
import axe from "axe-core";
import { chromium } from "playwright-core";

const READY_MS = 120_000;
/** A debug binary on a busy machine takes its time over a check. */
const PATIENCE_MS = 180_000;

async function freePort() {
  const server = createServer();
  await new Promise((done) => { server.listen(0, "127.0.0.1", done); });
  const { port } = server.address();
  await new Promise((done) => { server.close(done); });
  return port;
}

/** Starts the binary on a free port with an empty data folder: `{url, stop}`. */
export async function startService(binary, settings = {}) {
  const folder = await mkdtemp(join(tmpdir(), "seamster-page-"));
  const listen = `127.0.0.1:${await freePort()}`;
  const env = { ...process.env, SEAMSTER_LISTEN: listen, SEAMSTER_DATA: join(folder, "data"), ...settings };
  const service = spawn(binary, ["serve"], { env, stdio: ["ignore", "pipe", "pipe"] });
  let log = "";
  for (const stream of [service.stdout, service.stderr]) stream.on("data", (part) => { log = (log + part).slice(-8000); });
  const ended = new Promise((done) => { service.on("exit", done).on("error", (error) => { log += error; done(); }); });
  let running = true;
  ended.then(() => { running = false; });
  const stop = async () => {
    service.kill("SIGTERM");
    const killer = setTimeout(() => service.kill("SIGKILL"), 15_000);
    await ended;
    clearTimeout(killer);
    await rm(folder, { recursive: true, force: true });
  };
  for (const start = Date.now(); Date.now() - start < READY_MS && running; await pause(100)) {
    const ready = await fetch(`http://${listen}/health/ready`).catch(() => null);
    if (ready?.ok) return { url: `http://${listen}/`, stop, log: () => log };
  }
  await stop();
  throw new Error(`the service did not get ready:\n${log}`);
}

function browserPath() {
  const known = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];
  const found = known.find((path) => path && existsSync(path));
  if (!found) throw new Error("chromium is not installed; CHROMIUM can name it");
  return found;
}

/** Headless Chromium that draws WebGL in software and calls nobody by itself. */
export const startBrowser = () => chromium.launch({
  executablePath: browserPath(),
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});

/**
 * A tab at `url` with a record of what must not happen: foreign requests, errors, breaches of the
 * policy.
 */
export async function openTab(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  context.setDefaultTimeout(PATIENCE_MS);
  const record = { foreign: [], errors: [], breaches: [] };
  const origin = new URL(url).origin;
  page.on("request", (request) => {
    const { protocol, origin: from } = new URL(request.url());
    if (!["blob:", "data:"].includes(protocol) && from !== origin) record.foreign.push(request.url());
  });
  page.on("pageerror", (error) => record.errors.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") record.errors.push(`${message.text()} ${message.location().url}`);
  });
  await page.exposeFunction("recordBreach", (what) => record.breaches.push(what));
  await page.addInitScript(() => {
    document.addEventListener("securitypolicyviolation", (event) =>
      window.recordBreach(`${event.violatedDirective} ${event.blockedURI}`));
  });
  await page.goto(url);
  return { page, context, record };
}

/**
 * Service and browser of a suite, as `{service, browser, close}`: BASE is the address of a running
 * service, without it SEAMSTER_BIN is started on a free port.
 */
export async function startSuite() {
  const { BASE, SEAMSTER_BIN } = process.env;
  if (!BASE && !SEAMSTER_BIN) throw new Error("set BASE to a running service or SEAMSTER_BIN to the binary");
  const service = BASE ? { url: BASE, stop: async () => {} } : await startService(SEAMSTER_BIN);
  let browser = null;
  const close = async () => {
    await browser?.close();
    await service.stop();
  };
  try {
    browser = await startBrowser();
  } catch (error) {
    await close();
    throw error;
  }
  return { service, browser, close };
}

/** A suite with one tab on its service: `{service, browser, close, page, context, record}`. */
export async function startPage() {
  const suite = await startSuite();
  try {
    return { ...suite, ...await openTab(suite.browser, suite.service.url) };
  } catch (error) {
    await suite.close();
    throw error;
  }
}

/** Options of a test that starts a service of its own, with tokens. */
export const TOKEN_TEST = { skip: process.env.BASE ? "BASE names a service without tokens" : false };

/** Takes the recorded errors, of which there are `least` or more, and each is as `pattern` says. */
export function expectErrors(record, pattern, { least = 1 } = {}) {
  const told = record.errors.splice(0);
  assert.ok(told.length >= least, `${told.length} errors like ${pattern} were recorded`);
  for (const text of told) assert.match(text, pattern);
}

/** Nothing left the origin, broke the policy or failed. */
export const assertClean = (record) => assert.deepEqual(record, { foreign: [], errors: [], breaches: [] });

/** Faults that axe finds, one line each. */
export async function axeFaults(page) {
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() => window.axe.run(document));
  return violations.flatMap(({ id, nodes }) => nodes.map((node) => `${id}: ${node.target.join(" ")}: ${node.failureSummary}`));
}

/** Finds nothing wrong in the light nor in the dark, and leaves the page in the light. */
export async function assertAccessible(page) {
  for (const colorScheme of ["dark", "light"]) {
    await page.emulateMedia({ colorScheme });
    assert.deepEqual(await axeFaults(page), [], colorScheme);
  }
}

/** Share of pixels in which two PNG pictures of one size differ by more than a shade. */
export async function difference(browser, one, other) {
  const page = await browser.newPage();
  try {
    return await page.evaluate(async (pictures) => {
      const [a, b] = await Promise.all(pictures.map(async (text) => {
        const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
        canvas.drawImage(image, 0, 0);
        return canvas.getImageData(0, 0, image.width, image.height);
      }));
      if (a.width !== b.width || a.height !== b.height) return 1;
      let differing = 0;
      for (let i = 0; i < a.data.length; i += 4) {
        differing += [0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 20);
      }
      return differing / (a.width * a.height);
    }, [one, other].map((picture) => picture.toString("base64")));
  } finally {
    await page.close();
  }
}
