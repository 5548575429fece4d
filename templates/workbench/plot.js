// One plot that zooms: uPlot keeps scales, axes and the drag; the marks are drawn here, each kind by a shape of its own.
import { numberText } from "./numbers.js";

const MOST_DISTINCT = 40;   // more different places than this are taken together for the line of means
const BINS = 25;

// Limits are drawn into view unless that would press the points into less than this part of the height.
const LEAST_HEIGHT = 0.2;

/** Whether a value is beyond limits, either of which may be none. */
export const isOutside = (v, limits) => Boolean(limits) && v !== null && (limits[0] !== null && v < limits[0] || limits[1] !== null && v > limits[1]);

const css = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Means of `ys` at each place of the sorted `xs`, or over neighbours where there are many places; null elsewhere. */
function means(xs, ys, isUsed) {
  const out = xs.map(() => null);
  const used = [...xs.keys()].filter(i => isUsed[i] && ys[i] !== null && ys[i] !== undefined);
  const places = new Set(used.map(i => xs[i])).size;
  const groups = [];
  if (places <= MOST_DISTINCT) for (const i of used) { const g = groups.at(-1); if (g && xs[g[0]] === xs[i]) g.push(i); else groups.push([i]); }
  else for (let b = 0; b < BINS; b += 1) groups.push(used.slice(Math.floor(b * used.length / BINS), Math.floor((b + 1) * used.length / BINS)));
  for (const g of groups) if (g.length) out[g[g.length >> 1]] = g.reduce((s, i) => s + ys[i], 0) / g.length;
  return out;
}

// Each adds itself to a path, which is drawn once for all of its kind.
const shapes = {
  ring: (c, x, y, r) => { c.moveTo(x, y - 2 * r); c.lineTo(x + 2 * r, y); c.lineTo(x, y + 2 * r); c.lineTo(x - 2 * r, y); c.closePath(); },
  dot: (c, x, y, r) => { c.moveTo(x + r, y); c.arc(x, y, r, 0, 7); },
  dash: (c, x, y, r) => { c.moveTo(x - 1.8 * r, y); c.lineTo(x + 1.8 * r, y); },
  cross: (c, x, y, r) => { c.moveTo(x - r, y - r); c.lineTo(x + r, y + r); c.moveTo(x - r, y + r); c.lineTo(x + r, y - r); },
  triangle: (c, x, y, r) => { c.moveTo(x, y - 1.3 * r); c.lineTo(x + 1.2 * r, y + r); c.lineTo(x - 1.2 * r, y + r); c.closePath(); },
};

export class Plot {
  constructor(place, { pick }) {
    this.place = place;
    this.pick = pick;
    this.lastPicked = null;
    new ResizeObserver(() => this.resize()).observe(place);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { this.kind = null; if (this.last) this.show(this.last); });
  }

  /** what: { x, words, xName, yName, view, observed, predicted, trial, sigma, limits, struck, rows, picked }, parallel over the rows shown. */
  show(what) {
    this.last = what;
    const order = [...what.x.keys()].filter(i => what.x[i] !== null).sort((a, b) => what.x[a] - what.x[b]);
    const by = list => list ? order.map(i => list[i]) : null;
    const d = { x: by(what.x), observed: by(what.observed), predicted: by(what.predicted), trial: by(what.trial), sigma: by(what.sigma), limits: by(what.limits), struck: by(what.struck), rows: by(what.rows) };
    const isUsed = d.struck.map(s => !s);
    const less = (a, b) => a.map((v, i) => v === null || b[i] === null || b[i] === undefined ? null : v - b[i]);
    const isResidual = what.view === "residual" && d.predicted;
    if (isResidual) d.limits = null;
    d.main = isResidual ? less(d.observed, d.predicted) : d.observed;
    d.second = isResidual ? null : d.predicted;
    d.trialMarks = d.trial ? isResidual ? less(d.observed, d.trial) : d.trial : null;
    d.picked = what.picked;
    this.d = d;
    const lineOf = ys => ys ? means(d.x, ys, isUsed) : d.x.map(() => null);
    // The two ends of what has to fit into the height, drawn by nothing.
    const both = [d.main, d.second, d.trialMarks, ...this.limitsInView([d.main, d.second, d.trialMarks])].filter(Boolean);
    // Without lists in between: a slider asks for it at every move.
    const extreme = pick => d.x.map((_, i) => {
      let best = null;
      for (const list of both) { const v = list[i]; if (v !== null && v !== undefined) best = best === null ? v : pick(best, v); }
      return best;
    });
    const band = isResidual ? d.sigma.map(s => s === null ? null : 2 * s) : d.x.map(() => null);
    const data = [d.x, band.map(v => v === null ? null : -v), band, extreme(Math.min), extreme(Math.max), lineOf(isResidual ? d.main : d.second), lineOf(d.trialMarks)];

    const kind = [what.view, what.xName, what.yName, (what.words || []).join("\n"), d.x.length].join("|");
    if (this.u && this.kind === kind) {
      const { min, max } = this.u.scales.x;
      const isZoomed = this.isZoomed;
      this.u.setData(data, !isZoomed);
      // A point that is walked to comes into view.
      const at = d.x[d.rows.indexOf(d.picked)];
      const shift = this.lastPicked !== d.picked && at !== undefined && (at < min || at > max) ? at - (min + max) / 2 : 0;
      if (isZoomed) this.u.setScale("x", { min: min + shift, max: max + shift });
    } else {
      this.kind = kind;
      this.make(data, what, isResidual);
    }
    this.lastPicked = d.picked;
  }

  /** The limits as two lists, if they leave room for the points. */
  limitsInView(lists) {
    const { limits } = this.d;
    if (!limits) return [];
    const span = all => { const own = all.flat().filter(v => v !== null && v !== undefined); return own.length ? Math.max(...own) - Math.min(...own) : 0; };
    const own = [0, 1].map(end => limits.map(l => l ? l[end] : null)), points = lists.filter(Boolean);
    return span(points) >= LEAST_HEIGHT * span([...points, ...own]) ? own : [];
  }

  make(data, what, isResidual) {
    if (this.u) this.u.destroy();
    this.isZoomed = false;
    const ink = css("--ink"), soft = css("--soft"), line = css("--line"), first = css("--first"), second = css("--second"), third = css("--third");
    this.colours = { ink, soft, first, second, third, bad: css("--bad"), good: css("--good") };
    const none = { paths: () => null, points: { show: false } };
    const axis = { stroke: soft, grid: { stroke: line, width: 1 }, ticks: { stroke: line }, font: "12px system-ui, sans-serif", labelFont: "13px system-ui, sans-serif", labelSize: 22 };
    const opts = {
      width: this.width(), height: this.height(),
      legend: { show: false },
      scales: { x: { time: false, range: (u, low, high) => this.isZoomed ? [low, high] : low === high ? [low - 1, high + 1] : [low - (high - low) * 0.03, high + (high - low) * 0.03] } },
      cursor: { y: false, points: { show: false }, drag: { x: true, y: false, dist: 6 } },
      series: [{},
        none, none, none, none,
        { stroke: second, width: 2, spanGaps: true, points: { show: false } },
        { stroke: third, width: 2, dash: [8, 5], spanGaps: true, points: { show: false } }],
      axes: [
        { ...axis, label: what.xName, size: 32, values: (u, splits) => splits.map(v => what.words ? what.words[v] ?? "" : numberText(v, 4)), incrs: what.words ? [1, 2, 5, 10, 20, 50, 100] : undefined },
        { ...axis, label: what.yName, size: 58, values: (u, splits) => splits.map(v => numberText(v, 4)) },
      ],
      hooks: {
        setScale: [(u, key) => { if (key === "x") this.noteZoom(u); }],
        drawAxes: [u => this.drawLimits(u), u => this.drawBand(u, isResidual)],
        draw: [u => this.drawMarks(u)],
      },
    };
    this.u = new uPlot(opts, data, this.place);
    const frame = this.u.over;
    let down = null;
    frame.addEventListener("mousedown", e => { down = [e.clientX, e.clientY]; });
    frame.addEventListener("click", e => {
      if (down && Math.hypot(e.clientX - down[0], e.clientY - down[1]) > 5) return;
      const r = frame.getBoundingClientRect();
      const i = this.nearest(e.clientX - r.left, e.clientY - r.top);
      if (i !== null) this.pick(this.d.rows[i]);
    });
    frame.addEventListener("dblclick", () => this.showAll());
  }

  noteZoom(u) {
    const xs = u.data[0];
    const { min, max } = u.scales.x;
    this.isZoomed = xs.length > 0 && (min > xs[0] || max < xs[xs.length - 1]);
  }

  showAll() {
    if (!this.u) return;
    this.isZoomed = false;
    this.u.setData(this.u.data, true);
  }

  zoom(factor) {
    if (!this.u) return;
    const { min, max } = this.u.scales.x;
    const at = this.d.rows.indexOf(this.d.picked);
    const mid = at >= 0 ? this.d.x[at] : (min + max) / 2;
    const xs = this.u.data[0];
    if ((max - min) * factor > xs.at(-1) - xs[0]) { this.showAll(); return; }
    this.isZoomed = true;
    this.u.setScale("x", { min: mid - (mid - min) * factor, max: mid + (max - mid) * factor });
  }

  /** The next point along the plot in reading order, from the one that is picked. */
  walk(step) {
    const n = this.d ? this.d.rows.length : 0;
    if (!n) return;
    const at = this.d.rows.indexOf(this.d.picked);
    // Keys come faster than frames: the next one goes on from here.
    this.d.picked = this.d.rows[at < 0 ? (step > 0 ? 0 : n - 1) : (at + step + n) % n];
    this.pick(this.d.picked);
  }

  nearest(px, py) {
    let best = null, least = 30 * 30;
    this.d.x.forEach((x, i) => {
      if (this.d.main[i] === null || this.d.main[i] === undefined) return;
      const q = (this.u.valToPos(x, "x") - px) ** 2 + (this.u.valToPos(this.d.main[i], "y") - py) ** 2;
      if (q < least) { least = q; best = i; }
    });
    return best;
  }

  inFrame(u, act) {
    const c = u.ctx, b = u.bbox;
    c.save();
    c.beginPath();
    c.rect(b.left, b.top, b.width, b.height);
    c.clip();
    act(c, devicePixelRatio || 1);
    c.restore();
  }

  /** The tolerance: a light area between thin lines, from place to place; open where a limit is none. */
  drawLimits(u) {
    const { x, limits } = this.d;
    if (!limits || !limits.some(Boolean)) return;
    this.inFrame(u, (c, dpr) => {
      const top = u.bbox.top - 2 * dpr, bottom = u.bbox.top + u.bbox.height + 2 * dpr, out = 6 * dpr;
      const y = (v, end) => v === null ? end : u.valToPos(v, "y", true);
      // The strictest at each place; places without a limit part the band.
      const runs = [[]];
      let last = null;
      x.forEach((v, i) => {
        const own = limits[i], run = runs.at(-1);
        if (!own) { if (run.length && v !== last) runs.push([]); return; }
        const strict = (a, b, pick) => a === null ? b : b === null ? a : pick(a, b);
        if (run.length && v === last) { const p = run.at(-1); p.low = strict(p.low, own[0], Math.max); p.high = strict(p.high, own[1], Math.min); }
        else run.push({ v, low: own[0], high: own[1] });
        last = v;
      });
      c.fillStyle = c.strokeStyle = this.colours.good;
      c.lineWidth = dpr;
      for (const run of runs.filter(own => own.length)) {
        const at = run.map(p => u.valToPos(p.v, "x", true));
        const line = (end, edge) => [[at[0] - out, y(run[0][end], edge)], ...run.map((p, i) => [at[i], y(p[end], edge)]), [at.at(-1) + out, y(run.at(-1)[end], edge)]];
        const low = line("low", bottom), high = line("high", top);
        const along = points => points.forEach(([px, py], i) => i ? c.lineTo(px, py) : c.moveTo(px, py));
        c.globalAlpha = 0.12;
        c.beginPath();
        along([...low, ...high.reverse()]);
        c.fill();
        c.globalAlpha = 0.8;
        c.beginPath();
        along(low);
        along(high);
        c.stroke();
      }
      c.globalAlpha = 1;
    });
  }

  drawBand(u, isResidual) {
    // Without a comparison there is no uncertainty either.
    const { x, sigma, main } = this.d;
    this.inFrame(u, (c, dpr) => {
      const at = i => u.valToPos(x[i], "x", true), y = v => u.valToPos(v, "y", true);
      c.fillStyle = c.strokeStyle = this.colours.soft;
      if (isResidual) {
        // The widest at each place, as a straight band from place to place.
        const wide = new Map();
        x.forEach((v, i) => wide.set(v, Math.max(wide.get(v) || 0, 2 * (sigma[i] || 0))));
        const places = [...wide.keys()];
        if (places.length) {
          const px = v => u.valToPos(v, "x", true), out = 6 * dpr;
          const ends = [[px(places[0]) - out, places[0]], ...places.map(v => [px(v), v]), [px(places.at(-1)) + out, places.at(-1)]];
          c.globalAlpha = 0.2;
          c.beginPath();
          for (const [p, v] of ends) c.lineTo(p, y(wide.get(v)));
          for (const [p, v] of ends.reverse()) c.lineTo(p, y(-wide.get(v)));
          c.fill();
        }
        c.globalAlpha = 1;
        c.lineWidth = dpr;
        c.beginPath();
        c.moveTo(u.bbox.left, y(0));
        c.lineTo(u.bbox.left + u.bbox.width, y(0));
        c.stroke();
      } else {
        c.globalAlpha = 0.6;
        c.lineWidth = dpr;
        c.beginPath();
        main.forEach((v, i) => {
          if (v === null || !sigma || !sigma[i]) return;
          c.moveTo(at(i), y(v - 2 * sigma[i]));
          c.lineTo(at(i), y(v + 2 * sigma[i]));
        });
        c.stroke();
      }
    });
  }

  drawMarks(u) {
    const d = this.d, colours = this.colours;
    this.inFrame(u, (c, dpr) => {
      const r = (d.x.length > 600 ? 2 : 3.2) * dpr;
      const each = (ys, shape, colour, which, alpha = 1) => {
        if (!ys) return;
        c.fillStyle = c.strokeStyle = colour;
        c.lineWidth = 1.4 * dpr;
        c.globalAlpha = alpha;
        c.beginPath();
        ys.forEach((v, i) => { if (v !== null && v !== undefined && which(i)) shapes[shape](c, u.valToPos(d.x[i], "x", true), u.valToPos(v, "y", true), r); });
        if (shape === "dot") c.fill(); else c.stroke();
        c.globalAlpha = 1;
      };
      each(d.main, "dot", colours.first, i => !d.struck[i]);
      each(d.main, "cross", colours.soft, i => d.struck[i]);
      each(d.second, "dash", colours.second, i => !d.struck[i]);
      each(d.trialMarks, "triangle", colours.third, i => !d.struck[i], 0.8);
      if (d.limits) each(d.main, "ring", colours.bad, i => !d.struck[i] && isOutside(d.main[i], d.limits[i]));
      const at = d.rows.indexOf(d.picked);
      if (at >= 0 && d.main[at] !== null) {
        c.strokeStyle = colours.ink;
        c.lineWidth = 2.2 * dpr;
        c.beginPath();
        c.arc(u.valToPos(d.x[at], "x", true), u.valToPos(d.main[at], "y", true), 7 * dpr, 0, 7);
        c.stroke();
      }
    });
  }

  width() { return Math.max(240, Math.floor(this.place.clientWidth)); }
  height() { return Math.round(Math.min(460, Math.max(290, this.width() * 0.7))); }
  resize() {
    if (this.u && Math.abs(this.u.width - this.width()) > 1) this.u.setSize({ width: this.width(), height: this.height() });
  }
}
