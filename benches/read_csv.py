#!/usr/bin/env python3
"""Reading of a large table on one core: hysteron's reader beside pandas and polars, where these are installed.

    cargo build --release -p hysteron-recordings --example read_time
    taskset -c 0 python3 benches/read_csv.py target/release/examples/read_time [MB]

Each reader runs three times on one file in the page cache; the shortest time counts, and the largest resident memory.
The time is that of reading; the time of the processor is that of the whole process, with its start and its imports.
"""

import os
import resource
import subprocess
import sys
import tempfile

ROW = "{:.3f},{:.7f},{:.7f},{:.7f},{:.7f},{:.7f}\n"
PANDAS = "import pandas, sys, time; t = time.time(); d = pandas.read_csv(sys.argv[1]); print(f'{len(d)} rows, {d.shape[1]} columns, {time.time() - t:.2f} s')"
POLARS = "import polars, sys, time; t = time.time(); d = polars.read_csv(sys.argv[1]); print(f'{d.height} rows, {d.width} columns, {time.time() - t:.2f} s')"


def table(path, size):
    """Write a table of a time and five channels with `size` bytes or a little more."""
    written = 0
    with open(path, "w") as f:
        written += f.write("time[s],u[mm],v[mm/s],a[g],F1[kN],F2[kN]\n")
        i = 0
        while written < size:
            x = (i * 2654435761 % 2**32) / 2**32
            written += f.write(ROW.format(i * 0.001, 100 * x - 50, 30 * x, 0.3 * x - 0.1, 250 * x, -120.5 * x))
            i += 1


def run(command):
    """Output, processor time of the process in s, and its largest resident memory in MB."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    out = process.stdout.read().strip()
    _, status, usage = os.wait4(process.pid, 0)
    return (out if status == 0 else ""), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    reader, megabytes = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 100.0
    os.environ["POLARS_MAX_THREADS"] = "1"
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "table.csv")
        table(path, megabytes * 1e6)
        print(f"{os.path.getsize(path) / 1e6:.1f} MB")
        for name, command in [
            ("hysteron", [reader, path]),
            ("pandas", [sys.executable, "-c", PANDAS, path]),
            ("polars", [sys.executable, "-c", POLARS, path]),
        ]:
            runs = [run(command) for _ in range(3)]
            if not all(out for out, _, _ in runs):
                print(f"{name:10} does not run")
                continue
            seconds = [float(out.rsplit(", ", 1)[1].split()[0]) for out, _, _ in runs]
            memory, processor = max(r[2] for r in runs), min(r[1] for r in runs)
            print(f"{name:10} {min(seconds):6.2f} s, {processor:6.2f} s of the processor, {memory:6.0f} MB resident: {runs[0][0]}")


if __name__ == "__main__":
    main()
