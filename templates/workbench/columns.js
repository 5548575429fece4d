// How files are read: the table as it stands in a file, and above each column what it is to be. What a file says in words
// of its own is put right here, as is a file that was refused for them.
import { alarm, app, load, redraw, refuse, say, withoutFolder } from "./app.js";
import { h } from "./dom.js";
import { proseText, unitText } from "./numbers.js";
import { Refusal, get, post, refusalText } from "./server.js";
import { T } from "./texts.js";

const MOST_LOOKED = 12;   // files of a folder that are looked into to see which fits the model
// Units that are offered beside the usual one; any other may be written.
const KIN = [["um", "mm", "m"], ["N", "kN"], ["s", "min", "h"], ["degC", "K"], ["deg", "rad"]];
const NONE = { columns: [], decimal: null, header: null, sheet: null, as_typed: false };

const known = () => app.state.model && app.state.model.columns || [];
const ownOf = name => known().find(c => c.name === name.split("@")[0]) || null;
const files = () => app.reading.refused ? app.reading.refused.files : app.state.data ? app.state.data.files : [];
/** What the server was last told of how to read these files. */
const base = () => app.reading.refused ? app.reading.refused.reading : app.state.data && app.state.data.reading || NONE;
/** What is said of the file as a whole: its decimal mark, the line of its headings, its sheet, whether it is taken as typed. */
const how = () => ({ ...NONE, ...base(), ...app.reading.how });

function parse(said) {
  const [, name, unit] = said.match(/^(.*?)\s*(?:\[(.*)\])?$/);
  return { name, unit: unit || "" };
}

/** What is to be made of a column; an empty name is: as it is read. */
function saidOf(heading) {
  if (app.reading.said.has(heading)) return app.reading.said.get(heading);
  const found = base().columns.find(([own]) => own === heading);
  return found ? parse(found[1]) : { name: "", unit: "" };
}

/** What a heading is read as by itself: by the server as it read it, or as it would be where the file was refused. */
function readAs(heading) {
  if (app.state.data && !app.reading.refused) return app.state.data.columns.find(c => c.heading === heading) || null;
  for (const { headings, meant } of app.reading.previews.values()) {
    const name = meant && headings.includes(heading) ? meant[headings.indexOf(heading)] : null;
    if (name) return { ...parse(name), heading };
  }
  return null;
}

/** All that is said of columns, as the server takes it. */
function reading() {
  const all = new Map(base().columns);
  for (const [heading, { name, unit }] of app.reading.said) {
    const own = name || (unit && readAs(heading) ? readAs(heading).name : "");
    if (own) all.set(heading, unit && own !== "-" ? `${own} [${unit.replace(/[\u00b5\u03bc]/g, "u")}]` : own);
    else all.delete(heading);
  }
  return { ...how(), columns: [...all] };
}

/** Forgets what was said and not sent. */
export function forgetSaid() {
  app.reading.said.clear();
  Object.assign(app.reading, { how: {}, refused: null });
}

// The file as it stands: asked for once for each state, and told when it has come.
const underWay = new Map();
function look(file) {
  const { previews } = app.reading, { version } = app.state, { header, sheet } = how();
  const asked = "preview?file=" + encodeURIComponent(file) + (header === null ? "" : "&header=" + header) + (sheet ? "&sheet=" + encodeURIComponent(sheet) : "");
  const have = previews.get(file);
  if (have && have.version === version && have.asked === asked) return Promise.resolve(have);
  // Where no table is found in a sheet, the others are still there to be chosen.
  const none = e => ({ headings: [], rows: [], lines: 0, sheets: have ? have.sheets : [], problem: refusalText(e) });
  if (!underWay.has(asked)) underWay.set(asked, get(asked)
    .then(found => ({ ...found, problem: null }), none)
    .then(found => { previews.set(file, { ...found, version, asked }); redraw(); return previews.get(file); })
    .finally(() => underWay.delete(asked)));
  return underWay.get(asked);
}
const preview = file => { look(file); return app.reading.previews.get(file) || null; };

/** Files of the folder that the model can be compared with as they are. */
export function fitting() {
  const { measurements } = app.state;
  if (!known().length || measurements.length > MOST_LOOKED) return [];
  return measurements.filter(file => {
    const found = preview(file);
    return found !== null && found.fits === true;
  });
}

/** What is said of a file, without its folder, and with the hint of the command line as one to what stands below. */
const forPage = text => withoutFolder(text).replace(/ or say which one it is: --columns '[^']*'(; `[^`]*` lists all names)?/g, " " + T.orBelow);

/** Opens files; those that are refused are kept, with the reason, to be put right in the pane. */
export async function openFiles(names, how, said) {
  try { await post("data", { files: names, ...how }); } catch (e) {
    if (!(e instanceof Refusal) || !app.state.model || !names.length) { refuse(e); return false; }
    const file = names.includes(e.file) ? e.file : names.at(-1);
    const text = forPage(refusalText(e));
    Object.assign(app.reading, { refused: { files: names, reading: how, text, file }, file, how: {} });
    alarm("");
    await load();
    redraw();
    // Once it is drawn.
    requestAnimationFrame(() => requestAnimationFrame(() => {
      const place = document.getElementById("columns");
      if (!place) return;
      place.open = true;
      place.scrollIntoView({ block: "start" });
      redraw();
    }));
    return false;
  }
  forgetSaid();
  alarm("");
  await load();
  if (said) say(said);
  return true;
}

/** What was said of columns, as far as these files have them. */
export async function readingOf(names) {
  const all = reading();
  if (!all.columns.length) return all;
  const found = await Promise.all(names.map(look));
  const isThere = heading => found.some(own => own.problem || own.headings.includes(heading));
  return { ...all, columns: all.columns.filter(([heading]) => isThere(heading)) };
}

function units(name) {
  const own = ownOf(name);
  if (!own || own.words || !own.unit) return [];
  return [own.unit, ...(KIN.find(all => all.includes(own.unit)) || []).filter(u => u !== own.unit)];
}

function choice(heading, i) {
  const said = saidOf(heading), as = readAs(heading), names = known().map(c => c.name);
  const label = heading || T.columnNumber(i + 1);
  const isUnit = said.name !== "-" && units(said.name || (as ? as.name : "")).length > 0;
  return h("th", { scope: "col" }, h("div", { class: "said" },
    h("select", { id: "said-" + i, "data-change": "sayColumn", "data-heading": heading, "data-column": i, disabled: !heading, "aria-label": T.columnIs(label) },
      h("option", { value: "", selected: !said.name }, as ? T.asReadAs(as.name) : T.asRead),
      [...(said.name && said.name !== "-" && !names.includes(said.name) ? [said.name] : []), ...names].map(n => h("option", { value: n, selected: said.name === n, title: (ownOf(n) || {}).about }, n)),
      h("option", { value: "-", selected: said.name === "-" }, T.leaveOut)),
    h("input", { type: "text", id: "unit-" + i, size: 5, list: isUnit ? "units-" + i : null, "data-input": "sayUnit", "data-heading": heading, disabled: !isUnit, value: unitText(said.unit), placeholder: as && !said.name && as.unit ? unitText(as.unit) : T.columnUnit, "aria-label": T.unitOf(label), autocomplete: "off", spellcheck: "false" }),
    h("datalist", { id: "units-" + i }, units(said.name || (as ? as.name : "")).map(u => h("option", { value: unitText(u) })))));
}

function table(file, { headings, rows, lines }) {
  return [
    h("div", { class: "tablebox", tabindex: "0", role: "group", "aria-label": T.fileAsItIs(file), "data-key": "preview" },
      h("table", { class: "preview" },
        h("thead", {}, h("tr", { "data-key": "said" }, headings.map(choice)), h("tr", { "data-key": "headings" }, headings.map((t, i) => h("th", { scope: "col" }, t || T.columnNumber(i + 1))))),
        h("tbody", {}, rows.map(cells => h("tr", {}, headings.map((t, i) => h("td", { class: saidOf(t).name === "-" ? "out" : null }, cells[i] === undefined ? "" : cells[i]))))))),
    h("p", { class: "note", "data-key": "more" }, rows.length < lines ? T.firstOf(rows.length, lines) : T.allOf(rows.length)),
  ];
}

/** As the server read it, where the file is no table that could be shown. */
const readTable = ({ columns }) => h("div", { class: "tablebox", tabindex: "0", role: "group", "aria-label": T.columnsRead, "data-key": "read" },
  h("table", {}, h("caption", {}, T.columnsRead),
    h("thead", {}, h("tr", {}, [T.column, T.columnUnit, T.heading].map(t => h("th", { scope: "col" }, t)))),
    h("tbody", {}, columns.map(c => h("tr", {}, h("td", {}, c.name), h("td", {}, unitText(c.unit) || T.none), h("td", {}, c.heading || T.none))))));

/** What may be said of a file as a whole. */
function whole({ sheets }) {
  const { decimal, header, sheet, as_typed } = how();
  const field = (key, text, own) => h("div", { class: "row", "data-key": key }, h("label", { for: "said-" + key }, text), own);
  return [
    sheets && sheets.length > 1 ? field("sheet", T.sheet, h("select", { id: "said-sheet", "data-change": "saySheet" },
      [["", T.asRead], ...sheets.map(name => [name, name])].map(([v, name]) => h("option", { value: v, selected: (sheet || "") === v }, name)))) : null,
    field("header", T.headingsIn, h("input", { type: "number", id: "said-header", min: 0, step: 1, size: 5, value: header === null ? "" : header, placeholder: T.asRead, "data-change": "sayHeader", "aria-describedby": "header-note" })),
    h("p", { class: "note", id: "header-note", "data-key": "header-note" }, T.headingsNote),
    field("decimal", T.decimalMark, h("select", { id: "said-decimal", "data-change": "sayDecimal" },
      [["", T.asRead], ["comma", T.comma], ["point", T.point]].map(([v, name]) => h("option", { value: v, selected: (decimal || "") === v }, name)))),
    h("div", { class: "row", "data-key": "typed" }, h("label", {}, h("input", { type: "checkbox", id: "said-typed", checked: as_typed, "data-change": "sayTyped" }), " " + T.asTyped)),
  ];
}

export function columns() {
  const names = files(), { refused } = app.reading;
  if (!names.length) return null;
  const file = names.includes(app.reading.file) ? app.reading.file : names[0];
  const place = document.getElementById("columns");
  const found = refused || place && place.open ? preview(file) : null;
  const isSaid = app.reading.said.size > 0 || base().columns.length > 0 || Object.entries(how()).some(([key, own]) => key !== "columns" && own !== NONE[key]);
  return h("details", { id: "columns", open: Boolean(refused) }, h("summary", {}, T.columns, isSaid && !refused ? h("span", { class: "note" }, " · " + T.isSaid) : null),
    refused ? h("div", { class: "caution refused", role: "alert", "data-key": "refused" }, h("p", {}, h("span", { "aria-hidden": "true" }, "⚠ "), T.notRead(refused.file)), h("p", { class: "lines" }, proseText(refused.text))) : null,
    h("form", { "data-submit": "reading", "data-key": "form" },
      names.length > 1 ? h("div", { class: "row", "data-key": "file" }, h("label", { for: "said-file" }, T.shownFile), h("select", { id: "said-file", "data-change": "lookAt" }, names.map(n => h("option", { value: n, selected: n === file }, n)))) : null,
      found && found.problem ? [h("p", { class: "note", "data-key": "none" }, T.noTable(file), refused && refused.text === forPage(found.problem) ? null : " " + proseText(forPage(found.problem))), app.state.data && !refused ? readTable(app.state.data) : null]
        : found ? [
          h("p", { class: "note", "data-key": "hint" }, T.columnsHint),
          table(file, found),
        ] : h("p", { class: "note", "data-key": "waits" }, T.trialWaits),
      found ? whole(found) : null,
      h("p", { class: "acts", "data-key": "acts" },
        found && (!found.problem || app.reading.how.header !== undefined || app.reading.how.sheet !== undefined) ? h("button", { type: "submit", class: refused ? "main" : null, id: "read-so" }, T.readSo) : null,
        refused ? h("button", { type: "button", "data-click": "leaveRefused" }, T.leaveRefused) : null)));
}

export const clicks = {
  leaveRefused: () => {
    forgetSaid();
    redraw();
    say(T.didLeave);
    document.getElementById("data-title").focus();
  },
};

const tellsUnit = heading => /[[(/]| in \S+$/.test(heading);

export const changes = {
  lookAt: e => { app.reading.file = e.value; redraw(); },
  sayDecimal: e => { app.reading.how.decimal = e.value || null; redraw(); },
  saySheet: e => { app.reading.how.sheet = e.value || null; redraw(); },
  sayHeader: e => { app.reading.how.header = /^\d+$/.test(e.value) ? Number(e.value) : null; redraw(); },
  sayTyped: e => { app.reading.how.as_typed = e.checked; redraw(); },
  sayColumn: e => {
    const { heading, column } = e.dataset, file = app.reading.previews.get(document.getElementById("said-file")?.value || files()[0]);
    const first = file && file.rows[0] ? file.rows[0][Number(column)] || "" : "";
    // The usual unit is proposed where the file seems to tell none, in its heading or in the row below; it is there to be seen and written over.
    const isTold = tellsUnit(heading) || first !== "" && !/\d/.test(first);
    app.reading.said.set(heading, { name: e.value, unit: isTold ? "" : units(e.value)[0] || "" });
    redraw();
  },
};

export const inputs = {
  sayUnit: e => { app.reading.said.set(e.dataset.heading, { ...saidOf(e.dataset.heading), unit: e.value.trim() }); },
};

export const submits = {
  reading: async () => {
    const names = files();
    if (await openFiles(names, reading(), T.didRead(names.join(", ")))) document.querySelector("#columns summary")?.focus();
  },
};
