// The step that comes next, offered in the header: from an empty page to files that correct the job.
import { app, change, redraw } from "./app.js";
import { isIn } from "./causes.js";
import { fitting, openFiles } from "./columns.js";
import { h } from "./dom.js";
import { progress, runButton } from "./job.js";
import { T } from "./texts.js";

const MOST_BUTTONS = 3;
const button = (click, text, about, isMain) => h("button", { type: "button", class: isMain ? "main" : null, "data-click": click, ...about, "data-key": text }, text);
const goTo = (id, text, isMain) => button("goTo", text, { "data-to": id }, isMain);

/** Causes of the last diagnosis that are to be added, the certain ones first. */
const causesToAdd = () => app.state.diagnosis ? app.state.diagnosis.causes.filter(c => c.can_add && !isIn(c.effect)) : [];
const certain = () => causesToAdd().filter(c => c.class === "certain");

/** Whether a comparison fails because values are not known yet. */
export const lacksValues = ({ model, data, comparison }) => model !== null && data !== null && comparison !== null && Boolean(comparison.problem)
  && model.values.some(v => v.knowledge === "unknown" && v.value === null);

function toOpen({ models }) {
  if (models.length && models.length <= MOST_BUTTONS) return models.map(m => button("openModel", T.openIt(m), { "data-model": m }, models.length === 1));
  return models.length ? goTo("model-file", T.chooseModel, true) : null;
}

function toCompare({ measurements }) {
  const fit = fitting();
  if (fit.length && fit.length <= MOST_BUTTONS) return fit.map(f => button("compareWith", T.compareWith(f), { "data-file": f }, fit.length === 1));
  return goTo(measurements.length ? "file-0" : "pick", T.chooseData, true);
}

function toExplain({ diagnosis }) {
  const all = causesToAdd(), sure = certain();
  if (!all.length) return [
    runButton("diagnose", T.diagnose, false, true, "step-"),
    diagnosis && diagnosis.is_current && diagnosis.next ? goTo("next", T.next) : null,
  ];
  const first = sure[0] || all[0];
  return [
    sure.length > 1 ? button("addAll", T.addAll(sure.length), {}, true) : null,
    button("add", T.addOf(first.label), { "data-effect": first.effect }, sure.length < 2),
    goTo("causes-title", T.seeCauses),
  ];
}

function toCorrect({ correction }) {
  if (!correction || !correction.is_current) return runButton("correct", T.correct, false, true, "step-");
  return goTo("write-name", T.writeFiles, true);
}

function what(state) {
  const { session, model, data, comparison, job } = state;
  if (session) return [button("resume", T.resume(session.steps), {}, true), button("forget", T.forget, {})];
  if (job) return progress();
  if (!model) return toOpen(state);
  if (app.reading.refused) return goTo("columns", T.sayColumns, true);
  if (!data) return toCompare(state);
  if (lacksValues(state)) return runButton("fit", T.fit, false, true, "step-");
  if (!comparison || comparison.problem) return null;
  return comparison.is_adequate ? toCorrect(state) : toExplain(state);
}

export function nextStep() {
  const parts = [what(app.state)].flat(Infinity).filter(Boolean);
  return parts.length ? h("div", { class: "step-next", role: "group", "aria-label": T.nextStep, "data-key": "next-step" }, parts) : null;
}

export const clicks = {
  openModel: e => change("open", { model: e.dataset.model }, T.didOpen(e.dataset.model)),
  compareWith: e => openFiles([e.dataset.file], { columns: [], decimal: null }, T.didCompare(e.dataset.file)),
  goTo: e => {
    const to = document.getElementById(e.dataset.to);
    if (!to) return;
    const details = to.closest("details");
    if (details) details.open = true;
    to.scrollIntoView({ block: "center" });
    if (to.tagName === "DETAILS") to.querySelector("summary").focus({ preventScroll: true });
    else {
      if (!to.matches("input,select,button")) to.setAttribute("tabindex", "-1");
      to.focus({ preventScroll: true });
    }
  },
  addAll: async () => {
    const names = certain().map(c => c.effect);
    // Each is a step of its own, so that each can be undone and shows what it gains.
    for (const effect of names) if (!await change("add", { effect }, T.didAdd(effect))) break;
    redraw();
  },
  resume: () => change("resume", {}, T.didResume),
  forget: () => change("forget", {}, T.didForget),
};
