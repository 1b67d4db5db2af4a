// The page: its parts, and what the keys and the clock do.

function make(tag, attributes = {}, ...children) {
  const e = Object.assign(document.createElement(tag), attributes);
  e.append(...children);
  return e;
}

function checkbox(text, checked, change, colour) {
  const input = make("input", { type: "checkbox", checked });
  input.onchange = () => change(input.checked);
  const swatch = colour ? [make("span", { className: "swatch", style: `background:${colour}` })] : [];
  return make("label", {}, input, ...swatch, text);
}

function chooser(text, options, change) {
  const select = make("select");
  options.forEach(([name, value]) => select.append(new Option(name, value)));
  select.onchange = () => change(select.value);
  return Object.assign(make("label", {}, text, select), { select });
}

/** Peaks of nodes and elements: a row each, with what it belongs to. */
function peakRows(data) {
  const rows = [], { length, force } = data.units, time = s => data.times[s], dims = data.ndm, xyz = ["X", "Y", "Z"];
  const acceleration = length && `${length}/s²`, moment = force && length ? `${force} ${length}` : "";
  data.nodes.tags.forEach((tag, n) => {
    for (let k = 0; k < dims; k++) {
      const i = n * dims + k, of = { kind: "node", at: n };
      if (data.peaks.disp[i]) rows.push({ name: `node ${tag}`, what: `displacement ${xyz[k]}`, value: data.peaks.disp[i], unit: length, step: data.peaks.dispStep[i], of });
      if (data.peaks.accel[i]) rows.push({ name: `node ${tag}`, what: `acceleration ${xyz[k]}`, value: data.peaks.accel[i], unit: acceleration, step: data.peaks.accelStep[i], of });
    }
  });
  const element = e => `element ${data.elements.tags[e]}`;
  for (const d of data.devices)
    d.directions.forEach(([name, role], k) => {
      for (const [i, what, unit] of [[k, role === "rotation" ? "rotation" : "deformation", role === "rotation" ? "rad" : length], [d.directions.length + k, role === "rotation" ? "moment" : "force", role === "rotation" ? moment : force]])
        if (d.peaks[i][0]) rows.push({ name: element(d.element), what: `${what}, ${name}`, value: d.peaks[i][0], unit, step: d.peaks[i][1], of: { kind: "element", at: d.element } });
    });
  const m = data.members, names = { 1: ["N"], 6: ["N", "V", "M"], 12: ["N", "Vy", "Vz", "T", "My", "Mz"] };
  let at = 0;
  m.elements.forEach((e, i) => {
    const columns = m.columns[i], list = names[columns];
    for (let c = 0; c < columns && columns > 1; c++) {
      const low = m.low[at + c], high = m.high[at + c], larger = Math.abs(low) > Math.abs(high), name = list[c % list.length];
      const end = c < list.length ? "i" : "j";
      if (Number.isFinite(low) && (low || high))
        rows.push({ name: element(e), what: `${name}, end ${end}`, value: larger ? low : high, unit: /[MT]/.test(name) ? moment : force, step: (larger ? m.lowStep : m.highStep)[at + c], of: { kind: "element", at: e } });
    }
    at += columns;
  });
  rows.forEach(r => { r.time = time(r.step); r.size = Math.abs(r.value); });
  return rows;
}

/** The table of peaks, sorted by a click on a head. */
function peakTable(data, choose) {
  const rows = peakRows(data), body = make("tbody"), most = 200;
  const wanted = make("input", { type: "search", placeholder: "node 3, force …" });
  wanted.setAttribute("aria-label", "Rows with these words");
  const note = make("span", { className: "note" });
  let key = "size", down = true;
  const heads = [["where", "name"], ["quantity", "what"], ["largest", "size"], ["unit", "unit"], ["time", "time"]].map(([text, k]) => {
    const button = make("button", { type: "button", textContent: text, onclick: () => { down = k === key ? !down : k === "size"; key = k; fill(); } });
    return Object.assign(make("th", {}, button), { key: k });
  });
  const order = (a, b) => typeof a[key] === "number" ? a[key] - b[key] : a[key].localeCompare(b[key], undefined, { numeric: true });
  function fill() {
    heads.forEach(h => h.setAttribute("aria-sort", h.key === key ? (down ? "descending" : "ascending") : "none"));
    const words = wanted.value.toLowerCase().split(/\s+/).filter(w => w);
    const found = rows.filter(r => words.every(w => `${r.name} ${r.what} `.toLowerCase().includes(w)));
    found.sort((a, b) => (down ? -1 : 1) * order(a, b));
    body.replaceChildren(...found.slice(0, most).map(r => {
      const cells = [r.name, r.what, digits(r.value), r.unit, digits(r.time)].map(t => make("td", { textContent: t }));
      return make("tr", { onclick: () => choose(r.of, r.step) }, ...cells);
    }));
    note.textContent = found.length > most ? `The first ${most} of ${found.length} rows.` : "";
  }
  wanted.oninput = fill;
  fill();
  const table = make("table", {}, make("thead", {}, make("tr", {}, ...heads)), body);
  return make("section", { className: "peaks" }, make("h2", { textContent: "Peaks" }), make("div", { className: "bar" }, wanted, note), make("div", { className: "scroll" }, table));
}

async function start() {
  const data = await loadData(), root = document.getElementById("view"), n = data.nodes.tags.length;
  const canvas = make("canvas", { tabIndex: 0 });
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", `Model with ${n} nodes and ${data.elements.tags.length} elements; arrows turn it, plus and minus zoom`);
  const slider = make("input", { type: "range", min: 0, step: "any", value: 0 }), output = make("output");
  slider.setAttribute("aria-label", "Time");
  const play = make("button", { type: "button", textContent: "▶" });
  play.setAttribute("aria-label", "Play");
  const model = make("div", { className: "model" }), side = make("aside", { className: "panel" });
  const view = new ModelView(canvas, data), panel = new Panel(side, data);
  const last = data.stages.reduce((best, s, i) => s[2] - s[1] >= data.stages[best][2] - data.stages[best][1] ? i : best, 0);
  const state = { stage: last, mode: -1, playing: false, step: 0, speed: 1, factor: 1, phase: 0 };
  panel.stage = () => { const [, from, to] = data.stages[state.stage]; return [Math.max(from - 1, 0), to]; };
  panel.stageKind = () => data.stages[state.stage];

  /** Displacements of the largest size are this share of the size of the model, at scale 1 of the slider. */
  const SHARE = 0.05;
  const peakOf = () => {
    if (state.mode >= 0) return view.moved.reduce((m, x) => Math.max(m, Math.abs(x)), 0);
    return data.peaks.disp.reduce((m, x) => Math.max(m, Math.abs(x)), 0);
  };
  const natural = () => { const p = peakOf(); return p > 0 ? SHARE * data.size / p : 0; };
  const shape = () => { const s = data.modes[state.mode].shape; view.moved.fill(0); s.forEach((x, i) => { view.moved[3 * ((i / data.ndm) | 0) + i % data.ndm] = x; }); };

  function show() {
    if (state.mode >= 0) {
      const { lambda } = data.modes[state.mode], omega = Math.sqrt(Math.max(lambda, 0));
      view.scale = state.factor * natural() * Math.cos(state.phase);
      output.textContent = omega > 0 ? `T = ${digits(2 * Math.PI / omega)} s` : `λ = ${digits(lambda)}`;
    } else {
      displacements(data, state.step, view.moved);
      view.scale = state.exact ? 1 : state.factor * natural();
      if (data.members.elements.length) view.memberRow = memberRow(data, state.step);
      const shown = Math.round(state.step);
      output.textContent = `t = ${digits(data.times[shown])}, step ${shown}`;
    }
    amplified.textContent = state.mode >= 0 ? "shape" : `× ${digits(view.scale)}`;
    slider.value = state.step;
    view.draw();
    scale.textContent = view.diagram && view.largest ? `largest ${digits(view.largest)} ${/[MT]/.test(view.diagram) ? [data.units.force, data.units.length].filter(x => x).join(" ") : data.units.force}` : "";
  }

  let told = 0;
  function tell(now = true) {
    if (now || performance.now() - told > 200) { told = performance.now(); panel.at(state.step); }
  }
  function setStage(i) {
    state.stage = +i;
    const [, from, to] = data.stages[state.stage];
    [slider.min, slider.max] = [from, to - 1];
    // The largest displacement is seen first; playing begins at the beginning.
    const within = data.peaks.dispStep.reduce((best, s, k) => s >= from && s < to && Math.abs(data.peaks.disp[k]) > best[0] ? [Math.abs(data.peaks.disp[k]), s] : best, [0, from]);
    state.step = within[1];
    state.fresh = true;
    panel.step = state.step;
    show();
    panel.show(view.selected ?? null);
  }
  function setPlaying(on) {
    state.playing = on && (state.mode >= 0 || +slider.max > +slider.min);
    play.textContent = state.playing ? "❚❚" : "▶";
    play.setAttribute("aria-label", state.playing ? "Pause" : "Play");
    if (state.playing && state.mode < 0 && (state.fresh || state.step >= +slider.max)) state.step = +slider.min;
    state.fresh = false;
    if (state.playing) { let before = performance.now(); requestAnimationFrame(function tick(now) {
      if (!state.playing) return;
      const [, from, to] = data.stages[state.stage], span = data.times[to - 1] - data.times[from];
      const seconds = Math.min(Math.max(span, 6), 20), dt = Math.max(now - before, 0) / 1000 * state.speed;
      before = now;
      if (state.mode >= 0) state.phase += 3 * dt;
      else state.step = Math.min(state.step + dt * (to - 1 - from) / seconds, to - 1);
      show();
      if (state.mode < 0) tell(false);
      if (state.mode < 0 && state.step >= to - 1) return setPlaying(false), tell();
      requestAnimationFrame(tick);
    }); } else tell();
  }
  function choose(selection, step) {
    view.selected = selection;
    if (step !== undefined) {
      const stage = data.stages.findIndex(s => step >= s[1] && step < s[2]);
      if (stage >= 0 && stage !== state.stage) { stageChoice.select.value = stage; setStage(stage); }
      state.step = step;
    }
    show();
    panel.step = state.step;
    return panel.show(selection);
  }
  view.pick = choose;

  slider.oninput = () => { state.step = +slider.value; if (state.mode >= 0) { state.mode = -1; what.select.value = -1; } show(); tell(); };
  play.onclick = () => setPlaying(!state.playing);
  const amplified = make("span"), scale = make("span", { className: "note" });
  const factor = make("input", { type: "range", min: -2, max: 2, step: "any", value: 0 });
  factor.oninput = () => { state.exact = false; state.factor = 10 ** +factor.value; show(); };
  const exact = make("button", { type: "button", textContent: "true scale", onclick: () => { state.exact = true; show(); } });
  const stageChoice = chooser("stage ", data.stages.map(([kind, from, to], i) => [`${i + 1}: ${kind}, ${to - from} steps`, i]), setStage);
  stageChoice.select.value = state.stage;
  const what = chooser("show ", [["motion", -1], ...data.modes.map((m, i) => [`mode ${i + 1}`, i])], v => { state.mode = +v; state.phase = 0; if (state.mode >= 0) shape(); show(); });
  const diagrams = { 0: ["none"], 2: ["none", "N", "Vy", "Mz"], 3: ["none", "N", "Vy", "Vz", "T", "My", "Mz"] }[data.members.elements.length ? Math.max(data.ndm, 2) : 0];
  const diagram = chooser("forces ", diagrams.map(d => [d, d]), v => { view.diagram = v === "none" ? null : v; show(); });
  const find = make("input", { type: "search", placeholder: "node 3, element 7" });
  find.setAttribute("aria-label", "Find a node or an element by its tag");
  find.onchange = () => {
    const [, word, tag] = /^\s*([a-z]*)\s*(-?\d+)\s*$/i.exec(find.value) ?? [], kind = /^e/i.test(word ?? "") ? "element" : "node";
    const at = (kind === "node" ? data.nodes : data.elements).tags.indexOf(+tag);
    find.setCustomValidity(at < 0 ? "There is none with this tag" : "");
    find.reportValidity();
    if (at >= 0) choose({ kind, at });
  };
  const shown = (text, key, on = false) => checkbox(text, on, v => { view.shown[key] = v; show(); });
  const families = data.families.map((name, f) => [name, f]).filter(([, f]) => data.elements.family.includes(f));
  const legend = families.map(([name, f]) => checkbox(name, true, v => { view.hidden[v ? "delete" : "add"](f); show(); }, COLOURS[f]));
  const speed = chooser("speed ", [["× ¼", 0.25], ["× 1", 1], ["× 4", 4]], v => { state.speed = +v; });
  speed.select.value = 1;
  const bar = (...children) => make("div", { className: "bar controls" }, ...children);
  model.append(
    make("div", { className: "bar" }, ...legend), canvas,
    bar(play, make("label", { className: "wide" }, slider), output, speed),
    bar(make("label", { className: "wide" }, "deformed ", factor), amplified, exact, what, ...(data.stages.length > 1 ? [stageChoice] : [])),
    bar(...(diagrams.length > 1 ? [diagram, checkbox("envelope", false, v => { view.envelope = v; show(); }), scale] : []), find,
      ...(data.ndm === 3 ? [chooser("up ", [["Z", 2], ["Y", 1]], v => { view.upright = +v; view.draw(); })] : []),
      make("button", { type: "button", textContent: "whole model", onclick: () => { view.reset(); view.draw(); } })),
    bar(shown("supports", "supports", true), shown("at rest", "rest", true), shown("masses", "masses"), shown("loads", "loads"), shown("local axes", "axes"), shown("node tags", "nodeTags"), shown("element tags", "elementTags")),
    make("p", { className: "note", textContent: notes(data) }));
  root.append(model, side, peakTable(data, choose));
  addEventListener("keydown", e => {
    if (e.target.closest("input, select, button")) return;
    if (e.key === " ") { e.preventDefault(); setPlaying(!state.playing); }
    if (e.key === "," || e.key === ".") { state.step = Math.min(Math.max(Math.round(state.step) + (e.key === "." ? 1 : -1), +slider.min), +slider.max); show(); tell(); }
  });
  const restyled = paper => { panel.paper = paper; view.draw(paper); return panel.current.drawn.forEach(d => window.Plotly.relayout(d.place, { "font.color": panel.layout("", "").font.color })); };
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => restyled(false));
  addEventListener("beforeprint", () => restyled(true));
  addEventListener("afterprint", () => restyled(false));
  setStage(state.stage);
  const first = data.devices[0];
  if (first && data.times.length > 1) choose({ kind: "element", at: first.element });
  document.documentElement.dataset.ready = "yes";
  window.hysteronView = { data, view, panel, state };
}

/** What the page leaves out or rounds. */
function notes(data) {
  const out = [`${data.nodes.tags.length} nodes, ${data.elements.tags.length} elements, ${data.times.length - 1} steps. Drag turns, shift and drag moves, the wheel zooms; space plays, comma and point go step by step.`];
  if (data.frames.steps.length < data.times.length) out.push(`The motion is drawn from ${data.frames.steps.length} steps.`);
  if (data.frames.error > 0) out.push(`Its displacements are right to ${digits(100 * data.frames.error)} % of the largest.`);
  if (data.models > 1) out.push(`The script analyses ${data.models} models; this is the last.`);
  if (data.devicesLeftOut) out.push(`${data.devicesLeftOut} devices have no loops here: there are too many.`);
  return out.join(" ");
}

start().catch(error => { document.getElementById("view").textContent = `The page cannot be drawn: ${error.message}`; throw error; });
