"""Faults put into one of two runs of a real recording, whose models are those of validation/identification/recordings (good but not perfect).

The steel has no clock in the source: there the causes that need one are left out.
"""
import shutil
from pathlib import Path

from bench import columns, resample, write

HERE = Path(__file__).resolve().parent
SIZES = {  # share of the largest value; samples for the lag
    "gain": (0.9, 1.3),
    "drift": (0.1, 0.3),
    "clipping": (0.85, 0.65),
    "lag": (2, 6),
}
CASES = {f"{model}_{fault}_{size}": (model, fault, SIZES[fault][k]) for model in ("steel", "damper") for fault in SIZES for k, size in enumerate(("small", "large"))}
CASES |= {f"{model}_as_recorded": (model, None, 0) for model in ("steel", "damper")}
VARIANTS = {}


def faulty(fault, size, t, y):
    peak = max(map(abs, y))
    if fault == "gain":
        return [size * v for v in y]
    if fault == "drift":
        return [v + size * peak * s / t[-1] for s, v in zip(t, y)]
    if fault == "clipping":
        return [min(max(v, -size * peak), size * peak) for v in y]
    if fault == "lag":
        return resample(t, y, [max(s - size * t[1], 0.0) for s in t])
    return y


def prepare(data, folder):
    coupon = {n: columns(data / f"steel-coupon-cyclic-resspylab/{n}.csv") for n in ("example_1", "example_2")}
    damper = {n: columns(data / f"friction-damper-backlash-brfd/harmonic_{f}_36lb_1in.csv") for n, f in (("half", "0.5Hz"), ("one", "1Hz"))}
    sources = {n: (c["true_strain"], 1.0, "stress[MPa]", c["true_stress_MPa"]) for n, c in coupon.items()}
    sources |= {n: (damper[n]["disp_mm"][::every], every / 256, "force[kN]", damper[n]["force_kN"][::every]) for n, every in (("half", 4), ("one", 2))}
    for name, (u, dt, channel, y) in sources.items():
        write(folder, name, u, dt, {channel: y})
    for model, of in (("steel", "steel_coupon"), ("damper", "friction_damper")):
        shutil.copy(HERE.parent.parent / f"identification/recordings/{of}/model.tcl", folder / f"{model}.tcl")
    for case, (model, fault, size) in CASES.items():
        (folder / f"{case}.toml").write_text((HERE / f"{model}.toml").read_text().replace("{case}", case))
        VARIANTS[case] = (f"{case}.toml", None)
        u, dt, channel, y = sources["example_2" if model == "steel" else "half"]
        write(folder, case, u, dt, {channel: faulty(fault, size, [dt * i for i in range(len(y))], y)})


def known(variant):
    _, fault, size = CASES[variant]
    return f"sensor_{fault} ({size:g})" if fault else "no fault"


def kind(verdict):
    return "rig" if verdict["cause"].startswith("sensor") else verdict["cause"] if verdict["cause"] in ("none", "unknown") else "physics"


def right(variant, verdict):
    fault = CASES[variant][1]
    if fault is None:
        return "no" if any(c.startswith("sensor") for c in (verdict["cause"], *verdict["also"])) else "yes"
    if verdict["cause"] == f"sensor_{fault}":
        return "yes"
    return "as the second" if f"sensor_{fault}" in verdict["also"] else "another fault" if kind(verdict) == "rig" else "no"


def count(judged):
    kinds = ("rig", "physics", "none", "unknown")
    rows = ["| put in | cases | rig | physics | none | unknown | right fault named | named second | right fault with the most evidence |", "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for fault in (*SIZES, None):
        these = [(v, said["verdict"]) for v, said, _ in judged if CASES[v][1] == fault]
        leads = sum(lead[0] == (f"sensor_{fault}" if fault else "none") for v, _, lead in judged if CASES[v][1] == fault)
        found = [kind(x) for _, x in these]
        answers = [right(v, x) for v, x in these]
        rows.append(f"| {fault or 'nothing'} | {len(these)} | " + " | ".join(str(found.count(k)) for k in kinds) + f" | {answers.count('yes')} | {answers.count('as the second')} | {leads} |")
    return rows
