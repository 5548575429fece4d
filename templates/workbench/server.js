// The only way out of the page: all addresses are relative, as the token is a part of the page's own.

import { T } from "./texts.js";

/** A refusal of the server, with what to do about it and the field that it is about. */
export class Refusal extends Error {
  constructor(answer) {
    super(answer.problem);
    this.help = answer.help || null;
    this.path = answer.path || null;
    this.file = answer.file || null;
  }
}

/** The problem and what helps, as sentences. */
export function refusalText(e) {
  const sentence = t => /[.!?:]$/.test(t) ? t : t + ".";
  return e.help ? sentence(e.message || T.failed) + " " + e.help : e.message || T.failed;
}

async function answer(response) {
  const text = await response.text();
  let json = null;
  try { json = text ? JSON.parse(text) : {}; } catch { /* not every failure is told as JSON */ }
  if (response.ok && json) return json;
  throw new Refusal(json && json.problem ? json : { problem: text.trim().slice(0, 300) || `${response.status} ${response.statusText}` });
}

export const get = async what => answer(await fetch(what, { cache: "no-store" }));

export const post = async (what, body) => answer(await fetch(what, {
  method: "POST",
  headers: { "content-type": "application/json" },
  body: JSON.stringify(body || {}),
}));

export const send = async file => answer(await fetch("file?name=" + encodeURIComponent(file.name), {
  method: "POST",
  headers: { "content-type": "application/octet-stream" },
  body: file,
}));

/** Listens to what happens at the server; the browser connects again by itself, unless it is another server that answers. */
export function listen({ state, job, lost, back }) {
  const source = new EventSource("events");
  let isLost = false;
  source.addEventListener("state", e => state(Number(e.data)));
  source.addEventListener("job", e => job(JSON.parse(e.data)));
  source.addEventListener("open", () => { if (isLost) back(); isLost = false; });
  source.addEventListener("error", () => {
    const isOver = source.readyState === EventSource.CLOSED;
    if (!isLost || isOver) lost(isOver);
    isLost = true;
  });
}
