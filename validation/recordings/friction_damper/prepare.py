"""Every fourth sample (64 Hz) of the slow runs and the earthquakes, every second of those at 1 and 2 Hz."""
from bench import columns, write

EVERY = {"harmonic_0.5Hz_36lb_1in": 4, "harmonic_1Hz_36lb_1in": 2, "harmonic_2Hz_36lb_0.5in": 2, "harmonic_0.5Hz_36lb_0.5in": 4,
         "harmonic_0.25Hz_36lb_1in": 4, "harmonic_0.5Hz_30lb_1in": 4, "eq_36lb_KocaeliDBE": 4, "eq_36lb_ImperialValleyDBE": 4,
         "semiactive_step0.03ea1forward": 4}
# Rows that are kept: the band is let go at rest behind them.
ROWS = {"semiactive_step0.03ea1forward": 897}
VARIANTS = {"no_backlash": ("study.toml", None), "no_speed": ("backlash.toml", None),
            "pretension": ("condition.toml", None), "tightened": ("tightened.toml", None)}


def prepare(data, folder):
    for name, every in EVERY.items():
        c = columns(data / f"friction-damper-backlash-brfd/{name}.csv")
        u, f = (c[column][::every][:ROWS.get(name)] for column in ("disp_mm", "force_kN"))
        write(folder, name, u, every / 256, {"force[kN]": f, "disp[mm]": u})


def panel(folder, run, channel, time, curves):
    u = columns(folder / run["recording"])["disp[mm]"]
    return ("mm", "kN"), {k: (u, y) for k, y in curves.items()}
