/**
 * Drafts: the work of each tab in IndexedDB, so that a reload, a crash or a closed tab lose
 * nothing.
 */

const NAME = "seamster";
const DRAFTS = "drafts";
const MOST = 20;
const TAB = "seamster.tab";
/** How long the tab that this one is a copy of may take to let go of its name while it reloads. */
const CLAIM_MS = 400;

let opened = null;
let tab = null;

const settled = (request) => new Promise((done, failed) => {
  request.onsuccess = () => done(request.result);
  request.onerror = () => failed(request.error);
});

function open() {
  opened ??= new Promise((done, failed) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(DRAFTS, { keyPath: "tab" });
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error);
  });
  return opened;
}

async function inStore(mode, act) {
  const transaction = (await open()).transaction(DRAFTS, mode);
  const result = settled(act(transaction.objectStore(DRAFTS)));
  if (mode === "readwrite") transaction.commit?.();
  return result;
}

/** A number for this tab that no other has. */
const freshTab = () => Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(36)).join("");

/** True if no other tab holds the name; then this one does until it is closed. */
function claim(name) {
  if (!navigator.locks) return Promise.resolve(true);
  return new Promise((done) => {
    const forever = () => {
      done(true);
      return new Promise(() => {});
    };
    navigator.locks.request(`${NAME} ${name}`, { signal: AbortSignal.timeout(CLAIM_MS) }, forever).catch(() => done(false));
  });
}

/**
 * Names this tab: `{draft, isCopy}`, its draft and whether the tab was duplicated from one that is
 * still open.
 */
export async function openDrafts() {
  const known = sessionStorage.getItem(TAB);
  const isOwn = known !== null && await claim(known);
  tab = isOwn ? known : freshTab();
  if (!isOwn) await claim(tab);
  sessionStorage.setItem(TAB, tab);
  const draft = known === null ? null : await inStore("readonly", (store) => store.get(known)).catch(() => null);
  prune();
  return { draft: draft ?? null, isCopy: known !== null && !isOwn };
}

/** All drafts, the latest first. */
export async function allDrafts() {
  const found = await inStore("readonly", (store) => store.getAll()).catch(() => []);
  return found.sort((a, b) => b.at - a.at);
}

/** Lets the oldest drafts go. */
async function prune() {
  for (const old of (await allDrafts()).slice(MOST)) {
    await inStore("readwrite", (store) => store.delete(old.tab)).catch(() => {});
  }
}

/** Drafts of other tabs. */
export const otherDrafts = async () => (await allDrafts()).filter((draft) => draft.tab !== tab);

/** Keeps the work of this tab. */
export async function keepDraft(work) {
  if (tab === null) return;
  try {
    await inStore("readwrite", (store) => store.put({ ...work, tab, at: Date.now() }));
  } catch {
    // A full or forbidden store only loses the draft.
  }
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
