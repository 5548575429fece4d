// What the model could have and has not: keys, tables and lists, found by a part of their names.
import { app, load, redraw, say } from "./app.js";
import { h } from "./dom.js";
import { clearChoice, rowForm } from "./lists.js";
import { pathText } from "./numbers.js";
import { post, refusalText } from "./server.js";
import { T } from "./texts.js";

const keys = () => app.state.model.absent || [];
const lists = () => (app.state.model.lists || []).filter(l => !l.rows);

// How a table is written is shown by one that is ready to be changed.
const isTable = key => (key.example || "").startsWith("{");

function fieldOf(key) {
  const about = app.seen.addProblem ? "to-add-problem" : null;
  return h("form", { class: "add-row", "data-submit": "addKey", "data-key": "key:" + key.path, novalidate: true },
    h("label", { for: "to-add-value" }, pathText(key.path)),
    key.choices && key.choices.length
      ? h("select", { id: "to-add-value", name: "value", "data-own": "", "aria-describedby": about }, key.choices.map(c => h("option", { value: c, selected: c === key.example }, c)))
      : h("input", { id: "to-add-value", name: "value", type: "text", autocomplete: "off", spellcheck: "false", value: isTable(key) ? key.example : null, placeholder: key.example, "data-own": "", "aria-describedby": about }),
    h("button", { type: "submit" }, T.add),
    app.seen.addProblem ? h("p", { class: "problem", id: "to-add-problem", role: "alert" }, h("span", { "aria-hidden": "true" }, "⚠ "), app.seen.addProblem) : null);
}

export function absent() {
  const all = [...keys(), ...lists()].sort((a, b) => a.path < b.path ? -1 : 1);
  if (!all.length) return null;
  const key = keys().find(k => k.path === app.seen.toAdd), own = key ? null : lists().find(l => l.path === app.seen.toAdd);
  return h("div", { class: "absent", "data-key": "absent" },
    h("h3", {}, T.absent),
    h("div", { class: "row" },
      h("label", { for: "to-add" }, T.absentName),
      h("input", { id: "to-add", type: "text", list: "could-have", autocomplete: "off", spellcheck: "false", placeholder: T.absentHint(all.length), "data-own": "", "data-input": "toAdd", "aria-describedby": "to-add-about" }),
      h("datalist", { id: "could-have" }, all.map(k => h("option", { value: k.path }, k.about || pathText(k.path))))),
    h("p", { class: "note", id: "to-add-about", role: "status" }, key ? key.about : own ? own.about : app.seen.toAdd ? T.noSuchKey : ""),
    key ? fieldOf(key) : own ? rowForm(own, "new") : null);
}

export const inputs = {
  toAdd: e => { Object.assign(app.seen, { toAdd: e.value.trim(), addProblem: null }); redraw(); },
};

export const submits = {
  addKey: async form => {
    const path = app.seen.toAdd, place = form.elements.value, text = place.value.trim();
    if (!text) { say(T.fillIn(path)); place.focus(); return; }
    app.seen.addProblem = null;
    try { await post("set", { path, text }); } catch (e) {
      app.seen.addProblem = refusalText(e);
      redraw();
      return;
    }
    clearChoice();
    await load();
    say(T.didSet(pathText(path), text));
  },
};
