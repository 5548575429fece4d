// What holds for the whole: the verdict, the error falling, undo, save, history.
import { app, alarm, change, redraw, say, withoutFolder } from "./app.js";
import { bars } from "./bars.js";
import { isIn } from "./causes.js";
import { h } from "./dom.js";
import { nameText, numberText, proseText, quantityText } from "./numbers.js";
import { lacksValues, nextStep } from "./steps.js";
import { T } from "./texts.js";

const MOST_CAUSES = 3;
/** What an effect does, without what follows from it. */
const briefly = about => about ? about.split(/[;:]|, (?=and |or |but |which )/)[0] : null;

/** The causes that a diagnosis of this very model found, in plain words; null if there is none. */
function causesText({ diagnosis }) {
  if (!diagnosis || !diagnosis.is_current) return null;
  const out = diagnosis.causes.filter(c => !isIn(c.effect));
  if (!out.length) return null;
  const told = out.slice(0, MOST_CAUSES).map(c => T.causeInWords(nameText(c.label), briefly(c.about)));
  return T.causesInWords(told, out.length - told.length);
}

function verdict(state) {
  const { model, data, comparison } = state;
  if (!model) return ["", "○", T.noModel];
  if (app.reading.refused) return ["bad", "⚠", T.notRead(app.reading.refused.file)];
  if (!data) return ["", "○", T.noData];
  if (lacksValues(state)) return ["bad", "⚠", T.lacksValues(proseText(withoutFolder(comparison.problem)))];
  if (!comparison || comparison.problem) return ["bad", "⚠", comparison ? proseText(withoutFolder(comparison.problem)) : T.noComparison];
  const rms = quantityText(comparison.rms, comparison.unit), noise = quantityText(comparison.noise, comparison.unit);
  return comparison.is_adequate ? ["good", "✓", T.adequate(rms, noise)] : ["bad", "⚠", T.fails(rms, noise, causesText(state))];
}

export function header() {
  const { model, comparison, folder, steps, noise } = app.state;
  const [mood, sign, sentence] = verdict(app.state);
  const has = comparison && !comparison.problem;
  return [
    h("p", { class: "kicker", title: folder }, [folder.split(/[\\/]/).at(-1), model && model.file, model && model.process].filter(Boolean).join(" · ")),
    h("h1", {}, model ? model.title || model.file : T.page),
    h("p", { class: `verdict ${mood}`, "data-key": "verdict" }, h("span", { class: "sign", "aria-hidden": "true" }, sign), h("span", {}, sentence)),
    nextStep(),
    h("div", { class: "top", "data-key": "top" },
      has ? h("dl", { class: "facts", "data-key": "facts" },
        h("div", { class: "main" }, h("dt", {}, T.errorNow), h("dd", {}, quantityText(comparison.rms, comparison.unit))),
        app.trial.values.size ? h("div", { class: "trial", "data-key": "trial" }, h("dt", {}, T.trialError), h("dd", {}, app.trial.rms === null ? T.trialWaits : quantityText(app.trial.rms, comparison.unit))) : null,
        h("div", {}, h("dt", {}, T.noise), h("dd", {}, quantityText(comparison.noise, comparison.unit))),
        h("div", {}, h("dt", {}, T.reducedChi2), h("dd", {}, numberText(comparison.reduced_chi2))),
        h("div", {}, h("dt", {}, T.verdictWord), h("dd", {}, comparison.verdict))) : null,
      bars(steps, { unit: comparison && comparison.unit || "um", noise, title: T.bars, key: "bars" })),
  ];
}

export function bar() {
  const { model, undo, redo, history } = app.state;
  return [
    h("ul", { class: "panes" }, Object.entries(T.panes).map(([id, name]) => h("li", {}, h("a", { href: "#" + id }, name)))),
    h("div", { class: "actions", role: "group", "aria-label": T.actionsLabel },
      h("button", { type: "button", id: "undo", "data-click": "undo", disabled: !undo, title: undo ? T.undoWhat(undo) : T.nothingToUndo, "aria-keyshortcuts": "Control+Z" }, h("span", { "aria-hidden": "true" }, "↶ "), T.undo),
      h("button", { type: "button", id: "redo", "data-click": "redo", disabled: !redo, title: redo ? T.redoWhat(redo) : T.nothingToRedo, "aria-keyshortcuts": "Control+Shift+Z" }, h("span", { "aria-hidden": "true" }, "↷ "), T.redo),
      model ? [
        h("button", { type: "button", id: "save", "data-click": "save", disabled: model.is_saved }, model.is_saved ? T.saved : [T.save, h("span", { class: "dot", title: T.unsaved, "aria-hidden": "true" }, " •")]),
        h("details", { class: "menu", id: "save-as" }, h("summary", {}, T.saveAs),
          h("form", { "data-submit": "saveAs" }, h("label", { for: "save-name" }, T.saveAsName), h("input", { id: "save-name", name: "name", "data-own": "", type: "text", autocomplete: "off", spellcheck: "false", placeholder: model.file }), h("button", { type: "submit" }, T.saveAsDo))),
        h("details", { class: "menu", id: "export" }, h("summary", {}, T.exportMenu),
          h("ul", {}, [["page", T.exportPage], ["csv", T.exportCsv], ["notebook", T.exportNotebook]].map(([what, name]) => h("li", {}, h("a", { href: "export?what=" + what, download: true }, name))))),
      ] : null,
      h("details", { class: "menu wide", id: "history" }, h("summary", {}, T.history),
        h("div", {}, history.length ? [h("p", { class: "note" }, T.historyNote), h("pre", { tabindex: "0", role: "group", "aria-label": T.history }, h("code", {}, history.join("\n"))), h("button", { type: "button", "data-click": "copyHistory" }, T.copy)] : h("p", { class: "note" }, T.historyEmpty)))),
  ];
}

export function trouble() {
  const { trouble } = app.state;
  return [
    app.isLost ? h("p", { class: "caution", role: "alert" }, h("span", { "aria-hidden": "true" }, "⚠ "), app.isLost === "over" ? T.lostForGood : T.lost) : null,
    trouble ? h("div", { class: "caution", role: "alert", "data-key": "trouble" }, h("p", {}, h("span", { "aria-hidden": "true" }, "⚠ "), T.trouble), h("pre", { tabindex: "0", role: "group", "aria-label": T.trouble }, h("code", {}, trouble))) : null,
  ];
}

export function trialBar() {
  const { values, rms, moves, problem } = app.trial;
  const unit = app.state.comparison ? app.state.comparison.unit : "um";
  return [
    h("p", {}, h("span", { class: "dashes", "aria-hidden": "true" }), problem || (moves ? null : T.nothingMoves) || T.trialBar(values.size, rms === null ? T.trialWaits : quantityText(rms, unit)), " ", h("span", { class: "note" }, T.trialNote)),
    h("button", { type: "button", "data-click": "resetAll" }, T.resetAll),
  ];
}

async function step(which, said) {
  const what = app.state[which];
  if (what) await change(which, {}, said(what));
}

export const undo = () => step("undo", T.didUndo);
export const redo = () => step("redo", T.didRedo);

export const clicks = {
  undo, redo,
  save: () => change("save", { as: null }, T.didSave(app.state.model.file)),
  copyHistory: async () => {
    try { await navigator.clipboard.writeText(app.state.history.join("\n") + "\n"); say(T.copied); } catch (e) { alarm(e.message); }
  },
};

export const submits = {
  saveAs: async form => {
    const name = form.elements.name.value.trim();
    if (!name) { form.elements.name.focus(); return; }
    if (await change("save", { as: name }, T.didSave(name))) {
      form.reset();
      form.closest("details").open = false;
      form.closest("details").querySelector("summary").focus();
    }
    redraw();
  },
};
