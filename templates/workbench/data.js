// The measurements: files, what was read of them, rows that are struck out.
import { alarm, app, change, redraw, refuse, say } from "./app.js";
import { columns, forgetSaid, openFiles, readingOf } from "./columns.js";
import { h } from "./dom.js";
import { numberText, proseText, unitText } from "./numbers.js";
import { send } from "./server.js";
import { T } from "./texts.js";

const used = () => app.state.data ? app.state.data.files : [];
// Files that were refused are still wanted: what is wrong with them stands below.
const wanted = () => app.reading.refused ? app.reading.refused.files : used();

function files() {
  const { measurements } = app.state;
  return h("fieldset", { "data-key": "files" }, h("legend", {}, T.measurements),
    measurements.length ? measurements.map((name, i) => h("div", { class: "check", "data-key": "file:" + name },
      h("input", { type: "checkbox", id: "file-" + i, value: name, checked: wanted().includes(name), "data-change": "files" }),
      h("label", { for: "file-" + i }, name), wanted().includes(name) && !used().includes(name) ? h("span", { class: "warn" }, T.isNotRead) : null)) : h("p", { class: "note" }, T.noMeasurements));
}

const drop = () => h("div", { class: "drop", id: "drop" },
  h("p", {}, T.drop, " ", h("label", { for: "pick", class: "pick" }, T.choose)),
  h("input", { type: "file", id: "pick", multiple: true, "data-change": "pick", class: "hidden" }));

function table(rows, struck) {
  const { columns, observables, observable, observed, predicted, lines } = rows;
  const shown = Math.min(lines.length, app.seen.rowsShown);
  const cell = (c, i) => c.words ? h("td", {}, c.words[i]) : h("td", { class: "num" }, numberText(c.values[i], 6));
  const unit = observables.length === 1 ? ` [${unitText(observables[0].unit)}]` : "";
  return h("details", { id: "rows" }, h("summary", {}, T.rowsTable),
    h("div", { class: "tablebox tall", tabindex: "0", role: "group", "aria-label": T.rowsTable },
      h("table", {},
        h("thead", {}, h("tr", {}, h("th", { scope: "col", class: "num" }, T.line),
          columns.map(c => h("th", { scope: "col", class: c.words ? null : "num" }, c.unit ? `${c.name} [${unitText(c.unit)}]` : c.name)),
          observables.length > 1 ? h("th", { scope: "col" }, T.observable) : null,
          h("th", { scope: "col", class: "num" }, T.observed + unit),
          predicted ? h("th", { scope: "col", class: "num" }, T.residual + unit) : null,
          h("th", { scope: "col" }, T.rowUse))),
        h("tbody", {}, lines.slice(0, shown).map((line, i) => h("tr", { class: struck.has(i) ? "struck" : null, "data-key": "row:" + i },
          h("th", { scope: "row", class: "num" }, String(line)),
          columns.map(c => cell(c, i)),
          observables.length > 1 ? h("td", {}, observables[observable[i]].name) : null,
          h("td", { class: "num" }, numberText(observed[i], 5)),
          predicted ? h("td", { class: "num" }, numberText(observed[i] - predicted[i])) : null,
          h("td", {}, strikeButton(i, line, struck.has(i)))))))),
    shown < lines.length ? h("button", { type: "button", "data-click": "moreRows" }, T.showMore(Math.min(200, lines.length - shown))) : null);
}

export const strikeButton = (row, line, isStruck) => h("button", {
  type: "button", class: "plain", "data-click": "strike", "data-row": row,
  "aria-label": `${isStruck ? T.restore : T.strike}: ${T.line} ${line}`,
}, isStruck ? T.restore : T.strike);

export function data() {
  const { data } = app.state;
  const struck = new Set(data ? data.struck : []);
  return [
    h("h2", { id: "data-title" }, T.panes.data),
    files(), drop(), columns(),
    data ? [
      h("p", { "data-key": "count" }, T.rowsRead(data.rows), struck.size ? [" · ", h("span", { class: "warn" }, T.struck(struck.size)), " ", h("button", { type: "button", class: "plain", "data-click": "restoreAll" }, T.restoreAll)] : null),
      data.notes.length ? h("details", { id: "notes", open: true }, h("summary", {}, T.notes), h("ul", {}, data.notes.map(n => h("li", {}, proseText(n))))) : null,
      app.rows ? table(app.rows, struck) : null,
    ] : null,
  ];
}

export async function strike(row) {
  const isStruck = !app.state.data.struck.includes(row);
  const line = app.rows ? app.rows.lines[row] : row;
  await change("strike", { rows: [row], is_struck: isStruck }, isStruck ? T.didStrike(line) : T.didRestore(line));
}

// A file that is dropped is stored in the folder, and what is dropped is meant to be used.
async function take(list) {
  const names = [];
  for (const file of list) {
    say(T.dropping(file.name));
    try { names.push((await send(file)).name); } catch (e) { refuse(e); }
  }
  if (!names.length) return;
  const all = [...new Set([...wanted(), ...names])];
  await openFiles(all, await readingOf(all), names.map(T.dropped).join(" "));
}

export function listenForDrops() {
  let depth = 0;
  const mark = isOver => { const place = document.getElementById("drop"); if (place) place.classList.toggle("over", isOver); };
  addEventListener("dragenter", e => { e.preventDefault(); depth += 1; mark(true); });
  addEventListener("dragleave", () => { depth = Math.max(0, depth - 1); if (!depth) mark(false); });
  addEventListener("dragover", e => e.preventDefault());
  addEventListener("drop", e => {
    e.preventDefault();
    depth = 0;
    mark(false);
    alarm("");
    if (e.dataTransfer.files.length) take(e.dataTransfer.files);
  });
}

export const clicks = {
  strike: e => strike(Number(e.dataset.row)),
  restoreAll: () => change("strike", { rows: app.state.data.struck, is_struck: false }, T.didRestoreAll),
  moreRows: () => { app.seen.rowsShown += 200; redraw(); },
};

export const changes = {
  files: async e => {
    const names = app.state.measurements.filter(n => n === e.value ? e.checked : wanted().includes(n));
    // Nothing to be told of: the files that were open before a refusal are open still.
    if (app.reading.refused && names.join("\n") === used().join("\n")) forgetSaid();
    else await openFiles(names, await readingOf(names), names.length ? null : T.didClose);
    redraw();
  },
  pick: async e => { const list = [...e.files]; e.value = ""; await take(list); },
};
