"""Four hundred even samples a run."""
from bench import columns, resample, write

OCA = {"oca_0.083": ("oca_shear_step_relaxation_src5_rate0.083", 2.1), "oca_0.017": ("oca_shear_step_relaxation_src1_rate0.017", 3.3),
       "oca_0.070": ("oca_shear_step_relaxation_src0d1_rate0.070", 2.05), "oca_unload": ("oca_shear_load_unload_step_relaxation", 2.85)}
VHB = {"vhb_0d01_2d0": 0.5, "vhb_0d05_2d0": 0.1, "vhb_0d01_1d5": 0.25, "vhb_0d05_1d5_1": 0.05, "vhb_0d01_2d5": 0.75, "vhb_0d05_2d5_1": 0.15}
VARIANTS = {"shear": ("study.toml", None), "tension": ("vhb.toml", None)}


def prepare(data, folder):
    source = data / "acrylic-viscoelastic-rate-relaxation"
    files = {n: (source / f"{f}.csv", dt) for n, (f, dt) in OCA.items()} | {n: (source / f"vhb4910_tension_load_unload_{n[4:]}.csv", dt) for n, dt in VHB.items()}
    for name, (file, dt) in files.items():
        c = columns(file)
        times = [dt * i for i in range(401 if c["time_s"][-1] >= 400 * dt - dt / 2 else 400)]
        t, u, f = [-1e-9, *c["time_s"]], [0.0, *c["disp_mm"]], [0.0, *c["force_N"]]
        u, f = resample(t, u, times), resample(t, f, times)
        write(folder, name, u, dt, {"force[N]": f, "disp[mm]": u})


def panel(folder, run, channel, time, curves):
    u = columns(folder / run["recording"])["disp[mm]"]
    return ("mm", "N"), {k: (u, y) for k, y in curves.items()}
