// Where the model fails: residuals over any coordinate, with what a trial would make of them.
import { app, redraw, say, withoutFolder } from "./app.js";
import { strike, strikeButton } from "./data.js";
import { blob, h } from "./dom.js";
import { numberText, proseText, quantityText, unitText } from "./numbers.js";
import { Plot, isOutside } from "./plot.js";
import { T } from "./texts.js";

const nameOf = (name, unit) => unit ? `${name.replace(/_/g, " ")} [${unitText(unit)}]` : name.replace(/_/g, " ");
const MOST_WORST = 8;

/** What is looked at now, over the rows of one observable. */
function looked() {
  const { columns, observables, observable, observed, predicted, sigma, lines, limits } = app.rows;
  const column = columns.find(c => c.name === app.seen.column) || columns.find(c => !c.words) || columns[0];
  const kind = Math.min(app.seen.observable, observables.length - 1);
  const rows = lines.map((_, i) => i).filter(i => observables.length < 2 || observable[i] === kind);
  const struck = new Set(app.state.data ? app.state.data.struck : []);
  const trial = app.trial.predicted && app.trial.predicted.length === observed.length ? app.trial.predicted : null;
  const words = column && column.words ? [...new Set(column.words)] : null;
  const by = list => list ? rows.map(i => list[i]) : null;
  const view = predicted ? app.seen.view : "both";
  const about = observables[kind] || { name: T.observed, unit: "" };
  return {
    column, about, kind, view, rows, words,
    x: rows.map(i => !column ? i : words ? words.indexOf(column.words[i]) : column.values[i]),
    xName: column ? nameOf(column.name, column.unit) : T.line,
    yName: view === "residual" ? `${T.residual} [${unitText(about.unit)}]` : nameOf(about.name, about.unit),
    observed: by(observed), predicted: by(predicted), trial: by(trial), sigma: by(sigma), limits: by(limits || null),
    struck: rows.map(i => struck.has(i)), picked: app.seen.picked, isStruck: struck,
  };
}

const choice = (id, label, options, value) => h("div", { class: "choice", "data-key": id + "-box" }, h("label", { for: id }, label),
  h("select", { id, "data-change": id }, options.map(([v, name]) => h("option", { value: v, selected: String(v) === String(value) }, name))));

function controls(seen) {
  const { columns, observables, predicted } = app.rows;
  return h("div", { class: "row controls", "data-key": "controls" },
    columns.length ? choice("over", T.over, columns.map(c => [c.name, nameOf(c.name, c.unit)]), seen.column.name) : null,
    observables.length > 1 ? choice("observable", T.observable, observables.map((o, i) => [i, nameOf(o.name, o.unit)]), seen.kind) : null,
    predicted ? h("div", { class: "switch", role: "group", "aria-label": T.show, "data-key": "view" }, [["residual", T.showResidual], ["both", T.showBoth]].map(([v, name]) =>
      h("button", { type: "button", "data-click": "view", "data-view": v, "aria-pressed": String(seen.view === v), "data-key": v }, name))) : null,
    h("span", { class: "zooms", "data-key": "zooms" },
      h("button", { type: "button", "data-click": "zoomIn", "aria-label": T.zoomIn, title: T.zoomIn }, "+"),
      h("button", { type: "button", "data-click": "zoomOut", "aria-label": T.zoomOut, title: T.zoomOut }, "\u2212")),
    h("button", { type: "button", class: "plain", id: "show-all", "data-click": "showAll" }, T.resetZoom));
}

function legend(seen) {
  const entry = (mark, text) => h("li", {}, h("span", { class: "mark " + mark, "aria-hidden": "true" }, { dot: "●", cross: "×", dash: "━", triangle: "△", ring: "◇" }[mark] || ""), text);
  const isResidual = seen.view === "residual";
  return h("ul", { class: "legend", "data-key": "legend" },
    entry("dot", isResidual ? T.legendResidual : T.legendMeasured),
    isResidual ? null : seen.predicted ? entry("dash", T.legendPredicted) : null,
    seen.predicted ? entry("line", T.legendMean) : null,
    seen.sigma ? entry("band", T.legendBand) : null,
    !isResidual && seen.limits && seen.limits.some(Boolean) ? [entry("limits", T.legendLimits), seen.struck.some((s, i) => !s && isOutside(seen.observed[i], seen.limits[i])) ? entry("ring", T.legendOutside) : null] : null,
    seen.trial ? [entry("triangle", ""), entry("dashes", T.legendTrial)] : null,
    seen.struck.some(Boolean) ? entry("cross", T.legendStruck) : null);
}

const residualOf = i => app.rows.predicted && app.rows.predicted[i] !== null ? app.rows.observed[i] - app.rows.predicted[i] : null;
const unitOf = i => (app.rows.observables[app.rows.observable[i] ?? 0] || app.rows.observables[0] || { unit: "" }).unit;

/** Measured rows that the tolerance does not allow, of those that it speaks of. */
function outside(seen) {
  if (!seen.limits) return null;
  const own = seen.limits.map((l, i) => i).filter(i => seen.limits[i] && !seen.struck[i] && seen.observed[i] !== null);
  if (!own.length) return null;
  const out = own.filter(i => isOutside(seen.observed[i], seen.limits[i])).length;
  return h("p", { class: out ? "outside warn" : "outside", "data-key": "outside" }, h("span", { "aria-hidden": "true" }, out ? "⚠ " : "✓ "), T.outOfTolerance(out, own.length));
}

/** One row as a sentence: where, measured, predicted, residual. */
function told(i) {
  const { columns, observed, predicted, sigma, lines } = app.rows;
  const unit = unitOf(i);
  const where = columns.map(c => c.words ? `${c.name} ${c.words[i]}` : `${c.name} ${quantityText(c.values[i], c.unit, 4)}`).join(", ");
  const res = residualOf(i);
  return T.pointAt(lines[i], where, `${T.observed} ${quantityText(observed[i], unit, 4)}` + (res === null ? "" : `, ${T.predicted} ${quantityText(predicted[i], unit, 4)}, ${T.residual} ${quantityText(res, unit)}`) + (sigma && sigma[i] !== null ? ` (σ ${quantityText(sigma[i], unit)})` : ""));
}

function picked(seen) {
  const i = app.seen.picked;
  return h("div", { class: "picked", "data-key": "picked" },
    i !== null && i < app.rows.lines.length
      ? [h("p", {}, told(i), seen.isStruck.has(i) ? h("span", { class: "warn" }, ` · ${T.rowStruck}`) : null), strikeButton(i, app.rows.lines[i], seen.isStruck.has(i))]
      : h("p", { class: "note", id: "plot-hint" }, T.zoomHint));
}

function worst(seen) {
  if (!app.rows.predicted) return null;
  const of = i => Math.abs(residualOf(i)) / (app.rows.sigma[i] || 1);
  const rows = seen.rows.filter(i => residualOf(i) !== null && !seen.isStruck.has(i)).sort((a, b) => of(b) - of(a)).slice(0, MOST_WORST);
  return h("details", { id: "worst" }, h("summary", {}, T.worst),
    h("div", { class: "tablebox", tabindex: "0", role: "group", "aria-label": T.worst }, h("table", {},
      h("thead", {}, h("tr", {}, h("th", { scope: "col", class: "num" }, T.line), h("th", { scope: "col", class: "num" }, seen.xName), h("th", { scope: "col", class: "num" }, T.residual), h("th", { scope: "col", class: "num" }, T.inSigmas), h("th", { scope: "col" }, T.rowUse))),
      h("tbody", {}, rows.map(i => h("tr", { "data-key": "worst:" + i },
        h("th", { scope: "row", class: "num" }, String(app.rows.lines[i])),
        h("td", { class: "num" }, seen.column ? seen.column.words ? seen.column.words[i] : numberText(seen.column.values[i], 4) : ""),
        h("td", { class: "num" }, quantityText(residualOf(i), unitOf(i))),
        h("td", { class: "num" }, numberText(of(i), 2)),
        h("td", {}, strikeButton(i, app.rows.lines[i], false))))))));
}

export function residuals() {
  const { comparison } = app.state;
  const title = h("h2", { id: "residuals-title" }, T.panes.residuals);
  if (!app.rows || !app.rows.lines.length) return [title, h("p", { class: "note", "data-key": "none" }, T.noRows)];
  const seen = looked();
  return [
    title,
    comparison && comparison.problem ? h("p", { class: "caution", "data-key": "problem" }, h("span", { "aria-hidden": "true" }, "⚠ "), proseText(withoutFolder(comparison.problem))) : null,
    seen.predicted ? null : h("p", { class: "note", "data-key": "alone" }, T.noPrediction),
    controls(seen),
    h("div", { id: "plot", "data-live": "", tabindex: "0", role: "group", "aria-label": T.plotLabel(seen.yName, seen.xName, seen.rows.length), "aria-describedby": app.seen.picked === null ? "plot-hint" : null }),
    legend(seen),
    outside(seen),
    picked(seen),
    worst(seen),
    comparison && comparison.html ? h("details", { id: "comparison" }, h("summary", {}, T.comparisonAll), blob(comparison.html, { class: "served" })) : null,
  ];
}

let plot = null;
/** Draws into the place that `residuals` left; the place is a new one after there were no rows for a while. */
export function drawPlot() {
  const place = document.getElementById("plot");
  if (!place || !app.rows) { plot = null; return; }
  if (!plot || plot.place !== place) plot = new Plot(place, { pick });
  plot.show(looked());
}

function pick(row) {
  app.seen.picked = row;
  say(told(row));
  redraw();
}

export function keyInPlot(e) {
  if (!plot || e.target !== plot.place) return;
  if (e.key === "ArrowRight") plot.walk(1);
  else if (e.key === "ArrowLeft") plot.walk(-1);
  else if (e.key === "Enter" && app.seen.picked !== null) strike(app.seen.picked);
  else if (e.key === "Escape") { app.seen.picked = null; redraw(); }
  else if (e.key === "+") plot.zoom(0.7);
  else if (e.key === "-") plot.zoom(1 / 0.7);
  else if (e.key === "0") plot.showAll();
  else return;
  e.preventDefault();
}

export const clicks = {
  view: e => { app.seen.view = e.dataset.view; redraw(); },
  zoomIn: () => { if (plot) plot.zoom(0.6); },
  zoomOut: () => { if (plot) plot.zoom(1 / 0.6); },
  showAll: () => { if (plot) plot.showAll(); },
};

export const changes = {
  over: e => { app.seen.column = e.value; redraw(); },
  observable: e => { app.seen.observable = Number(e.value); app.seen.picked = null; redraw(); },
};
