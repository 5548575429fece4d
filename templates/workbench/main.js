// The page of the workbench: it draws what the server says and hands on what the user does. Nothing is computed here
// but residuals as differences and means along a coordinate.
import * as absent from "./absent.js";
import { app, alarm, fieldOf, follow, load, onChanged, onDraw, redraw, refuse, say } from "./app.js";
import * as causes from "./causes.js";
import * as columns from "./columns.js";
import * as correct from "./correct.js";
import * as data from "./data.js";
import { onFilled, put } from "./dom.js";
import { livenAll } from "./figures.js";
import * as field from "./field.js";
import * as header from "./header.js";
import * as job from "./job.js";
import * as lists from "./lists.js";
import * as model from "./model.js";
import * as readings from "./readings.js";
import * as residuals from "./residuals.js";
import { listen } from "./server.js";
import * as steps from "./steps.js";
import { T } from "./texts.js";
import { renew } from "./trial.js";

const at = id => document.getElementById(id);
const all = [absent, causes, columns, correct, data, field, header, job, lists, model, readings, residuals, steps];
const of = kind => Object.assign({}, ...all.map(own => own[kind]));
const clicks = of("clicks"), changes = of("changes"), inputs = of("inputs"), submits = of("submits");

// A downloaded figure carries the style of all figures with it.
const sheet = () => {
  const link = document.getElementById("figure-style");
  return link && link.sheet ? [...link.sheet.cssRules].map(r => r.cssText).join("\n") : "";
};
onFilled(place => livenAll(place, T, sheet));
let trialBefore = "", drawn = null;
onDraw(all => {
  if (!app.state) return;
  // While a slider moves only what says its value changes: the panes are long.
  const { values, problem, predicted } = app.trial;
  const trialNow = [...values.keys(), problem, predicted === null, app.trial.moves].join("\n");
  const isSame = !all && trialNow === trialBefore;
  trialBefore = trialNow;
  put(at("head"), header.header());
  if (isSame) field.tellTrials();
  else {
    put(at("model"), model.model());
    put(at("residuals"), residuals.residuals());
  }
  if (!isSame || predicted !== drawn) residuals.drawPlot();
  drawn = predicted;
  const isTrial = app.trial.values.size > 0;
  at("trial").hidden = !isTrial;
  put(at("trial"), isTrial ? header.trialBar() : []);
  if (!all) return;
  put(at("bar"), header.bar());
  put(at("trouble"), header.trouble());
  put(at("data"), data.data());
  put(at("causes"), causes.causes());
  put(at("correct"), correct.correct());
  const { model: open } = app.state;
  document.title = (open ? (open.is_saved ? "" : "• ") + open.file + " · " : "") + "fem";
});

let readingOf = "", openFile = null;
onChanged(() => {
  renew();
  // Problems of values that are gone have no field to stand at.
  const paths = new Set(app.state.model ? app.state.model.values.map(v => v.path) : []);
  for (const kept of [app.drafts, app.problems]) for (const path of kept.keys()) if (!paths.has(path) && !fieldOf(path)) kept.delete(path);
  for (const path of app.seen.more) if (!paths.has(path)) app.seen.more.delete(path);
  // What was about to be added was for the model that was open.
  const file = app.state.model && app.state.model.file;
  if (file !== openFile) {
    Object.assign(app.seen, { toAdd: "", addProblem: null, copied: null });
    const place = at("to-add");
    if (place) place.value = "";
  }
  openFile = file;
  // What was said of columns is of the files and the process to which it was said.
  const about = app.state.model ? [app.state.model.process, ...app.state.data ? app.state.data.files : []].join("\n") : "";
  if (about !== readingOf && !(app.reading.refused && about.split("\n")[0] === readingOf.split("\n")[0])) columns.forgetSaid();
  readingOf = about;
  if (app.rows && app.seen.picked !== null && app.seen.picked >= app.rows.lines.length) app.seen.picked = null;
});

// One listener for each kind of event: elements say what they do by data-click, data-change, data-input, data-submit.
function hand(kind, table) {
  document.addEventListener(kind, e => {
    const target = e.target.closest && e.target.closest(`[data-${kind}]`);
    const act = target && table[target.dataset[kind]];
    if (!act) return;
    if (kind === "submit") e.preventDefault();
    Promise.resolve().then(() => act(target)).catch(refuse);
  });
}
hand("click", clicks);
hand("change", changes);
hand("input", inputs);
hand("submit", submits);
document.addEventListener("input", e => { if (e.target.dataset && e.target.dataset.draft) field.noteDraft(e.target); });
// What opens is drawn only then; the event does not bubble.
document.addEventListener("toggle", e => { if (e.target.id === "columns") redraw(); }, true);

const isText = e => e.isContentEditable || e.tagName === "TEXTAREA" || e.tagName === "INPUT" && !["range", "checkbox", "radio", "file"].includes(e.type);
document.addEventListener("keydown", e => {
  if ((e.ctrlKey || e.metaKey) && !e.altKey && !isText(e.target)) {
    const key = e.key.toLowerCase();
    if (key === "z" || key === "y") {
      e.preventDefault();
      if (key === "y" || e.shiftKey) header.redo(); else header.undo();
    }
    return;
  }
  if (e.key === "Escape") {
    alarm("");
    const menu = e.target.closest && e.target.closest("details.menu[open]");
    if (menu) { menu.open = false; menu.querySelector("summary").focus(); }
  }
  field.keyInField(e);
  if (!e.ctrlKey && !e.metaKey) residuals.keyInPlot(e);
});
// A menu closes when something else is done.
document.addEventListener("pointerdown", e => {
  for (const menu of document.querySelectorAll("details.menu[open]")) if (!menu.contains(e.target)) menu.open = false;
});

data.listenForDrops();
at("skip").textContent = T.skip;
at("bar").setAttribute("aria-label", T.panesLabel);
at("trial").setAttribute("aria-label", T.trial);

let lastJob = null;
load();
listen({
  state: follow,
  job: now => {
    if (!app.state) return;
    if (lastJob && !now) { say(T.ended(T.working[lastJob.what] || lastJob.what)); load(); }
    lastJob = now;
    app.state.job = now;
    redraw();
  },
  lost: isOver => { app.isLost = isOver ? "over" : true; redraw(); },
  back: () => { app.isLost = false; say(T.back); load(); },
});
