#!/usr/bin/env python3
"""Writes a script in Visual Studio Code as a user would, with the extension of `editors/vscode`.

    tests/browser/editor.py --server ENTRY --extension VSIX [--engine HYSTERON] [--browser CHROMIUM] [--out DIR]

ENTRY is `out/node/entry.js` of npm's `code-server`, which serves Visual Studio Code to a browser; VSIX is what
`npm run package` in `editors/vscode` makes. Checked are: a mistake gets its line and its message, and both go away with it;
hover, completion and definition know the script; a lens over a bearing asks for an amplitude and shows the loop.
DIR gets pictures. Python 3.9 with playwright, Node.js and Chromium; exit status 1 where something is wrong.
"""
import argparse
import json
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from playwright.sync_api import sync_playwright

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """model basic -ndm 2 -ndf 3
node 1 0 0
node 2 0 0
fix 1 1 1 1
mass 2 10 10 0
uniaxialMaterial Steel01 7 50 5000 0.1
element zeroLngth 11 1 2 -mat 7 -dir 1
"""
SECONDS = 30_000


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def start(args, folder):
    """Start the server on a folder with the extension; the process and its address."""
    own = folder / "editor"
    (own / "data/User").mkdir(parents=True)
    (own / "extensions").mkdir()
    (own / "extensions/extensions.json").write_text("[]")
    settings = {
        "hysteron.path": str(Path(args.engine).resolve()),
        "security.workspace.trust.enabled": False,
        "workbench.startupEditor": "none",
        "telemetry.telemetryLevel": "off",
        "editor.hover.delay": 100,
    }
    (own / "data/User/settings.json").write_text(json.dumps(settings))
    base = ["node", args.server, "--user-data-dir", own / "data", "--extensions-dir", own / "extensions"]
    subprocess.run([*base, "--install-extension", args.extension], check=True, stdout=subprocess.DEVNULL)
    port = free_port()
    log = open(own / "log", "w")
    process = subprocess.Popen([*base, "--auth", "none", "--bind-addr", f"127.0.0.1:{port}", "--disable-telemetry"], stdout=log, stderr=log)
    for _ in range(100):
        with socket.socket() as s:
            if s.connect_ex(("127.0.0.1", port)) == 0:
                return process, f"http://127.0.0.1:{port}/?folder={folder}/work"
        time.sleep(0.1)
    raise SystemExit("the server of the editor does not start")


class Editor:
    def __init__(self, page, out):
        self.page, self.out, self.wrong = page, out, []

    def holds(self, what, selector, text=None, gone=False):
        """Wait for an element, with a text in it, or for its end."""
        found = self.page.locator(selector).filter(has_text=text) if text else self.page.locator(selector)
        try:
            found.first.wait_for(state="hidden" if gone else "visible", timeout=SECONDS)
            print(f"{what}: yes")
        except Exception:
            self.wrong.append(what)
            print(f"{what}: NO")
        if self.out:
            self.page.screenshot(path=self.out / f"{what.replace(' ', '_')}.png")

    def line(self, number, column=1):
        self.page.keyboard.press("Control+g")
        self.page.keyboard.type(f"{number}:{column}")
        self.page.keyboard.press("Enter")


def use(page, out):
    e = Editor(page, out)
    page.get_by_role("treeitem", name="model.tcl").dblclick(timeout=2 * SECONDS)
    e.holds("a mistake is underlined", ".squiggly-error")
    page.keyboard.press("Control+Shift+m")
    e.holds("the message names the nearest kind", ".markers-panel", "did you mean \"zeroLength\"")
    page.keyboard.press("Control+Shift+m")
    page.locator(".view-lines").first.click()
    e.line(7, 14)
    page.keyboard.type("e")
    e.holds("the mistake goes away", ".squiggly-error", gone=True)
    e.line(7, 25)
    page.keyboard.press("Control+k")
    page.keyboard.press("Control+i")
    e.holds("hover knows the node", ".monaco-hover", "node 2")
    page.keyboard.press("Escape")
    e.line(8)
    page.keyboard.type("uniaxialMaterial Stee")
    page.keyboard.press("Control+Space")
    e.holds("completion offers a kind", ".suggest-widget", "Steel02")
    page.keyboard.press("Escape")
    for _ in range(len("uniaxialMaterial Stee")):
        page.keyboard.press("Backspace")
    e.line(7, 32)
    page.keyboard.press("F12")
    e.holds("definition goes to the material", ".statusbar", "Ln 6")
    e.holds("a lens stands over the bearing", ".codelens-decoration", "Plot the loop of bearing 11")
    page.locator(".codelens-decoration a").filter(has_text="Plot the loop").first.click()
    e.holds("an amplitude is asked for", ".quick-input-widget", "Amplitudes of the displacement")
    page.keyboard.type("0.05,0.1")
    page.keyboard.press("Enter")
    e.holds("the loop is shown", ".tab", "loops.svg")
    return e.wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--server", required=True)
    parser.add_argument("--extension", required=True)
    parser.add_argument("--engine", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--browser", default=shutil.which("chromium"))
    parser.add_argument("--out", type=Path)
    args = parser.parse_args()
    if args.out:
        args.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary, sync_playwright() as play:
        folder = Path(temporary)
        (folder / "work").mkdir()
        (folder / "work/model.tcl").write_text(SCRIPT)
        process, address = start(args, folder)
        try:
            browser = play.chromium.launch(executable_path=args.browser, args=["--no-sandbox"])
            page = browser.new_page(viewport={"width": 1280, "height": 800})
            page.goto(address)
            wrong = use(page, args.out)
            if (folder / "work/model_11_test/cycles.csv").exists() is False:
                wrong.append("the test of the bearing has written no cycles")
            browser.close()
        finally:
            process.terminate()
            process.wait()
    for what in wrong:
        print(f"wrong: {what}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
