// What the page knows: the state as the server last told it, and what the user is about to say but has not said yet.
import { get, post, refusalText } from "./server.js";

export const app = {
  state: null,
  rows: null,
  drafts: new Map(),     // path of a value → text that is not set yet
  problems: new Map(),   // path of a value → why its text was refused
  trial: { values: new Map(), predicted: null, rms: null, moves: true, problem: null, path: null },
  // How files are to be read: what was said of columns but not sent, files as they stand, and those that were refused.
  reading: { file: null, said: new Map(), how: {}, previews: new Map(), refused: null },
  seen: { column: null, view: "residual", observable: 0, picked: null, rowsShown: 50, effect: null, more: new Set(), keys: new Set(), copied: null,
    toAdd: "", addProblem: null, program: "", addsBlocks: false, written: [], writeProblem: null },
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

/** Draws what a trial changes at once: its answer has taken its time already. */
export const drawTrial = () => draw(false);

export function say(text) {
  const place = document.getElementById("said");
  place.textContent = "";
  // The same sentence twice is told twice only if the text was empty between.
  setTimeout(() => { place.textContent = text; }, 30);
  clearTimeout(say.timer);
  say.timer = setTimeout(() => { place.textContent = ""; }, 6000);
}

/** Files of the folder by their names alone, as the page lists them. */
export const withoutFolder = text => app.state ? text.split(app.state.folder + "/").join("") : text;

export function alarm(text) {
  document.getElementById("alarm").textContent = withoutFolder(text);
  clearTimeout(alarm.timer);
  if (text) alarm.timer = setTimeout(() => alarm(""), 15000);
}

let loading = null, isStale = false, told = null;
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
    } while (isStale || told !== null && told > app.state.version);
  })().catch(e => { if (!app.isLost) alarm(e.message); }).finally(() => { loading = null; });
  return loading;
}

/** Asks for the state if it is older than the version told of, unless it is being asked for already. */
export function follow(version) {
  told = version;
  if (!loading && (!app.state || version !== app.state.version)) load();
}

/** Does something at the server and says that it was done, or why not; what was answered, false if it was not done. */
export async function change(what, body, said) {
  let answer;
  try {
    answer = await post(what, body);
  } catch (e) {
    refuse(e);
    return false;
  }
  alarm("");
  await load();
  if (said) say(typeof said === "function" ? said(answer) : said);
  return answer;
}

/** The field on the page in which a value is written; lists have fields for values that are not there yet. */
export const fieldOf = path => document.querySelector(`[data-draft="${CSS.escape(path)}"]`);

export function refuse(e) {
  const text = refusalText(e);
  if (e.path && fieldOf(e.path)) {
    app.problems.set(e.path, text);
    say(text);
  } else alarm(text);
  redraw();
}
