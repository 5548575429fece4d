// Elements are built anew from the state and merged into what stands there, so that an element that has focus, a field
// that is being written in, an open <details> and a scrolled table stay the very same elements.

/** h("p", { class: "note" }, "text", child, …): null and false children are left out. */
export function h(tag, attributes, ...children) {
  const e = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) {
    if (value === null || value === undefined || value === false) continue;
    e.setAttribute(name, value === true ? "" : String(value));
  }
  e.append(...children.flat(Infinity).filter(c => c !== null && c !== undefined && c !== false));
  return e;
}

/** A box for HTML that the server made; `ready` is called when its content was replaced. */
export function blob(html, attributes) {
  const e = h("div", { ...attributes, "data-blob": "" });
  e.html = html;
  return e;
}

const filled = new WeakMap();
let ready = () => {};
export function onFilled(call) { ready = call; }

function fill(box, html) {
  if (filled.get(box) === html) return;
  // Focus, open details and scroll positions within are found again by name or order.
  const names = [...box.querySelectorAll("*")];
  const focus = box.contains(document.activeElement) && document.activeElement !== box ? document.activeElement : null;
  const kind = focus && focus.tagName, label = focus && focus.getAttribute("aria-label");
  const order = focus && names.filter(e => e.tagName === kind).indexOf(focus);
  const opened = [...box.querySelectorAll("details")].map(d => d.open);
  const scrolled = [...box.querySelectorAll(".tablebox,.view")].map(e => [e.scrollLeft, e.scrollTop]);
  box.innerHTML = html;
  filled.set(box, html);
  ready(box);
  box.querySelectorAll("details").forEach((d, i) => { if (i < opened.length) d.open = opened[i]; });
  box.querySelectorAll(".tablebox,.view").forEach((e, i) => { if (scrolled[i]) [e.scrollLeft, e.scrollTop] = scrolled[i]; });
  if (focus) {
    const same = [...box.querySelectorAll(kind)];
    const again = (label && same.find(e => e.getAttribute("aria-label") === label)) || same[order];
    if (again) again.focus({ preventScroll: true });
  }
}

const isWritten = e => e.tagName === "TEXTAREA" || e.tagName === "INPUT" && !["range", "checkbox", "radio", "file"].includes(e.type);
// What the page never says a word to: a field of a form that is not sent yet.
const isOwn = e => e.hasAttribute("data-own");
// What a select was last told to show: while it has focus it follows what is new, and nothing else.
const told = new WeakMap();
const keyOf = e => e.nodeType === 1 ? e.getAttribute("data-key") || e.id || null : null;

/** Makes `old` say what `fresh` says. */
export function merge(old, fresh) {
  const isOpened = name => name === "open" && old.tagName === "DETAILS";
  const typed = isWritten(old) && !isOwn(old) && document.activeElement === old && old.value !== old.defaultValue ? old.value : null;
  for (const { name, value } of [...fresh.attributes]) {
    if (!isOpened(name) && old.getAttribute(name) !== value) old.setAttribute(name, value);
  }
  for (const { name } of [...old.attributes]) if (!fresh.hasAttribute(name) && !isOpened(name)) old.removeAttribute(name);
  if (fresh.html !== undefined) { fill(old, fresh.html); return; }
  if (!old.hasAttribute("data-live")) children(old, fresh);
  if (isOwn(old)) return;
  if (isWritten(old)) {
    const value = typed === null ? fresh.value : typed;
    if (old.value !== value) old.value = value;
  } else if (old.tagName === "INPUT" && old.type !== "file") {
    old.checked = fresh.checked;
    if (old.value !== fresh.value) old.value = fresh.value;
  } else if (old.tagName === "SELECT") {
    if (document.activeElement !== old || told.has(old) && told.get(old) !== fresh.value) old.value = fresh.value;
    told.set(old, fresh.value);
  }
}

function children(old, fresh) {
  const keyed = new Map();
  for (const c of old.childNodes) { const k = keyOf(c); if (k) keyed.set(k, c); }
  let at = old.firstChild;
  for (const next of [...fresh.childNodes]) {
    const key = keyOf(next);
    let same = null;
    if (key) same = keyed.get(key) || null;
    else if (at && !keyOf(at) && at.nodeType === next.nodeType && at.nodeName === next.nodeName) same = at;
    else {
      // The next unkeyed sibling of the kind, if something before it went.
      for (let e = at; e; e = e.nextSibling) if (!keyOf(e) && e.nodeType === next.nodeType && e.nodeName === next.nodeName) { same = e; break; }
    }
    if (same && same.nodeName !== next.nodeName) same = null;
    if (!same) {
      old.insertBefore(next, at);
      settle(next);
      continue;
    }
    if (same !== at) {
      // Moving an element takes its focus away: what stands before it goes instead.
      if (same.contains(document.activeElement)) while (at && at !== same) { const gone = at; at = at.nextSibling; if (keyOf(gone)) old.append(gone); else gone.remove(); }
      else old.insertBefore(same, at);
    }
    if (same.nodeType === 1) merge(same, next);
    else if (same.nodeValue !== next.nodeValue) same.nodeValue = next.nodeValue;
    at = same.nextSibling;
  }
  while (at) { const gone = at; at = at.nextSibling; gone.remove(); }
}

// A box that came in as new has its HTML still to be filled.
function settle(node) {
  if (node.nodeType !== 1) return;
  for (const e of [node, ...node.querySelectorAll("[data-blob]")]) if (e.html !== undefined) fill(e, e.html);
}

/** Puts the children into the place, merged with what is there. */
export function put(place, ...parts) {
  const fresh = place.cloneNode(false);
  fresh.append(...parts.flat(Infinity).filter(c => c !== null && c !== undefined && c !== false));
  const hadFocus = place.contains(document.activeElement);
  children(place, fresh);
  // The button that had focus may be gone (an added cause): the pane has it then, not the top of the page.
  if (hadFocus && document.activeElement === document.body) {
    const home = place.closest("section, header") || place;
    const title = home.querySelector("h1, h2") || home;
    title.setAttribute("tabindex", "-1");
    title.focus({ preventScroll: true });
  }
}
