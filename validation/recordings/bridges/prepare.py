"""Twenty seconds of each event, 50 Hz, transverse channels in m/s2; the motion is that of the foot of the bent."""
from bench import columns, resample, write

LICENSED = True  # public records of CSMIP/CESMD
PAINTER = {"painter_weak": ("2021-12-20_petrolia_weak_acc", 24.0), "painter_aftershock": ("1992-04-26_aftershock1_acc", 0.0), "painter_main": ("1992-04-25_petrolia_mainshock_acc", 0.0)}
PAINTER_CHANNELS = {"west_end": "ch04", "bent": "ch07", "east_end": "ch09"}
MELOLAND = {"meloland_weak": (("2008-11-20_calexico_weak_dt0.005_acc", "2008-11-20_calexico_weak_dt0.01_acc"), 6.0), "meloland_strong": (("1979-10-15_imperial_valley_dt0.02_acc",), 0.0)}
MELOLAND_CHANNELS = {"south_end": "ch03", "south_span": "ch05", "bent": "ch07", "north_span": "ch09", "north_end": "ch13"}
VARIANTS = {"painter_weak_fitted": ("painter.toml", None), "painter_strong_fitted": ("painter.toml", ["2021 weak", "1992 aftershock"]), "painter_both_fitted": ("painter.toml", ["1992 aftershock"]),
            "meloland_weak_fitted": ("meloland.toml", None), "meloland_strong_fitted": ("meloland.toml", ["2008 weak"])}
NAME = "{}_acc_cm_s2"


def prepare(data, folder):
    events = [(n, data / "painter-street-overcrossing", (f,), s, "ch03", PAINTER_CHANNELS) for n, (f, s) in PAINTER.items()]
    events += [(n, data / "meloland-road-overcrossing", f, s, "ch02", MELOLAND_CHANNELS) for n, (f, s) in MELOLAND.items()]
    for name, source, files, start, foot, channels in events:
        times = [start + 0.02 * i for i in range(1001)]
        found = {}
        for file in files:
            c = columns(source / f"{file}.csv")
            for channel in (foot, *channels.values()):
                if NAME.format(channel) in c:
                    found[channel] = [0.01 * v for v in resample(c["time_s"], c[NAME.format(channel)], times)]
        write(folder, name, found[foot], 0.02, {f"{k}[m/s2]": found[v] for k, v in channels.items()})


def panel(folder, run, channel, time, curves):
    if channel == "bent":
        return ("time, s", "m/s²"), {k: (time[:600], y[:600]) for k, y in curves.items()}
