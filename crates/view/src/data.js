// Data of the page: arrays are slices of one block, see crates/view/src/pack.rs.

/** Bytes of a block of the page. */
async function block(id) {
  const element = document.getElementById(id), text = atob(element.textContent);
  element.remove();
  const bytes = Uint8Array.from(text, c => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The description with its arrays in place. */
async function loadData() {
  const decoder = new TextDecoder();
  const data = JSON.parse(decoder.decode(await block("description")));
  const bytes = (await block("arrays")).buffer;
  const array = a => {
    if (a.k === "i") return new Int32Array(bytes, a.at, a.n);
    if (a.k === "f") return new Float32Array(bytes, a.at, a.n);
    const codes = new Uint16Array(bytes, a.at, a.n);
    if (a.lows) return { codes, lows: a.lows, steps: a.steps };
    const out = new Float32Array(a.n);
    for (let i = 0; i < a.n; i++) out[i] = a.low + a.step * codes[i];
    return out;
  };
  const placed = x => {
    if (Array.isArray(x)) return x.map(placed);
    if (x === null || typeof x !== "object") return x;
    if ("k" in x && "at" in x) return array(x);
    return Object.fromEntries(Object.entries(x).map(([key, value]) => [key, placed(value)]));
  };
  return placed(data);
}

/** The library of charts, which is run when the first chart is wanted. */
let library = null;
function charts() {
  library ??= block("library").then(bytes => {
    const script = document.createElement("script");
    script.textContent = new TextDecoder().decode(bytes);
    document.head.append(script);
    return window.Plotly;
  });
  return library;
}

/** A number with four significant digits. */
function digits(x) {
  if (!Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  return size >= 1e5 || size < 1e-3 ? x.toExponential(3) : String(+x.toPrecision(4));
}

/** A name with its unit in brackets. */
const labelled = (name, unit) => unit ? `${name} [${unit}]` : name;

/** Places of a step among rising steps: the frame before it, and the share of the way to the next. */
function placeOf(steps, step) {
  let low = 0, high = steps.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (steps[middle] <= step) low = middle; else high = middle - 1;
  }
  const next = Math.min(low + 1, steps.length - 1);
  const share = next > low ? (step - steps[low]) / (steps[next] - steps[low]) : 0;
  return [low, next, Math.min(Math.max(share, 0), 1)];
}

/** Displacements of all nodes at a step (which may lie between two), as three numbers a node. */
function displacements(data, step, out) {
  const f = data.frames, n = data.nodes.tags.length, dims = data.ndm, width = n * dims;
  const [a, b, share] = placeOf(f.steps, step);
  const set = i => 3 * ((i / dims) | 0) + i % dims;
  out.fill(0);
  if (f.values) {
    for (let i = 0; i < width; i++) {
      const x = f.values[a * width + i], y = f.values[b * width + i];
      out[set(i)] = x + share * (y - x);
    }
    return out;
  }
  for (let r = 0; r < f.rank; r++) {
    const x = f.coefficients[a * f.rank + r], y = f.coefficients[b * f.rank + r];
    const c = x + share * (y - x), shape = f.shapes[r];
    for (let i = 0; i < width; i++) out[set(i)] += c * shape[i];
  }
  return out;
}

/** End forces of all members at the frame nearest to a step. */
function memberRow(data, step) {
  const m = data.members, width = m.low.length, [a, b, share] = placeOf(m.steps, step);
  const frame = share > 0.5 ? b : a, row = new Float32Array(width);
  let at = 0;
  for (const columns of m.columns)
    for (let c = 0; c < columns; c++, at++) row[at] = m.values.lows[c] + m.values.steps[c] * m.values.codes[frame * width + at];
  return row;
}
