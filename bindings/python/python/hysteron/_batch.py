"""Batches: the cases of a plan, on threads or on the workers of Dask."""

import csv
import io
import os
import tempfile
from pathlib import Path

from ._hysteron import OpenSeesError, Plan

#: Tasks for each thread of the workers: few enough to cost little, enough to level out cases of different length.
_TASKS_A_THREAD = 8


class Table:
    """Table of the results of a batch, with a column for each parameter and result."""

    def __init__(self, text, failed, file):
        #: The table as CSV, the same bytes as `hysteron batch` writes.
        self.csv = text
        #: Number of cases whose script did not come to its end with all results.
        self.failed = failed
        #: File of the table.
        self.file = file
        rows = list(csv.reader(io.StringIO(text)))
        #: Columns by name: arrays of numbers where all words are numbers, else of text.
        self.columns = {name: _column([row[i] for row in rows[1:]]) for i, name in enumerate(rows[0])}

    def __getitem__(self, name):
        return self.columns[name]

    def __len__(self):
        return len(self.columns["case"])

    def __repr__(self):
        return f"<Table {len(self)} cases, {self.failed} failed, columns {', '.join(self.columns)}>"


def _column(words):
    import numpy as np

    try:
        return np.array([float(w) if w else np.nan for w in words])
    except ValueError:
        return np.array(words, dtype=object)


def batch(plan, out="batch", *, client=None, threads=None, resume=False):
    """Run the cases of a plan, as `hysteron batch` does, and return the table of their results.

    The files of the cases and ``results.csv`` go into the folder ``out``. With a ``client`` of Dask the cases run on its workers,
    which see the files of the plan under the same paths, and need no access to ``out``. Any number of threads or workers, in any
    order, gives the same bytes. A case whose worker has ended is run again. With ``resume`` complete cases are kept, unless a
    file that they have read has changed.
    """
    loaded = Plan(plan)
    cases = Path(out) / "cases"
    cases.mkdir(parents=True, exist_ok=True)
    if client is None:
        loaded.run(range(len(loaded.hashes)), cases, resume=resume, threads=threads or os.cpu_count() or 1)
    else:
        _on_workers(client, Path(plan).absolute(), loaded, cases, resume)
    text, failed = loaded.table(cases)
    file = Path(out) / "results.csv"
    _write(file, text.encode())
    return Table(text, failed, file)


def _on_workers(client, plan, loaded, cases, resume):
    import numpy as np

    hashes = loaded.hashes
    left = [i for i, name in enumerate(hashes) if not (resume and loaded.is_complete(i, cases))]
    tasks = max(1, sum(client.nthreads().values()) * _TASKS_A_THREAD)
    chunks = [c.tolist() for c in np.array_split(left, min(tasks, len(left)))] if left else []
    # The names of the cases are hashes of their inputs, so that equal tasks are equal work.
    futures = [client.submit(_run_cases, str(plan), os.getcwd(), c, [hashes[i] for i in c], pure=False) for c in chunks]
    try:
        from distributed import as_completed

        for future, done in as_completed(futures, with_results=True):
            for name, files in done:
                _take(cases / name, files)
            future.release()
    except BaseException:
        client.cancel(futures)
        raise


#: The plan that a worker has read last, by its path.
_read = {}


def _run_cases(plan, folder, numbers, hashes):
    """Run cases on a worker; the files of each."""
    if os.getcwd() != folder and os.path.isdir(folder):
        os.chdir(folder)
    if plan not in _read or [_read[plan].hashes[i] for i in numbers] != hashes:
        _read.clear()
        _read[plan] = Plan(plan)
    loaded = _read[plan]
    if [loaded.hashes[i] for i in numbers if i < len(loaded.hashes)] != hashes:
        raise OpenSeesError(f"the inputs of {plan} are not the same on this worker as on the client")
    with tempfile.TemporaryDirectory() as place:
        loaded.run(numbers, place)
        return [(name, _files_below(Path(place) / name)) for name in hashes]


def _files_below(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def _take(place, files):
    """Write the files of a case; the folder gets its name when it is complete."""
    import shutil

    part = place.with_name(place.name + ".part")
    shutil.rmtree(part, ignore_errors=True)
    for name, content in files.items():
        (part / name).parent.mkdir(parents=True, exist_ok=True)
        (part / name).write_bytes(content)
    shutil.rmtree(place, ignore_errors=True)
    part.rename(place)


def _write(file, content):
    part = file.with_suffix(".part")
    part.write_bytes(content)
    part.replace(file)
