// How an error falls from one model to the next.
import { h } from "./dom.js";
import { quantityText } from "./numbers.js";
import { T } from "./texts.js";

const MOST_LINEAR = 100;   // beyond this ratio the shortest bar could not be seen

/** items: [{ label, rms }]; bars begin at zero, unless that would hide the shortest of them. */
export function bars(items, { unit, noise, title, key }) {
  const all = items.map(i => i.rms).filter(v => v > 0);
  if (!all.length) return null;
  const most = Math.max(...all, noise || 0), least = Math.min(...all);
  const isLog = least < most / MOST_LINEAR;
  const low = Math.log(Math.min(least, noise > 0 ? noise : least) / 2), high = Math.log(most);
  const part = v => !(v > 0) ? 0 : isLog ? Math.max(1, Math.min(100, (Math.log(v) - low) / (high - low) * 100)) : Math.min(100, v / most * 100);
  const axis = (isLog ? T.barsLog : T.barsLinear)(noise > 0 ? quantityText(noise, unit) : null);
  return h("div", { class: "falling", "data-key": key },
    h("h2", { class: "small", id: key + "-title" }, title),
    h("ol", { class: "bars", "aria-labelledby": key + "-title", style: noise > 0 ? `--noise:${part(noise).toFixed(1)}%` : null },
      items.map((s, i) => h("li", { class: i === items.length - 1 ? "now" : null },
        h("span", { class: "step", title: s.label }, s.label),
        h("span", { class: "track", "aria-hidden": "true" }, h("span", { class: "fill", style: `width:${part(s.rms).toFixed(1)}%` })),
        h("span", { class: "num" }, quantityText(s.rms, unit))))),
    h("p", { class: "note" }, axis));
}
