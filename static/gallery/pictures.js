/**
 * Pictures and names of fits, kept by this browser beside the drafts, in a database of their own:
 * nothing waits for tabs that hold the drafts open.
 */

const NAME = "seamster-gallery";
const STORE = "fits";
/** Fits of which pictures are kept; the oldest go first. */
const MOST = 60;

let opened = null;

function connect() {
  return new Promise((done, failed) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: "fit" });
    request.onsuccess = () => {
      request.result.onclose = () => { opened = null; };
      done(request.result);
    };
    request.onerror = () => failed(request.error);
  });
}

async function inStore(mode, act) {
  opened ??= connect();
  const database = await opened.catch((error) => {
    opened = null;
    throw error;
  });
  const transaction = database.transaction(STORE, mode);
  const request = act(transaction.objectStore(STORE));
  return new Promise((done, failed) => {
    transaction.oncomplete = () => done(request.result);
    transaction.onabort = () => failed(transaction.error ?? request.error);
  });
}

/** Entries of all fits `{fit, name, at, verdict, isGood, cpu_s, picture}`, the latest first. */
export async function allEntries() {
  const entries = await inStore("readonly", (store) => store.getAll()).catch(() => []);
  return entries.sort((a, b) => b.at - a.at);
}

const entryOf = (fit) => inStore("readonly", (store) => store.get(fit)).catch(() => undefined);

export const forget = (fit) => inStore("readwrite", (store) => store.delete(fit));

/** Keeps an entry; a name that a person gave it stays, and so does its time. */
export async function keepEntry(entry) {
  const { name, at } = await entryOf(entry.fit) ?? {};
  await inStore("readwrite", (store) => store.put({ ...entry, name: name ?? entry.name, at: at ?? Date.now() }));
  for (const { fit } of (await allEntries()).slice(MOST)) await forget(fit);
}

export async function rename(fit, name) {
  const entry = await entryOf(fit);
  if (entry) await inStore("readwrite", (store) => store.put({ ...entry, name }));
}
