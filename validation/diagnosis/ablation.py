#!/usr/bin/env python3
"""Makes each number of the verdict's prior neutral in turn, and counts the verdicts that change.

    python3 validation/diagnosis/ablation.py [--each 1] [--skip SEED ...] [--only NAME ...] [--joint] [--threads N] [--out DIR]

A copy of the source reads its numbers from the environment and is built once. The cases are the quickest trials of each cause in trials.csv, made again
of their seeds. Rows go to ablation.csv; numbers that have a row are not tried again, so that a run goes on where it was stopped. A number takes some
minutes, all of them some hours. `--joint` makes all the numbers after `--only` neutral at once, since two may stand in for each other. Lists of numbers, and numbers from which the source computes constants, are not tried.
"""

import argparse
import csv
import glob
import json
import os
import re
import shutil
import subprocess
import sys

from generator.plan import draw

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
TABLE = os.path.join(HERE, "ablation.csv")
PRIOR = os.path.join("crates", "diagnose", "src", "prior.rs")
NUMBER = re.compile(r"^    ([A-Z_]+): (\w+) = ([^,\[\]]+), \"", re.M)
CONSTANT = "$($(#[doc = $doc])+ pub(crate) const $name: $type = $value;)+"
# In the copy, a number is also a function: its value comes from HYSTERON_PRIOR ("NAME=VALUE,NAME=VALUE") where that names it.
FUNCTION = CONSTANT + """
        #[allow(non_snake_case)]
        pub(crate) mod now {
            $(pub(crate) fn $name() -> $type {
                static VALUE: std::sync::OnceLock<$type> = std::sync::OnceLock::new();
                *VALUE.get_or_init(|| super::Overridden::overridden($value, stringify!($name)))
            })+
        }"""
OVERRIDDEN = """
trait Overridden: Copy { fn overridden(self, name: &str) -> Self; }
macro_rules! overridden { ($($number:ty),*) => {$(impl Overridden for $number {
    fn overridden(self, name: &str) -> Self {
        let text = std::env::var("HYSTERON_PRIOR").unwrap_or_default();
        let named = text.split(',').filter_map(|t| t.split_once('=')).find(|(known, _)| *known == name);
        named.map_or(self, |(_, value)| value.parse().unwrap())
    }
})*}; }
overridden!(f64, usize, isize, u32);
impl<T: Copy, const N: usize> Overridden for [T; N] { fn overridden(self, _: &str) -> Self { self } }
"""

# Values at which a number says nothing. All others are halved.
NEUTRAL = {
    "COMPLETE_MODEL_LOG_ODDS": "0.0",
    "ONE_EFFECT_LOG_ODDS": "0.0",
    "RANGE_FAULT_IN_ALL_RUNS_LOG_ODDS": "0.0",
    "VISIBLE_FAULT_LOG_ODDS": "0.0",
    "AUXILIARY_CHANNEL_LOG_ODDS": "0.0",
    "EQUAL_FORM_LOG_EVIDENCE": "0.0",
    "LAPSE_SHARE": "0.0",
    "MAX_NOISE_ROOT": "1.0",
    "MAX_LINEAR_STEP": "1.0",
    "MIN_REPAIR_GAIN": "0.0",
    "MIN_STRUCTURE_FOR_PAIRS": "1.0",
    "MIN_REPORTED_PROBABILITY": "0.0",
    "PREDICTED_SHARE": "0.0",
    "MIN_HOLDOUT_SIGNAL_RATIO": "1.0",
    "NEGLIGIBLE_RESIDUAL": "1e-12",
    "REGRESSION_RIDGE": "1e-9",
    "NEGLIGIBLE_STEP_ERROR": "1.0",
    "MAX_STEP_PARTS": "1",
}


def neutral(name, kind, value):
    if name in NEUTRAL:
        return NEUTRAL[name]
    return f"{float(value) / 2!r}" if kind == "f64" else str(max(1, int(value) // 2))


def called(text, names):
    """Source of a file in which each use of a number calls its function. Imports, comments and definitions stay."""
    use, lines = False, []
    for line in text.split("\n"):
        bare = line.strip()
        use = use or re.match(r"(pub(\(crate\))? )?use ", bare) is not None
        if not use and not bare.startswith("//") and not re.match(r"(pub(\(crate\))? )?const ", bare):
            line = names.sub(r"crate::prior::now::\1()", line)
        if use and bare.endswith(";"):
            use = False
        lines.append(line)
    return "\n".join(lines)


def built(out):
    """The program whose numbers the environment changes."""
    tree = os.path.join(out, "tree")
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    for name in filter(None, listed):
        target = os.path.join(tree, name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        shutil.copy2(os.path.join(ROOT, name), target)
    with open(os.path.join(tree, PRIOR)) as f:
        source = f.read()
    assert CONSTANT in source, "the macro of the prior is another one"
    scalars = "|".join(name for name, _, _ in NUMBER.findall(source))
    names = re.compile(rf"(?:\bprior::)?\b({scalars})\b")
    for path in glob.glob(os.path.join(tree, "crates", "diagnose", "src", "**", "*.rs"), recursive=True):
        if path.endswith("prior.rs"):
            continue
        with open(path) as f:
            text = f.read()
        if names.search(text):
            with open(path, "w") as f:
                f.write(called(text, names))
    with open(os.path.join(tree, PRIOR), "w") as f:
        f.write(source.replace(CONSTANT, FUNCTION) + OVERRIDDEN)
    command = ["cargo", "build", "--quiet", "--release", "--bin", "hysteron", "--target-dir", os.path.join(tree, "target")]
    done = subprocess.run(command, cwd=tree, capture_output=True, text=True)  # imports that are left over make warnings
    if done.returncode:
        sys.exit(done.stderr)
    return os.path.join(tree, "target", "release", "hysteron"), source


def cases(args):
    """(seed, folder) of the quickest trials of each cause, made of their seeds."""
    with open(os.path.join(HERE, "trials.csv")) as f:
        rows = [r for r in csv.DictReader(f) if r["cpu_s"] and r["cause"]]
    rows.sort(key=lambda r: float(r["cpu_s"]))
    taken = {}
    for row in rows:
        key = row["cause"] + ("+" if row["also"] else "")
        if len(taken.setdefault(key, [])) < args.each:
            taken[key].append(int(row["seed"]))
    for seed in sorted(sum(taken.values(), [])):
        folder = os.path.join(args.out, "cases", str(seed))
        if not os.path.exists(os.path.join(folder, "study.toml")):
            draw(seed).write(folder)
        yield seed, folder


def answers(engine, studies, out, threads, changed=""):
    """{seed: (causes, confidence)}; the answer of an engine that fails is its exit status."""
    said = {}
    for seed, folder in studies:
        to = os.path.join(out, str(seed))
        result = os.path.join(to, "diagnosis.json")
        if not os.path.exists(result):
            command = [engine, "diagnose", os.path.join(folder, "study.toml"), "--out", to, "--threads", str(threads)]
            done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "HYSTERON_PRIOR": changed})
            if done.returncode:
                said[seed] = (f"exit {done.returncode}", 0.0)
                continue
        with open(result) as f:
            verdict = json.load(f)["verdict"]
        said[seed] = (" + ".join([verdict["cause"], *verdict["also"]]), verdict["confidence"])
    return said


def tried():
    if not os.path.exists(TABLE):
        with open(TABLE, "w") as f:
            csv.writer(f, lineterminator="\n").writerow(["number", "value", "tried", "cases", "verdicts_changed", "mean_change_of_confidence", "changed_cases"])
    with open(TABLE) as f:
        return {row["number"] for row in csv.DictReader(f)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--each", type=int, default=1, help="trials of each cause")
    parser.add_argument("--skip", nargs="*", type=int, default=[], help="seeds to leave out, as those that take minutes")
    parser.add_argument("--only", nargs="*", help="these numbers alone")
    parser.add_argument("--joint", action="store_true", help="all the numbers after --only at once")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--out", default=os.path.join(ROOT, "results", "ablation"))
    args = parser.parse_args()
    studies = [(seed, folder) for seed, folder in cases(args) if seed not in args.skip]
    engine, source = built(args.out)
    usual = answers(engine, studies, os.path.join(args.out, "usual"), args.threads)
    done = tried()
    numbers = [(name, value, neutral(name, kind, value)) for name, kind, value in NUMBER.findall(source)]
    numbers = [n for n in numbers if not args.only or n[0] in args.only]
    if args.joint:
        numbers = [tuple(" ".join(words) for words in zip(*numbers))]
    for name, value, other in numbers:
        if name in done:
            continue
        changed = ",".join(f"{n}={x}" for n, x in zip(name.split(), other.split()))
        now = answers(engine, studies, os.path.join(args.out, "joint" if args.joint else name), args.threads, changed)
        different = [s for s in usual if now[s][0] != usual[s][0]]
        moved = sum(abs(now[s][1] - usual[s][1]) for s in usual) / len(usual)
        with open(TABLE, "a") as f:
            row = [name, value, other, len(usual), len(different), f"{moved:.3f}", " ".join(map(str, different))]
            csv.writer(f, lineterminator="\n").writerow(row)
        print(f"{name}: {value} -> {other}, {len(different)} of {len(usual)} verdicts change", flush=True)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main()
