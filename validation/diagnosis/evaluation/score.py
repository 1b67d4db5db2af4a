"""One trial: make the case, diagnose it, compare the verdict with the truth."""

import json
import os
import resource
import subprocess
import tempfile
import time

from generator.plan import draw

from . import checks

FIELDS = ("seed", "family", "cause", "also", "kinds", "effect_over_noise", "second_over_noise", "noise", "floor_fit", "floor_holdout", "self_check",
          "status", "verdict", "verdict_also", "confidence", "confidence_of_truth", "right", "place", "iou", "baseline_fit", "baseline_holdout",
          "corrected_fit", "corrected_holdout", "gain", "unexplained", "cpu_s")


def right(truth, verdict):
    """Either effect of a pair, found first or second; `none` and `unknown` only as such."""
    named = {verdict["cause"], *verdict.get("also", [])}
    if truth["cause"] in ("none", "unknown"):
        return verdict["cause"] == truth["cause"]
    return bool(named & {truth["cause"], *(truth.get("also") or [])})


def covered(spans, t):
    return any(a <= t <= b for a, b in spans)


def overlap(a, b):
    """Intersection over union of two lists of spans."""
    edges = sorted({x for span in a + b for x in span})
    both = either = 0.0
    for left, high in zip(edges, edges[1:]):
        mid = 0.5 * (left + high)
        both += (high - left) * (covered(a, mid) and covered(b, mid))
        either += (high - left) * (covered(a, mid) or covered(b, mid))
    return both / either if either else 0.0


def located(truth, mismatch):
    """(1 if the first mismatch is in a run and channel that hold the effect, overlap of its windows); empty where there is nothing to compare."""
    where = truth["where"]
    if not where or not mismatch or "accept_runs" not in where:
        return "", ""
    first = mismatch[0]
    place = first["run"] in where["accept_runs"] and first["channel"] in where["accept_channels"]
    if "windows" not in where:
        return int(place), ""
    same = [m for m in mismatch if (m["run"], m["channel"]) == (where["run"], where["channel"])]
    return int(place), f"{overlap(where['windows'], same[0]['windows']):.3f}" if same else "0"


def trial(seed, engine, options, limit, keep=None, ratio=None, cause=None, knock_out=False, imperfect=False):
    case = draw(seed, ratio, cause, imperfect)
    if knock_out:
        options = options + [word for name in case.truth for word in ("--without", name)]
    with tempfile.TemporaryDirectory() as scratch:
        folder = os.path.join(keep, str(seed)) if keep else scratch
        truth = case.write(folder)
        row = dict.fromkeys(FIELDS, "")
        row.update(seed=seed, family=truth["family"], cause=truth["cause"], also=" ".join(truth.get("also") or []), kinds=" ".join(truth["kinds"]), noise=truth["noise"],
                   floor_fit=f"{truth['noise_floor_nmse_fit']:.4g}", floor_holdout=f"{truth['noise_floor_nmse_holdout']:.4g}")
        for key, size in zip(("effect_over_noise", "second_over_noise"), truth["effect_over_noise"]):
            row[key] = size
        try:
            row["self_check"] = f"{checks.effect_off(case, [engine, 'run', '--compat', 'opensees']):.2e}"
        except RuntimeError as e:
            row["status"] = "script: " + str(e).splitlines()[-1][:100]
            return row
        before, started = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime, time.time()
        out = os.path.join(folder, "out")
        try:
            done = subprocess.run([engine, "diagnose", os.path.join(folder, "study.toml"), "--out", out] + options,
                                  capture_output=True, text=True, timeout=limit)
        except subprocess.TimeoutExpired:
            row["status"] = f"over {time.time() - started:.0f} s"
            return row
        if keep:
            with open(os.path.join(folder, "said.txt"), "w") as f:
                f.write(done.stdout + done.stderr)
        row["cpu_s"] = f"{resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before:.1f}"
        if done.returncode:
            row["status"] = "exit %d: %s" % (done.returncode, (done.stderr.strip().splitlines() or ["nothing said"])[0][:100])
            return row
        with open(os.path.join(out, "diagnosis.json")) as f:
            said = json.load(f)
    judge(row, truth, said)
    return row


def judge(row, truth, said):
    verdict, base, after = said["verdict"], said["baseline"], said["corrected"] or said["baseline"]
    told = {v["cause"]: v["confidence"] for v in [verdict, *verdict.get("also_possible", [])]}
    row["place"], row["iou"] = located(truth, said.get("mismatch", []))
    row.update(status="done", verdict=verdict["cause"], verdict_also=" ".join(verdict.get("also", [])), confidence=f"{verdict['confidence']:.3f}",
               confidence_of_truth=f"{told.get(truth['cause'], 0.0):.3f}", right=int(right(truth, verdict)), unexplained=f"{said['unexplained_share']:.3f}")
    for name, part in (("baseline", base), ("corrected", after)):
        for role in ("fit", "holdout"):
            row[f"{name}_{role}"] = f"{part[role + '_nmse']:.4g}"
    floor = truth["noise_floor_nmse_holdout"]
    if truth["cause"] not in ("none", "unknown") and base["holdout_nmse"] > 2.0 * floor:
        row["gain"] = f"{(base['holdout_nmse'] - after['holdout_nmse']) / (base['holdout_nmse'] - floor):.3f}"
