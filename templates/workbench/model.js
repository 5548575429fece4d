// The model: its file, the machine to scale, every value with how well it is known, the effects in it.
import { app, change, redraw, say } from "./app.js";
import { blob, h } from "./dom.js";
import { progress, runButton } from "./job.js";
import { numberText, quantityText, unitText, writtenNumber } from "./numbers.js";
import { T } from "./texts.js";
import { reset, tryValue } from "./trial.js";

const STEPS = 1000;
const idOf = path => "v-" + path.replace(/[^\w-]/g, "_");
const find = path => app.state.model.values.find(v => v.path === path);
const words = name => name.replace(/[._]/g, " ");
// Two joints have a stiffness each: spoken names say whose.
const nameOf = v => words(`${v.group} ${v.key}`).trim();
const isNumber = v => v.value !== null || v.knowledge !== "known";

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

function knowledge(v) {
  return h("div", { class: "knowledge", role: "group", "aria-label": T.knowledgeOf(nameOf(v)), "data-key": "knowledge" },
    ["known", "roughly", "unknown"].map(k => h("button", { type: "button", "data-click": "know", "data-path": v.path, "data-knowledge": k, "aria-pressed": String(v.knowledge === k), "data-key": k },
      h("span", { "aria-hidden": "true", class: k === "known" ? "lock" : null }, T[k + "Sign"])," ", T[k])));
}

function value(v) {
  const id = idOf(v.path);
  const isAt = app.trial.problem && app.trial.path === v.path;
  const problem = app.problems.get(v.path) || (isAt ? app.trial.problem : null);
  const facts = [
    v.range ? T.usual(numberText(v.range[0]), quantityText(v.range[1], v.unit)) : null,
    v.source ? T.source + v.source : null,
  ].filter(Boolean).join(" · ");
  const described = [problem && id + "-problem", v.about && id + "-about", facts && id + "-facts"].filter(Boolean).join(" ");
  return h("div", { class: "value", "data-key": v.path },
    h("label", { for: id, class: "key" }, h("span", { class: "hidden" }, words(v.group), " "), words(v.key)),
    h("input", { type: "text", id, class: "written", value: app.drafts.has(v.path) ? app.drafts.get(v.path) : v.text, "data-draft": v.path, "data-change": "set", "aria-describedby": described || null, "aria-invalid": problem ? "true" : null, autocomplete: "off", autocapitalize: "off", spellcheck: "false", title: T.enterToSet }),
    isNumber(v) ? knowledge(v) : null,
    problem ? h("p", { class: "problem", id: id + "-problem" }, h("span", { "aria-hidden": "true" }, "⚠ "), problem, " ",
      app.problems.has(v.path) ? h("button", { type: "button", class: "plain", "data-click": "takeBack", "data-path": v.path, "aria-label": T.takeBackOf(nameOf(v)) }, T.takeBack) : null) : null,
    isNumber(v) ? slider(v, id) : null,
    v.about ? h("p", { class: "note about", id: id + "-about" }, v.about) : null,
    facts ? h("p", { class: "note facts-line", id: id + "-facts" }, facts) : null);
}

function values({ values }) {
  const groups = [...new Set(values.map(v => v.group))];
  return [
    h("h3", {}, T.values),
    h("div", { class: "run", "data-key": "fit" }, runButton("fit", T.fit, !app.state.data), h("span", { class: "note" }, T.fitNote)),
    progress(["fit"]),
    groups.map(g => {
      const own = values.filter(v => v.group === g);
      return h("details", { class: "group", open: true, "data-key": "group:" + g }, h("summary", {}, words(g), h("span", { class: "note" }, ` ${own.length}`)), own.map(value));
    }),
  ];
}

function effects({ effects, catalogue }) {
  return [
    h("h3", {}, T.effectsIn),
    effects.length ? h("ul", { class: "effects", "data-key": "effects" }, effects.map(e => h("li", { "data-key": "effect:" + e.name },
      h("div", {}, h("strong", {}, e.name), h("p", { class: "note" }, e.about)),
      h("button", { type: "button", "data-click": "remove", "data-effect": e.name, "aria-label": T.removeOf(e.name) }, T.remove)))) : h("p", { class: "note", "data-key": "no-effects" }, T.noEffects),
    catalogue.length ? h("form", { class: "row", "data-submit": "addByHand", "data-key": "by-hand" },
      h("label", { for: "by-hand" }, T.addByHand),
      h("select", { id: "by-hand", name: "effect", "data-change": "noteEffect" }, h("option", { value: "" }, T.pickEffect), catalogue.map(e => h("option", { value: e.name, selected: app.seen.effect === e.name }, e.name))),
      h("button", { type: "submit" }, T.add),
      h("p", { class: "note", id: "by-hand-about" }, (catalogue.find(e => e.name === app.seen.effect) || { about: "" }).about)) : null,
  ];
}

export function model() {
  const { model, models, folder } = app.state;
  return [
    h("h2", { id: "model-title" }, T.panes.model),
    models.length ? h("div", { class: "row", "data-key": "file" }, h("label", { for: "model-file" }, T.modelFile),
      h("select", { id: "model-file", "data-change": "open" }, model && models.includes(model.file) ? null : h("option", { value: "" }, model ? model.file : T.pickModel),
        models.map(m => h("option", { value: m, selected: model !== null && model.file === m }, m)))) : h("p", { "data-key": "none" }, T.noModels(folder)),
    model ? [
      h("p", { class: "note", "data-key": "about" }, model.about),
      model.figures ? blob(model.figures, { class: "served", "data-key": "figures" }) : null,
      h("div", { "data-key": "effects-box" }, effects(model)),
      h("div", { "data-key": "values-box" }, values(model)),
      h("details", { id: "text" }, h("summary", {}, T.text), h("pre", { tabindex: "0", role: "group", "aria-label": T.text }, h("code", {}, model.text))),
    ] : null,
  ];
}

async function set(path, text) {
  app.problems.delete(path);
  const v = find(path);
  if (v && text.trim() === v.text) { app.drafts.delete(path); redraw(); return true; }
  app.drafts.set(path, text);
  const isDone = await change("set", { path, text: text.trim() }, T.didSet(v ? nameOf(v) : path, unitText(text.trim())));
  // What was typed meanwhile stays; a refused text stays too, with its problem.
  if (isDone && app.drafts.get(path) === text) app.drafts.delete(path);
  // No longer dirty: the field takes the text as the server writes it, also while it has focus.
  const field = document.getElementById(idOf(path));
  if (isDone && field && field.value === text) field.defaultValue = text;
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
  const field = document.getElementById(idOf(path));
  if (number === null && knowledge !== "unknown") {
    app.drafts.set(path, (knowledge === "known" ? " " : " +- ") + (v.unit || ""));
    say(T.writeValue(nameOf(v)));
    redraw();
    requestAnimationFrame(() => requestAnimationFrame(() => { field.focus(); field.setSelectionRange(0, 0); }));
    return;
  }
  // A tenth is a mere proposal: the field is handed over with the uncertainty marked, to be written over.
  const std = writtenNumber(v.std || before.std || Math.abs(number) / 10 || (v.range ? (v.range[1] - v.range[0]) / 4 : 1));
  const text = { known: `${plain(number ?? 0)}`, roughly: `${plain(number ?? 0)} +- ${std}`, unknown: number === null ? "?" : `? near ${plain(number)}` }[knowledge];
  const isDone = await set(path, (text + " " + (v.unit || "")).trim());
  if (isDone && knowledge === "roughly" && !v.std && !before.std) requestAnimationFrame(() => requestAnimationFrame(() => {
    const at = field.value.indexOf(std, field.value.search(/\+-|±/));
    field.focus();
    if (at >= 0) field.setSelectionRange(at, at + std.length);
  }));
}

async function use(path) {
  const v = find(path), number = writtenNumber(app.trial.values.get(path));
  const text = v.knowledge === "roughly" && v.std ? `${number} +- ${plain(v.std)}` : number;
  if (await set(path, (text + " " + (v.unit || "")).trim())) reset(path);
}

export const clicks = {
  know: e => know(e.dataset.path, e.dataset.knowledge),
  reset: e => { reset(e.dataset.path); document.getElementById(idOf(e.dataset.path) + "-try").focus(); },
  resetAll: () => reset(),
  takeBack: e => takeBack(e.dataset.path),
  use: e => use(e.dataset.path),
  add: e => add(e.dataset.effect),
  remove: e => change("remove", { effect: e.dataset.effect }, T.didRemove(e.dataset.effect)),
};

const add = effect => change("add", { effect }, T.didAdd(effect));

export const changes = {
  open: async e => { if (e.value) { await change("open", { model: e.value }, T.didOpen(e.value)); redraw(); } },
  set: e => set(e.dataset.draft, e.value),
  noteEffect: e => { app.seen.effect = e.value; redraw(); },
};

export const inputs = {
  try: e => { const b = bounds(find(e.dataset.path)); if (b) tryValue(e.dataset.path, valueAt(b, Number(e.value))); },
};

export const submits = {
  addByHand: async form => { if (form.elements.effect.value && await add(form.elements.effect.value)) { app.seen.effect = null; redraw(); } },
};

/** Keys within the field of a value: Enter sets it, Escape takes back what was typed. */
export function keyInField(e) {
  const path = e.target.dataset && e.target.dataset.draft;
  if (!path) return;
  if (e.key === "Enter") { e.preventDefault(); set(path, e.target.value); }
  else if (e.key === "Escape") takeBack(path);
}

function takeBack(path) {
  app.drafts.delete(path);
  app.problems.delete(path);
  const v = find(path), field = document.getElementById(idOf(path));
  if (v && field) { field.value = v.text; field.focus(); }
  redraw();
}

/** What is typed is remembered, so that nothing that happens meanwhile takes it away. */
export function noteDraft(e) {
  const v = find(e.dataset.draft);
  if (v && v.text === e.value) app.drafts.delete(e.dataset.draft);
  else app.drafts.set(e.dataset.draft, e.value);
}
