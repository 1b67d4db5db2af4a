#!/usr/bin/env python3
"""Diagnoses measured recordings, enters each answer in answers.csv, and writes outcome.md and a picture for each source.

    validation/recordings/run.py [NAME[/STUDY] ...] [--data DIR] [--out DIR] [--engine HYSTERON] [--build COMMIT]
                                 [--threads N] [--seconds S] [--again]

A diagnosis whose result is in OUT/BUILD is not computed again without --again, so the command goes on where it ended.
After S seconds no other diagnosis begins. outcome.md is written when all studies of its source have a result.
`HYSTERON_WRITE=1 cargo test --test measured` then writes the figures of the pages anew.
"""
import argparse
import csv
import functools
import importlib.util
import json
import math
import os
import re
import shutil
import subprocess
import sys
import time
import tomllib
from pathlib import Path

sys.dont_write_bytecode = True
import bench  # noqa: E402

HERE = Path(__file__).resolve().parent


@functools.cache
def module(name):
    """The module of a source, once: its cases are known after it has prepared its data."""
    spec = importlib.util.spec_from_file_location(name, HERE / name / "prepare.py")
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


def with_roles(study, holdout):
    """The study with these runs held out and the others fitted."""
    def role(m):
        return f'{m[1]}{"holdout" if m[2] in holdout else "fit"}"'
    return re.sub(r'(name\s*=\s*"([^"]+)"\s*\nrole\s*=\s*")\w+"', role, study)


COLUMNS = ["source", "study", "build", "known", "cause", "also", "probability", "second", "second_probability", "fitted_before", "fitted_after",
           "held_before", "held_after", "peak_before", "peak_after", "most_evidence", "over_none", "unexplained"]
ANSWERS = HERE / "answers.csv"


def peak_ratio(recorded, simulated):
    """Largest value of a channel over the recorded one, of the samples that were recorded."""
    if simulated is None:
        return None
    compared = [(abs(r), abs(y)) for r, y in zip(recorded, simulated) if math.isfinite(r)]
    return max(y for _, y in compared) / max(r for r, _ in compared)


def enter(args, name, variant, known, said, lead, peaks):
    """Replaces the row of a study in the table of answers, whose rows are in order of source and study.

    peaks: ratios of the peaks of the channels held out, before and after; the table has the smallest.
    """
    verdict, base, after = said["verdict"], said["baseline"], said["corrected"] or said["baseline"]
    second = (verdict["also_possible"] or [{"cause": "", "confidence": None}])[0]

    def short(x):
        return "" if x is None else f"{x:.4g}"
    row = [name, variant, args.build, known, verdict["cause"], " + ".join(verdict["also"]), f"{verdict['confidence']:.3f}", second["cause"],
           short(second["confidence"]), *(short(m[k]) for k in ("fit_nmse", "holdout_nmse") for m in (base, after)), *(short(min(p, default=None)) for p in peaks), lead[0], f"{lead[2]:.1f}",
           short(said["unexplained_share"])]
    rows = {}
    if ANSWERS.exists():
        with ANSWERS.open() as f:
            rows = {(r["source"], r["study"]): [r.get(c, "") for c in COLUMNS] for r in csv.DictReader(f)}
    rows[name, variant] = row
    unfinished = ANSWERS.with_suffix(".part")
    with unfinished.open("w") as f:
        csv.writer(f, lineterminator="\n").writerows([COLUMNS, *(rows[k] for k in sorted(rows))])
    unfinished.replace(ANSWERS)


def diagnose(args, folder, study, out):
    """Returns false if the result is not there and the time is up."""
    if (out / "diagnosis.json").exists() and (out / "said.txt").exists() and not args.again:
        return True
    if args.seconds is not None and time.monotonic() - args.begun > args.seconds:
        return False
    done = subprocess.run([args.engine, "diagnose", study, "--out", out, "--verbose", "--threads", str(args.threads)], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{folder.name}, {study}: {done.stdout}{done.stderr}")
    (out / "said.txt").write_text(done.stdout + done.stderr)
    return True


def errors(args, folder, study, said, out):
    """[(run, role, {channel: (recorded, before, after)})] of the fitted baseline and the repaired model."""
    model = bench.with_values((folder / study["model"]).read_text(), said["baseline"]["parameters"])
    repaired = (out / "corrected.tcl").read_text()
    faults = said["corrected"].get("channels", [])
    result = []
    for run in study["run"]:
        both = [bench.simulate(args.engine, folder, script, run) for script in (model, repaired)]
        channels = {}
        # A measure of loops is no time history.
        for name in (c["channel"] for c in run["observe"] if "measure" not in c):
            t, recorded, before = both[0][name] if both[0] else (None, None, None)
            after = None
            if both[1]:
                t, recorded, after = both[1][name]
                for fault in faults:
                    if fault["channel"] == name and fault.get("run") in (None, run["name"]):
                        after = bench.corrected_channel(t, after, fault)
            channels[name] = (t, recorded, before, after)
        result.append((run, channels))
    return result


def leading(out):
    """The cause with the most evidence and its lead over none: (cause, form, difference, NMSE)."""
    found = re.findall(r"^ +(\w+) +(\S+) +log evidence +(\S+) +(.*)$", (out / "said.txt").read_text(), re.M)
    none = next(float(e) for c, _, e, _ in found if c == "none")
    cause, nmse, evidence, form = found[0]
    return cause, form, float(evidence) - none, float(nmse)


def number(x):
    return "no answer" if x is None else f"{x:.3g}"


def compact(proof, name, judged):
    """A row a case, with what is known of it, and what the proof counts over them."""
    rows = [f"### {name}", "", "| case | known | answer | confidence | right | most evidence, over none | fitted NMSE | held out NMSE |", "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for variant, said, (cause, _, difference, _) in judged:
        verdict, base, after = said["verdict"], said["baseline"], said["corrected"] or said["baseline"]
        held = "" if base["holdout_nmse"] is None else f"{number(base['holdout_nmse'])} → {number(after['holdout_nmse'])}"
        rows.append(f"| {variant} | {proof.known(variant)} | {' + '.join([verdict['cause'], *verdict['also']])} | {100 * verdict['confidence']:.0f} % | "
                    f"{proof.right(variant, verdict)} | {cause}, {difference:.1f} | {number(base['fit_nmse'])} → {number(after['fit_nmse'])} | {held} |")
    return rows + ["", *proof.count(judged), ""]


def prepared(data, name, folder):
    """Models, studies and recordings of a source in a folder; false if its recordings are not at hand."""
    folder.mkdir(parents=True, exist_ok=True)
    for file in (HERE / name).iterdir():
        if file.suffix in (".tcl", ".toml"):
            shutil.copy(file, folder)
    proof, kept = module(name), HERE / name / "recordings"
    if data:
        proof.prepare(data.resolve(), folder)
        if getattr(proof, "LICENSED", False):
            kept.mkdir(exist_ok=True)
            for file in [*folder.glob("*.dat"), *folder.glob("*.csv")]:
                shutil.copy(file, kept)
    elif kept.is_dir():
        for file in [*kept.glob("*.dat"), *kept.glob("*.csv")]:
            shutil.copy(file, folder)
    else:
        print(f"{name}: its recordings are not in this repository, --data says where they are")
        return False
    return True


def study_of(name, variant, folder):
    """Writes the study of a variant to the folder; its name and text."""
    file, holdout = module(name).VARIANTS[variant]
    text = (folder / file).read_text()
    if holdout is not None:
        text = with_roles(text, holdout)
    (folder / f"{variant}.study.toml").write_text(text)
    return f"{variant}.study.toml", text


def prove(args, name, only):
    proof = module(name)
    folder = args.out.resolve() / args.build / name
    if not prepared(args.data, name, folder):
        return
    lines, judged, complete = [], [], True
    for variant in proof.VARIANTS:
        if only and variant not in only and not (folder / variant / "said.txt").exists():
            complete = False
            continue
        file, source = study_of(name, variant, folder)
        out = folder / variant
        if not diagnose(args, folder, file, out):
            complete = False
            continue
        said, study = json.loads((out / "diagnosis.json").read_text()), tomllib.loads(source)
        verdict = said["verdict"]
        others = ", ".join(f"{c['cause']} {100 * c['confidence']:.0f} %" for c in verdict["also_possible"][:3])
        after = said["corrected"] or said["baseline"]
        base = said["baseline"]
        held = "" if base["holdout_nmse"] is None else f", held out {number(base['holdout_nmse'])} → {number(after['holdout_nmse'])}"
        head = (f"Answer: **{' + '.join([verdict['cause'], *verdict['also']])}, {100 * verdict['confidence']:.0f} %** (then: {others or 'nothing'}); NMSE fitted "
                f"{number(base['fit_nmse'])} → {number(after['fit_nmse'])}{held}")
        print(f"{name}, {variant}: {head}", flush=True)
        if hasattr(proof, "known"):
            enter(args, name, variant, proof.known(variant), said, leading(out), ([], []))
            judged.append((variant, said, leading(out)))
            continue
        where = "; ".join(f"{m['at']} in {m['run']} ({m['channel']}): {100 * m['share']:.0f} % of the squared error in {sum(b - a for a, b in m['windows']):.3g} s, {m['regime']}"
                          for m in said["mismatch"] if m["windows"])
        cause, form, difference, nmse = leading(out)
        weighed = f"Most evidence: {cause} ({form}), {difference:.1f} in log evidence over none, NMSE {number(nmse)}." if cause != "none" else "Nothing had more evidence than none."
        lines += [f"### {name}: {variant}", "", head, "", f"It says: {verdict['explanation']}", "", weighed, "", f"Where the baseline differs: {where or 'nowhere'}.", "", "| run | role | channel | NMSE before | after | NRMSE before | after | peak over recorded before | after |", "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
        panels, peaks = [], ([], [])
        for run, channels in errors(args, folder, study, said, out):
            for channel, (t, recorded, before, after) in channels.items():
                e = [None if y is None else bench.nmse(recorded, y) for y in (before, after)]
                r = ["" if x is None else f"{100 * x ** 0.5:.0f} %" for x in e]
                ratios = [peak_ratio(recorded, y) for y in (before, after)]
                if run["role"] == "holdout":
                    for kept, ratio in zip(peaks, ratios):
                        kept += [] if ratio is None else [ratio]
                tops = " | ".join("" if x is None else f"{x:.2f}" for x in ratios)
                lines.append(f"| {run['name']} | {run['role']} | {channel} | {number(e[0])} | {number(e[1])} | {r[0]} | {r[1]} | {tops} |")
                if t and hasattr(proof, "panel"):
                    curves = {k: y for k, y in (("recorded", recorded), ("before", before), ("after", after)) if y is not None}
                    if made := proof.panel(folder, run, channel, t, curves):
                        panels.append((f"{run['name']} ({run['role']})", *made))
        enter(args, name, variant, "", said, leading(out), peaks)
        lines += [""]
        if panels and variant == next(iter(proof.VARIANTS)):
            bench.picture(HERE / name / "loops.svg", panels[:6])
    if not complete:
        return
    if judged:
        lines += compact(proof, name, judged)
    (HERE / name / "outcome.md").write_text(f"# {name}: outcome\n\nWritten by `run.py`.\n\n" + "\n".join(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    names = sorted(p.parent.name for p in HERE.glob("*/prepare.py"))
    parser.add_argument("names", nargs="*", metavar="NAME[/STUDY]", help=", ".join(names))
    parser.add_argument("--data", type=Path, help="folder with the recordings, a folder for each source")
    parser.add_argument("--out", type=Path, default=Path("results/recordings"))
    parser.add_argument("--engine", default=os.environ.get("HYSTERON", "hysteron"))
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--build", help="commit of the engine; that of this checkout if it is not given")
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--again", action="store_true")
    args = parser.parse_args()
    args.begun = time.monotonic()
    args.build = args.build or subprocess.run(["git", "rev-parse", "--short=8", "HEAD"], cwd=HERE, check=True, capture_output=True, text=True).stdout.strip()
    asked = {}
    for name, _, study in (n.partition("/") for n in args.names or names):
        asked.setdefault(name, set()).update({study} - {""})
    for name, only in asked.items():
        prove(args, name, only)


if __name__ == "__main__":
    main()
