// What is shown of a node, a device, a beam or a section that has been chosen.

const PALETTE = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

class Panel {
  constructor(root, data) {
    Object.assign(this, { root, data, drawn: [], panel: this, current: this });
  }

  /** Colours and margins of a chart. */
  layout(x, y, extra = {}) {
    const dark = !this.paper && matchMedia("(prefers-color-scheme: dark)").matches, ink = dark ? "#e8e8e8" : "#222";
    const grid = dark ? "#3a3d42" : "#ddd";
    const axis = title => ({ title: { text: title, standoff: 8 }, gridcolor: grid, zerolinecolor: dark ? "#666" : "#999" });
    return {
      margin: { l: 68, r: 14, t: 26, b: 46 }, height: 260, paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)",
      font: { color: ink, size: 12, family: "system-ui, sans-serif" }, xaxis: axis(x), yaxis: axis(y), hovermode: "closest",
      legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0 }, dragmode: "zoom", ...extra,
    };
  }

  async show(selection) {
    this.selection = selection;
    const body = document.createElement("div");
    this.root.replaceChildren(body);
    // Charts are drawn one after the other: what is still on its way of an earlier selection goes nowhere.
    const shown = this.current = Object.assign(Object.create(this), { root: body, drawn: [], window: this.stage() });
    if (!selection) return shown.text("p", "Choose a node or an element: click it, or write its tag.");
    if (selection.kind === "node") return shown.node(selection.at);
    await shown.element(selection.at);
  }

  text(tag, text, parent = this.root) {
    const e = document.createElement(tag);
    e.textContent = text;
    parent.append(e);
    return e;
  }

  /** Draw a chart; `cursor` gives the place of the present step in it, as [x, y] of a dot. */
  async chart(name, traces, layout, cursor) {
    const figure = document.createElement("figure");
    figure.setAttribute("aria-label", name);
    this.text("figcaption", name, figure);
    const place = document.createElement("div");
    figure.append(place);
    this.root.append(figure);
    const plotly = await charts();
    if (!figure.isConnected) return;
    const dot = { x: [null], y: [null], mode: "markers", marker: { size: 9, color: "#e69f00", line: { width: 1.5, color: "#000" } }, showlegend: false, hoverinfo: "skip" };
    layout.showlegend = traces.filter(t => t.name && t.showlegend !== false).length > 1;
    await plotly.newPlot(place, cursor ? [...traces, dot] : traces, layout, { responsive: true, displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"] });
    if (!cursor) return;
    const drawn = { place, dot: traces.length, cursor };
    this.drawn.push(drawn);
    this.at(this.panel.step ?? 0, [drawn]);
    return place;
  }

  /** The charts show a step. */
  at(step, drawn = this.current.drawn) {
    this.panel.step = step;
    for (const d of drawn) {
      const at = d.cursor(step);
      if (at.restyle) window.Plotly.restyle(d.place, at.restyle, at.traces);
      else window.Plotly.restyle(d.place, { x: [[at[0]]], y: [[at[1]]] }, [d.dot]);
    }
  }

  /** Part of a history within the chosen stage: its steps' times, and a function that takes a column's part. */
  part(history) {
    const [from, to] = this.window, { steps } = history, inside = [];
    for (let i = 0; i < steps.length; i++) if (steps[i] > from && steps[i] < to - 1) inside.push(i);
    // Rows that are left out lie on straight lines: the ends of the stage are between the rows around them.
    const all = [from, ...inside.map(i => steps[i]), ...(to - 1 > from ? [to - 1] : [])];
    const of = column => all.map((s, k) => k && k <= inside.length ? column[inside[k - 1]] : Panel.value(history, column, s));
    return { times: all.map(s => this.timeOf(s)), of };
  }

  /** Abscissa of a step: its time, or its number where the load factor goes back. */
  timeOf(step) {
    const [, from, to] = this.stageKind(), { times } = this.data;
    if (this.rising?.[0] !== from) {
      let rising = true;
      for (let s = from + 1; s < to; s++) rising &&= times[s] > times[s - 1];
      this.rising = [from, rising];
    }
    return this.rising[1] ? times[Math.round(step)] : step;
  }

  /** Value of a column at a step. */
  static value(history, column, step) {
    const [a, b, share] = placeOf(history.steps, step);
    return column[a] + share * (column[b] - column[a]);
  }

  timeName() {
    const [kind] = this.stageKind();
    this.timeOf(0);
    if (!this.rising[1]) return "step";
    return kind === "static" ? "load factor (time)" : labelled("time", "s");
  }

  async node(n) {
    const { data } = this, { length } = data.units, xyz = ["X", "Y", "Z"].slice(0, data.ndm), tag = data.nodes.tags[n];
    this.text("h2", `Node ${tag}`);
    const place = Array.from(data.nodes.places.subarray(3 * n, 3 * n + data.ndm), digits).join(", ");
    const mass = data.nodes.mass[n] ? `, mass ${digits(data.nodes.mass[n])}` : "";
    const fixed = Array.from({ length: data.nodes.ndf[n] }, (_, i) => data.nodes.fixed[n] >> i & 1 ? i + 1 : 0).filter(x => x);
    this.text("p", `At ${place}${length ? " " + length : ""}${mass}${fixed.length ? `; held in ${fixed.join(", ")}` : ""}.`);
    let history = data.histories.find(h => h.node === n);
    const known = !!history;
    if (!known) {
      // From the frames, which have displacements alone.
      const out = new Float32Array(3 * data.nodes.tags.length), steps = Int32Array.from(data.frames.steps);
      const columns = xyz.map(() => new Float32Array(steps.length));
      steps.forEach((s, i) => { displacements(data, s, out); columns.forEach((c, k) => { c[i] = out[3 * n + k]; }); });
      history = { steps, columns };
      if (steps.length < data.times.length) this.text("p", `Displacements at ${steps.length} of ${data.times.length} steps.`);
    }
    const { times, of } = this.part(history), count = known ? history.columns.length / 2 : xyz.length;
    const lines = from => xyz.slice(0, count).map((name, k) => ({ name, x: times, y: of(history.columns[from + k]), mode: "lines", line: { width: 1.5, color: PALETTE[k] } }));
    if (times.length < 2) return this.text("p", "It has not moved: the script makes no steps.");
    const dot = from => step => [this.timeOf(step), Panel.value(history, history.columns[from], step)];
    await this.chart("Displacement", lines(0), this.layout(this.timeName(), labelled("displacement", length)), dot(0));
    const acceleration = labelled("acceleration", length && `${length}/s²`);
    if (known && this.stageKind()[0] !== "static")
      await this.chart(data.shaken.length ? "Acceleration relative to the ground" : "Acceleration", lines(count), this.layout(this.timeName(), acceleration), dot(count));
  }

  async element(e) {
    const { data } = this, { elements } = data, tag = elements.tags[e];
    const nodes = Array.from(elements.nodes.subarray(elements.starts[e], elements.starts[e + 1]), n => data.nodes.tags[n]);
    this.text("h2", `Element ${tag}: ${elements.classes[elements.class[e]]}`);
    this.text("p", `Between nodes ${nodes.join(", ")}.`);
    const device = data.devices.find(d => d.element === e);
    if (device) await this.device(device);
    const member = data.members.elements.indexOf(e);
    if (member >= 0 && data.members.columns[member] > 1) await this.member(member);
    const sections = data.fibers.sections.map((s, i) => [s, i]).filter(([s]) => s.element === e);
    for (const [section, i] of sections) await this.section(section, i);
    if (!device && member < 0 && !sections.length) this.text("p", "No histories of this element are kept.");
  }

  async device(d) {
    const { data } = this, { force, length } = data.units, n = d.directions.length, { times, of } = this.part(d);
    if (d.steps.length < 2) return this.text("p", "The script makes no steps: there are no loops.");
    const moment = force && length ? `${force} ${length}` : "";
    const names = k => {
      const [name, role] = d.directions[k];
      return role === "rotation" ? [labelled(`rotation, ${name}`, "rad"), labelled(`moment, ${name}`, moment)] : [labelled(`deformation, ${name}`, length), labelled(`force, ${name}`, force)];
    };
    const travel = k => { const c = of(d.columns[k]); return c.reduce((m, x) => Math.max(m, x), -Infinity) - c.reduce((m, x) => Math.min(m, x), Infinity); };
    const loops = [...Array(n).keys()].filter(k => d.directions[k][1] === "shear").sort((a, b) => travel(b) - travel(a));
    const axial = [...Array(n).keys()].find(k => d.directions[k][1] === "axial");
    const order = [...loops, ...[...Array(n).keys()].filter(k => !loops.includes(k))];
    const chooser = document.createElement("label");
    chooser.textContent = "Loop of ";
    const select = document.createElement("select");
    order.forEach(k => select.append(new Option(d.directions[k][0], k)));
    chooser.append(select);
    this.root.append(chooser);
    let k = order[0];
    const line = (x, y, name) => ({ x, y, name, mode: "lines", line: { width: 1.5, color: PALETTE[0] } });
    const loop = () => [line(of(d.columns[k]), of(d.columns[n + k]))];
    const place = await this.chart("Loop", loop(), this.layout(...names(k)), s => [Panel.value(d, d.columns[k], s), Panel.value(d, d.columns[n + k], s)]);
    select.onchange = () => {
      k = +select.value;
      const [x, y] = names(k), [trace] = loop();
      window.Plotly.update(place, { x: [trace.x], y: [trace.y] }, { "xaxis.title.text": x, "yaxis.title.text": y, "xaxis.autorange": true, "yaxis.autorange": true }, [0]);
      this.at(this.panel.step);
    };
    if (loops.length > 1) {
      const [a, b] = loops.slice(0, 2).sort((x, y) => x - y);
      const layout = this.layout(names(a)[0], names(b)[0]);
      layout.yaxis.scaleanchor = "x";
      await this.chart("Orbit", [line(of(d.columns[a]), of(d.columns[b]))], layout, s => [Panel.value(d, d.columns[a], s), Panel.value(d, d.columns[b], s)]);
    }
    if (axial !== undefined && n > 1) {
      const column = d.columns[n + axial];
      await this.chart("Axial force", [line(times, of(column))], this.layout(this.timeName(), names(axial)[1]), s => [this.timeOf(s), Panel.value(d, column, s)]);
    }
    const u = d.columns[order[0]];
    await this.chart("Deformation in time", [line(times, of(u))], this.layout(this.timeName(), names(order[0])[0]), s => [this.timeOf(s), Panel.value(d, u, s)]);
  }

  async member(m) {
    const { data } = this, { force, length } = data.units, columns = data.members.columns[m], half = columns / 2;
    const from = data.members.columns.subarray(0, m).reduce((a, b) => a + b, 0), moment = force && length ? `${force} ${length}` : "";
    const names = half === 3 ? ["N", "V", "M"] : ["N", "Vy", "Vz", "T", "My", "Mz"];
    const table = document.createElement("table");
    this.text("caption", `End forces in local axes: smallest and largest${force ? ` [${force}, ${moment}]` : ""}`, table);
    const row = (tag, cells) => { const r = document.createElement("tr"); cells.forEach(c => this.text(tag, c, r)); table.append(r); };
    row("th", ["", "end i: min", "max", "end j: min", "max"]);
    names.forEach((name, k) => row("td", [name, ...[k, half + k].flatMap(c => [digits(data.members.low[from + c]), digits(data.members.high[from + c])])]));
    this.root.append(table);
    const steps = data.members.steps, history = { steps, columns: [] }, width = data.members.low.length, v = data.members.values;
    for (let c = 0; c < columns; c++)
      history.columns.push(Float32Array.from(steps, (_, f) => v.lows[c] + v.steps[c] * v.codes[f * width + from + c]));
    const { times, of } = this.part(history);
    if (times.length < 2) return;
    const groups = half === 3 ? [["Bending moment", [2], moment], ["Axial force", [0], force]] : [["Bending moments", [5, 4], moment], ["Axial force", [0], force]];
    for (const [name, ks, unit] of groups) {
      const traces = ks.flatMap((k, i) => [0, half].map(end => ({ name: `${names[k]}, end ${end ? "j" : "i"}`, x: times, y: of(history.columns[k + end]), mode: "lines", line: { width: 1.5, color: PALETTE[2 * i + (end ? 1 : 0)] } })));
      await this.chart(name, traces, this.layout(this.timeName(), labelled(name.toLowerCase(), unit)), s => [this.timeOf(s), Panel.value(history, history.columns[ks[0]], s)]);
    }
  }

  /** Fibers of a section, and the curve of one that is clicked. */
  async section(section, index) {
    const { data } = this, f = data.fibers, n = section.places.length / 3, total = f.stress.length / f.steps.length;
    const from = f.sections.slice(0, index).reduce((sum, s) => sum + s.places.length / 3, 0), { force, length } = data.units;
    const stressUnit = force && length ? `${force}/${length}²` : "", part = k => Array.from({ length: n }, (_, i) => section.places[3 * i + k]);
    const areas = part(2), most = Math.max(...areas), flat = new Set(part(1)).size < 2;
    const values = (array, step) => { const [a] = placeOf(f.steps, step); return Array.from(array.subarray(a * total + from, a * total + from + n)); };
    let peak = 0;
    for (let s = 0; s < f.steps.length; s++) for (let i = 0; i < n; i++) peak = Math.max(peak, Math.abs(f.stress[s * total + from + i]));
    this.text("h3", `Fibers of section ${section.number}`);
    const now = step => ({ color: values(f.stress, step), text: values(f.strain, step).map((e, i) => `strain ${digits(e)}<br>stress ${digits(values(f.stress, step)[i])}`) });
    const start = now(this.panel.step ?? 0);
    const layout = this.layout(labelled("z", length), labelled("y", length), { height: 320 });
    if (!flat) layout.yaxis.scaleanchor = "x";
    const trace = { x: flat ? part(1) : part(1), y: part(0), mode: "markers", text: start.text, hoverinfo: "text", marker: { symbol: "square", size: areas.map(a => 5 + 11 * Math.sqrt(a / most)), color: start.color, cmin: -peak, cmax: peak, colorscale: [[0, "#0072b2"], [0.5, "#dddddd"], [1, "#d55e00"]], colorbar: { title: { text: labelled("stress", stressUnit), side: "right" }, thickness: 10 } } };
    const cursor = step => { const { color, text } = now(step); return { restyle: { "marker.color": [color], text: [text] }, traces: [0] }; };
    const place = await this.chart("Fibers", [trace], layout, cursor);
    if (!place) return;
    let fiber = areas.reduce((best, _, i) => Math.abs(section.places[3 * i]) > Math.abs(section.places[3 * best]) ? i : best, 0);
    const curve = array => Array.from(f.steps, (_, s) => array[s * total + from + fiber]);
    const name = () => `Fiber at y = ${digits(section.places[3 * fiber])}, z = ${digits(section.places[3 * fiber + 1])} (click another)`;
    const second = await this.chart("Stress and strain", [{ x: curve(f.strain), y: curve(f.stress), mode: "lines", line: { width: 1.5, color: PALETTE[0] } }], this.layout("strain", labelled("stress", stressUnit)), step => [values(f.strain, step)[fiber], values(f.stress, step)[fiber]]);
    const caption = second.parentElement.querySelector("figcaption");
    caption.textContent = name();
    place.on("plotly_click", e => {
      if (e.points[0].curveNumber !== 0) return;
      fiber = e.points[0].pointIndex;
      window.Plotly.restyle(second, { x: [curve(f.strain)], y: [curve(f.stress)] }, [0]);
      caption.textContent = name();
      this.at(this.panel.step);
    });
  }
}
