// Numbers as people of the shop read them.

/** µm as it is printed; files and the server write um. */
export const unitText = unit => (unit || "").replace(/\bu(?=[mNsJWVA]\b)/g, "\u00b5").replace(/\bdeg\b/g, "°");

/** Sentences of the server: um alone, as "us" is a word. */
export const proseText = text => (text || "").replace(/\bum\b/g, "\u00b5m");

export function numberText(v, digits = 3) {
  if (v === null || v === undefined || Number.isNaN(v)) return "—";
  const size = Math.abs(v);
  const text = v === 0 ? "0" : size >= 1e6 || size < 1e-4 ? v.toExponential(digits - 1) : String(Number(v.toPrecision(Math.max(digits, size >= 1 ? Math.floor(Math.log10(size)) + 1 : digits))));
  return text.replace("-", "\u2212").replace("-", "\u2212");
}

export const quantityText = (v, unit, digits) => (numberText(v, digits) + " " + unitText(unit)).trim();

/** As it is written into the model: no typographic signs. */
export const writtenNumber = v => String(Number(v.toPrecision(5)));

/** Names of effects as words: tool wear. */
export const nameText = name => (name || "").replace(/[._-]/g, " ");

/** Paths of values as words, counted as people do: workpiece segments 1 length. */
export const pathText = path => path.replace(/\[(\d+)\]/g, (_, n) => ` ${Number(n) + 1} `).replace(/[._]/g, " ").replace(/ +/g, " ").trim();
