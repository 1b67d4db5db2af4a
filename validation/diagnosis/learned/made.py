#!/usr/bin/env python3
"""Laws learned on made rigs, beside three rivals: share of the gap to the noise that each closes, and the kinds of memory found.

    validation/diagnosis/learned/made.py [--noise PERCENT ...] [--no-effects] [--no-families] [--out DIR] [--engine HYSTERON]

Writes its tables to the README. Ten effects are none of the library's causes, each at a noise of 1.5 % of the force, or at those of
--noise; --no-effects leaves them out. Twenty rigs have one of four kinds of memory; --no-families leaves them out. Needs numpy; seeds are fixed.
"""
import argparse
import statistics
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import numpy as np  # noqa: E402

from learn import held_out, learned, write_table  # noqa: E402
from rigs import EFFECTS, Rig, library_effect  # noqa: E402
from rivals import RIVALS, errors  # noqa: E402

HERE = Path(__file__).resolve().parent
FAMILIES = ("heat", "work", "largest_deformation", "clock")
RIGS_PER_FAMILY = 5


def share(user, after, floor):
    """Part of the way from the user's error to the noise."""
    return (user - after) / (user - floor)


def effects(engine, out, noises):
    """A row for each effect and noise, and a row of means for each noise."""
    rows = []
    for noise in noises:
        label, all_shares = f"{noise:g} %", []
        for k, (name, effect) in enumerate(EFFECTS.items()):
            rig = Rig(effect, 0.01 * noise, seed=100 + k)
            folder = out / f"effect{k}_{noise:g}"
            rig.write(folder)
            found = learned(engine, folder / "study.toml", folder / "law")
            base, by_rival = errors(rig)
            # Without a law the user's model stays.
            user, law = (base, base) if "refused" in found else held_out(found)
            shares = [share(user, law, rig.floor), *(share(base, e, rig.floor) for e in by_rival.values())]
            all_shares.append(shares)
            rows.append(f"| {name} | {label} | {rig.floor:.2e} | {user:.2e} | {law:.2e} | {found.get('family', 'no law')} | " + " | ".join(f"{s:.2f}" for s in shares) + " |")
            print(rows[-1], flush=True)
        means = [statistics.mean(s) for s in zip(*all_shares)]
        rows.append(f"| **mean** | {label} | | | | | " + " | ".join(f"**{m:.2f}**" for m in means) + " |")
    return rows


def families(engine, out):
    """A row for each kind of memory: how often it was the first of the law."""
    rows = []
    for k, family in enumerate(FAMILIES):
        found = []
        for i in range(RIGS_PER_FAMILY):
            size = float(np.linspace(0.6, 1.4, RIGS_PER_FAMILY)[i])
            rig = Rig(library_effect(family, size), 0.01, seed=200 + 10 * k + i, clock=0.4 * size if family == "clock" else 0.0)
            folder = out / f"{family}{i}"
            rig.write(folder)
            found.append(learned(engine, folder / "study.toml", folder / "law").get("family", "no law").split(" and ")[0])
        rows.append(f"| {family} | {sum(f == family for f in found)} of {RIGS_PER_FAMILY} | {', '.join(found)} |")
        print(rows[-1], flush=True)
    return rows


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--noise", type=float, nargs="+", default=[1.5])
    p.add_argument("--no-effects", action="store_true")
    p.add_argument("--no-families", action="store_true")
    p.add_argument("--out", type=Path, default=Path("results/learned"))
    p.add_argument("--engine", default="target/release/hysteron")
    args = p.parse_args()
    engine, out = str(Path(args.engine).resolve()), args.out.resolve()
    names = " | ".join(RIVALS)
    head = f"| effect | noise | floor | user | law | kinds of memory | learned law | {names} |"
    if not args.no_effects:
        write_table(HERE / "README.md", "effects", head, effects(engine, out, args.noise))
    if not args.no_families:
        write_table(HERE / "README.md", "families", "| memory of the rig | first of the law | found |", families(engine, out))


main()
