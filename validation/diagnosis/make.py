#!/usr/bin/env python3
"""Makes the studies and truths of a sealed batch, whose cases are a module of generator/batches.

    python3 validation/diagnosis/make.py --batch 2 --opensees "python3 benches/peer.py run" --out DIR             # and compare with the archive
    python3 validation/diagnosis/make.py --batch 9 --opensees "python3 benches/peer.py run" --out DIR --archive   # and pack a new one

`--opensees` is any command that runs a Tcl script in OpenSees. A new batch is a module with SEED, STREAM, NAMES and CASES. Its seals are to be
published before any of its cases is diagnosed; its row of batches.csv takes the two digests that `--archive` prints.
"""

import argparse
import importlib
import os
import shlex
import tempfile

from evaluation import archive
from generator import sealed

HERE = os.path.dirname(os.path.abspath(__file__))


def write(case, name, out):
    """The files of a case: what the analyst has, the truth, and the concealed script."""
    folder = os.path.join(out, "cases", name)
    case.write(folder)
    for kind in ("truth", "concealed"):
        os.makedirs(os.path.join(out, kind), exist_ok=True)
    os.replace(os.path.join(folder, "truth.json"), os.path.join(out, "truth", name + ".json"))
    with open(os.path.join(out, "concealed", name + ".tcl"), "w") as f:
        f.write(case.script)


def seal(out):
    """Writes the digests of what is secret until the answers are given."""
    secret = [path for path in archive.files_below(out) if path.startswith(("truth/", "concealed/"))]
    with open(os.path.join(out, archive.SEALS), "w") as f:
        f.writelines(f"{archive.sha256(os.path.join(out, path))}  {path}\n" for path in secret)


def compare(out, names, source):
    """Says which files of the cases differ from those of the archive."""
    with tempfile.TemporaryDirectory() as packed:
        archive.unpack(source, packed)
        paths = [p for p in archive.files_below(packed) if any(f"/{name}{end}" in "/" + p for name in names for end in ("/", ".json", ".tcl"))]
        made = [os.path.exists(os.path.join(out, p)) and archive.sha256(os.path.join(out, p)) == archive.sha256(os.path.join(packed, p)) for p in paths]
    wrong = [p for p, same in zip(paths, made) if not same]
    print("\n".join(["differs: " + p for p in wrong] + [f"{len(paths) - len(wrong)} of {len(paths)} files are those of the archive"]))
    return not wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--batch", required=True)
    parser.add_argument("--opensees", required=True, help="command that runs a Tcl script in OpenSees")
    parser.add_argument("--out", required=True, help="folder for the files")
    parser.add_argument("--case", action="append", metavar="NAME", help="this case alone; may be repeated")
    parser.add_argument("--archive", action="store_true", help="pack a new archive instead of comparing with the one that is there")
    args = parser.parse_args()
    try:
        batch = importlib.import_module(f"generator.batches.batch_{args.batch}")
    except ModuleNotFoundError:
        raise SystemExit(f"no module of batch {args.batch}: README.md says which batches can be made again") from None
    # Scripts run in folders of their own.
    command = [os.path.abspath(word) if os.path.exists(word) else word for word in shlex.split(args.opensees)]
    names = []
    for name, case in sealed.cases(batch):
        if args.case and name not in args.case:
            continue
        off = case.run_all(command)
        print(name, *case.truth, {" ".join(k): f"{v:.2g}" for k, v in off.items()}, flush=True)
        write(case, name, args.out)
        names.append(name)
    target = os.path.join(HERE, "batches", f"{args.batch}.tar.xz")
    if not args.archive:
        raise SystemExit(0 if compare(args.out, names, target) else 1)
    if os.path.exists(target):
        raise SystemExit(f"{target} is there already")
    seal(args.out)
    print("files:", archive.pack(args.out, target))
    print("seal:", archive.sha256(os.path.join(args.out, archive.SEALS)))


if __name__ == "__main__":
    main()
