"use strict";
// Figures answer to pointer and keys, steps slide and tables sort; without this script the page says the same.
const tip = document.getElementById("tip");
const svgns = "http://www.w3.org/2000/svg";
const valueText = (axis, v) => v === null ? "" : axis.words.length ? axis.words[v] : (v + " " + axis.unit).trim();

function sentence(data, mark) {
  const [, , series, ...values] = mark;
  const label = data.series[series];
  const parts = values.map((v, i) => v === null ? "" : data.axes[i].name === "\u00b1" ? "\u00b1 " + valueText(data.axes[i], v) : data.axes[i].name + " = " + valueText(data.axes[i], v));
  return (label ? label + ": " : "") + parts.filter(Boolean).join(", ");
}

function save(name, type, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function button(text, label, act) {
  const b = document.createElement("button");
  b.type = "button";
  b.textContent = text;
  b.setAttribute("aria-label", label);
  b.addEventListener("click", act);
  return b;
}

/** Makes all figures, steps and tables within `place` live, with these words on them; a downloaded figure carries the style of
 * `sheet` with it. May be called again after HTML was replaced. */
function livenAll(place, words, sheet) {
  for (const figure of place.querySelectorAll("figure")) liven(figure, words, sheet);
  for (const steps of place.querySelectorAll(".steps")) slideThrough(steps);
  for (const table of place.querySelectorAll("table.sortable:not([data-is-live])")) sortable(table, words);
}

function liven(figure, words, sheet) {
  const view = figure.querySelector(".view"), svg = view && view.querySelector("svg");
  const told = figure.querySelector("script"), caption = figure.querySelector("figcaption");
  if (!svg || !told || !caption || view.dataset.isLive) return;
  view.dataset.isLive = "";
  const data = JSON.parse(told.textContent);
  const whole = svg.getAttribute("viewBox").split(" ").map(Number);
  let box = whole.slice(), at = -1, drag = null;

  const hit = document.createElementNS(svgns, "circle");
  hit.setAttribute("class", "hit");
  hit.setAttribute("r", 6);
  hit.setAttribute("visibility", "hidden");
  svg.append(hit);

  const show = i => {
    at = i;
    if (i < 0) { tip.hidden = true; hit.setAttribute("visibility", "hidden"); return; }
    const [x, y] = data.marks[i];
    hit.setAttribute("cx", x);
    hit.setAttribute("cy", y);
    hit.setAttribute("visibility", "visible");
    tip.textContent = sentence(data, data.marks[i]);
    tip.hidden = false;
    const p = new DOMPoint(x, y).matrixTransform(svg.getScreenCTM());
    const left = Math.min(p.x + 14, innerWidth - tip.offsetWidth - 8);
    tip.style.left = Math.max(8, left) + "px";
    tip.style.top = (p.y > tip.offsetHeight + 24 ? p.y - tip.offsetHeight - 14 : p.y + 18) + "px";
  };
  const place = e => new DOMPoint(e.clientX, e.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const nearest = p => {
    let best = -1, least = 40 * 40;
    data.marks.forEach(([x, y], i) => {
      const d = (x - p.x) ** 2 + (y - p.y) ** 2;
      if (d < least) { least = d; best = i; }
    });
    return best;
  };
  const look = next => {
    const size = Math.min(whole[2], Math.max(whole[2] / 40, next[2]));
    box = [next[0], next[1], size, size * whole[3] / whole[2]];
    for (const i of [0, 1]) box[i] = Math.min(whole[i] + whole[i + 2] - box[i + 2], Math.max(whole[i], box[i]));
    svg.setAttribute("viewBox", box.join(" "));
    view.classList.toggle("zoomed", box[2] < whole[2]);
  };
  const zoom = (factor, p = { x: box[0] + box[2] / 2, y: box[1] + box[3] / 2 }) =>
    look([p.x - (p.x - box[0]) * factor, p.y - (p.y - box[1]) * factor, box[2] * factor]);

  svg.addEventListener("pointermove", e => {
    if (drag) {
      const p = place(e);
      look([box[0] + drag.x - p.x, box[1] + drag.y - p.y, box[2]]);
    } else show(nearest(place(e)));
  });
  svg.addEventListener("pointerleave", () => { if (!drag) show(-1); });
  svg.addEventListener("pointerdown", e => { if (box[2] < whole[2]) { drag = place(e); svg.setPointerCapture(e.pointerId); } });
  svg.addEventListener("pointerup", () => { drag = null; });
  svg.addEventListener("dblclick", e => box[2] < whole[2] ? look(whole) : zoom(0.4, place(e)));
  view.addEventListener("wheel", e => {
    if (!e.ctrlKey && !e.metaKey) return;
    e.preventDefault();
    zoom(e.deltaY > 0 ? 1.25 : 0.8, place(e));
  }, { passive: false });
  view.addEventListener("keydown", e => {
    const n = data.marks.length, step = { ArrowRight: 1, ArrowLeft: -1 }[e.key];
    if (step && n) show((at + step + n) % n);
    else if (e.key === "+") zoom(0.7);
    else if (e.key === "-") zoom(1 / 0.7);
    else if (e.key === "0") look(whole);
    else if (e.key === "Escape") show(-1);
    else return;
    e.preventDefault();
  });
  view.addEventListener("blur", () => show(-1));

  const what = data.name;
  caption.append(
    button("+", words.figureIn(what), () => zoom(0.7)),
    button("\u2212", words.figureOut(what), () => zoom(1 / 0.7)),
    button("SVG", words.figureSvg(what), () => {
      const copy = svg.cloneNode(true);
      copy.querySelector(".hit").remove();
      copy.setAttribute("xmlns", svgns);
      copy.setAttribute("viewBox", whole.join(" "));
      copy.setAttribute("width", whole[2]);
      copy.setAttribute("height", whole[3]);
      const style = document.createElementNS(svgns, "style");
      style.textContent = sheet();
      copy.prepend(style);
      save(what + ".svg", "image/svg+xml", new XMLSerializer().serializeToString(copy));
    }),
    button("CSV", words.figureCsv(what), () => {
      const quote = t => /[",\n]/.test(t) ? '"' + t.replace(/"/g, '""') + '"' : t;
      const head = [words.series, ...data.axes.map(a => a.unit ? a.name + " [" + a.unit + "]" : a.name)];
      const rows = data.marks.map(m => [data.series[m[2]], ...m.slice(3).map((v, i) => v === null ? "" : data.axes[i].words.length ? data.axes[i].words[v] : String(v))]);
      save(what + ".csv", "text/csv", [head, ...rows].map(r => r.map(quote).join(",")).join("\n") + "\n");
    }));
}

function slideThrough(steps) {
  const all = [...steps.querySelectorAll(".step")], slide = steps.querySelector(".slide");
  if (!slide || !slide.hidden) return;
  const input = slide.querySelector("input"), output = slide.querySelector("output");
  const go = () => {
    all.forEach((s, i) => { s.hidden = i !== Number(input.value); });
    output.textContent = all[input.value].dataset.label;
    input.setAttribute("aria-valuetext", all[input.value].dataset.label);
  };
  input.addEventListener("input", go);
  slide.hidden = false;
  steps.classList.add("on");
  go();
}

function sortable(table, words) {
  table.dataset.isLive = "";
  table.querySelectorAll("thead th").forEach((th, column) => {
    const text = th.textContent;
    th.textContent = "";
    th.append(button(text, words.sortBy(text), () => {
      const up = th.getAttribute("aria-sort") !== "ascending";
      for (const other of table.querySelectorAll("th")) other.removeAttribute("aria-sort");
      th.setAttribute("aria-sort", up ? "ascending" : "descending");
      const key = row => { const c = row.cells[column], n = parseFloat(c.dataset.value); return isNaN(n) ? c.textContent : n; };
      const body = table.tBodies[0], rows = [...body.rows];
      rows.sort((a, b) => { const p = key(a), q = key(b); return (typeof p === typeof q ? p < q ? -1 : p > q ? 1 : 0 : typeof p === "number" ? -1 : 1) * (up ? 1 : -1); });
      body.append(...rows);
    }));
  });
}
