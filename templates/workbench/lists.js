// Lists of tables in the model, such as the segments of a shaft: each as one table, a row for each of them.
import { app, load, redraw, say } from "./app.js";
import { h } from "./dom.js";
import { about, field, idOf, isBusy, isQuantity } from "./field.js";
import { pathText, unitText } from "./numbers.js";
import { post, refusalText } from "./server.js";
import { T } from "./texts.js";

const LIST = "list:";   // before the path of a list, among the problems of values
const all = () => app.state.model.lists || [];
export const list = path => all().find(l => l.path === path);

/** The list that a value belongs to, the innermost of several. */
export const listOf = path => all().filter(l => l.rows && path.startsWith(l.path + "[")).sort((a, b) => b.path.length - a.path.length)[0] || null;

/** Where in its list a value stands: the row, from 0, and the key. */
function placeIn(l, path) {
  const [, row, key] = path.slice(l.path.length).match(/^\[(\d+)\]\.?(.*)$/) || [];
  return { row: Number(row), key: key || "" };
}

/** Keys that a row has, or that somebody wants to write, in the order of the list. */
function shownKeys(l, own) {
  const there = new Set(own.map(v => placeIn(l, v.path).key));
  const known = l.keys.map(k => k.key).filter(k => there.has(k) || app.seen.keys.has(`${l.path}.${k}`));
  return [...known, ...[...there].filter(k => !known.includes(k))];
}

const signOf = v => h("span", { "aria-hidden": "true", class: v.knowledge === "known" ? "lock" : null }, T[v.knowledge + "Sign"]);
const isOpen = v => app.seen.more.has(v.path) || isBusy(v);

function cell(l, v, row, key) {
  const path = `${l.path}[${row}].${key}`;
  // What lies deeper needs a table of its own first.
  if (!v && /[.[]/.test(key)) return h("td", { "data-key": key }, T.none);
  const about = l.keys.find(k => k.key === key);
  // A row may lack what another has; it is written like any other.
  const shown = v || { path, text: "", choices: about ? about.choices : null };
  return h("td", { "data-key": key }, h("div", { class: "cell" },
    field(shown, pathText(path), Boolean(v) && isOpen(v)),
    v && (isQuantity(v) || v.about) ? h("button", { type: "button", class: "plain", "data-click": "more", "data-path": path, "aria-expanded": String(isOpen(v)), "aria-label": T.moreOf(pathText(path), isQuantity(v) ? T[v.knowledge] : null), "data-key": "more" },
      isQuantity(v) ? signOf(v) : "…") : null));
}

function row(l, keys, at, number) {
  const name = T.rowOf(pathText(l.path), number + 1);
  return h("tr", { "data-key": "row:" + number },
    h("th", { scope: "row", class: "num" }, String(number + 1)),
    keys.map(key => cell(l, at.get(number + "." + key) || null, number, key)),
    h("td", { class: "acts", "data-key": "acts" },
      h("button", { type: "button", class: "plain", "data-click": "copyRow", "data-list": l.path, "data-number": number, "aria-label": T.copyRowOf(name) }, T.copyRow),
      h("button", { type: "button", class: "plain", "data-click": "removeRow", "data-list": l.path, "data-number": number, "aria-label": T.removeRowOf(name) }, T.remove)));
}

function problem(l) {
  const text = app.problems.get(LIST + l.path);
  return text ? h("p", { class: "problem", role: "alert", "data-key": "problem" }, h("span", { "aria-hidden": "true" }, "⚠ "), text) : null;
}

/** Fields of a row that is to be added: what it cannot do without, and what the row has that it is made after. */
export function rowForm(l, where) {
  const like = where === "row" && app.seen.copied && app.seen.copied.path === l.path ? app.seen.copied : { number: "", cells: {} };
  const needed = l.keys.filter(k => k.needed || k.key in like.cells), keys = needed.length ? needed : l.keys.slice(0, 3);
  return h("form", { class: "add-row", "data-submit": "addRow", "data-list": l.path, "data-key": `add:${where}:${l.path}:${like.number}`, novalidate: true },
    keys.map(k => {
      const id = `${where}-${idOf(l.path)}-${k.key}`.replace(/[^\w-]/g, "_"), text = like.cells[k.key] || null;
      return h("div", { class: "choice", "data-key": k.key },
        h("label", { for: id, title: k.about }, pathText(k.key)),
        k.choices && k.choices.length
          ? h("select", { id, name: k.key, "data-own": "" }, k.choices.map(c => h("option", { value: c, selected: c === (text || k.example) }, c)))
          : h("input", { id, name: k.key, type: "text", value: text, size: 10, autocomplete: "off", spellcheck: "false", placeholder: unitText(k.example || k.unit || ""), "data-own": "" }));
    }),
    h("button", { type: "submit" }, T.addRow),
    where === "new" ? problem(l) : null);
}

/** A list as a table; what is known of single values opens below it, so that the table stays small. */
export function listTable(l, own) {
  const at = new Map(own.map(v => { const { row, key } = placeIn(l, v.path); return [row + "." + key, v]; }));
  const keys = shownKeys(l, own), hidden = l.keys.filter(k => !keys.includes(k.key));
  const name = pathText(l.path), id = idOf(l.path);
  return h("details", { class: "group", open: true, "data-key": "list:" + l.path },
    h("summary", {}, name, h("span", { class: "note" }, ` ${l.rows}`)),
    l.about ? h("p", { class: "note" }, l.about) : null,
    h("div", { class: "tablebox", tabindex: "0", role: "group", "aria-label": T.listOf(name) },
      h("table", { class: "list" },
        h("thead", {}, h("tr", {}, h("th", { scope: "col", class: "num" }, "#"), keys.map(k => h("th", { scope: "col", title: (l.keys.find(o => o.key === k) || {}).about }, pathText(k))), h("th", { scope: "col" }, T.rowActs))),
        h("tbody", {}, Array.from({ length: l.rows }, (_, n) => row(l, keys, at, n))))),
    problem(l),
    own.filter(isOpen).map(v => h("div", { class: "value panel", role: "group", "aria-label": pathText(v.path), "data-key": "more:" + v.path }, h("p", { class: "key" }, pathText(v.path)), about(v))),
    h("details", { class: "add", "data-key": "add" }, h("summary", {}, T.addARow), rowForm(l, "row"),
      hidden.length ? h("div", { class: "row" }, h("label", { for: id + "-key" }, T.addKey), h("select", { id: id + "-key", "data-change": "showKey", "data-list": l.path },
        h("option", { value: "" }, T.pickKey), hidden.map(k => h("option", { value: k.key, title: k.about }, pathText(k.key))))) : null));
}

/** Changes a list; why it cannot be done stands at the list. */
async function changeList(path, question, told) {
  app.problems.delete(LIST + path);
  try { await post("row", { path, ...question }); } catch (e) {
    app.problems.set(LIST + path, refusalText(e));
    redraw();
    return false;
  }
  await load();
  say(told);
  return true;
}

/** A row that cannot stand twice as it is, such as a support, is offered to be changed first. */
function offerCopy(path, number) {
  const start = `${path}[${number}].`;
  const own = app.state.model.values.filter(v => v.path.startsWith(start) && v.text);
  app.seen.copied = { path, number, cells: Object.fromEntries(own.map(v => [v.path.slice(start.length), v.text])) };
  redraw();
  requestAnimationFrame(() => requestAnimationFrame(() => {
    const form = document.querySelector(`form[data-list="${CSS.escape(path)}"]`), place = form && form.querySelector("input, select");
    if (!place) return;
    form.closest("details").open = true;
    place.focus();
    if (place.select) place.select();
  }));
}

const changeRow = ({ dataset: { list: path, number } }, what, told) =>
  changeList(path, { what, number: Number(number) }, told(T.rowOf(pathText(path), Number(number) + 1)));

export const clicks = {
  more: e => {
    const { path } = e.dataset;
    if (!app.seen.more.delete(path)) app.seen.more.add(path);
    redraw();
  },
  copyRow: async e => {
    const { list: path, number } = e.dataset;
    if (!await changeRow(e, "copy", T.didCopyRow)) offerCopy(path, number);
  },
  removeRow: e => changeRow(e, "remove", T.didRemoveRow),
};

export const changes = {
  showKey: e => {
    if (!e.value) return;
    app.seen.keys.add(`${e.dataset.list}.${e.value}`);
    say(T.didShowKey(pathText(e.value)));
    e.value = "";
    redraw();
  },
};

/** Empties the chooser of what the model could have, once that is in it. */
export function clearChoice() {
  app.seen.toAdd = "";
  const place = document.getElementById("to-add");
  if (place) { place.value = ""; place.focus(); }
}

export const submits = {
  addRow: async form => {
    const path = form.dataset.list, cells = {};
    for (const place of form.querySelectorAll("[name]")) {
      if (!place.value.trim()) { say(T.fillIn(place.name)); place.focus(); return; }
      cells[place.name] = place.value.trim();
    }
    if (!await changeList(path, { what: "add", cells }, T.didAddRow(pathText(path)))) return;
    app.seen.copied = null;
    form.reset();
    if (app.seen.toAdd === path) clearChoice();
    redraw();
  },
};
