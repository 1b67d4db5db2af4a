"""Nine seconds of a cold run, and two of nine seconds of a run under a heat gun, 100 Hz; once with and once without the column of temperature."""
from bench import columns, resample, write

VARIANTS = {"temperature_known": ("study.toml", None), "temperature_dropped": ("no_temperature.toml", None)}


def prepare(data, folder):
    for name, file, start in (("cold", "t1_3_3_24_24_s5_n10_100psi", 0.5), ("hot", "t1_3_3_24_24_s5_n100_100psi_with_heat_gun", 84.0), ("warm", "t1_3_3_24_24_s5_n100_100psi_with_heat_gun", 40.0)):
        c = columns(data / f"hydraulic-damper-temperature/{file}.csv")
        times = [start + 0.01 * i for i in range(901)]
        u, f, hot = (resample(c["time_s"], c[k], times) for k in ("disp_mm", "force_N", "body_temp_C"))
        u = [x - u[0] for x in u]
        write(folder, name, u, 0.01, {"force[N]": f, "disp[mm]": u, "temperature[degC]": [sum(hot) / len(hot)] * len(hot)})
        write(folder, name + "_bare", u, 0.01, {"force[N]": f, "disp[mm]": u})


def panel(folder, run, channel, time, curves):
    return ("time, s", "N"), {k: (time[:300], y[:300]) for k, y in curves.items()}
