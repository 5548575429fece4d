// One value of the model: its field, how well it is known, the slider that tries others.
import { app, change, fieldOf, redraw, say } from "./app.js";
import { h } from "./dom.js";
import { numberText, pathText, quantityText, unitText, writtenNumber } from "./numbers.js";
import { T } from "./texts.js";
import { reset, tryValue } from "./trial.js";

const STEPS = 1000;
export const idOf = path => "v-" + path.replace(/[^\w-]/g, "_");
const find = path => app.state.model.values.find(v => v.path === path);
// Two joints have a stiffness each: spoken names say whose.
const nameOf = v => pathText(v.path);
/** Words, counts and flags are known and have no slider. */
export const isQuantity = v => (v.kind || "quantity") === "quantity" && (v.value !== null || v.knowledge !== "known");

/** Where the slider of a value begins and ends: its usual range, else what is plausible around it. */
function bounds(v) {
  let low, high;
  if (v.range) [low, high] = v.range;
  else if (v.value === null) return null;
  else if (v.std) [low, high] = [v.value - 4 * v.std, v.value + 4 * v.std];
  else if (v.value !== 0) [low, high] = [Math.min(0, 2 * v.value), Math.max(0, 2 * v.value)];
  else [low, high] = [-1, 1];
  if (!v.range && v.value > 0) low = Math.max(0, low);
  if (v.value !== null) [low, high] = [Math.min(low, v.value), Math.max(high, v.value)];
  return high > low ? { low, high, isLog: low > 0 && high / low >= 50 } : null;
}
const valueAt = ({ low, high, isLog }, step) => Number((isLog ? low * (high / low) ** (step / STEPS) : low + (high - low) * step / STEPS).toPrecision(4));
const stepOf = ({ low, high, isLog }, value) => Math.round(STEPS * (isLog ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low)));

function slider(v, id) {
  const b = bounds(v);
  if (!b) return null;
  const isTrial = app.trial.values.has(v.path);
  const now = isTrial ? app.trial.values.get(v.path) : v.value === null ? valueAt(b, STEPS / 2) : v.value;
  return h("div", { class: isTrial ? "try on" : "try", "data-key": "try" },
    h("input", { type: "range", id: id + "-try", min: 0, max: STEPS, step: 1, value: stepOf(b, now), "data-input": "try", "data-path": v.path, "aria-label": T.sliderOf(nameOf(v)), "aria-valuetext": quantityText(now, v.unit, 4) }),
    isTrial ? [
      h("output", { for: id + "-try", "data-key": "out" }, T.trialValue(quantityText(now, v.unit, 4))),
      h("button", { type: "button", class: "plain", "data-key": "reset", "data-click": "reset", "data-path": v.path, "aria-label": T.resetOf(nameOf(v)) }, T.reset),
      h("button", { type: "button", class: "plain", "data-key": "use", "data-click": "use", "data-path": v.path, "aria-label": T.useOf(nameOf(v)) }, T.use),
    ] : null);
}

/** Says what stands on trial at its sliders, and changes nothing else. */
export function tellTrials() {
  for (const [path, value] of app.trial.values) {
    const v = find(path), slider = document.getElementById(idOf(path) + "-try");
    if (!v || !slider) continue;
    const text = quantityText(value, v.unit, 4), told = slider.parentElement.querySelector("output");
    slider.setAttribute("aria-valuetext", text);
    if (told) told.textContent = T.trialValue(text);
  }
}

function knowledge(v) {
  return h("div", { class: "knowledge", role: "group", "aria-label": T.knowledgeOf(nameOf(v)), "data-key": "knowledge" },
    ["known", "roughly", "unknown"].map(k => h("button", { type: "button", "data-click": "know", "data-path": v.path, "data-knowledge": k, "aria-pressed": String(v.knowledge === k), "data-key": k },
      h("span", { "aria-hidden": "true", class: k === "known" ? "lock" : null }, T[k + "Sign"])," ", T[k])));
}

const isTried = v => app.trial.values.has(v.path);
const problemOf = v => app.problems.get(v.path) || (app.trial.problem && app.trial.path === v.path ? app.trial.problem : null);
/** Whether more is to be said of a value than its field holds. */
export const isBusy = v => Boolean(problemOf(v)) || isTried(v);

/** Where a value is written: a choice of words sets at once, a text by Enter. `v` may be one that is not there yet; in a table
 * it has a label of its own, and what is said about it may be out of sight. */
export function field(v, label = null, isTold = true) {
  const id = idOf(v.path), problem = problemOf(v), text = app.drafts.has(v.path) ? app.drafts.get(v.path) : v.text || "";
  const described = [problem && id + "-problem", v.about && id + "-about", factsOf(v) && id + "-facts"].filter(Boolean).join(" ");
  const all = { id, class: "written", "data-draft": v.path, "data-change": "set", "aria-label": label, "aria-describedby": isTold && described || null, "aria-invalid": problem ? "true" : null, "data-key": "field" };
  if (v.choices && v.choices.length) {
    const words = v.choices.includes(text) ? v.choices : [text, ...v.choices];
    return h("select", all, words.map(w => h("option", { value: w, selected: w === text }, w || T.none)));
  }
  return h("input", { ...all, type: "text", value: text, autocomplete: "off", autocapitalize: "off", spellcheck: "false", title: T.enterToSet });
}

const factsOf = v => [
  v.range ? T.usual(numberText(v.range[0]), quantityText(v.range[1], v.unit)) : null,
  v.source ? T.source + v.source : null,
].filter(Boolean).join(" · ");

/** All that is said of a value beside its field. */
export function about(v) {
  const id = idOf(v.path), problem = problemOf(v), facts = factsOf(v);
  return [
    isQuantity(v) ? knowledge(v) : null,
    problem ? h("p", { class: "problem", id: id + "-problem" }, h("span", { "aria-hidden": "true" }, "⚠ "), problem, " ",
      app.problems.has(v.path) ? h("button", { type: "button", class: "plain", "data-click": "takeBack", "data-path": v.path, "aria-label": T.takeBackOf(nameOf(v)) }, T.takeBack) : null) : null,
    isQuantity(v) ? slider(v, id) : null,
    isTried(v) && !app.trial.moves && !problem ? h("p", { class: "still", "data-key": "still" }, T.nothingMoves) : null,
    v.about ? h("p", { class: "note about", id: id + "-about" }, v.about) : null,
    facts ? h("p", { class: "note facts-line", id: id + "-facts" }, facts) : null,
  ];
}

export const value = v => h("div", { class: "value", "data-key": v.path },
  h("label", { for: idOf(v.path), class: "key" }, h("span", { class: "hidden" }, pathText(v.group), " "), pathText(v.key)),
  field(v), about(v));

/** Writes a value into the model. */
export async function set(path, text) {
  app.problems.delete(path);
  const v = find(path);
  if (v && text.trim() === v.text) { app.drafts.delete(path); redraw(); return true; }
  app.drafts.set(path, text);
  const isDone = await change("set", { path, text: text.trim() }, T.didSet(pathText(path), unitText(text.trim())));
  // What was typed meanwhile stays; a refused text stays too, with its problem.
  if (isDone && app.drafts.get(path) === text) app.drafts.delete(path);
  // No longer dirty: the field takes the text as the server writes it, also while it has focus.
  const place = fieldOf(path);
  if (isDone && place && place.value === text) place.defaultValue = text;
  redraw();
  return isDone;
}

// Numbers that a value had before it became unknown in this sitting, to offer them again.
const had = new Map();
const plain = v => String(Number(v.toPrecision(12)));

async function know(path, knowledge) {
  const v = find(path);
  if (!v || v.knowledge === knowledge) return;
  const before = had.get(path) || {};
  const number = app.trial.values.has(path) ? app.trial.values.get(path) : v.value === null ? before.value ?? null : v.value;
  if (number !== null) had.set(path, { value: number, std: v.std || before.std || null });
  const place = fieldOf(path);
  if (number === null && knowledge !== "unknown") {
    app.drafts.set(path, (knowledge === "known" ? " " : " +- ") + (v.unit || ""));
    say(T.writeValue(nameOf(v)));
    redraw();
    requestAnimationFrame(() => requestAnimationFrame(() => { place.focus(); place.setSelectionRange(0, 0); }));
    return;
  }
  // A tenth is a mere proposal: the field is handed over with the uncertainty marked, to be written over.
  const std = writtenNumber(v.std || before.std || Math.abs(number) / 10 || (v.range ? (v.range[1] - v.range[0]) / 4 : 1));
  const text = { known: `${plain(number ?? 0)}`, roughly: `${plain(number ?? 0)} +- ${std}`, unknown: number === null ? "?" : `? near ${plain(number)}` }[knowledge];
  const isDone = await set(path, (text + " " + (v.unit || "")).trim());
  if (isDone && knowledge === "roughly" && !v.std && !before.std) requestAnimationFrame(() => requestAnimationFrame(() => {
    const at = place.value.indexOf(std, place.value.search(/\+-|±/));
    place.focus();
    if (at >= 0) place.setSelectionRange(at, at + std.length);
  }));
}

async function use(path) {
  const v = find(path), number = writtenNumber(app.trial.values.get(path));
  const text = v.knowledge === "roughly" && v.std ? `${number} +- ${plain(v.std)}` : number;
  if (await set(path, (text + " " + (v.unit || "")).trim())) reset(path);
}

/** Keys within the field of a value: Enter sets it, Escape takes back what was typed. */
export function keyInField(e) {
  const path = e.target.dataset && e.target.dataset.draft;
  if (!path) return;
  // A choice is made by what the browser shows for it, and is set when it is made.
  if (e.key === "Enter" && e.target.tagName !== "SELECT") { e.preventDefault(); set(path, e.target.value); }
  else if (e.key === "Escape") takeBack(path);
}

function takeBack(path) {
  app.drafts.delete(path);
  app.problems.delete(path);
  const v = find(path), place = fieldOf(path);
  if (place) { place.value = v ? v.text : ""; place.focus(); }
  redraw();
}

/** What is typed is remembered, so that nothing that happens meanwhile takes it away. */
export function noteDraft(e) {
  const v = find(e.dataset.draft);
  if ((v ? v.text : "") === e.value) app.drafts.delete(e.dataset.draft);
  else app.drafts.set(e.dataset.draft, e.value);
}

export const clicks = {
  know: e => know(e.dataset.path, e.dataset.knowledge),
  reset: e => { reset(e.dataset.path); document.getElementById(idOf(e.dataset.path) + "-try").focus(); },
  resetAll: () => reset(),
  takeBack: e => takeBack(e.dataset.path),
  use: e => use(e.dataset.path),
};

export const changes = { set: e => set(e.dataset.draft, e.value) };

export const inputs = {
  try: e => { const b = bounds(find(e.dataset.path)); if (b) tryValue(e.dataset.path, valueAt(b, Number(e.value))); },
};
