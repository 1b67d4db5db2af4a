#!/usr/bin/env python3
"""Makes the tables of two public repositories that the other sources do not use.

    validation/recordings/switched/convert.py BRAKE HYDRAULIC DATA

BRAKE is a clone of github.com/ARTS-Laboratory/Dataset-Friction-Damper-with-Backlash (CC BY-SA 4.0), HYDRAULIC one of
github.com/LucasDudley/damper_characterization (no licence stated), either of them with or without a work tree. The tables go to
DATA/switched, in the form of the neighbouring folders: 256 Hz, mm and kN; 300 Hz, mm and N.
"""
import csv
import io
import json
import subprocess
import sys
from pathlib import Path

BRAKE = {
    "30lb_1in_again": "data/dataset-3/characterization tests/0.5Hz30lbtension1amplitude.json",
    "30lb_1.5in_again": "data/dataset-3/characterization tests/0.5Hz30lbtension1.5amplitude.json",
    "0lb_1.5in": "data/dataset-2/characterization datasets/0.5Hz0lbtension1.5amplitude.json",
}
HYDRAULIC = {
    "valve_12": "Test_Data/Phase1_temp_sensitivity/t2_3_3_12_12_s5_n100_100psi_with_heat_gun.csv",
}
MM_PER_INCH, KN_PER_KIP = 25.4, 4.4482216


def content(clone, path):
    return subprocess.run(["git", "-C", clone, "show", f"HEAD:{path}"], check=True, capture_output=True, text=True).stdout


def write(path, head, rows):
    with path.open("w") as f:
        f.write(head + "\n")
        f.writelines(",".join(f"{x:.6g}" for x in row) + "\n" for row in rows)


def main():
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    brake, hydraulic, out = sys.argv[1], sys.argv[2], Path(sys.argv[3]) / "switched"
    out.mkdir(parents=True, exist_ok=True)
    for name, path in BRAKE.items():
        rows = json.loads(content(brake, path))["data"][::4]
        write(out / f"{name}.csv", "time_s,disp_mm,force_kN", ((r[0], MM_PER_INCH * r[1], KN_PER_KIP * r[2]) for r in rows))
    for name, path in HYDRAULIC.items():
        rows = list(csv.DictReader(io.StringIO(content(hydraulic, path))))
        write(out / f"{name}.csv", "time_s,disp_mm,force_N,body_temp_C",
              ((i / 300, float(r["Displacement (mm)"]), float(r["Force (N)"]), float(r["Temperature (C)"])) for i, r in enumerate(rows)))


if __name__ == "__main__":
    main()
