"""Every so-manieth sample, so that a cycle has about 40, 80 or 320. The source has no time: samples are counted."""
from bench import columns, write

PER_CYCLE = (40, 80, 320)
SOURCE_PER_CYCLE = 941
VARIANTS = {f"samples_{n}": (f"cycles_of_{n}.toml", None) for n in PER_CYCLE}


def prepare(data, folder):
    c = columns(data / "hdr-bearing-bench" / "hdrb_shear_to_98.csv")
    for n in PER_CYCLE:
        step = round(SOURCE_PER_CYCLE / n)
        u, f = c["displacement[cm]"][::step], c["force[tonf]"][::step]
        write(folder, f"shear_{n}", u, 1.0, {"force[tonf]": f, "disp[cm]": u})


def panel(folder, run, channel, time, curves):
    u = columns(folder / run["recording"])["disp[cm]"]
    return ("cm", "tonf"), {k: (u, y) for k, y in curves.items()}
