#!/usr/bin/env python3
"""Concealed in models of further kinds, by the means of ../structures: writes `cases/`, `truth/` and `concealed/`, and seals them.

    python3 make.py --opensees "python -m opensees"
"""

import argparse
import hashlib
import importlib.util
import os
import random
import shlex
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
STRUCTURES = os.path.join(HERE, "..", "structures")


def loaded(name, path):
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


sys.path.insert(0, STRUCTURES)
means = loaded("means", os.path.join(STRUCTURES, "make.py"))
further = loaded("further", os.path.join(HERE, "models.py"))

NAMES = ("alder", "birch", "cedar", "damson", "ebony", "fig", "ginkgo", "hornbeam", "ironwood", "juniper", "larch", "maple")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--opensees", required=True)
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--only", type=int, nargs="*", help="try these, and write nothing")
    args = parser.parse_args()
    names = list(NAMES)
    random.Random(f"order {args.seed}").shuffle(names)
    seals = []
    for number, (name, make) in enumerate(zip(names, further.ALL)):
        if args.only is not None and number not in args.only:
            continue
        own = random.Random(f"unfamiliar {args.seed} {number}")
        title, script, parameters, runs, channels, conceal = make(own)
        model = means.Structure(f"{title}, series {name}", f"# {title}, series {name}\n" + script, parameters, runs, channels)
        case = means.Sealed(name, model, conceal(model), own, 10 ** own.uniform(-1.9, -1.4))
        off = case.run_all(shlex.split(args.opensees))
        print(number, case.truth, {f"{r} {c}": f"{v:.2g}" for (r, c), v in off.items()}, flush=True)
        if args.only is not None:
            continue
        folder = os.path.join(HERE, "cases", name)
        case.write(folder)
        for kind in ("truth", "concealed"):
            os.makedirs(os.path.join(HERE, kind), exist_ok=True)
        os.replace(os.path.join(folder, "truth.json"), os.path.join(HERE, "truth", name + ".json"))
        with open(os.path.join(HERE, "concealed", name + ".tcl"), "w") as f:
            f.write(case.script)
        seals += [f"truth/{name}.json", f"concealed/{name}.tcl"]
    if args.only is None:
        with open(os.path.join(HERE, "sealed.sha256"), "w") as out:
            for path in sorted(seals) + ["make.py", "models.py"]:
                with open(os.path.join(HERE, path), "rb") as f:
                    out.write(f"{hashlib.sha256(f.read()).hexdigest()}  {path}\n")


if __name__ == "__main__":
    main()
