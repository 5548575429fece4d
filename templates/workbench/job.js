// What runs beside the page: its progress, and the button that stops it.
import { app, change, refuse, say } from "./app.js";
import { h } from "./dom.js";
import { post } from "./server.js";
import { T } from "./texts.js";

/** What work is to know beside its name, asked for when it begins; null if it cannot begin so. */
const asked = {};
export const onAsked = (what, call) => { asked[what] = call; };

/** The header has buttons of its own for the same work. */
export const runButton = (what, name, isOff, isMain, place = "run-") => h("button", {
  type: "button", id: place + what, class: isMain ? "main" : null, "data-click": "run", "data-what": what,
  disabled: isOff || !app.state.model || app.state.job !== null,
}, name);

const working = what => T.working[what] || what;

/** The progress of such work, of any without names. */
export function progress(whats) {
  const job = app.state.job;
  if (!job || whats && !whats.includes(job.what)) return null;
  const percent = job.done === null ? null : Math.round(job.done * 100);
  return h("div", { class: "job", "data-key": "job" },
    h("progress", { max: 1, value: job.done, "aria-label": T.progressOf(working(job.what)) }),
    h("span", {}, T.runs(working(job.what), Math.round(job.seconds), percent)),
    h("button", { type: "button", "data-click": "stop" }, T.stop));
}

export const clicks = {
  run: async e => {
    const what = e.dataset.what;
    const more = asked[what] ? asked[what]() : {};
    if (more && await change("run", { what, ...more })) say(T.began(working(what)));
  },
  stop: async () => {
    try { await post("stop", {}); say(T.stopped); } catch (e) { refuse(e); }
  },
};
