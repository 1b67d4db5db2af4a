"""Made rigs: a device with one memory under imposed motions, its study, and the analyst's fitted model. Needs numpy.

The device is a spring beside a slider. The analyst's script has both, and no memory. Ten effects are none of the library's causes;
four are, and differ from rig to rig.
"""
import numpy as np

DT, SAMPLES = 0.02, 1500
STIFFNESS, STRENGTH, LEVEL, STROKE = 400.0, 12.0, 0.003, 0.06


def motion(kind, rng):
    """An imposed motion of 30 s."""
    t = DT * np.arange(SAMPLES)
    if kind == "cycles":
        steps = np.interp(t, [0, 8, 10, 16, 18, 30], [0.3, 0.6, 0.6, 1.0, 0.4, 0.8])
        moving = np.where((t > 8) & (t < 10) | (t > 16) & (t < 18), 0.0, 1.0)
        return STROKE * steps * np.sin(np.cumsum(moving * (1.5 + 0.5 * rng.random())) * DT * np.pi)
    f = np.arange(1, 60) / t[-1]
    phases = rng.random(len(f)) * 2 * np.pi
    waves = (np.sin(2 * np.pi * np.outer(t, f) + phases) / (1 + (f / 0.8) ** 2)).sum(axis=1)
    waves *= np.minimum(1.0, t / 2.0) * (0.4 + 0.6 * np.sin(np.pi * t / t[-1]))
    # Two stops within the run.
    held = np.clip(np.interp(t, [0, 9, 11, 19, 22, 30], [0, 9, 9, 17, 17, 25]) / t[-1] * (SAMPLES - 1), 0, SAMPLES - 1)
    waves = np.interp(held, np.arange(SAMPLES), waves)
    return STROKE * 0.95 * (waves - waves[0]) / np.abs(waves - waves[0]).max()


class Memory:
    """Quantities of the past of a device that effects use."""

    def __init__(self):
        self.largest = self.work = self.heat = self.rest = self.aged = self.slow = self.path = self.set = self.damage = 0.0
        self.reversals, self.side, self.direction = 0, 0.0, 0.0

    def step(self, u, du, z):
        v = du / DT
        self.largest = max(self.largest, abs(u))
        slip = abs(du) if abs(z) >= 0.999 else 0.0
        self.path += slip
        self.work += abs(z) * abs(du)
        self.heat += abs(z) * abs(du) - self.heat * DT / 8.0
        self.rest = self.rest + DT if abs(v) < 1e-4 else 0.0
        self.aged = max(self.aged * np.exp(-slip / 0.008), np.log1p(self.rest / 0.3) / 3.0)
        self.slow += (abs(v) - self.slow) * DT / 1.5
        self.set += (0.35 * u - self.set) * DT / 3.0
        self.damage += abs(du) * 0.6 - self.damage * DT / 6.0
        if du * self.direction < 0:
            self.reversals += 1
        self.direction = du if du else self.direction
        self.side += (np.sign(u) - self.side) * DT / 4.0


# Factors of spring and strength, the origin and a further force, by memory and deformation.
EFFECTS = {
    "friction ages at rest": lambda m, u, v: (1, 1 + 0.7 * m.aged, 0, 0),
    "the origin creeps": lambda m, u, v: (1, 1, m.set, 0),
    "the slider runs in": lambda m, u, v: (1, 1 + 0.5 * (1 - np.exp(-m.path / 0.4)), 0, 0),
    "a worn spot of the stroke": lambda m, u, v: (1, 1 - 0.5 * np.exp(-((u - 0.015) / 0.012) ** 2), 0, 0),
    "friction follows the speed late": lambda m, u, v: (1, 1 + 0.45 * np.exp(-m.slow / 0.05), 0, 0),
    "the spring tires by reversals": lambda m, u, v: (1 - 0.45 * (1 - np.exp(-m.reversals / 12)), 1, 0, 0),
    "the spring heals with time": lambda m, u, v: (1 - 0.5 * np.tanh(m.damage / 0.3), 1, 0, 0),
    "the side last used is stronger": lambda m, u, v: (1, 1 + 0.4 * m.side * np.sign(u), 0, 0),
    "the slider is stronger near the end": lambda m, u, v: (1, 1 + 0.6 * (u / STROKE) ** 4, 0, 0),
    "resistance of a fluid by position": lambda m, u, v: (1, 1, 0, 40.0 * v * (u / STROKE) ** 2),
}


def library_effect(family, size):
    """An effect of a family of the library with a size between 0.5 and 1.5."""
    return {
        "heat": lambda m, u, v: (1, 1 - 0.7 * (1 - np.exp(-size * m.heat / 0.5)), 0, 0),
        "work": lambda m, u, v: (1 - size * 0.35 * (1 - np.exp(-m.work / 0.6)), 1 - size * 0.35 * (1 - np.exp(-m.work / 0.6)), 0, 0),
        "largest_deformation": lambda m, u, v: (1 + size * 0.8 * np.exp(-m.largest / (0.3 * STROKE)), 1, 0, 0),
        "clock": lambda m, u, v: (1, 1, 0, 0),
    }[family]


def force(u, effect, clock=0.0):
    """Force of the device along a motion; `clock` is the loss of strength over the run."""
    out, z, m = np.zeros(len(u)), 0.0, Memory()
    for j in range(1, len(u)):
        du = u[j] - u[j - 1]
        spring, strength, origin, further = effect(m, u[j], du / DT)
        strength *= 1 - clock * j / len(u)
        z = np.clip(z + du / LEVEL, -strength, strength)
        m.step(u[j], du, z / strength)
        out[j] = STIFFNESS * spring * (u[j] - origin) + STRENGTH * z + further
    return out


MODEL = """# A spring beside a slider.
# Units: kN, m, s.
wipe
model basic -ndm 1 -ndf 1
pset K 300.0
pset Q 10.0
pset K1 5000.0
node 1 0.0
node 2 0.0
fix 1 1
uniaxialMaterial ElasticPP 1 $K1 [expr {$Q/$K1}]
uniaxialMaterial Elastic 2 $K
uniaxialMaterial Parallel 3 1 2
element zeroLength 1 1 2 -mat 3 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-10 40
algorithm Newton
integrator LoadControl $dt
analysis Static
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
"""
BOUNDS = {"K": (50, 2000), "Q": (1, 60), "K1": (500, 40000)}


class Rig:
    """Runs of a rig: motions, recorded forces and the variance of their noise; the last run is held out."""

    def __init__(self, effect, noise, seed, clock=0.0):
        rng = np.random.default_rng(seed)
        self.motions = [motion(kind, rng) for kind in ("cycles", "random", "random")]
        clean = [force(u, effect, clock) for u in self.motions]
        self.recorded = [f + rng.normal(0, noise * f.std(), len(f)) for f in clean]
        self.floor = float(np.mean((self.recorded[-1] - clean[-1]) ** 2) / self.recorded[-1].var())

    def write(self, folder):
        """Writes its study."""
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "model.tcl").write_text(MODEL)
        bounds = "".join(f'[[parameter]]\nname = "{n}"\nlower = {a}\nupper = {b}\nscale = "log"\n' for n, (a, b) in BOUNDS.items())
        text = f'title = "a made rig"\nmodel = "model.tcl"\n{bounds}'
        for k, (u, f) in enumerate(zip(self.motions, self.recorded)):
            np.savetxt(folder / f"run{k}.dat", u, fmt="%.9g")
            rows = "".join(f"{DT * j:.6g},{y:.9g}\n" for j, y in enumerate(f))
            (folder / f"run{k}.csv").write_text("time[s],force[kN]\n" + rows)
            role = "holdout" if k == len(self.motions) - 1 else "fit"
            text += (f'[[run]]\nname = "run {k}"\nrole = "{role}"\nrecording = "run{k}.csv"\n'
                     f'set = {{ motion = "run{k}.dat", dt = {DT}, npts = {SAMPLES} }}\n'
                     'observe = [{ channel = "force", output = "force.out", column = 2 }]\n')
        (folder / "study.toml").write_text(text)

    def user_forces(self):
        """The analyst's model, fitted to the runs that are not held out: a spring beside a slider of the best level."""
        def columns(level):
            out = []
            for u in self.motions:
                z, stop = 0.0, np.zeros(len(u))
                for j in range(1, len(u)):
                    z = min(max(z + u[j] - u[j - 1], -level), level)
                    stop[j] = z
                out.append(np.column_stack([u, stop]))
            return out

        def fit(level):
            a = columns(level)
            scale = [f.std() for f in self.recorded[:-1]]
            x = np.vstack([c / s for c, s in zip(a, scale)])
            y = np.concatenate([f / s for f, s in zip(self.recorded, scale)])
            w, *_ = np.linalg.lstsq(x, y, rcond=None)
            return np.sum((x @ w - y) ** 2), level, [c @ w for c in a]

        def best(levels):
            return min((fit(level) for level in levels), key=lambda x: x[0])
        _, near, _ = best(LEVEL * np.geomspace(0.3, 5.0, 16))
        return best(near * np.geomspace(0.85, 1.18, 16))[2]
