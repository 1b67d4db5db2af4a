#!/usr/bin/env python3
"""Examples and tests of packages on top of openseespy, with openseespy and with hysteron in its place.

    validation/python_packages.py FOLDER --python PYTHON [--csv TABLE] [--each NUMBER] [--only WORD] [--cache FOLDER]

PYTHON has openseespy, hysteron and pytest, and what the packages need. FOLDER has the sources of the packages, unmodified, each in
a folder of its name: opsvis, opstool, vfo, o3seespy, ospgrillage. Each file of tests runs in a process of its own with either
program; of the tests that pass with openseespy those are counted that pass with hysteron too. Examples are scripts and notebooks in
folders of documents and examples that use the package. They run with either program, and draw. An example counts if openseespy runs
it to its end; it is equal if each answer of each call, in the order of the calls, differs by at most --tolerance of its peak.
"""
import argparse
import csv
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

from python_scripts import difference, run, text_of_script, wanted

#: Set in the processes of tests: the program that stands for openseespy.
PROGRAM = "PROGRAM_OF_THE_TESTS"
PACKAGES = ("opsvis", "opstool", "vfo", "o3seespy", "ospgrillage")
EXAMPLES = re.compile(r"(^|/)(docs?|examples?|notebooks|tutorials?|vfo_test)\b", re.I)
#: What asks for other programs: windows, several processes, a build of documents.
NOT_EXAMPLES = re.compile(r"tkinter|PyQt|mpi4py|\binput\s*\(|sphinx|gmsh\.fltk|(^|\n)\s*extensions\s*=")

if os.environ.get(PROGRAM) == "hysteron":
    import hysteron

    hysteron.install()


def environment(folder):
    """Of the processes: the package's own sources first, and pictures that open no window."""
    paths = [str(folder), str(folder / "src"), str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in paths if p), "MPLBACKEND": "Agg", "PYVISTA_OFF_SCREEN": "true",
            "PLOTLY_RENDERER": "json", "KEEP_PICTURES": "1"}  # fmt: skip


def outcomes(options, folder, file, program):
    """Outcome of each test of a file by its name: `passed`, or the message."""
    with tempfile.TemporaryDirectory() as work:
        table = Path(work) / "tests.xml"
        command = [options.python, "-m", "pytest", "-q", "-p", "python_packages", "-p", "no:cacheprovider", f"--junitxml={table}", file.name]
        limit = options.limit * (1 if program == "openseespy" else 2)
        try:
            subprocess.run(command, cwd=file.parent, env={**environment(folder), PROGRAM: program}, capture_output=True, timeout=limit)
        except subprocess.TimeoutExpired:
            return {"timeout": "timeout"}
        if not table.exists():
            return {"ends early": "the process ends early"}
        found = {}
        for case in ET.parse(table).getroot().iter("testcase"):
            wrong = next((e for e in case if e.tag in ("failure", "error", "skipped")), None)
            found[case.get("name")] = "passed" if wrong is None else f"{wrong.tag}: {(wrong.get('message') or '')[:200]}"
        return found


def tests(options, folder):
    """Rows of the tests of a package: kind, name, outcome, detail."""
    for file in sorted(p for p in folder.rglob("test_*.py") if "tests" in p.relative_to(folder).parts[:-1]):
        theirs, ours = (outcomes(options, folder, file, program) for program in ("openseespy", "hysteron"))
        for name, outcome in theirs.items():
            row = "test", f"{file.relative_to(folder)}::{name}"
            if outcome != "passed":
                yield *row, "OpenSees fails", outcome
            else:
                got = ours.get(name) or next(iter(ours.values()), "no test ran")
                yield *row, "equal" if got == "passed" else "differs", "" if got == "passed" else got


def examples(options, folder):
    """Rows of the examples of a package."""
    found = sorted(p for p in folder.rglob("*") if p.suffix in (".py", ".ipynb") and EXAMPLES.search(str(p.relative_to(folder))))
    uses = re.compile(rf"^\s*(?:import|from)\s+(?:{folder.name}|openseespy)\b", re.M)
    own = [p for p in found if not {"tests", "build"} & set(p.relative_to(folder).parts)]
    taken = [p for p in own if uses.search(text_of_script(p)) and not NOT_EXAMPLES.search(text_of_script(p))]
    for script in taken[: options.each]:
        row = "example", str(script.relative_to(folder))
        want = wanted(options, script)
        if want[0] != 0:
            yield *row, "OpenSees fails", (want[2].strip().splitlines() or [str(want[0])])[-1][:200]
            continue
        outcome, detail = difference(want, run(options, "hysteron", script), options.tolerance)
        if outcome != "equal" and difference(want, run(options, "compat", script), options.tolerance)[0] == "equal":
            outcome, detail = "equal", "with compat"
        yield *row, outcome, detail


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--python", default=sys.executable)
    parser.add_argument("--each", type=int, default=1000, help="examples of a package")
    parser.add_argument("--limit", type=float, default=120.0, help="seconds of an example or a file of tests")
    parser.add_argument("--tolerance", type=float, default=1e-4)
    parser.add_argument("--only", default="", help="a word in the name of the package")
    parser.add_argument("--cache", type=Path, help="folder that keeps what openseespy makes of examples")
    parser.add_argument("--csv", type=Path, help="table of all outcomes")
    options = parser.parse_args()
    rows = []
    for name in PACKAGES:
        folder = (options.folder / name).resolve()
        if options.only not in name or not folder.is_dir():
            continue
        os.environ.update(environment(folder))
        for of in (tests, examples):
            for row in of(options, folder):
                rows.append((name, *row))
                print(" | ".join(rows[-1])[:200], flush=True)
    print(f"{'':14}{'tests':>8}{'equal':>8}{'examples':>10}{'equal':>8}")
    for name in dict.fromkeys(r[0] for r in rows):
        of = {kind: [r for r in rows if r[:2] == (name, kind) and r[3] != "OpenSees fails"] for kind in ("test", "example")}
        equal = {kind: sum(r[3] == "equal" for r in found) for kind, found in of.items()}
        print(f"{name:14}{len(of['test']):8}{equal['test']:8}{len(of['example']):10}{equal['example']:8}")
    if options.csv:
        with options.csv.open("w", newline="", encoding="utf-8") as out:
            csv.writer(out, lineterminator="\n").writerows([("package", "kind", "name", "outcome", "detail"), *rows])
    return 0


if __name__ == "__main__":
    sys.exit(main())
