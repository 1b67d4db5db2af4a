"""Random calls with random words, and models made and dropped: no crash, and memory that stays flat.

    python tests/fuzz.py calls --number 1000000 --seed 1
    python tests/fuzz.py models --number 100000

`calls` makes its calls in processes of 20,000 each. A process that ends by a signal, a panic of Rust, or an error of another kind than
those of commands counts as a defect; its seed repeats it. `models` prints the memory of the process along the way.
"""

import argparse
import gc
import random
import subprocess
import sys
import tempfile
import time
import warnings

CALLS_OF_A_PROCESS = 20_000
CALLS_OF_A_MODEL = 150
WORDS = [
    0, 1, 2, 3, 4, -1, 10, 3.5, 0.01, 1e-9, 1e308, -0.0, float("inf"), float("nan"), 10**9, 10**30, True, None, "", "x", "1", "é\0",
    "-node", "-dof", "-ele", "-ndm", "-ndf", "-mat", "-dir", "-time", "-file", "-section", "-values", "-iter", "force", "disp",
    [1, 2], (), [[1.0, 2.0], 3], b"bytes", {"a": 1}, object(), "Linear", "Elastic", "Newton", "Static", "Transient", "Plain",
]  # fmt: skip
#: A model that stands, so that calls go beyond the first check.
FRAME = [
    ("model", "basic", "-ndm", 2, "-ndf", 3), ("node", 1, 0.0, 0.0), ("node", 2, 0.0, 3.0), ("node", 3, 4.0, 3.0), ("fix", 1, 1, 1, 1),
    ("mass", 2, 1.0, 1.0, 0.1), ("uniaxialMaterial", "Elastic", 1, 100.0), ("geomTransf", "Linear", 1),
    ("element", "elasticBeamColumn", 1, 1, 2, 0.01, 2e8, 1e-4, 1), ("element", "elasticBeamColumn", 2, 2, 3, 0.01, 2e8, 1e-4, 1),
    ("timeSeries", "Linear", 1), ("pattern", "Plain", 1, 1), ("load", 2, 1.0, 0.0, 0.0), ("integrator", "LoadControl", 0.1),
    ("analysis", "Static"),
]  # fmt: skip


def calls(number, seed):
    """Make random calls in this process; the number of those that were accepted."""
    import numpy as np

    from hysteron import Model, OpenSeesError
    from hysteron._model import USAGES

    warnings.simplefilter("ignore")
    sys.stdout.write = sys.stderr.write = lambda text: len(text)
    chance = random.Random(seed)
    kinds = {name: [k for names, _ in kinds for k in names] for name, (_, kinds) in USAGES.items()}
    # Commands that write files under names of their own.
    names = sorted(n for n in USAGES if hasattr(Model, n) and n not in {"figure", "plot", "database", "save", "restore", "logFile"})
    words = [*WORDS, np.float32(2.5), np.arange(3), np.zeros((2, 2)), np.array("text"), np.datetime64("2000-01-01")]
    accepted, model = 0, None
    for i in range(number):
        if i % CALLS_OF_A_MODEL == 0:
            model = Model(strict=chance.random() < 0.1, compat=chance.random() < 0.2, ladder=chance.random() < 0.2)
            for name, *given in FRAME:
                getattr(model, name)(*given)
        name = chance.choice(names)
        given = [chance.choice(words) for _ in range(chance.randrange(9))]
        if kinds[name] and chance.random() < 0.9:
            given = [chance.choice(kinds[name]), *given]
        if name == "analyze":
            given = [chance.randrange(4), 0.01][: chance.randrange(3)]
        if any(isinstance(g, int) and abs(g) > 1000 for g in given) and name in {"eigen", "block2D", "block3D", "modalProperties"}:
            continue
        try:
            getattr(model, name)(*given)
            accepted += 1
        except OpenSeesError as error:
            assert str(error) and "panicked" not in str(error), (name, given)
        except TypeError:
            # Methods of Python with arguments of their own.
            assert name in {"getTime", "getNumThreads", "setNumThreads", "analyze"}, (name, given)
    return accepted


def run_calls(number, seed):
    done, accepted, defects, began = 0, 0, [], time.monotonic()
    while done < number:
        part = min(CALLS_OF_A_PROCESS, number - done)
        code = f"import sys; sys.path.insert(0, {sys.path[0]!r}); import fuzz; fuzz.print_count(fuzz.calls({part}, {seed}))"
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=folder, timeout=1200)
        if process.returncode or "panicked" in process.stderr:
            defects.append((seed, process.returncode, "\n".join(wrong_lines(process.stderr))))
            print("defect:", *defects[-1], sep="\n", flush=True)
        else:
            accepted += int(process.stdout.split()[-1])
        done, seed = done + part, seed + 1
    print(f"{done} calls, {accepted} of them accepted, {len(defects)} defects, {time.monotonic() - began:.0f} s")
    return len(defects)


def wrong_lines(text):
    """What a process says about its end."""
    lines = text.splitlines()
    found = [i for i, line in enumerate(lines) if "panicked" in line]
    return [lines[j] for i in found for j in range(i, min(i + 2, len(lines)))] + lines[-3:]


def print_count(count):
    import os

    os.write(1, f"{count}\n".encode())


def memory():
    gc.collect()
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096 / 1e6


def run_models(number):
    import hysteron

    def one(load):
        model = hysteron.Model()
        for name, *given in FRAME:
            getattr(model, name)(*given)
        model.load(3, load, 0.0, 0.0)
        assert model.analyze(2) == 0
        return model.nodeDisp(2, 1)

    began = time.monotonic()
    for i in range(number + 1):
        one(1.0 + i)
        if i % (number // 10) == 0 or i == 1000:
            print(f"{i} models, {memory():.1f} MB", flush=True)
    print(f"{1e6 * (time.monotonic() - began) / number:.0f} µs for each model")
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["calls", "models"])
    parser.add_argument("--number", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    sys.exit(run_calls(options.number, options.seed) if options.what == "calls" else run_models(options.number))
