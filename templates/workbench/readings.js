// What to measure next, as a form that prints and takes readings back.
import { alarm, app, change } from "./app.js";
import { blob, h } from "./dom.js";
import { proseText } from "./numbers.js";
import { T } from "./texts.js";

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

export function next({ next }) {
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
