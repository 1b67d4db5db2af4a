#!/usr/bin/env python3
"""Opens reports in a real browser and looks at them as a reader would.

    tests/browser/check.py [--engine HYSTERON] [--browser CHROMIUM] [--out DIR] [REPORT.html ...]

Without reports it makes those of a calibration, of a diagnosis and of driven bearings. Of each page it is asked, as the browser lays it out: nothing is fetched from elsewhere;
the first sentence comes before the first picture; no letters lie over each other or outside their picture; letters are no smaller than 9 px, on
paper too; axes have names, and units where they have any; curves of a chart with several have a legend; nothing is wider than the page,
also on a phone of 390 px; it prints on ten pages at most. DIR gets pictures of each page and what it prints as.
Python 3.9 and Chromium; exit status 1 where something is wrong.
"""
import argparse
import html
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Width of a phone in px, and pages of paper at most.
PHONE = 390
MOST_PAGES = 10

# Runs in the page. Letters touch where their boxes, less a little, have a common part.
LOOK = r"""
<script>
addEventListener("load", () => {
  const wrong = [], shown = e => e.getBoundingClientRect();
  const name = e => JSON.stringify((e.textContent || "").trim().slice(0, 40));
  const inside = (a, b, slack) => a.left >= b.left - slack && a.right <= b.right + slack && a.top >= b.top - slack && a.bottom <= b.bottom + slack;
  for (const [k, svg] of [...document.querySelectorAll("svg")].entries()) {
    const where = `picture ${k + 1}`, box = shown(svg);
    const texts = [...svg.querySelectorAll("text")].filter(t => t.textContent.trim());
    texts.forEach((t, i) => {
      const a = shown(t), size = /rotate/.test(t.getAttribute("transform")) ? a.width : a.height;
      if (!inside(a, box, 2)) wrong.push(`${where}: ${name(t)} is cut off`);
      if (t.textContent.trim().length > 1 && size < 9) wrong.push(`${where}: ${name(t)} is ${size.toFixed(1)} px high`);
      for (const u of texts.slice(i + 1)) {
        const b = shown(u);
        const w = Math.min(a.right, b.right) - Math.max(a.left, b.left), h = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        if (w > 1 && h > 3) wrong.push(`${where}: ${name(t)} lies over ${name(u)}`);
      }
    });
    const curves = new Set([...svg.querySelectorAll("polyline")].filter(p => p.points.numberOfItems > 2).map(p => p.getAttribute("stroke")));
    const words = texts.map(t => t.textContent.trim()).filter(t => isNaN(t));
    if (words.length < 3) wrong.push(`${where}: title or names of the axes are missing (${words})`);
    if (curves.size > 1 && words.length < 3 + curves.size) wrong.push(`${where}: ${curves.size} curves and no legend`);
    if (!svg.querySelector("polyline, circle, rect")) wrong.push(`${where}: nothing is drawn`);
  }
  const width = document.documentElement.clientWidth;
  // What scrolls by itself may be wider than the page.
  const scrolls = e => e && (getComputedStyle(e).overflowX === "auto" ? shown(e).right <= width + 1 : scrolls(e.parentElement));
  for (const e of document.querySelectorAll("table, svg, p, h1, h2, pre"))
    if (shown(e).right > width + 1 && !scrolls(e.parentElement)) wrong.push(`${e.tagName} ${name(e)} is wider than the page`);
  for (const e of document.querySelectorAll("[src], link, a[href^=http]")) wrong.push(`${e.tagName} is fetched from elsewhere`);
  const first = document.querySelector("p"), picture = document.querySelector("svg");
  if (first && picture && first.compareDocumentPosition(picture) & 2) wrong.push("a picture comes before the first sentence");
  const pictures = document.querySelectorAll("svg").length;
  parent.document.documentElement.innerHTML = "<pre id=found>" + JSON.stringify({wrong, pictures, height: document.body.scrollHeight}) + "</pre>";
});
</script>
"""


def browse(browser, *options):
    with tempfile.TemporaryDirectory() as profile:
        command = [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--user-data-dir={profile}", *options]
        return subprocess.run(command, capture_output=True, text=True, timeout=180).stdout


def look(browser, page, out):
    """What is wrong with a page at the width of a screen and of a sheet of paper."""
    text = page.read_text()
    wrong = [f"asks for {u}" for u in re.findall(r"""(?:src|href)=["'](?!data:|#)([^"']+)""", text)]
    pictures = height = 0
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "page.html"
        copy.write_text(text.replace("</body>", LOOK + "</body>"))
        # A browser without a head has no window as narrow as a phone: the page stands in a frame there.
        frame = Path(folder) / "frame.html"
        frame.write_text(f'<body style="margin:0"><iframe width={PHONE} height=1000 style="border:0" srcdoc="{html.escape(copy.read_text())}"></iframe>')
        for medium, width, shown in (("screen", 1100, copy), ("paper", 720, copy), ("phone", 600, frame)):
            dom = browse(browser, f"--window-size={width},1000", "--virtual-time-budget=5000", "--dump-dom", shown.as_uri())
            found = re.search(r'<pre id="?found"?>(.*?)</pre>', dom, re.S)
            if not found:
                wrong.append(f"{medium}: the browser shows nothing")
                continue
            found = json.loads(html.unescape(found[1]))
            pictures = found["pictures"]
            wrong += [f"{medium}: {w}" for w in found["wrong"]]
        frame.write_text(
            f'<body style="margin:0"><iframe width={PHONE} height=12000 style="border:0" srcdoc="{html.escape(text)}"></iframe>'
        )
        stem = f"{page.parent.name}-{page.stem}"
        browse(browser, f"--screenshot={out / stem}-phone.png", "--window-size=500,12000", frame.as_uri())
    browse(browser, f"--screenshot={out / stem}.png", "--window-size=1100,3200", page.resolve().as_uri())
    browse(browser, f"--print-to-pdf={out / stem}.pdf", "--no-pdf-header-footer", page.resolve().as_uri())
    printed = out / f"{stem}.pdf"
    if not printed.exists() or printed.stat().st_size < 2000:
        wrong.append("it cannot be printed")
        return pictures, wrong
    pages = len(re.findall(rb"/Type\s*/Page\b", printed.read_bytes()))
    if pages > MOST_PAGES:
        wrong.append(f"it prints on {pages} pages, more than {MOST_PAGES}")
    return pictures, wrong


def made(engine, out):
    """Reports of the examples in the repository."""
    jobs = [
        ([engine, "calibrate", ROOT / "tcl-like-inputs/pad_study/study.toml", "--out", out / "calibration"], out / "calibration/report.html"),
        (
            [sys.executable, ROOT / "validation/diagnosis/run.py", "--engine", engine, "--batch", "1", "--case", "basalt", "--out", out / "diagnosis"],
            out / "diagnosis/batch-1/results/basalt/report.html",
        ),
    ]
    for words, report in jobs:
        subprocess.run([*map(str, words)], check=True, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        yield report
    for motion in ("cycles", "circles"):
        folder = out / f"bearing-{motion}"
        words = ["bearing", ROOT / "models/lrb.tcl", "--amplitudes", "0.05,0.1,0.2", "--motion", motion, "--axial", "1.0e6", "-o", folder]
        subprocess.run([engine, *map(str, words)], check=True, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        page = folder / "loops.html"
        page.write_text(f"<style>svg {{ max-width: 100%; height: auto }}</style><body><p>A lead rubber bearing, {motion}.</p>{(folder / 'loops.svg').read_text()}</body>")
        yield page


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reports", nargs="*", type=Path, metavar="REPORT.html")
    parser.add_argument("--engine", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--browser", default=shutil.which("chromium") or shutil.which("google-chrome") or "chromium")
    parser.add_argument("--out", type=Path, default=Path("results/browser"))
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    bad = False
    for page in args.reports or made(args.engine, args.out.resolve()):
        pictures, wrong = look(args.browser, page, args.out)
        bad |= bool(wrong)
        print(f"{page}: {pictures} pictures, {len(wrong)} faults")
        for w in wrong:
            print(f"  {w}")
    sys.exit(bad)


if __name__ == "__main__":
    main()
