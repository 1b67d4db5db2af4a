"""No times in the source: a sample a second. Nothing is thinned."""
from bench import columns, write

LICENSED = True  # MIT: the recordings are kept here
VARIANTS = {"perfectly_plastic": ("study.toml", None), "bilinear": ("hardening.toml", None)}


def prepare(data, folder):
    for name in ("example_1", "example_2"):
        c = columns(data / f"steel-coupon-cyclic-resspylab/{name}.csv")
        write(folder, name, c["true_strain"], 1.0, {"stress[MPa]": c["true_stress_MPa"], "strain[-]": c["true_strain"]})


def panel(folder, run, channel, time, curves):
    u = columns(folder / run["recording"])["strain[-]"]
    return ("strain", "MPa"), {k: (u, y) for k, y in curves.items()}
