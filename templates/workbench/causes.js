// What is missing: every suspect with its probability and what it would gain, and what to measure next.
import { app, change } from "./app.js";
import { bars } from "./bars.js";
import { blob, h } from "./dom.js";
import { progress, runButton } from "./job.js";
import { nameText, proseText, quantityText } from "./numbers.js";
import { next } from "./readings.js";
import { T } from "./texts.js";

const LEAST_TOLD = 0.01;   // sets of less probability are not told
const percent = p => p > 0.995 ? "> 99 %" : p < 0.005 ? "< 1 %" : Math.round(p * 100) + " %";
export const isIn = name => Boolean(app.state.model) && app.state.model.effects.some(e => e.name === name);
export const canAdd = name => Boolean(app.state.model) && app.state.model.catalogue.some(e => e.name === name);

function alike(c) {
  if (!c.alike.length) return null;
  return h("div", { class: "note", "data-key": "alike" }, T.alike, h("ul", {}, c.alike.map(a => h("li", { "data-key": a },
    isIn(a) ? [proseText(a), ` (${T.inModel})`] : proseText(a), " ",
    canAdd(a) && (c.can_add || isIn(c.effect)) ? h("button", { type: "button", class: "plain", "data-click": "instead", "data-effect": c.effect, "data-other": a, "aria-label": T.insteadOf(a, c.label) }, T.instead) : null))));
}

/** A cause with what it gains beyond those before it. */
function cause(c, i, before) {
  const gain = before !== null && before > c.rms_after ? before - c.rms_after : null;
  return h("article", { class: `cause ${c.class}`, "data-key": "cause:" + c.effect, "aria-labelledby": "cause-" + i },
    h("h3", { id: "cause-" + i }, c.label),
    h("p", { class: "class" }, h("span", { class: "badge" }, h("span", { "aria-hidden": "true" }, T.classSigns[c.class] + " "), T.classes[c.class]), ` ${T.probability} ${percent(c.probability)}`),
    h("div", { class: "meter", "aria-hidden": "true" }, h("span", { class: "fill", style: `width:${(c.probability * 100).toFixed(1)}%` })),
    h("p", { class: "gain" }, gain !== null ? [h("strong", {}, T.gains(quantityText(gain, c.unit))), " · ", T.errorWith(quantityText(before, c.unit), quantityText(c.rms_after, c.unit))] : T.errorWithIt(quantityText(c.rms_after, c.unit))),
    h("p", {}, c.about),
    c.doubt ? h("p", { class: "doubt", "data-key": "doubt" }, h("span", { "aria-hidden": "true" }, "⚠ "), proseText(c.doubt)) : null,
    c.values.length ? h("p", { class: "note" }, T.estimates, " ", c.values.map(proseText).join(", ")) : null,
    alike(c),
    c.separated_by ? h("p", { class: "note", "data-key": "separated" }, T.separated, " ", proseText(c.separated_by)) : null,
    isIn(c.effect)
      ? h("p", { class: "acts", "data-key": "acts" }, h("span", { class: "badge" }, "✓ " + T.inModel), " ", h("button", { type: "button", "data-click": "remove", "data-effect": c.effect, "aria-label": T.removeOf(c.label) }, T.remove))
      : c.can_add ? h("p", { class: "acts", "data-key": "acts" }, h("button", { type: "button", class: "main", "data-click": "add", "data-effect": c.effect, "aria-label": T.addOf(c.label) }, T.add)) : null);
}

function gains({ causes }, before) {
  if (before === null || !causes.length) return null;
  const { noise } = app.state;
  return bars([{ label: T.before, rms: before }, ...causes.map(c => ({ label: "+ " + c.label, rms: c.rms_after }))], { unit: causes[0].unit, noise, title: T.gainBars, key: "gains" });
}

/** A set as what it has beyond the chosen one, and what it lacks of it. */
function setText(effects, chosen) {
  const more = effects.filter(e => !chosen.includes(e)).map(nameText), less = chosen.filter(e => !effects.includes(e)).map(nameText);
  return more.length || less.length ? T.setBeside(more.join(" and "), less.join(" and ")) : chosen.map(nameText).join(", ") || T.nothing;
}

function sets({ sets, groups }) {
  const told = (sets || []).filter(s => s.probability > LEAST_TOLD);
  const { effects: chosen } = (sets || []).find(s => s.is_chosen) || { effects: [] };
  const isChoice = told.some(s => !s.is_chosen);
  if (!isChoice && !(groups || []).length) return null;
  return h("div", { class: "sets", "data-key": "sets" },
    isChoice ? [h("h3", {}, T.sets), h("ol", {}, told.map(s => h("li", {}, setText(s.effects, chosen), ` · ${percent(s.probability)}`, s.is_chosen ? [" ", h("span", { class: "badge" }, "✓ " + T.chosen)] : null)))] : null,
    (groups || []).length ? h("ul", { "data-key": "groups" }, groups.map(g => h("li", {}, proseText(g.text)))) : null);
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

export function causes() {
  const { diagnosis, data } = app.state;
  const before = diagnosis ? diagnosis.rms_before ?? null : null;
  return [
    h("h2", { id: "causes-title" }, T.panes.causes),
    h("div", { class: "run", "data-key": "run" }, runButton("diagnose", T.diagnose, !data, true), h("span", { class: "note" }, T.diagnoseNote)),
    progress(["diagnose"]),
    diagnosis ? [
      diagnosis.is_current ? null
        : diagnosis.causes.length && diagnosis.causes.every(c => isIn(c.effect)) ? h("p", { class: "note", "data-key": "old" }, T.allIn)
          : h("p", { class: "caution", "data-key": "old" }, h("span", { "aria-hidden": "true" }, "⚠ "), T.old),
      h("p", { class: "sentence", "data-key": "verdict" }, proseText(diagnosis.verdict)),
      gains(diagnosis, before),
      diagnosis.causes.map((c, i) => cause(c, i, i ? diagnosis.causes[i - 1].rms_after : before)),
      sets(diagnosis),
      others(diagnosis),
      next(diagnosis),
      h("details", { id: "answer" }, h("summary", {}, T.wholeAnswer), blob(diagnosis.html, { class: "served" })),
    ] : h("p", { class: "note", "data-key": "none" }, T.noDiagnosis),
  ];
}

export const clicks = {
  // The other is added once the one is out; if it cannot be, the one is in again.
  instead: async e => {
    const { effect, other } = e.dataset, was = isIn(effect);
    if (was && !await change("remove", { effect })) return;
    if (!await change("add", { effect: other }, T.didInstead(other, effect)) && was) await change("undo", {});
  },
};
