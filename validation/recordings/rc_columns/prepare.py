"""All specimens of the source, force and displacement over their peaks, a sample a second: the source has no clock."""
import csv
from collections import Counter
from pathlib import Path

from bench import write

LOSS = {"cyclic_degradation", "pinching", "mullins_softening", "axial_shear_interaction"}
VARIANTS, TYPES = {}, {}


def prepare(data, folder):
    source = data / "peer-spd-rc-columns"
    with (source / "specimens.csv").open() as f:
        chosen = sorted(csv.DictReader(f), key=lambda s: (s["FailureType"], int(s["specimen_id"])))
    curves = {s["specimen_id"]: ([], []) for s in chosen}
    with (source / "curves.csv").open() as f:
        for row in csv.DictReader(f):
            if row["specimen_id"] in curves:
                curves[row["specimen_id"]][0].append(float(row["lateral_disp_mm"]))
                curves[row["specimen_id"]][1].append(float(row["lateral_force_kN"]))
    template = (Path(__file__).parent / "template.toml").read_text()
    for s in chosen:
        name = f"{int(s['specimen_id']):03}"
        u, f = ([x / max(map(abs, v)) for x in v] for v in curves[s["specimen_id"]])
        write(folder, name, u, 1.0, {"force[-]": f, "disp[-]": u})
        (folder / f"{name}.toml").write_text(template.replace("{id}", name).replace("{npts}", str(len(u))))
        VARIANTS[name], TYPES[name] = (f"{name}.toml", None), s["FailureType"]


def known(variant):
    return TYPES[variant]


def right(variant, verdict):
    """Returns true if a loss or pinching is among the causes found. Flexural failures may have little of it."""
    found = LOSS & {verdict["cause"], *verdict["also"]}
    return " + ".join(sorted(found)) if found else "-"


def count(judged):
    rows = ["| failure | specimens | loss of strength or stiffness | pinching | either | unknown | none | a channel's fault | something else | median unexplained |",
            "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for kind in ("Flexure", "Flexure-Shear", "Shear"):
        these = [said for v, said, _ in judged if TYPES[v] == kind]
        c, shares = Counter(), []
        for said in these:
            verdict = said["verdict"]
            causes = {verdict["cause"], *verdict["also"]}
            c["loss"] += bool(causes & (LOSS - {"pinching"}))
            c["pinching"] += "pinching" in causes
            c["either"] += bool(causes & LOSS)
            first = verdict["cause"]
            c[first if first in ("unknown", "none") else "sensor" if first.startswith("sensor") else "either_first" if causes & LOSS else "else"] += 1
            shares.append(said["unexplained_share"])
        if these:
            rows.append(f"| {kind} | {len(these)} | {c['loss']} | {c['pinching']} | {c['either']} | {c['unknown']} | {c['none']} | {c['sensor']} | {c['else']} | {sorted(shares)[len(shares) // 2]:.2f} |")
    return rows
