#!/usr/bin/env python3
"""Opens pages of `hysteron view` in a real browser and uses them as a reader would.

    tests/browser/view.py [--engine HYSTERON] [--browser CHROMIUM] [--out DIR]

Each page is opened at 1280 px and, in dark mode, at 390 px: it draws the model, plays, answers clicks on the model and in the table, shows modes and
section forces, asks for nothing from elsewhere and logs no error; nothing is wider than the window. The files for ParaView are read with meshio, and their
displacements and forces compared with those that recorders write. DIR gets pictures of the pages.
Python 3.9 with playwright, meshio and numpy from PyPI, and Chromium; exit status 1 where something is wrong.
"""
import argparse
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import meshio
import numpy
from playwright.sync_api import sync_playwright

ROOT = Path(__file__).resolve().parents[2]
# Script, options, and what is chosen in the page.
PAGES = [
    ("tcl-like-inputs/isolated_building.tcl", ["--modes", "3", "--units", "kN", "m"], "element 1"),
    ("tcl-like-inputs/yielding_portal.tcl", [], "element 2"),
    ("tcl-like-inputs/rubber_bearings_orbit.tcl", ["--units", "kN", "m"], None),
    ("validation/opensees/rc_fiber_pushover/model.tcl", ["--units", "kN", "m"], "element 1"),
    ("validation/opensees/shells_bricks/model.tcl", [], "node 3"),
]
# The share of pixels of the canvas that are not of its commonest colour.
DRAWN = """() => { const c = document.querySelector("canvas"), d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data, n = new Map();
for (let i = 0; i < d.length; i += 4) { const k = d[i] << 24 | d[i+1] << 16 | d[i+2] << 8 | d[i+3]; n.set(k, (n.get(k) ?? 0) + 1); }
return 1 - Math.max(...n.values()) / (d.length / 4); }"""
MIDDLE = """([kind, tag]) => { const {view, data} = hysteronView, box = view.canvas.getBoundingClientRect();
const at = data[kind + "s"].tags.indexOf(tag), [x, y] = kind === "node" ? [view.screen[2 * at], view.screen[2 * at + 1]] : view.middle(view.nodesOf(at));
return [box.left + x, box.top + y]; }"""


class Check:
    def __init__(self, name):
        self.name, self.wrong = name, []

    def holds(self, condition, what):
        if not condition:
            self.wrong.append(what)


def choose(page, label, value):
    page.evaluate(
        """([text, value]) => { const label = [...document.querySelectorAll("label")].find(l => l.textContent.startsWith(text));
        const select = label.querySelector("select"); select.value = value; select.dispatchEvent(new Event("change")); }""",
        [label, value],
    )


def use(browser, path, chosen, width, dark, out):
    """What is wrong with a page at a width of the window."""
    check = Check(f"{path.stem} at {width} px")
    page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme="dark" if dark else "light")
    page.on("console", lambda m: check.holds(m.type not in ("error", "warning"), f"console: {m.text[:200]}"))
    page.on("pageerror", lambda e: check.wrong.append(f"error: {e}"))
    page.on("request", lambda r: check.holds(r.url == path.as_uri() or r.url.startswith(("data:", "blob:")), f"asks for {r.url[:120]}"))
    page.goto(path.as_uri())
    page.wait_for_function('document.documentElement.dataset.ready === "yes"')
    check.holds(page.evaluate(DRAWN) > 0.001, "the model is not drawn")
    if chosen:
        page.fill('input[aria-label^="Find"]', chosen)
        page.keyboard.press("Enter")
        page.wait_for_selector(".panel .js-plotly-plot .main-svg")
        kind, tag = chosen.split()
        head = page.text_content(".panel h2")
        check.holds(head.lower().startswith(chosen), f"{chosen} is chosen, shown is {head}")
        page.evaluate("document.querySelector('canvas').scrollIntoView({block: 'center'})")
        page.mouse.click(*page.evaluate(MIDDLE, [kind, int(tag)]))
        page.wait_for_timeout(300)
        check.holds(page.locator(".panel h2").count() == 1, "a click on the model shows nothing")
    steps = page.evaluate("hysteronView.data.times.length")
    if steps > 2:
        before = page.input_value('input[aria-label="Time"]')
        page.click('button[aria-label="Play"]')
        page.wait_for_timeout(1200)
        page.locator("button[aria-label=Pause], button[aria-label=Play]").click()
        check.holds(page.input_value('input[aria-label="Time"]') != before, "it does not play")
        row = page.locator(".peaks tbody tr").first
        name = row.locator("td").first.text_content()
        row.click()
        page.wait_for_timeout(500)
        check.holds(page.text_content(".panel h2").lower().startswith(name), "a click in the table of peaks chooses nothing")
        head = page.locator(".peaks th button").nth(4)
        head.click()
        times = [float(t) for t in page.locator(".peaks tbody td:nth-child(5)").all_text_contents()]
        check.holds(times == sorted(times) and len(times) > 2, "a click on a head does not sort")
    if page.evaluate("hysteronView.data.modes.length"):
        choose(page, "show", "0")
        page.wait_for_timeout(200)
        check.holds("T =" in page.text_content("output"), "no period of a mode")
        choose(page, "show", "-1")
    if page.evaluate("hysteronView.data.members.elements.length"):
        for force in page.evaluate("""[...[...document.querySelectorAll("label")].find(l => l.textContent.startsWith("forces")).querySelectorAll("option")].map(o => o.value)"""):
            choose(page, "forces", force)
        choose(page, "forces", "Mz")
    page.wait_for_timeout(800)
    check.holds(page.evaluate("document.documentElement.scrollWidth <= innerWidth + 1"), "it is wider than the window")
    page.screenshot(path=str(out / f"{path.stem}-{width}.png"), full_page=True)
    if width > 1000:
        page.pdf(path=str(out / f"{path.stem}.pdf"))
    page.close()
    return check




def vtk(engine, out):
    """What is wrong with the files for ParaView of a model whose recorders write the same."""
    check = Check("files for ParaView")
    model = out / "vtk_model.tcl"
    model.write_text(
        "model BasicBuilder -ndm 3 -ndf 6\nnode 7 0 0 0\nnode 3 0 0 3\nnode 5 2 0 3\nfix 7 1 1 1 1 1 1\nmass 5 10 10 10 1 1 1\n"
        "geomTransf Linear 1 0 1 0\nelement elasticBeamColumn 2 7 3 0.01 2e7 8e6 1e-5 2e-5 1e-5 1\nelement elasticBeamColumn 1 3 5 0.01 2e7 8e6 1e-5 2e-5 1e-5 1\n"
        "timeSeries Trig 1 0 10 0.5\npattern Plain 1 1 { load 5 3 2 -5 0.1 0.2 0.3 }\n"
        "recorder Node -file disp.out -precision 16 -node 3 5 7 -dof 1 2 3 disp\nrecorder Node -file vel.out -precision 16 -node 3 5 7 -dof 1 2 3 vel\n"
        "recorder Node -file rot.out -precision 16 -node 3 5 7 -dof 4 5 6 disp\nrecorder Element -file force.out -precision 16 -ele 1 2 force\n"
        "recorder Node -file reaction.out -precision 16 -node 3 5 7 -dof 1 2 3 reaction\nrecorder PVD pvd/motion disp reaction eleResponse localForce\n"
        "recorder Element -file local.out -precision 16 -ele 1 2 localForce\n"
        "constraints Plain\nintegrator Newmark 0.5 0.25\nanalysis Transient\nanalyze 20 0.02\n"
    )
    subprocess.run([engine, "run", "--out", str(out / "recorded"), str(model)], check=True, cwd=out)
    subprocess.run([engine, "view", "--vtk", str(out / "vtk"), str(model)], check=True, cwd=out)
    files = [d.get("file") for d in ElementTree.parse(out / "vtk/motion.pvd").getroot().iter("DataSet")]
    check.holds(len(files) == 21, f"{len(files)} files for 20 steps")
    read = [meshio.read(out / "vtk" / f) for f in files]
    check.holds(read[0].points.tolist() == [[0, 0, 3], [2, 0, 3], [0, 0, 0]], "points are not the nodes by rising tag")
    check.holds(numpy.concatenate([c.data for c in read[0].cells]).tolist() == [[0, 1], [2, 0]], "cells are not the elements by rising tag")
    for field, name in (("Displacement", "disp"), ("Velocity", "vel"), ("DisplacementRotation", "rot")):
        recorded = numpy.loadtxt(out / f"recorded/{name}.out")
        seen = numpy.array([m.point_data[field].ravel() for m in read[1:]])
        check.holds(numpy.abs(recorded).max() > 0 and numpy.allclose(seen, recorded, rtol=1e-12, atol=0), f"{field} is not what the recorder writes")
    recorded = numpy.loadtxt(out / "recorded/force.out").reshape(20, 2, 12)
    seen = numpy.array([numpy.concatenate([numpy.concatenate(m.cell_data[k]) for k in ("Force1", "Moment1", "Force2", "Moment2")], axis=1) for m in read[1:]])
    check.holds(numpy.allclose(seen, recorded, rtol=1e-12, atol=1e-12), "end forces are not what the recorder writes")
    listed = [d.get("file") for d in ElementTree.parse(out / "recorded/pvd/motion.pvd").getroot().iter("DataSet")]
    read = [meshio.read(out / "recorded/pvd" / f) for f in listed]
    for name, seen in (
        ("disp", [m.point_data["Displacement"].ravel() for m in read]),
        ("reaction", [m.point_data["Reaction"].ravel() for m in read]),
        ("local", [numpy.concatenate(m.cell_data["localForce"]).ravel() for m in read]),
    ):
        recorded = numpy.loadtxt(out / f"recorded/{name}.out")
        check.holds(numpy.allclose(numpy.array(seen), recorded, rtol=1e-12, atol=1e-15), f"recorder PVD: {name} is not what the recorder of numbers writes")
    return check


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--browser", default=shutil.which("chromium") or shutil.which("google-chrome"))
    parser.add_argument("--out", type=Path, default=Path("results/browser-view"))
    args = parser.parse_args()
    out = args.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    engine = str(Path(args.engine).resolve())
    checks = [vtk(engine, out)]
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=args.browser, args=["--no-sandbox"])
        for script, options, chosen in PAGES:
            script = ROOT / script
            page = out / f"{script.parent.name if script.stem == 'model' else script.stem}.html"
            made = subprocess.run([engine, "view", *options, "--out", str(page), script.name], cwd=script.parent, capture_output=True, text=True)
            if not page.exists():
                sys.exit(f"{script}: no page\n{made.stderr}")
            for width, dark in ((1280, False), (390, True)):
                checks.append(use(browser, page, chosen, width, dark, out))
        browser.close()
    for check in checks:
        print(f"{check.name}: {len(check.wrong)} faults")
        for w in check.wrong:
            print(f"  {w}")
    sys.exit(any(c.wrong for c in checks))


if __name__ == "__main__":
    main()
