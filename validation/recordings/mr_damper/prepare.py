"""Three windows of two seconds at the 1002 Hz of the file."""

from bench import columns, write

VARIANTS = {"no_voltage": ("study.toml", None)}


def prepare(data, folder):
    c = columns(data / "mr-damper-dyke-nees/ranran_50.csv")
    for name, start in (("first", 0), ("second", 4000), ("third", 8000)):
        u, f, volt = (c[k][start:start + 2000] for k in ("disp_mm", "force_N", "circuit_voltage_V"))
        write(folder, name, u, 0.00099834, {"force[N]": f, "disp[mm]": u, "voltage[V]": volt})


def panel(folder, run, channel, time, curves):
    return ("time, s", "N"), {k: (time[:500], y[:500]) for k, y in curves.items()}
