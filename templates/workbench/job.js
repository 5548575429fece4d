// What runs beside the page: its progress, and the button that stops it.
import { app, change, refuse, say } from "./app.js";
import { h } from "./dom.js";
import { post } from "./server.js";
import { T } from "./texts.js";

export const runButton = (what, name, isOff, isMain) => h("button", {
  type: "button", id: "run-" + what, class: isMain ? "main" : null, "data-click": "run", "data-what": what,
  disabled: isOff || !app.state.model || app.state.job !== null,
}, name);

export function progress(whats) {
  const job = app.state.job;
  if (!job || !whats.includes(job.what)) return null;
  const percent = job.done === null ? null : Math.round(job.done * 100);
  return h("div", { class: "job", "data-key": "job" },
    h("progress", { max: 1, value: job.done, "aria-label": T.progressOf(T.working[job.what]) }),
    h("span", {}, T.runs(T.working[job.what], Math.round(job.seconds), percent)),
    h("button", { type: "button", "data-click": "stop" }, T.stop));
}

export const clicks = {
  run: async e => {
    const what = e.dataset.what;
    if (await change("run", { what })) say(T.began(T.working[what]));
  },
  stop: async () => {
    try { await post("stop", {}); say(T.stopped); } catch (e) { refuse(e); }
  },
};
