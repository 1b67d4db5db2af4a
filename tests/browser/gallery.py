#!/usr/bin/env python3
"""Makes the pictures of docs/gallery.md from the shipped inputs, in a real browser.

    tests/browser/gallery.py [--engine HYSTERON] [--browser CHROMIUM] [--only NAME ...]

Python 3.9 with playwright and pillow from PyPI, and Chromium.
"""
import argparse
import io
import shutil
import subprocess
import tempfile
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

ROOT = Path(__file__).resolve().parents[2]
GALLERY = ROOT / "docs/gallery"

INPUTS = "tcl-like-inputs"
# Name of the picture: command, page or drawing that it writes below its --out (none: --out itself), element or node to choose,
# height in pixels, whether it is dark.
PICTURES = {
    "building": (["view", f"{INPUTS}/isolated_building.tcl", "--modes", "3", "--units", "kN", "m"], None, "element 1", 800, False),
    "orbit": (["view", f"{INPUTS}/rubber_bearings_orbit.tcl", "--units", "N", "m"], None, "element 1", 800, True),
    "bridge": (["view", f"{INPUTS}/bridge_study/bridge.tcl", "--modes", "3"], None, "element 1", 800, False),
    "eight_storeys": (["view", f"{INPUTS}/eight_storey_study/building.tcl", "--modes", "3"], None, "element 1", 800, True),
    "pendulum": (["view", f"{INPUTS}/friction_pendulum.tcl"], None, "element 1", 800, False),
    "portal": (["view", f"{INPUTS}/yielding_portal.tcl"], None, "element 2", 800, True),
    "loops": (["bearing", "models/lrb.tcl", "--amplitudes", "0.07,0.14,0.28", "--axial", "3e6", "--units", "N", "m"], "loops.svg", None, 720, False),
    "calibration": (["calibrate", f"{INPUTS}/pad_study/study.toml"], "report.html", None, 1100, False),
    "none": (["diagnose", f"{INPUTS}/pad_study/study.toml", "--view"], "report_interactive.html", None, 1100, True),
    "diagnosis": (["diagnose", f"{INPUTS}/hdr_heating_study/study.toml", "--view"], "report_interactive.html", None, 1500, False),
    "isolation": (["isolate", f"{INPUTS}/isolation_study/study.toml"], "report.html", None, 1300, False),
    "review": (["run", f"{INPUTS}/isolated_building.tcl", "--review"], "review.html", None, 1100, True),
}


def chosen(page, label):
    """Choose an element or a node of a model's page, half of the motion done."""
    page.fill('input[aria-label^="Find"]', label)
    page.keyboard.press("Enter")
    page.wait_for_selector(".panel .js-plotly-plot .main-svg")
    page.evaluate("""() => { const t = document.querySelector('input[aria-label="Time"]');
        t.value = t.max / 5; t.dispatchEvent(new Event("input")); }""")
    page.evaluate("""() => { const label = [...document.querySelectorAll("label")].find(l => l.textContent.startsWith("forces"));
        const select = label?.querySelector("select"); if (select) { select.value = "Mz"; select.dispatchEvent(new Event("change")); } }""")


def ordered(command, out):
    """A command with the place of its results."""
    if command[0] != "run":
        return [*command, "--out", str(out)]
    verb, script, *options = command
    return [verb, "--out", str(out), *options, str(out / "review.html"), script]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--browser", default=shutil.which("chromium") or shutil.which("google-chrome"))
    parser.add_argument("--only", nargs="*", choices=PICTURES)
    args = parser.parse_args()
    engine = str(Path(args.engine).resolve())
    GALLERY.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=args.browser, args=["--no-sandbox"])
        for name, (command, report, label, height, dark) in PICTURES.items():
            if args.only and name not in args.only:
                continue
            out = Path(folder) / (name if report else f"{name}.html")
            subprocess.run([engine, *ordered(command, out)], cwd=ROOT, check=True, capture_output=True)
            # Two pixels of the picture for one of the page: sharp on paper too.
            page = browser.new_page(
                viewport={"width": 1280, "height": height}, color_scheme="dark" if dark else "light", device_scale_factor=2
            )
            page.goto((out / report if report else out).as_uri())
            page.wait_for_timeout(1500)
            if label:
                chosen(page, label)
            page.wait_for_timeout(1500)
            picture = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
            picture.save(GALLERY / f"{name}.webp", quality=60, method=6)
            print(f"{name}: {(GALLERY / f'{name}.webp').stat().st_size // 1024} kB", flush=True)
            page.close()
        browser.close()


if __name__ == "__main__":
    main()
