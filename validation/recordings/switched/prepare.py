"""Conditions that the testers switched: the brake at 64 Hz (128 Hz at 1 Hz), the hydraulic damper in windows of 4.5 s at 100 Hz."""
from bench import columns, resample, write

BRAKE = "friction-damper-backlash-brfd/harmonic_"
RUNS = {"36lb_1in": (BRAKE + "0.5Hz_36lb_1in", 4), "36lb_0.5in": (BRAKE + "0.5Hz_36lb_0.5in", 4), "36lb_1in_1Hz": (BRAKE + "1Hz_36lb_1in", 2),
        "30lb_1in": (BRAKE + "0.5Hz_30lb_1in", 4), "30lb_0.5in": (BRAKE + "0.5Hz_30lb_0.5in", 4), "30lb_1.5in": (BRAKE + "0.5Hz_30lb_1.5in", 4),
        "0lb_1in": (BRAKE + "0.5Hz_0lb_1in", 4), "0lb_1.5in": ("switched/0lb_1.5in", 4),
        "30lb_1in_again": ("switched/30lb_1in_again", 4), "30lb_1.5in_again": ("switched/30lb_1.5in_again", 4)}
WINDOWS = {"valve_24_a": ("hydraulic-damper-temperature/t1_3_3_24_24_s5_n10_100psi", 0.5), "valve_24_b": ("hydraulic-damper-temperature/t1_3_3_24_24_s5_n10_100psi", 5.5),
           "valve_12_a": ("switched/valve_12", 0.5), "valve_12_b": ("switched/valve_12", 40.5)}
STUDIES = ("brake_off", "brake_repeated", "brake_36_30", "brake_36_0", "valve_off", "valve_24_12")
VARIANTS = {name: (f"{name}.toml", None) for name in STUDIES}


def prepare(data, folder):
    for name, (file, every) in RUNS.items():
        c = columns(data / f"{file}.csv")
        u, f = (c[column][::every] for column in ("disp_mm", "force_kN"))
        write(folder, name, u, every / 256, {"force[kN]": f, "disp[mm]": u})
    for name, (file, start) in WINDOWS.items():
        c = columns(data / f"{file}.csv")
        times = [start + 0.01 * i for i in range(451)]
        u, f = (resample(c["time_s"], c[k], times) for k in ("disp_mm", "force_N"))
        u = [x - u[0] for x in u]
        write(folder, name, u, 0.01, {"force[N]": f, "disp[mm]": u})


def panel(folder, run, channel, time, curves):
    u = columns(folder / run["recording"])["disp[mm]"]
    return ("mm", "force"), {k: (u, y) for k, y in curves.items()}
