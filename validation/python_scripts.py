#!/usr/bin/env python3
"""Share of a folder of openseespy scripts that hysteron runs with openseespy's numbers.

    validation/python_scripts.py FOLDER --python PYTHON [--csv TABLE]

PYTHON has openseespy and hysteron, and the packages of the scripts. FOLDER has one folder a repository. A script or notebook is
taken if it imports openseespy, builds a model, analyses it, and no other script of its repository imports it; of each repository
at most --each scripts, chosen by a hash of their paths. Each script runs with openseespy and with `hysteron.install()`, both in a
copy of its folder and for at most --limit seconds. It counts if it is within scope and openseespy runs it to its end with numbers.
It is equal if each answer of each call, in the order of the calls, and every column of every file differs by at most --tolerance
of its peak; without either, the numbers that it prints are compared. `--compat` tries OpenSees' slips where the default differs or
refuses.
"""
import argparse
import hashlib
import json
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

import scripts
from scripts import OUT_OF_SCOPE, compare, has_numbers, report, table, text_of

IMPORTS = re.compile(r"^[ \t]*(?:import|from)[ \t]+(?:openseespy|opensees)\b", re.M)
BUILDS = re.compile(r"\b(?:node|block2D|block3D)\s*\(")
ANALYSES = re.compile(r"\b(?:analyze|eigen)\s*\(")
LOCAL = re.compile(r"^[ \t]*(?:import|from)[ \t]+\.?(\w+)", re.M)
EXECUTES = re.compile(r"(?:exec|open|run)\w*\s*\(\s*(?:open\s*\(\s*)?[rf]?[\"']([^\"']+\.py)[\"']")
# What is out of scope beside the words of scripts in Tcl: several processes, meshes of fluids, gradients, questions to a person.
NOT_HERE = re.compile(
    r"\bpartition\s*\(|\bpartition2|remesh\s*\(|\bmesh\s*\(|computeGradients|sensNodeDisp|mpi4py|\bIGA\s*\(|\binput\s*\(|tkinter|PyQt"
)
# Calls whose answers are of the machine, not of the model.
NOT_COMPARED = {"version", "pyversion", "accelCPU", "solveCPU", "totalCPU", "numIter", "numFact", "testIter", "testNorm", "testNorms",
                "recorder", "logFile", "systemSize", "getNumThreads"}
# Modes have no sign, and equal frequencies no order.
MODES = {"nodeEigenvector", "modalProperties"}
# Forces of which nothing but round-off is left.
FORCES = {"nodeReaction", "nodeUnbalance", "eleForce", "eleResponse", "basicForce", "localForce"}
NO_FORCE = 1e-8
ANSWERS = 200_000


def runner(kind, script, log):
    """Run a script with `kind` in the place of openseespy, and write the answers of its calls to `log`."""
    import builtins
    import types
    import warnings

    os.environ["MPLBACKEND"] = "Agg"
    warnings.simplefilter("ignore")
    if kind == "openseespy":
        import openseespy.opensees as real
    else:
        import hysteron

        real = hysteron.install(**({"compat": True} if kind == "compat" else {}))
    try:
        import matplotlib

        matplotlib.use("Agg")
    except ImportError:
        pass
    module = types.ModuleType("openseespy.opensees")
    out = open(log, "w", encoding="utf-8")
    count = 0

    def wrapped(name, function):
        def call(*args, **kwargs):
            nonlocal count
            answer = function(*args, **kwargs)
            if answer is not None and name not in NOT_COMPARED and count < ANSWERS:
                count += 1
                values = list(numbers(answer))
                if name == "analyze":
                    values = [float(values[0] != 0)]
                words = " ".join(str(a) for a in args)[:60]
                out.write(json.dumps([name, words, values]) + "\n")
            return answer

        return call

    for name in dir(real):
        if not name.startswith("_"):
            value = getattr(real, name)
            setattr(module, name, wrapped(name, value) if callable(value) and not isinstance(value, type) else value)
    sys.modules["openseespy.opensees"] = sys.modules["opensees"] = module
    sys.modules["openseespy"].opensees = module
    import openseespy.postprocessing  # noqa: F401

    for name in () if os.environ.get("KEEP_PICTURES") else PICTURES:
        sys.modules[name] = picture = Picture(name)
        parent, _, child = name.rpartition(".")
        if parent:
            setattr(sys.modules[parent], child, picture)
    change = os.chdir
    os.chdir = lambda path: change(path) if os.path.isdir(path) else None
    builtins.input = lambda *_: ""
    sys.argv = [script]
    sys.path.insert(0, os.getcwd())
    code = compile(open(script, encoding="utf-8", errors="replace").read(), script, "exec")
    main = types.ModuleType("__main__")
    main.__file__ = script
    sys.modules["__main__"] = main
    status = 0
    try:
        exec(code, main.__dict__)
    except SystemExit as end:
        status = 0 if end.code in (None, 0) else 1
    finally:
        out.close()
        real.wipe()
    sys.stdout.flush()
    os._exit(status)


class Picture(type(sys)):
    """A module of pictures that draws nothing: programs that draw differ by their versions."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_, **__: None


PICTURES = ("vfo", "vfo.vfo", "openseespy.postprocessing.Get_Rendering", "openseespy.postprocessing.ops_vis", "opsvis")


def numbers(answer):
    if isinstance(answer, dict):
        for value in answer.values():
            yield from numbers(value)
    elif isinstance(answer, (list, tuple)) or type(answer).__name__ == "ndarray":
        for value in answer:
            yield from numbers(value)
    elif isinstance(answer, (int, float)):
        yield float(answer)


def of_notebook(path):
    """Code of a notebook without magics."""
    try:
        cells = json.loads(text_of(path)).get("cells", [])
    except ValueError:
        return ""
    code = ["".join(c.get("source", [])) for c in cells if c.get("cell_type") == "code"]
    lines = [line for c in code if not c.startswith("%%") for line in [*c.splitlines(), ""]]
    return "\n".join(re.sub(r"^(\s*)[%!].*", r"\1pass", line) for line in lines)


def text_of_script(path):
    return of_notebook(path) if path.suffix == ".ipynb" else text_of(path)


def entries(repository, each, known):
    """Scripts of a repository that stand alone, no two with the same text, and the number of those out of scope."""
    found = sorted(p for p in repository.rglob("*") if p.suffix in (".py", ".ipynb") and p.is_file() and "checkpoint" not in str(p))
    texts = {p: text_of_script(p) for p in found}
    by_folder = {(p.parent, p.stem): p for p in found}
    imported = {by_folder.get((p.parent, name)) for p, t in texts.items() for name in LOCAL.findall(t)}
    imported |= {p.parent / name for p, t in texts.items() for name in EXECUTES.findall(t)}

    def closure(path, seen):
        seen.add(path)
        near = [by_folder.get((path.parent, n)) for n in LOCAL.findall(texts[path])] + [path.parent / n for n in EXECUTES.findall(texts[path])]
        return "\n".join([texts[path], *(closure(p, seen) for p in near if p in texts and p not in seen)])

    inside, outside = [], 0
    for script in sorted(found, key=lambda p: hashlib.sha1(str(p.relative_to(repository)).encode()).hexdigest()):
        if script in imported:
            continue
        text = closure(script, set())
        if text in known or not all(p.search(text) for p in (IMPORTS, BUILDS, ANALYSES)):
            continue
        known.add(text)
        if OUT_OF_SCOPE.search(text) or NOT_HERE.search(text):
            outside += 1
        else:
            inside.append(script)
    return inside[:each], outside


def run(options, kind, script):
    """Status, printed text, messages, files, and the answers of calls."""
    with tempfile.TemporaryDirectory() as work:
        log = Path(work) / "calls.jsonl"
        name = script
        if script.suffix == ".ipynb":
            copy = Path(work) / "folder"
            shutil.copytree(script.parent, copy, symlinks=True)
            name = copy / "notebook_code.py"
            name.write_text(of_notebook(script), encoding="utf-8")
        command = [options.python, str(Path(__file__).resolve()), "--run", kind, "--log", str(log)]
        text = "../" if re.search(r"\.\./|\.\.\\|\.\.['\"]", text_of_script(script)) else ""
        status, out, err, files = scripts.run(command, name, text, options.limit if kind == "openseespy" else 2 * options.limit)
        files = {n: d for n, d in files.items() if not n.endswith((".pyc", ".png", ".pdf", ".svg", ".jpg", ".gif", ".mp4", ".pkl", ".npz", ".xlsx"))}
        # OpenSeesPy tells the end of the process.
        out = out.replace("Process 0 Terminating", "")
        calls = [json.loads(line) for line in log.read_text().splitlines()] if log.exists() and status == 0 else []
    return status, out, err, files, calls


def apart(want, got, tolerance):
    """Empty if the answers of all calls agree, else the first difference."""
    groups = {}
    for i, (name, words, values) in enumerate(want):
        if i >= len(got):
            return f"calls: {len(got)}, not {len(want)}"
        if got[i][:2] != [name, words] or len(got[i][2]) != len(values):
            return f"call {i + 1}: {name} {words[:40]} {str(values)[:40]}, not {got[i][0]} {got[i][1][:40]} {str(got[i][2])[:40]}"
        groups.setdefault((name, words), []).append((values, got[i][2]))
    if len(got) > len(want):
        return f"calls: {len(got)}, not {len(want)}"
    whole = {}
    for (name, _), rows in groups.items():
        whole[name] = max([whole.get(name, 0.0), *(abs(x) for w, _ in rows for x in w if abs(x) < 1e300)])
    worst, where = 0.0, ""
    for (name, words), rows in groups.items():
        peak = max((abs(x) for w, _ in rows for x in w if abs(x) < 1e300), default=0.0)
        peak = max(peak, scripts.NOISE_OF_FILE * whole[name], 1e-30)
        for w, g in rows:
            for x, y in zip(w, g):
                if x == y or (x != x and y != y) or (name in FORCES and max(abs(x), abs(y)) < NO_FORCE):
                    continue
                distance = abs(abs(x) - abs(y)) if name in MODES else abs(x - y)
                if not distance / peak <= worst:
                    worst, where = distance / peak, f"{name} {words[:40]} {x:.6g} {y:.6g}"
    return "" if worst <= tolerance else f"{where}: by {worst:.2g} of its peak"


def difference(want, got, tolerance):
    if got[0] != 0:
        lines = got[2].strip().splitlines() or [""]
        last = next((i for i, line in reversed(list(enumerate(lines))) if re.match(r"[\w.]*(Error|Exception)\b|hysteron\.", line)), len(lines) - 1)
        return "timeout" if got[0] == "timeout" else "refused", " / ".join(line.strip() for line in lines[last:])[:300]
    found = apart(want[4], got[4], tolerance)
    if not found and (want[3] or not want[4]):
        found = compare(want[:4], got[:4], tolerance)
    return ("differs", found) if found else ("equal", "")


def wanted(options, script):
    """What openseespy makes of a script, from an earlier run if the folder of --cache has it."""
    kept = options.cache / hashlib.sha1(str(script).encode()).hexdigest() if options.cache else None
    if kept and kept.exists():
        return scripts.pickle.loads(kept.read_bytes())
    found = run(options, "openseespy", script)
    if kept:
        options.cache.mkdir(parents=True, exist_ok=True)
        kept.write_bytes(scripts.pickle.dumps(found))
    return found


def judge(options, repository, script):
    """Row of the table of one script: repository, script, outcome, detail."""
    head = (repository, str(script.relative_to(options.folder / repository)))
    want = wanted(options, script)
    if want[0] != 0 or not (want[4] or has_numbers(want)):
        lines = [line for line in want[2].strip().splitlines() if not line.startswith("Process 0")]
        detail = "timeout" if want[0] == "timeout" else (lines or ["no numbers"])[-1][:160]
        return (*head, "OpenSees fails", detail)
    outcome, detail = difference(want, run(options, "hysteron", script), options.tolerance)
    if outcome in ("differs", "refused") and options.compat:
        if difference(want, run(options, "compat", script), options.tolerance)[0] == "equal":
            return (*head, "equal", "with compat")
    return (*head, outcome, detail)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--python", default=sys.executable)
    parser.add_argument("--each", type=int, default=10)
    parser.add_argument("--limit", type=float, default=60.0)
    parser.add_argument("--tolerance", type=float, default=1e-4)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="a regular expression for REPOSITORY/SCRIPT")
    parser.add_argument("--compat", action="store_true")
    parser.add_argument("--cache", type=Path)
    parser.add_argument("--csv", type=Path, help="table of the outcomes by repository")
    options = parser.parse_args()
    options.folder = options.folder.resolve()
    work, outside, known = [], 0, set()
    for repository in sorted(p for p in options.folder.iterdir() if p.is_dir()):
        found, out = entries(repository, options.each, known)
        outside += out
        work += [(repository.name, s) for s in found]
    work = [(r, s) for r, s in work if re.search(options.only, f"{r}/{s.relative_to(options.folder / r)}")]
    report(options, work, judge, outside, "openseespy")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--run"]:
        runner(sys.argv[2], sys.argv[5], sys.argv[4])
    sys.exit(main())
