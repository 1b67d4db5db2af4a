// The model in its view: drawn on a canvas in parallel projection, so that it needs no graphics card.

/** Colours that the colour-blind tell apart (Okabe and Ito), by family of elements. */
const COLOURS = ["#0072b2", "#56b4e9", "#d55e00", "#e69f00", "#009e73", "#cc79a7"];
const AXES = ["#d55e00", "#009e73", "#0072b2"];

class ModelView {
  constructor(canvas, data) {
    Object.assign(this, { canvas, data, pick: () => {}, shown: { supports: true, rest: true }, hidden: new Set() });
    const n = data.nodes.tags.length;
    this.moved = new Float32Array(3 * n);
    this.places = new Float32Array(3 * n);
    this.screen = new Float32Array(2 * n);
    this.rest = new Float32Array(2 * n);
    this.scale = 0;
    this.upright = 2;
    this.reset();
    this.listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  /** The whole model from the usual side. */
  reset() {
    this.turn = this.data.ndm < 3 ? [0, Math.PI / 2] : [-0.6, 0.35];
    this.zoom = 1;
    this.shift = [0, 0];
  }

  /** Right and upward vectors of the screen in global axes. */
  directions() {
    const [a, e] = this.turn, right = [Math.cos(a), Math.sin(a), 0];
    const up = [-Math.sin(a) * Math.sin(e), Math.cos(a) * Math.sin(e), Math.cos(e)];
    // With Y upward, the axes x, y, z of the view are z, x, y of the model.
    const from = v => this.upright === 2 || this.data.ndm < 3 ? v : [v[1], v[2], v[0]];
    return [from(right), from(up)];
  }

  /** Projection of places to the screen. */
  project(places, out) {
    const [r, u] = this.directions(), { width, height } = this.canvas.getBoundingClientRect();
    const { centre, extent } = this.bounds();
    const s = this.zoom * Math.min(width, height * 1.2) * 0.72 / extent;
    Object.assign(this, { pixels: s, right: r, up: u });
    const x0 = width / 2 + this.shift[0], y0 = height / 2 + this.shift[1];
    for (let i = 0, k = 0; i < places.length; i += 3, k += 2) {
      const x = places[i] - centre[0], y = places[i + 1] - centre[1], z = places[i + 2] - centre[2];
      out[k] = x0 + s * (r[0] * x + r[1] * y + r[2] * z);
      out[k + 1] = y0 - s * (u[0] * x + u[1] * y + u[2] * z);
    }
  }

  bounds() {
    if (!this.box) {
      const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], p = this.data.nodes.places;
      for (let i = 0; i < p.length; i++) {
        low[i % 3] = Math.min(low[i % 3], p[i]);
        high[i % 3] = Math.max(high[i % 3], p[i]);
      }
      this.box = { centre: low.map((x, i) => (x + high[i]) / 2), extent: this.data.size };
    }
    return this.box;
  }

  /** Nodes of an element. */
  nodesOf(e) {
    const { starts, nodes } = this.data.elements;
    return nodes.subarray(starts[e], starts[e + 1]);
  }

  /** Pairs of nodes that are the edges of an element. */
  static edges(count) {
    if (count === 2) return [[0, 1]];
    if (count === 8) return [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
    return Array.from({ length: count }, (_, i) => [i, (i + 1) % count]);
  }

  /** Draw on the canvas; `paper` takes the colours of paper. */
  draw(paper = false) {
    const { canvas, data } = this, { width, height } = canvas.getBoundingClientRect(), ratio = paper ? 2 : devicePixelRatio;
    if (width < 1) return;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const c = this.context = canvas.getContext("2d");
    c.scale(ratio, ratio);
    const dark = !paper && matchMedia("(prefers-color-scheme: dark)").matches;
    this.ink = dark ? "#e8e8e8" : "#222";
    this.faint = dark ? "#666" : "#bbb";
    this.ground = dark ? "#16181b" : "#fff";
    for (let i = 0; i < this.places.length; i++) this.places[i] = data.nodes.places[i] + this.scale * this.moved[i];
    this.project(data.nodes.places, this.rest);
    this.project(this.places, this.screen);
    if (this.shown.rest && this.scale > 0) this.drawElements(this.rest, true);
    if (this.diagram) this.drawDiagrams();
    this.drawElements(this.screen, false);
    if (this.shown.supports) this.drawSupports();
    if (this.shown.masses) this.drawMasses();
    if (this.shown.loads) this.drawLoads();
    if (this.shown.axes) this.drawAxes();
    this.drawSelection();
    if (this.shown.nodeTags || this.shown.elementTags) this.drawTags();
    this.drawTriad(height);
  }

  drawElements(screen, rest) {
    const c = this.context, { elements } = this.data, few = elements.tags.length < 3000;
    COLOURS.forEach((colour, family) => {
      if (this.hidden.has(family)) return;
      const device = family === 2 || family === 3, lines = new Path2D(), dots = new Path2D(), faces = new Path2D();
      for (let e = 0; e < elements.tags.length; e++) {
        if (elements.family[e] !== family) continue;
        const nodes = this.nodesOf(e);
        for (const [i, j] of ModelView.edges(nodes.length)) {
          lines.moveTo(screen[2 * nodes[i]], screen[2 * nodes[i] + 1]);
          lines.lineTo(screen[2 * nodes[j]], screen[2 * nodes[j] + 1]);
        }
        if (nodes.length === 3 || nodes.length === 4) {
          nodes.forEach((n, i) => faces[i ? "lineTo" : "moveTo"](screen[2 * n], screen[2 * n + 1]));
          faces.closePath();
        }
        if (device && nodes.length === 2) {
          const [x, y] = this.middle(nodes, screen), s = few ? 4.5 : 3;
          if (family === 2) dots.rect(x - s, y - s, 2 * s, 2 * s);
          else { dots.moveTo(x + s, y); dots.arc(x, y, s, 0, 2 * Math.PI); }
        }
      }
      c.strokeStyle = rest ? this.faint : colour;
      c.lineWidth = rest ? 1 : device ? 3 : few ? 2 : 1;
      c.setLineDash(rest && few ? [4, 3] : []);
      c.globalAlpha = 1;
      c.stroke(lines);
      c.setLineDash([]);
      if (!rest) {
        c.fillStyle = colour;
        c.fill(dots);
        c.globalAlpha = 0.18;
        c.fill(faces);
        c.globalAlpha = 1;
      }
    });
    if (rest) return;
    c.strokeStyle = this.faint;
    c.setLineDash([2, 4]);
    c.lineWidth = 1;
    c.beginPath();
    const { ties } = this.data;
    for (let i = 0; i < ties.length && ties.length < 8000; i += 2) {
      c.moveTo(screen[2 * ties[i]], screen[2 * ties[i] + 1]);
      c.lineTo(screen[2 * ties[i + 1]], screen[2 * ties[i + 1] + 1]);
    }
    c.stroke();
    c.setLineDash([]);
  }

  middle(nodes, screen = this.screen) {
    let x = 0, y = 0;
    for (const n of nodes) { x += screen[2 * n]; y += screen[2 * n + 1]; }
    return [x / nodes.length, y / nodes.length];
  }

  drawSupports() {
    const c = this.context, { fixed, ndf } = this.data.nodes, few = fixed.length < 2000;
    c.strokeStyle = this.ink;
    c.fillStyle = this.ground;
    c.lineWidth = 1.3;
    for (let n = 0; n < fixed.length; n++) {
      if (!fixed[n]) continue;
      const x = this.rest[2 * n], y = this.rest[2 * n + 1], s = few ? 7 : 3;
      c.beginPath();
      if (fixed[n] === (1 << ndf[n]) - 1) c.rect(x - s, y + 2, 2 * s, s);
      else { c.moveTo(x, y); c.lineTo(x - s, y + 1.5 * s); c.lineTo(x + s, y + 1.5 * s); c.closePath(); }
      c.fill();
      c.stroke();
    }
  }

  drawMasses() {
    const c = this.context, { mass } = this.data.nodes, most = mass.reduce((m, x) => Math.max(m, x), 0);
    c.strokeStyle = this.ink;
    c.lineWidth = 1;
    for (let n = 0; n < mass.length; n++) {
      if (!mass[n]) continue;
      c.beginPath();
      c.arc(this.screen[2 * n], this.screen[2 * n + 1], 2 + 8 * Math.cbrt(mass[n] / most), 0, 2 * Math.PI);
      c.stroke();
    }
  }

  /** An arrow from a place of the screen along a global vector, `length` pixels for its projected part. */
  arrow(x, y, v, length, colour, toward = false) {
    const c = this.context, size = Math.hypot(...v), r = this.right, u = this.up;
    const dx = length * (r[0] * v[0] + r[1] * v[1] + r[2] * v[2]) / size, dy = -length * (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / size;
    const long = Math.hypot(dx, dy);
    if (long < 2) return;
    const [x0, y0] = toward ? [x - dx, y - dy] : [x, y], [x1, y1] = [x0 + dx, y0 + dy], h = Math.min(6, long / 2) / long;
    c.strokeStyle = colour;
    c.beginPath();
    c.moveTo(x0, y0);
    c.lineTo(x1, y1);
    c.lineTo(x1 - h * (dx - 0.6 * dy), y1 - h * (dy + 0.6 * dx));
    c.moveTo(x1, y1);
    c.lineTo(x1 - h * (dx + 0.6 * dy), y1 - h * (dy - 0.6 * dx));
    c.stroke();
    return [x1, y1];
  }

  drawLoads() {
    const { load } = this.data.nodes, sizes = [];
    for (let i = 0; i < load.length; i += 3) sizes.push(Math.hypot(load[i], load[i + 1], load[i + 2]));
    const most = sizes.reduce((m, x) => Math.max(m, x), 0);
    this.context.lineWidth = 1.6;
    sizes.forEach((size, n) => {
      if (size > 0) this.arrow(this.screen[2 * n], this.screen[2 * n + 1], load.subarray(3 * n, 3 * n + 3), 12 + 34 * size / most, "#cc79a7", true);
    });
  }

  drawAxes() {
    const { axes, tags } = this.data.elements;
    this.context.lineWidth = 1.6;
    for (let e = 0; e < tags.length; e++) {
      if (this.hidden.has(this.data.elements.family[e]) || !axes.subarray(9 * e, 9 * e + 9).some(x => x)) continue;
      const [x, y] = this.middle(this.nodesOf(e));
      for (let a = 0; a < 3; a++) this.arrow(x, y, axes.subarray(9 * e + 3 * a, 9 * e + 3 * a + 3), tags.length < 500 ? 22 : 10, AXES[a]);
    }
  }

  drawSelection() {
    const c = this.context, s = this.selected;
    if (!s) return;
    c.strokeStyle = this.ink;
    c.lineWidth = 2;
    c.beginPath();
    if (s.kind === "node") c.arc(this.screen[2 * s.at], this.screen[2 * s.at + 1], 8, 0, 2 * Math.PI);
    else {
      const nodes = this.nodesOf(s.at), [x, y] = this.middle(nodes);
      c.lineWidth = 6;
      c.globalAlpha = 0.35;
      for (const [i, j] of ModelView.edges(nodes.length)) {
        c.moveTo(this.screen[2 * nodes[i]], this.screen[2 * nodes[i] + 1]);
        c.lineTo(this.screen[2 * nodes[j]], this.screen[2 * nodes[j] + 1]);
      }
      c.stroke();
      c.globalAlpha = 1;
      c.lineWidth = 2;
      c.beginPath();
      c.arc(x, y, 10, 0, 2 * Math.PI);
    }
    c.stroke();
  }

  /** Tags, as many as have room. */
  drawTags() {
    const c = this.context, taken = new Set(), { width, height } = this.canvas.getBoundingClientRect();
    c.font = "11px system-ui, sans-serif";
    const write = (text, x, y, colour) => {
      const cell = `${Math.round(x / 26)},${Math.round(y / 13)}`;
      if (x < 0 || y < 0 || x > width || y > height || taken.has(cell)) return;
      taken.add(cell);
      c.lineWidth = 3;
      c.strokeStyle = this.ground;
      c.strokeText(text, x + 5, y - 5);
      c.fillStyle = colour;
      c.fillText(text, x + 5, y - 5);
    };
    const { nodes, elements } = this.data;
    if (this.shown.nodeTags) nodes.tags.forEach((t, n) => write(t, this.screen[2 * n], this.screen[2 * n + 1], this.ink));
    if (this.shown.elementTags)
      elements.tags.forEach((t, e) => {
        if (!this.hidden.has(elements.family[e])) write(t, ...this.middle(this.nodesOf(e)), COLOURS[elements.family[e]]);
      });
  }

  drawTriad(height) {
    const c = this.context;
    c.lineWidth = 2;
    c.font = "12px system-ui, sans-serif";
    ["X", "Y", "Z"].slice(0, Math.max(this.data.ndm, 2)).forEach((name, a) => {
      const v = [0, 0, 0];
      v[a] = 1;
      const end = this.arrow(34, height - 34, v, 24, AXES[a]);
      c.fillStyle = this.ink;
      if (end) c.fillText(name, end[0] + 3, end[1] - 3);
    });
  }

  /** Positions and values of a section force along a beam, from its end forces under a uniform load. */
  static along(row, at, columns, force, length) {
    const half = columns / 2, plane = columns === 6, index = { N: 0, Vy: 1, Mz: plane ? 2 : 5, Vz: 2, T: 3, My: 4 }[force];
    if (plane && (force === "Vz" || force === "T" || force === "My")) return null;
    const i = row[at + index], j = row[at + half + index];
    if (force === "N" || force === "T") return [[0, -i], [1, j]];
    if (force === "Vy" || force === "Vz") return [[0, i], [1, -j]];
    const v = force === "Mz" ? 1 : 2, shear = row[at + v], load = -(shear + row[at + half + v]) / length, sign = force === "Mz" ? 1 : -1;
    return Array.from({ length: 11 }, (_, k) => {
      const x = k / 10 * length;
      return [k / 10, -i + sign * (shear * x + load * x * x / 2)];
    });
  }

  /** Curves of the chosen section force: one a member, or those of both extremes. */
  curves() {
    const { data } = this, m = data.members, out = [];
    let at = 0;
    m.elements.forEach((e, k) => {
      const columns = m.columns[k], nodes = this.nodesOf(e), p = data.nodes.places;
      const length = Math.hypot(...[0, 1, 2].map(a => p[3 * nodes[1] + a] - p[3 * nodes[0] + a]));
      const add = row => {
        const curve = columns > 1 ? ModelView.along(row, at, columns, this.diagram, length) : this.diagram === "N" ? [[0, row[at]], [1, row[at]]] : null;
        if (curve) out.push({ e, curve });
      };
      if (this.envelope && columns > 1) {
        // Extremes of both ends need not be of one time: straight lines between them.
        const half = columns / 2, index = { N: 0, Vy: 1, Mz: columns === 6 ? 2 : 5, Vz: 2, T: 3, My: 4 }[this.diagram];
        if (columns === 12 || ["N", "Vy", "Mz"].includes(this.diagram)) {
          const i = at + index, j = i + half, turned = ["Vy", "Vz"].includes(this.diagram);
          const low = turned ? [m.low[i], -m.high[j]] : [-m.high[i], m.low[j]], high = turned ? [m.high[i], -m.low[j]] : [-m.low[i], m.high[j]];
          out.push({ e, curve: [[0, low[0]], [1, low[1]]] }, { e, curve: [[0, high[0]], [1, high[1]]] });
        }
      } else if (this.envelope) { add(m.low); add(m.high); } else add(this.memberRow);
      at += columns;
    });
    return out;
  }

  drawDiagrams() {
    const c = this.context, { axes } = this.data.elements, curves = this.curves();
    const most = curves.reduce((m, { curve }) => Math.max(m, ...curve.map(p => Math.abs(p[1]))), 0);
    this.largest = most;
    if (!most) return;
    // Moments are drawn on the side in tension.
    const [axis, sign] = { N: [1, 1], Vy: [1, 1], Mz: [1, -1], Vz: [2, 1], T: [1, 1], My: [2, 1] }[this.diagram];
    const size = 0.1 * this.data.size * this.pixels / most, r = this.right, u = this.up;
    c.fillStyle = "#e69f0055";
    c.strokeStyle = "#b87700";
    c.lineWidth = 1;
    for (const { e, curve } of curves) {
      const nodes = this.nodesOf(e), o = 9 * e + 3 * axis;
      let v = [axes[o], axes[o + 1], axes[o + 2]];
      if (!v.some(x => x)) v = this.up;
      const dx = sign * size * (r[0] * v[0] + r[1] * v[1] + r[2] * v[2]), dy = -sign * size * (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
      const [x0, y0, x1, y1] = [0, 1].flatMap(k => [this.screen[2 * nodes[k]], this.screen[2 * nodes[k] + 1]]);
      c.beginPath();
      c.moveTo(x0, y0);
      for (const [t, f] of curve) c.lineTo(x0 + t * (x1 - x0) + f * dx, y0 + t * (y1 - y0) + f * dy);
      c.lineTo(x1, y1);
      c.fill();
      c.stroke();
    }
  }

  /** What lies at a place of the screen. */
  at(x, y) {
    const { nodes, elements } = this.data;
    let best = null, near = 14;
    const take = (distance, kind, at) => { if (distance < near) [near, best] = [distance, { kind, at }]; };
    for (let e = 0; e < elements.tags.length; e++) {
      if (this.hidden.has(elements.family[e])) continue;
      const of = this.nodesOf(e), family = elements.family[e];
      if (family === 2 || family === 3) {
        const [mx, my] = this.middle(of);
        take(Math.hypot(x - mx, y - my) - 4, "element", e);
      }
      for (const [i, j] of ModelView.edges(of.length)) {
        const [ax, ay, bx, by] = [i, j].flatMap(k => [this.screen[2 * of[k]], this.screen[2 * of[k] + 1]]);
        const l = (bx - ax) ** 2 + (by - ay) ** 2, t = l ? Math.min(Math.max(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / l, 0), 1) : 0;
        take(Math.hypot(x - ax - t * (bx - ax), y - ay - t * (by - ay)) + 3, "element", e);
      }
    }
    for (let n = 0; n < nodes.tags.length; n++) take(Math.hypot(x - this.screen[2 * n], y - this.screen[2 * n + 1]) - 1, "node", n);
    return best;
  }

  listen() {
    const { canvas } = this, pointers = new Map();
    let travel = 0;
    canvas.addEventListener("pointerdown", e => { canvas.setPointerCapture(e.pointerId); pointers.set(e.pointerId, e); travel = 0; });
    canvas.addEventListener("pointermove", e => {
      const last = pointers.get(e.pointerId);
      if (!last) return;
      const dx = e.clientX - last.clientX, dy = e.clientY - last.clientY;
      travel += Math.abs(dx) + Math.abs(dy);
      if (pointers.size === 2) {
        const other = [...pointers.values()].find(p => p.pointerId !== e.pointerId);
        const far = p => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY);
        this.zoom *= far(e) / Math.max(far(last), 1);
      }
      if (this.data.ndm < 3 || e.shiftKey || e.buttons === 4 || e.buttons === 2 || pointers.size === 2) this.move(dx, dy);
      else this.rotate(-0.008 * dx, 0.008 * dy);
      pointers.set(e.pointerId, e);
      this.draw();
    });
    const end = e => {
      if (pointers.delete(e.pointerId) && travel < 5 && e.type === "pointerup") {
        const box = canvas.getBoundingClientRect();
        this.pick(this.at(e.clientX - box.left, e.clientY - box.top));
      }
    };
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
    canvas.addEventListener("contextmenu", e => e.preventDefault());
    canvas.addEventListener("wheel", e => { e.preventDefault(); this.zoom *= Math.exp(-0.0012 * e.deltaY); this.draw(); }, { passive: false });
    canvas.addEventListener("keydown", e => {
      const keys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }, k = keys[e.key];
      if (k && (e.shiftKey || this.data.ndm < 3)) this.move(20 * k[0], 20 * k[1]);
      else if (k) this.rotate(0.08 * k[0], 0.08 * k[1]);
      else if (e.key === "+" || e.key === "=") this.zoom *= 1.2;
      else if (e.key === "-") this.zoom /= 1.2;
      else if (e.key === "0") this.reset();
      else return;
      e.preventDefault();
      this.draw();
    });
  }

  rotate(around, over) {
    this.turn = [this.turn[0] + around, Math.min(Math.max(this.turn[1] + over, -Math.PI / 2), Math.PI / 2)];
  }

  move(dx, dy) {
    this.shift = [this.shift[0] + dx, this.shift[1] + dy];
  }
}
