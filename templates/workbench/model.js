// The model: its file, the machine to scale, its values, the effects in it and what it could have besides.
import { absent } from "./absent.js";
import { app, change, redraw } from "./app.js";
import { blob, h } from "./dom.js";
import { value } from "./field.js";
import { progress, runButton } from "./job.js";
import { listOf, listTable } from "./lists.js";
import { pathText } from "./numbers.js";
import { T } from "./texts.js";

/** Values by the tables and lists in which they stand, in the order of the file. */
function places({ values, lists }) {
  const all = new Map();
  for (const v of values) {
    const list = listOf(v.path), key = list ? "list:" + list.path : "group:" + v.group;
    if (!all.has(key)) all.set(key, { list, group: v.group, own: [] });
    all.get(key).own.push(v);
  }
  for (const list of lists || []) if (list.rows && !all.has("list:" + list.path)) all.set("list:" + list.path, { list, own: [] });
  return [...all.values()];
}

const group = ({ group, own }) => h("details", { class: "group", open: true, "data-key": "group:" + group },
  h("summary", {}, pathText(group) || T.whole, h("span", { class: "note" }, ` ${own.length}`)), own.map(value));

function values(model) {
  return [
    h("h3", {}, T.values),
    h("div", { class: "run", "data-key": "fit" }, runButton("fit", T.fit, !app.state.data), h("span", { class: "note" }, T.fitNote)),
    progress(["fit"]),
    places(model).map(place => place.list ? listTable(place.list, place.own) : group(place)),
    absent(),
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

export const clicks = {
  add: e => add(e.dataset.effect),
  remove: e => change("remove", { effect: e.dataset.effect }, T.didRemove(e.dataset.effect)),
};

const add = effect => change("add", { effect }, T.didAdd(effect));

export const changes = {
  open: async e => { if (e.value) { await change("open", { model: e.value }, T.didOpen(e.value)); redraw(); } },
  noteEffect: e => { app.seen.effect = e.value; redraw(); },
};

export const submits = {
  addByHand: async form => { if (form.elements.effect.value && await add(form.elements.effect.value)) { app.seen.effect = null; redraw(); } },
};
