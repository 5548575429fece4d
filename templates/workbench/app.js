// What the page knows: the state as the server last told it, and what the user is about to say but has not said yet.
import { get, post, refusalText } from "./server.js";

export const app = {
  state: null,
  rows: null,
  drafts: new Map(),     // path of a value → text that is not set yet
  problems: new Map(),   // path of a value → why its text was refused
  trial: { values: new Map(), predicted: null, rms: null, problem: null, path: null },
  seen: { column: null, view: "residual", observable: 0, picked: null, rowsShown: 50 },
  isLost: false,
};

let draw = () => {};
export const onDraw = call => { draw = call; };
let isAsked = false, isAll = false;
/** Draws once before the next frame, however often it is asked for; "trial": only what a trial changes. */
export function redraw(what) {
  isAll = isAll || what !== "trial";
  if (isAsked) return;
  isAsked = true;
  requestAnimationFrame(() => {
    const all = isAll;
    isAsked = isAll = false;
    draw(all);
  });
}

export function say(text) {
  const place = document.getElementById("said");
  place.textContent = "";
  // The same sentence twice is told twice only if the text was empty between.
  setTimeout(() => { place.textContent = text; }, 30);
  clearTimeout(say.timer);
  say.timer = setTimeout(() => { place.textContent = ""; }, 6000);
}

export function alarm(text) {
  document.getElementById("alarm").textContent = text;
  clearTimeout(alarm.timer);
  if (text) alarm.timer = setTimeout(() => alarm(""), 15000);
}

let loading = null, isStale = false;
let changed = () => {};
export const onChanged = call => { changed = call; };

/** Asks for the state; while one answer is under way, any number of wishes make one more question. */
export function load() {
  if (loading) { isStale = true; return loading; }
  loading = (async () => {
    do {
      isStale = false;
      const state = await get("state");
      const isNew = !app.state || state.version !== app.state.version || !app.rows;
      const rows = !state.data ? null : isNew ? await get("rows") : app.rows;
      app.state = state;
      app.rows = rows;
      if (isNew) changed();
      redraw();
    } while (isStale);
  })().catch(e => { if (!app.isLost) alarm(e.message); }).finally(() => { loading = null; });
  return loading;
}

/** Asks for the state if it is older than the version told of. */
export const follow = version => { if (!app.state || version !== app.state.version) load(); };

/** Does something at the server and says that it was done, or why not; true if it was. */
export async function change(what, body, said) {
  try {
    await post(what, body);
  } catch (e) {
    refuse(e);
    return false;
  }
  alarm("");
  await load();
  if (said) say(said);
  return true;
}

export function refuse(e) {
  const text = refusalText(e);
  if (e.path && app.state && app.state.model && app.state.model.values.some(v => v.path === e.path)) {
    app.problems.set(e.path, text);
    say(text);
  } else alarm(text);
  redraw();
}
