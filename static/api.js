/** Calls to the service: the token, problems as errors, streams of events. */

const TOKEN = "seamster.token";
let asking = null;
let askToken = async () => null;

/** Says how a person is asked for a token: `ask(refused)` resolves to the token or null. */
export function setTokenPrompt(ask) {
  askToken = ask;
}

/** A refusal: `faults` lists what is wrong (RFC 9457 with `errors`). */
export class Problem extends Error {
  constructor(message, status, faults, retryAfter) {
    super(message);
    this.status = status;
    this.faults = faults;
    this.retryAfter = retryAfter;
  }

  /** From the `application/problem+json` object itself. */
  static fromBody(body, status, retryAfter) {
    const told = body.detail || body.title || `The service answered ${status}.`;
    const text = /[.!?]$/.test(told) ? told : `${told}.`;
    const wait = retryAfter ? ` Try again in ${retryAfter} s.` : "";
    return new Problem(text + wait, status, body.errors ?? [], retryAfter);
  }

  static async fromResponse(response) {
    let body = {};
    try {
      body = await response.json();
    } catch {
      // A proxy may answer with something else; the status says enough.
    }
    return Problem.fromBody(body, response.status, response.headers.get("Retry-After"));
  }
}

/** True if the same request may succeed later: the connection failed or the service is busy. */
export const isTransient = ({ status }) => !status || status === 408 || status === 429 || status >= 500;

/** True if there is nothing at the address, and will not be. */
export const isGone = ({ status }) => status === 404 || status === 410;

function withToken(options) {
  const headers = new Headers(options.headers);
  const token = sessionStorage.getItem(TOKEN);
  if (token) headers.set("Authorization", `Bearer ${token}`);
  return { ...options, headers, redirect: "error" };
}

async function renewToken(used) {
  if (sessionStorage.getItem(TOKEN) !== used) return true;
  asking ??= askToken(used !== null).finally(() => { asking = null; });
  const token = await asking;
  if (!token) return false;
  sessionStorage.setItem(TOKEN, token);
  return true;
}

/** A call that succeeded; throws a `Problem` otherwise. Asks for a token where one is needed. */
export async function call(path, options = {}) {
  for (;;) {
    const used = sessionStorage.getItem(TOKEN);
    let response;
    try {
      response = await fetch(path, withToken(options));
    } catch (error) {
      if (error.name === "AbortError") throw error;
      throw new Problem("The service cannot be reached. Is it running?", 0, []);
    }
    if (response.status === 401 && await renewToken(used)) continue;
    if (!response.ok) throw await Problem.fromResponse(response);
    return response;
  }
}

export const getJson = async (path, options) => (await call(path, options)).json();

export async function postJson(path, body, options = {}) {
  const headers = { "Content-Type": "application/json", ...options.headers };
  return (await call(path, { ...options, method: "POST", headers, body: JSON.stringify(body) })).json();
}

function parseEvent(block) {
  const event = { type: "message", data: "", id: null };
  for (const line of block.split("\n")) {
    const colon = line.indexOf(":");
    if (colon <= 0) continue;
    const value = line.slice(colon + 1).replace(/^ /, "");
    const field = line.slice(0, colon);
    if (field === "event") event.type = value;
    else if (field === "id") event.id = value;
    else if (field === "data") event.data += (event.data ? "\n" : "") + value;
  }
  return event;
}

/**
 * Server-sent events of one response; `EventSource` cannot send a token. Yields `{type, id, data}`
 * with parsed data.
 */
export async function* events(path, { lastId, signal } = {}) {
  const headers = { Accept: "text/event-stream" };
  if (lastId) headers["Last-Event-ID"] = lastId;
  const response = await call(path, { headers, signal });
  // The last event was read before.
  if (response.status === 204) return;
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    const blocks = (rest + value).replace(/\r\n/g, "\n").split("\n\n");
    rest = blocks.pop();
    for (const block of blocks) {
      const event = parseEvent(block);
      if (event.data) yield { ...event, data: JSON.parse(event.data) };
    }
  }
}
