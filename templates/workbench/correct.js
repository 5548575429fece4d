// What to do about it: offsets, contours, remedies; all as the server writes them.
import { app } from "./app.js";
import { blob, h } from "./dom.js";
import { progress, runButton } from "./job.js";
import { T } from "./texts.js";

export function correct() {
  const { correction } = app.state;
  return [
    h("h2", { id: "correct-title" }, T.panes.correct),
    h("div", { class: "run", "data-key": "run" }, runButton("correct", T.correct, false), h("span", { class: "note" }, T.correctNote)),
    progress(["correct"]),
    correction ? [
      correction.is_current ? null : h("p", { class: "caution", "data-key": "old" }, h("span", { "aria-hidden": "true" }, "⚠ "), T.old),
      blob(correction.html, { class: "served", "data-key": "html" }),
    ] : h("p", { class: "note", "data-key": "none" }, T.noCorrection),
  ];
}
