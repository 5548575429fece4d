// Values that are tried by the sliders. They are no estimates, are never stored, and are drawn otherwise.
import { app, drawTrial, redraw } from "./app.js";
import { post, refusalText } from "./server.js";

let isUnderWay = false, isWanted = false;

export function tryValue(path, value) {
  app.trial.values.set(path, value);
  app.trial.path = path;
  ask();
  redraw("trial");
}

export function reset(path) {
  if (path) app.trial.values.delete(path);
  else app.trial.values.clear();
  app.trial.problem = null;
  if (app.trial.values.size) ask();
  else Object.assign(app.trial, { predicted: null, rms: null, moves: true, path: null });
  redraw("trial");
}

/** The model has changed: what was tried for values that are gone or that stand there now is no trial any more. */
export function renew() {
  const values = app.state.model ? app.state.model.values : [];
  for (const [path, value] of app.trial.values) {
    const now = values.find(v => v.path === path);
    if (!now || now.value === value) app.trial.values.delete(path);
  }
  if (app.trial.values.size) ask();
  else reset();
}

// One question under way: the last value wins.
function ask() {
  isWanted = true;
  if (!isUnderWay) next();
}

async function next() {
  isUnderWay = true;
  while (isWanted && app.trial.values.size) {
    isWanted = false;
    try {
      const { predicted, rms, moves } = await post("try", { values: Object.fromEntries(app.trial.values) });
      if (app.trial.values.size) Object.assign(app.trial, { predicted, rms, moves: moves !== false, problem: null });
    } catch (e) {
      Object.assign(app.trial, { predicted: null, rms: null, moves: true, problem: refusalText(e) });
      if (e.path) app.trial.path = e.path;
    }
    drawTrial();
  }
  isUnderWay = false;
}
