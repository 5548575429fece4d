// What is missing: every suspect with its probability and what it would gain, and what to measure next.
import { alarm, app, change } from "./app.js";
import { blob, h } from "./dom.js";
import { progress, runButton } from "./job.js";
import { proseText, quantityText } from "./numbers.js";
import { T } from "./texts.js";

const percent = p => p > 0.995 ? "> 99 %" : p < 0.005 ? "< 1 %" : Math.round(p * 100) + " %";
const isIn = name => app.state.model && app.state.model.effects.some(e => e.name === name);
const canAdd = name => app.state.model && app.state.model.catalogue.some(e => e.name === name);

function cause(c, i) {
  const { comparison } = app.state;
  const before = comparison && !comparison.problem ? comparison.rms : null;
  const gain = before !== null && !isIn(c.effect) && before > c.rms_after ? before - c.rms_after : null;
  return h("article", { class: `cause ${c.class}`, "data-key": "cause:" + c.effect, "aria-labelledby": "cause-" + i },
    h("h3", { id: "cause-" + i }, c.label),
    h("p", { class: "class" }, h("span", { class: "badge" }, h("span", { "aria-hidden": "true" }, T.classSigns[c.class] + " "), T.classes[c.class]), ` ${T.probability} ${percent(c.probability)}`),
    h("div", { class: "meter", "aria-hidden": "true" }, h("span", { class: "fill", style: `width:${(c.probability * 100).toFixed(1)}%` })),
    h("p", { class: "gain" }, before !== null && gain !== null ? [h("strong", {}, T.gains(quantityText(gain, c.unit))), " · ", T.errorWith(quantityText(before, comparison.unit), quantityText(c.rms_after, c.unit))] : T.errorWithIt(quantityText(c.rms_after, c.unit))),
    h("p", {}, c.about),
    c.values.length ? h("p", { class: "note" }, T.estimates, " ", c.values.map(proseText).join(", ")) : null,
    c.alike.length ? h("div", { class: "note" }, T.alike, h("ul", {}, c.alike.map(a => h("li", {}, proseText(a))))) : null,
    isIn(c.effect)
      ? h("p", { class: "acts", "data-key": "acts" }, h("span", { class: "badge" }, "✓ " + T.inModel), " ", h("button", { type: "button", "data-click": "remove", "data-effect": c.effect, "aria-label": T.removeOf(c.label) }, T.remove))
      : c.can_add ? h("p", { class: "acts", "data-key": "acts" }, h("button", { type: "button", class: "main", "data-click": "add", "data-effect": c.effect, "aria-label": T.addOf(c.label) }, T.add)) : null);
}

function others({ others }) {
  if (!others.length) return null;
  const unit = app.state.comparison ? app.state.comparison.unit : "um";
  return h("details", { id: "others" }, h("summary", {}, T.others),
    h("div", { class: "tablebox", tabindex: "0", role: "group", "aria-label": T.others },
      h("table", {}, h("thead", {}, h("tr", {}, h("th", { scope: "col" }, T.effect), h("th", { scope: "col", class: "num" }, T.probability), h("th", { scope: "col", class: "num" }, T.alone), h("th", { scope: "col" }, T.add))),
        h("tbody", {}, others.map(o => h("tr", { "data-key": "other:" + o.effect },
          h("th", { scope: "row", title: o.about }, o.effect),
          h("td", { class: "num" }, percent(o.probability)),
          h("td", { class: "num" }, o.rms_alone === null ? T.none : quantityText(o.rms_alone, unit)),
          h("td", {}, isIn(o.effect) ? T.inModel : canAdd(o.effect) ? h("button", { type: "button", class: "plain", "data-click": "add", "data-effect": o.effect, "aria-label": T.addOf(o.effect) }, T.add) : T.none)))))));
}

/** The cells of one line: apart by commas, unless quoted. */
function cellsOf(line) {
  const cells = [""];
  let isQuoted = false;
  for (let i = 0; i < line.length; i += 1) {
    const c = line[i];
    if (c === '"' && isQuoted && line[i + 1] === '"') { cells[cells.length - 1] += c; i += 1; }
    else if (c === '"') isQuoted = !isQuoted;
    else if (c === "," && !isQuoted) cells.push("");
    else cells[cells.length - 1] += c;
  }
  return cells.map(t => t.trim());
}

function parse(text) {
  const lines = text.split(/\r?\n/).filter(l => l.trim());
  const table = lines.filter(l => !l.startsWith("#")).map(cellsOf);
  return { comments: lines.filter(l => l.startsWith("#")), header: table[0] || [], rows: table.slice(1) };
}
const written = cells => cells.map(t => /[",\n]/.test(t) ? '"' + t.replace(/"/g, '""') + '"' : t).join(",");

// Readings that are not sent yet outlive a reload: they are nowhere else.
const store = "readings";
function readings(rows) {
  try { const kept = JSON.parse(sessionStorage.getItem(store)); if (kept && kept.rows === rows) return kept.cells; } catch { /* nothing kept */ }
  return {};
}

function next({ next }) {
  if (!next) return null;
  const { header, rows } = parse(next.rows), cells = readings(next.rows);
  return h("div", { class: "next", id: "next" },
    h("h3", {}, T.next),
    blob(next.html, { class: "served", "data-key": "why" }),
    rows.length ? h("form", { "data-submit": "readings", "data-key": "form" },
      h("p", { class: "note" }, T.nextNote),
      h("div", { class: "tablebox", tabindex: "0", role: "group", "aria-label": T.next }, h("table", {},
        h("thead", {}, h("tr", {}, header.map(t => h("th", { scope: "col" }, proseText(t).replace(/_/g, " "))))),
        h("tbody", {}, rows.map((row, r) => h("tr", {}, header.map((name, c) => row[c] ? h("td", { class: "num" }, row[c])
          : h("td", {}, h("input", { type: "text", inputmode: "decimal", size: 8, autocomplete: "off", "data-cell": `${r},${c}`, "data-input": "reading", value: cells[`${r},${c}`] || "", "aria-label": T.cell(proseText(name).replace(/_/g, " "), r + 1), id: `reading-${r}-${c}` })))))))),
      h("p", { class: "acts" }, h("button", { type: "submit", class: "main" }, T.send), " ", h("button", { type: "button", "data-click": "printForm" }, T.print))) : null);
}

export function causes() {
  const { diagnosis, data } = app.state;
  return [
    h("h2", { id: "causes-title" }, T.panes.causes),
    h("div", { class: "run", "data-key": "run" }, runButton("diagnose", T.diagnose, !data, true), h("span", { class: "note" }, T.diagnoseNote)),
    progress(["diagnose"]),
    diagnosis ? [
      diagnosis.is_current ? null : h("p", { class: "caution", "data-key": "old" }, h("span", { "aria-hidden": "true" }, "⚠ "), T.old),
      h("p", { class: "sentence", "data-key": "verdict" }, proseText(diagnosis.verdict)),
      diagnosis.causes.map(cause),
      others(diagnosis),
      next(diagnosis),
      h("details", { id: "answer" }, h("summary", {}, T.wholeAnswer), blob(diagnosis.html, { class: "served" })),
    ] : h("p", { class: "note", "data-key": "none" }, T.noDiagnosis),
  ];
}

export const clicks = {
  printForm: () => {
    document.body.classList.add("form-only");
    addEventListener("afterprint", () => document.body.classList.remove("form-only"), { once: true });
    print();
  },
};

export const inputs = {
  reading: e => {
    const rows = app.state.diagnosis.next.rows, cells = readings(rows);
    cells[e.dataset.cell] = e.value;
    e.removeAttribute("aria-invalid");
    try { sessionStorage.setItem(store, JSON.stringify({ rows, cells })); } catch { /* private windows may refuse; the fields keep what is written */ }
  },
};

export const submits = {
  readings: async form => {
    const { comments, header, rows } = parse(app.state.diagnosis.next.rows);
    const out = [];
    let bad = null;
    rows.forEach((row, r) => {
      const empty = header.map((_, c) => c).filter(c => !row[c]);
      const fields = empty.map(c => form.querySelector(`[data-cell="${r},${c}"]`));
      if (!fields.some(f => f.value.trim())) return;
      const cells = header.map((_, c) => row[c] || "");
      empty.forEach((c, i) => {
        // A decimal comma would be read as the end of the cell.
        const text = fields[i].value.trim().replace(",", ".").replace("\u2212", "-");
        if (text && !Number.isFinite(Number(text)) && !bad) { bad = fields[i]; bad.setAttribute("aria-invalid", "true"); }
        cells[c] = text;
      });
      out.push(cells);
    });
    if (bad) { alarm(T.badReading(bad.value)); bad.focus(); return; }
    if (!out.length) { alarm(T.noReadings); form.querySelector("input").focus(); return; }
    const csv = [...comments, written(header), ...out.map(written)].join("\n") + "\n";
    if (await change("readings", { csv }, T.didSend(out.length))) sessionStorage.removeItem(store);
  },
};
