// What to do about it: offsets, contours, programs, remedies; all as the server writes them.
import { alarm, app, load, redraw, say } from "./app.js";
import { blob, h } from "./dom.js";
import { onAsked, progress, runButton } from "./job.js";
import { proseText } from "./numbers.js";
import { post, refusalText } from "./server.js";
import { T } from "./texts.js";

const programs = () => app.state.programs || [];
const program = () => programs().includes(app.seen.program) ? app.seen.program : null;
const old = () => h("p", { class: "caution", "data-key": "old" }, h("span", { "aria-hidden": "true" }, "⚠ "), T.old);

function tolerance({ tolerance }) {
  const lines = tolerance || [];
  return lines.length ? h("div", { class: "tolerance", "data-key": "tolerance" }, h("h3", { id: "tolerance-title" }, T.tolerance), h("ul", { "aria-labelledby": "tolerance-title" }, lines.map(t => h("li", {}, proseText(t))))) : null;
}

function forProgram() {
  if (!programs().length) return null;
  const own = program();
  return h("div", { class: "row", "data-key": "program" },
    h("label", { for: "program" }, T.forProgram),
    h("select", { id: "program", "data-change": "program" }, h("option", { value: "", selected: !own }, T.noProgram), programs().map(p => h("option", { value: p, selected: p === own }, p))),
    own ? h("div", { class: "check", "data-key": "blocks" }, h("input", { type: "checkbox", id: "add-blocks", checked: app.seen.addsBlocks, "data-change": "addBlocks" }), h("label", { for: "add-blocks" }, T.addBlocks)) : null);
}

const nextName = name => {
  const [, stem, number] = name.match(/^(.*?)(?:-(\d+))?$/);
  return `${stem}-${Number(number || 1) + 1}`;
};

function write({ correction }) {
  if (!correction) return null;
  const { written, writeProblem } = app.seen;
  return h("div", { class: "write", "data-key": "write" },
    h("form", { class: "row", "data-submit": "write" },
      h("label", { for: "write-name" }, T.writeInto),
      h("input", { type: "text", id: "write-name", name: "name", value: T.writeName, autocomplete: "off", spellcheck: "false", "data-own": "", "aria-describedby": writeProblem ? "write-problem" : null }),
      h("button", { type: "submit", class: "main" }, T.writeFiles)),
    writeProblem ? h("p", { class: "problem", id: "write-problem", role: "alert" }, h("span", { "aria-hidden": "true" }, "⚠ "), writeProblem) : null,
    written.length ? h("div", { "data-key": "written" }, h("p", {}, T.written), h("ul", {}, written.map(n => h("li", {}, n)))) : null);
}

function remedies({ model, remedies }) {
  if (!model || !model.has_settings && !remedies) return null;
  return h("div", { class: "remedies", "data-key": "remedies" },
    h("h3", {}, T.remediesTitle),
    model.has_settings ? h("div", { class: "run", "data-key": "run" },
      runButton("remedies", T.remedies, false),
      h("span", { class: "minutes" }, h("label", { for: "minutes" }, T.atMost), h("input", { type: "text", id: "minutes", inputmode: "decimal", size: 4, autocomplete: "off", "data-own": "", "aria-describedby": "minutes-note" }), h("span", { id: "minutes-note" }, T.minutesMore))) : null,
    progress(["remedies"]),
    remedies ? [remedies.is_current ? null : old(), blob(remedies.html, { class: "served", "data-key": "html" })] : null);
}

export function correct() {
  const { correction } = app.state;
  return [
    h("h2", { id: "correct-title" }, T.panes.correct),
    tolerance(app.state),
    forProgram(),
    h("div", { class: "run", "data-key": "run" }, runButton("correct", T.correct, false), h("span", { class: "note" }, T.correctNote)),
    progress(["correct"]),
    correction ? [
      correction.is_current ? null : old(),
      write(app.state),
      blob(correction.html, { class: "served", "data-key": "html" }),
    ] : h("p", { class: "note", "data-key": "none" }, T.noCorrection),
    remedies(app.state),
  ];
}

onAsked("correct", () => {
  Object.assign(app.seen, { written: [], writeProblem: null });
  return programs().length ? { program: program(), add_blocks: program() !== null && app.seen.addsBlocks } : {};
});
onAsked("remedies", () => {
  const place = document.getElementById("minutes"), text = place ? place.value.trim().replace(",", ".") : "";
  if (!text) return { minutes: null };
  const minutes = Number(text);
  if (Number.isFinite(minutes) && minutes >= 0) { place.removeAttribute("aria-invalid"); return { minutes }; }
  alarm(T.badReading(place.value));
  place.setAttribute("aria-invalid", "true");
  place.focus();
  return null;
});

export const changes = {
  program: e => { app.seen.program = e.value; redraw(); },
  addBlocks: e => { app.seen.addsBlocks = e.checked; redraw(); },
};

export const submits = {
  write: async form => {
    const place = form.elements.name, name = place.value.trim();
    if (!name) { place.focus(); return; }
    app.seen.writeProblem = null;
    try {
      const { names } = await post("write", { as: name });
      app.seen.written = names || [];
      say(T.didWrite(app.seen.written, name));
      await load();
    } catch (e) {
      Object.assign(app.seen, { written: [], writeProblem: refusalText(e) });
      // Most often the folder is there already: the next name is at hand.
      place.value = nextName(name);
      place.focus();
      place.select();
    }
    redraw();
  },
};
