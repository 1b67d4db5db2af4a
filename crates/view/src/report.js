// Charts of a report, drawn anew so that they can be zoomed and asked; those of one heading move in step.
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#999999"];

async function unpacked(id) {
  const element = document.getElementById(id), bytes = Uint8Array.from(atob(element.textContent), c => c.charCodeAt(0));
  element.remove();
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).text();
}

let library = null;
function charts() {
  library ??= unpacked("library").then(text => {
    const script = document.createElement("script");
    script.textContent = text;
    document.head.append(script);
    return window.Plotly;
  });
  return library;
}

/** The heading that a chart stands under, and what is on its horizontal axis. */
function groupOf(figure, chart) {
  let heading = "";
  for (const h of document.querySelectorAll("h1, h2, h3, summary"))
    if (h.compareDocumentPosition(figure) & Node.DOCUMENT_POSITION_FOLLOWING) heading = h.textContent;
  return `${heading}\n${chart.x}`;
}

const groups = new Map();

async function draw(figure, chart) {
  const plotly = await charts(), place = document.createElement("div");
  place.className = "plot";
  figure.append(place);
  figure.classList.add("live");
  let colour = chart.colour;
  const traces = chart.curves.map(c => {
    const wide = c.mark === "wide", own = wide ? "#b5b5b5" : COLOURS[colour++ % COLOURS.length];
    return { name: c.name, x: c.x, y: c.y, mode: c.mark === "dots" ? "markers" : "lines", line: { width: wide ? 4 : 1.5, color: own }, marker: { size: 4, color: own }, type: "scatter" };
  });
  const axis = text => ({ title: { text, standoff: 8 }, gridcolor: "#ddd", zerolinecolor: "#999" });
  const layout = {
    title: { text: chart.title, font: { size: 14 }, x: 0.02 }, margin: { l: 70, r: 14, t: 58, b: 48 }, height: chart.equal ? 520 : 380, hovermode: chart.equal ? "closest" : "x",
    font: { family: "system-ui, sans-serif", size: 12, color: "#222" }, legend: { orientation: "h", y: 1.01, yanchor: "bottom", x: 0 }, showlegend: traces.filter(t => t.name).length > 1,
    xaxis: axis(chart.x), yaxis: axis(chart.y), paper_bgcolor: "#fff", plot_bgcolor: "#fff",
    shapes: chart.shaded.map(([x0, x1]) => ({ type: "rect", xref: "x", yref: "paper", x0, x1, y0: 0, y1: 1, fillcolor: "#e69f00", opacity: 0.15, line: { width: 0 } })),
  };
  if (chart.log) layout.yaxis.type = "log";
  if (chart.equal) layout.yaxis.scaleanchor = "x";
  await plotly.newPlot(place, traces, layout, { responsive: true, displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d"] });
  const group = groupOf(figure, chart), others = () => groups.get(group).filter(p => p !== place && p.isConnected);
  groups.set(group, [...(groups.get(group) ?? []), place]);
  // Only an axis of time is common to the charts of a heading.
  if (!/^time\b/i.test(chart.x)) return;
  let busy = false;
  place.on("plotly_relayout", e => {
    if (busy || place.following) return;
    const range = e["xaxis.range[0]"] !== undefined ? [e["xaxis.range[0]"], e["xaxis.range[1]"]] : e["xaxis.range"];
    if (!range && !e["xaxis.autorange"]) return;
    busy = true;
    const moved = others().map(p => { p.following = true; return plotly.relayout(p, range ? { "xaxis.range": range } : { "xaxis.autorange": true }).then(() => { p.following = false; }); });
    Promise.all(moved).then(() => { busy = false; });
  });
  place.on("plotly_hover", e => {
    if (place.following) return;
    for (const p of others()) { p.following = true; plotly.Fx.hover(p, { xval: e.points[0].x }); p.following = false; }
  });
  place.on("plotly_unhover", () => others().forEach(p => plotly.Fx.unhover(p)));
}

const seen = new IntersectionObserver(entries => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    seen.unobserve(target);
    draw(target, JSON.parse(target.querySelector("script.chart").textContent));
  }
}, { rootMargin: "300px" });
document.querySelectorAll("figure:has(> script.chart)").forEach(f => seen.observe(f));
document.documentElement.dataset.ready = "yes";
