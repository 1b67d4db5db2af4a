"""Storey drifts, slip of the bearings and table accelerations at 128 Hz."""
import math

from bench import columns, write

FILES = ["fixed_gm152_level1", "fixed_gm152_level2", "fixed_gm152_level3", "isolated_gm152_level1", "isolated_gm152_level2", "isolated_gm111_level1", "isolated_gm111_level2",
         "isolated_gm162_level1", "isolated_gm162_level2"]
VARIANTS = {"linear": ("linear.toml", None), "fixed": ("fixed.toml", None), "bilinear": ("bilinear.toml", None),
            "without_isolation": ("without_isolation.toml", None)}
G = 386.0886        # in/s2
STEP = 1.0 / 256.0  # s, of the source
CORNER = 0.15       # Hz; the table's displacement was not recorded, and integration below it drifts
AT_REST = 100       # samples before the motion


def high_passed(x, step):
    """Two-pole Butterworth high-pass, forwards and backwards."""
    w = math.tan(math.pi * CORNER * step)
    a0 = 1.0 + math.sqrt(2.0) * w + w * w
    b, a1, a2 = 1.0 / a0, 2.0 * (w * w - 1.0) / a0, (1.0 - math.sqrt(2.0) * w + w * w) / a0
    for _ in range(2):
        y, x1, x2, y1, y2 = [], 0.0, 0.0, 0.0, 0.0
        for v in x:
            out = b * (v - 2.0 * x1 + x2) - a1 * y1 - a2 * y2
            x1, x2, y1, y2 = v, x1, out, y1
            y.append(out)
        x = y[::-1]
    return x


def integrated(x, step):
    total, out = 0.0, [0.0]
    for a, b in zip(x, x[1:]):
        total += 0.5 * step * (a + b)
        out.append(total)
    return out


def table_displacement(acceleration):
    velocity = high_passed(integrated(high_passed(acceleration, STEP), STEP), STEP)
    return high_passed(integrated(velocity, STEP), STEP)


def smoothed(x):
    """Every second sample of the source, averaged with its neighbours against aliases."""
    padded = [x[0], *x, x[-1]]
    return [0.25 * padded[i] + 0.5 * padded[i + 1] + 0.25 * padded[i + 2] for i in range(0, len(x), 2)]


def prepare(data, folder):
    for name in FILES:
        c = columns(data / "friction-pendulum-frame-buffalo" / f"{name}.csv")
        ground = [G * a for a in c["table_acc[g]"]]
        levels = []
        for key in ("s2[in]", "s3[in]", "s4[in]", "s5[in]"):
            rest = sum(c[key][:AT_REST]) / AT_REST
            levels.append([x - rest for x in c[key]])
        channels = {f"drift{i}[in]": [b - a for a, b in zip(levels[i - 1], levels[i])] for i in (1, 2, 3)}
        if name.startswith("isolated"):
            channels["slip[in]"] = [s - u for s, u in zip(levels[0], table_displacement(ground))]
        write(folder, name, smoothed(ground), 2 * STEP, {k: smoothed(v) for k, v in channels.items()})


def panel(folder, run, channel, time, curves):
    """Slip over time."""
    if channel != "slip":
        return None
    return ("s", "in"), {k: (time, y) for k, y in curves.items()}
