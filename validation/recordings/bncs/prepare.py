"""Thirty strong seconds of each motion, every second sample (50 Hz)."""
from bench import columns, write

START = {"CNP100": 6.0, "LAC100": 11.0, "ICA50": 32.0, "ICA100": 39.0}
LICENSED = True  # MIT: the thinned recordings are kept here
VARIANTS = {"two_held_out": ("study.toml", None)} | {f"without_{r}": ("study.toml", [r]) for r in START}


def prepare(data, folder):
    for name, start in START.items():
        c = columns(data / f"bncs-hdr-isolated-building/{name}.csv")
        first = round(100 * start)
        c = {k: v[first:first + 3001:2] for k, v in c.items()}
        write(folder, name, c["table_acc_m_s2"], 0.02, {
            "base_disp[m]": c["disp_rel_table_level1_isolated_base_m"],
            "base_acc[m/s2]": c["abs_acc_level1_isolated_base_m_s2"],
            "roof_acc[m/s2]": c["abs_acc_roof_m_s2"],
        })


def panel(folder, run, channel, time, curves):
    if channel == "base_disp":
        return ("time, s", "m"), {k: (time, y) for k, y in curves.items()}
