/**
 * Drafts: the work of each tab in IndexedDB, so that a reload, a crash or a closed tab lose
 * nothing. Work that another pattern takes the place of stays as a draft of its own.
 */

const NAME = "seamster";
const DRAFTS = "drafts";
const MOST = 20;
/** Key under which a tab keeps the name of its draft. */
const TAB = "seamster.tab";
/** Time for a tab that reloads to let go of its draft, before this one is taken for a copy [ms]. */
const CLAIM_MS = 400;

let opened = null;
const held = new Set(); // names of drafts that this tab claimed

function connect() {
  return new Promise((done, failed) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(DRAFTS, { keyPath: "tab" });
    request.onsuccess = () => {
      request.result.onclose = () => { opened = null; };
      done(request.result);
    };
    request.onerror = () => failed(request.error);
  });
}

/** The store; one that could not be opened is tried again by the next call. */
async function open() {
  opened ??= connect();
  try {
    return await opened;
  } catch (error) {
    opened = null;
    throw error;
  }
}

/** Result of a request, once all of its transaction is kept. */
async function inStore(mode, act) {
  const transaction = (await open()).transaction(DRAFTS, mode);
  const request = act(transaction.objectStore(DRAFTS));
  return new Promise((done, failed) => {
    transaction.oncomplete = () => done(request.result);
    transaction.onabort = () => failed(transaction.error ?? request.error);
  });
}

/** A name for a draft that no other has. */
export const freshName = () => Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(36)).join("");

const lockOf = (name) => `${NAME} ${name}`;

/** True if no other tab holds the name; then this one does until it is closed. */
function claim(name, options) {
  if (!navigator.locks || held.has(name)) return Promise.resolve(true);
  return new Promise((done) => {
    const forever = (lock) => {
      if (lock === null) return done(false);
      held.add(name);
      done(true);
      return new Promise(() => {});
    };
    navigator.locks.request(lockOf(name), options, forever).catch(() => done(false));
  });
}

/** Goes on with a draft: its name, or null where another tab has it open. */
export const takeOver = async ({ tab }) => (await claim(tab, { ifAvailable: true }) ? tab : null);

/**
 * The draft that this tab left: `{draft, isCopy}`. A tab that was duplicated from one that is still
 * open has a copy, whose name stays with the other.
 */
export async function openDrafts() {
  const known = sessionStorage.getItem(TAB);
  if (known === null) return { draft: null, isCopy: false };
  const isOwn = await claim(known, { signal: AbortSignal.timeout(CLAIM_MS) });
  const draft = await inStore("readonly", (store) => store.get(known)).catch(() => null);
  return { draft: draft ?? null, isCopy: !isOwn };
}

/** All drafts, the latest first. */
export async function allDrafts() {
  const found = await inStore("readonly", (store) => store.getAll()).catch(() => []);
  return found.sort((a, b) => b.at - a.at);
}

/** Deletes drafts that are too many, the oldest first; `name` and those open elsewhere stay. */
async function prune(name) {
  // Where there are no locks, as without HTTPS, open tabs cannot be told from closed ones.
  const { held: locks } = await navigator.locks?.query() ?? { held: [] };
  const open = new Set(locks.map((lock) => lock.name));
  for (const { tab } of (await allDrafts()).slice(MOST)) {
    // This tab keeps the locks of drafts that it left, because undo may return to them.
    const isOpen = held.has(tab) ? tab === name : open.has(lockOf(tab));
    if (!isOpen) await inStore("readwrite", (store) => store.delete(tab)).catch(() => {});
  }
}

/** Keeps the work of this tab under a name; fails where the browser cannot. */
export async function keepDraft(name, work) {
  if (sessionStorage.getItem(TAB) !== name) {
    sessionStorage.setItem(TAB, name);
    claim(name, { ifAvailable: true });
    prune(name).catch(() => {});
  }
  await inStore("readwrite", (store) => store.put({ ...work, tab: name, at: Date.now() }));
}

/** Tells other tabs which pattern is open here; `onMet()` is called where one has the same open. */
export function announce(onMet) {
  if (!globalThis.BroadcastChannel) return () => {};
  const channel = new BroadcastChannel(NAME);
  let mine = null;
  channel.addEventListener("message", ({ data }) => {
    if (mine === null || data.pattern !== mine) return;
    if (data.asks) channel.postMessage({ pattern: mine, asks: false });
    onMet();
  });
  return (pattern) => {
    mine = pattern;
    if (pattern !== null) channel.postMessage({ pattern, asks: true });
  };
}
