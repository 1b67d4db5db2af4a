"""Every 1th sample; fitted are the smaller cycles, held out the larger ones that follow (the whole path is imposed)."""
import math

from bench import columns, write

LICENSED = True  # Apache-2.0: the thinned recordings are kept here
VARIANTS = {"bilinear": ("study.toml", None)}
FIRST, SPLIT, END, EVERY = 8420, 8820, 9281, 1


def prepare(data, folder):
    c = columns(data / "clt-rocking-wall-ts1/TS1.csv")
    for name, last in (("first", SPLIT), ("later", END)):
        u = [1000.0 * x for x in c["top_disp_m"][FIRST:last:EVERY]]
        force = c["base_shear_kN"][FIRST:last:EVERY]
        u, force = [x - u[0] for x in u], [x if name == "first" or FIRST + EVERY * i >= SPLIT else math.nan for i, x in enumerate(force)]
        write(folder, name, u, 1.0, {"force[kN]": force, "disp[mm]": u})


def panel(folder, run, channel, time, curves):
    u = columns(folder / run["recording"])["disp[mm]"]
    return ("mm", "kN"), {k: (u, y) for k, y in curves.items()}
