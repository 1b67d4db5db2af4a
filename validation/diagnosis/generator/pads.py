"""Rig tests of one bearing under imposed motion: in shear, along orbits, under axial load, in axial pulls."""

import math

from . import signals
from .effects import DEVICE, Coupling, Scale, State, drive
from .laws import Bilinear, BoucWen, MenegottoPinto, Viscoelastic
from .model import Channel, Model, Run, Units, loop, number

SUB = 4


def tidy(dt):
    return float(f"{dt:.3g}")


STATIC = """constraints Transformation
numberer Plain
system UmfPack
test NormDispIncr {tol} 60
algorithm Newton
integrator LoadControl $dt
analysis Static
"""
ACTUATOR = """constraints {how}
numberer Plain
system BandGeneral
test NormDispIncr {tol} 60
algorithm Newton
integrator Newmark 0.6 0.3025
analysis Transient
"""


class Pad(Model):
    def __init__(self, rng, causes, family="pad"):
        self.units = un = Units(rng)
        self.causes, self.family = causes, family
        self.known = None
        self.vertical_test = "cavitation" in causes
        self.orbit = "bidirectional_coupling" in causes or ("none" in causes and rng.random() < 0.15)
        self.vertical_in_script = rng.random() < 0.7
        self.U = rng.uniform(0.02, 0.15) * un.L
        self.Q = 10 ** rng.uniform(3.7, 4.9) * un.F
        if self.vertical_test:
            self.U *= 0.1
        self.k2 = self.Q / self.U * rng.uniform(0.4, 1.5)
        self.uy = self.U * rng.uniform(0.05, 0.16)
        self.kind = self.pick_kind(rng)
        self.n = rng.choice((1.0, 1.0, 2.0)) if self.kind in ("spring", "link") else 1.0
        if self.orbit:
            self.n = 2.0
        self.P0 = rng.uniform(4.0, 12.0) * self.Q
        self.title = f"pad {rng.randint(2, 60)}, " + rng.choice(("cyclic shear", "acceptance test", "prototype test", "research rig"))
        self.parameters = self.draw_parameters(rng)
        self.runs = self.draw_runs(rng)
        self.script = self.write_script()
        if self.orbit:
            self.channels = [Channel("force_" + d, un.force, "force.out", c, "upper plate") for d, c in (("x", 3), ("y", 4))]
        else:
            column = {"bearing": 4, "plastic": 4, "vertical": 5, "link": 4}.get(self.kind, 2)
            self.channels = [Channel("force", un.force, "force.out", column, "upper plate")]

    def pick_kind(self, rng):
        c = self.causes
        if self.orbit:
            return "orbit"
        if self.vertical_test:
            return "vertical"
        if any(x in c for x in ("axial_shear_interaction", "varying_axial_load")):
            return rng.choice(("bearing", "plastic"))
        if "pinching" in c:
            return rng.choice(("spring", "link"))
        if any(x in c for x in ("self_heating", "cyclic_degradation", "ambient_temperature", "lopsided")):
            return rng.choice(("spring", "link", "bearing", "plastic", "steel01"))
        return rng.choice(("spring", "link", "bearing", "plastic", "steel02", "steel01", "visco"))

    def draw_parameters(self, rng):
        k1 = self.k2 + self.Q / self.uy
        alpha = self.k2 / k1
        if self.kind in ("spring", "link", "orbit", "plastic"):
            return {"kInit" if self.kind == "plastic" else "ko": k1, "Qd": self.Q, "alpha": alpha}
        if self.kind == "bearing":
            return {"kInit": k1, "Fy": self.Q, "alpha": alpha}
        if self.kind == "steel01":
            return {"Fy": k1 * self.uy, "E0": k1, "b": alpha}
        if self.kind == "steel02":
            self.b = rng.uniform(0.01, 0.03)
            return {"Fy": self.Q, "E0": self.Q / self.uy, "ks": self.k2}
        k = 3.0 * self.k2
        w = 2.0 * math.pi * 0.3
        return {"k": k, "c": k / w * rng.uniform(0.05, 0.2)}

    def law(self, p):
        if self.kind == "steel02":
            return MenegottoPinto(p["Fy"], p["E0"], self.b, p["ks"])
        if self.kind == "steel01":
            return Bilinear(p["b"] * p["E0"], p["Fy"] * (1.0 - p["b"]), p["E0"])
        if self.kind in ("visco", "vertical"):
            return Viscoelastic(p["k"], p["c"])
        k1 = p["kInit"] if "kInit" in p else p["ko"]
        Q = p["Fy"] if "Fy" in p else p["Qd"]
        if self.kind == "plastic":
            return Bilinear(p["alpha"] * k1, Q, k1)
        return BoucWen(p["alpha"] * k1, Q, k1, self.n)

    # -------------------------------------------------------------- motions

    def draw_runs(self, rng):
        U, c = self.U, self.causes
        f = rng.choice((0.1, 0.2, 0.25, 0.5, 1.0))
        if self.kind in ("visco", "vertical"):
            f = rng.choice((0.2, 0.3, 0.5))
        cycle = rng.choice((90, 110, 130))

        def grow(a, speed=1.0, steps=4, repeat=2):
            amps = [a * (i + 1) / steps for i in range(steps) for _ in range(repeat)]
            dt = tidy(1.0 / (f * speed * cycle))
            return dt, signals.cycles(amps, f * speed, dt, rest=5 * dt)

        def steady(a, count, speed=1.0, pause=None):
            dt = tidy(1.0 / (f * speed * cycle))
            return dt, signals.cycles([a] * count, f * speed, dt, rest=5 * dt, pause=pause)

        def roam(a, speed=1.0, periods=8):
            dt = tidy(1.0 / (f * speed * cycle))
            return dt, signals.wander(rng, a, 0.35 * f * speed, 1.6 * f * speed, periods / (f * speed), dt)

        def chirp(a, speed=1.0):
            f0, f1 = 0.4 * f * speed, 2.5 * f * speed
            dt = tidy(1.0 / (f1 * 50))
            return dt, signals.sweep(a, f0, f1, 12 / (f1), dt)

        if "rate_dependence" in c:
            r = rng.choice((5.0, 8.0))
            plan = [("slow", grow(U, 1.0 / r, 3, 1)), ("fast", grow(0.9 * U, 1.0)), ("middle", roam(0.95 * U, 0.5))]
        elif "self_heating" in c:
            pause = (16, 6 / f) if rng.random() < 0.6 else None
            plan = [("many", steady(U, 22, pause=pause)), ("few", grow(0.8 * U)), ("blocks", steady(0.9 * U, 14, pause=(8, 5 / f)))]
        elif "cyclic_degradation" in c:
            plan = [("steady", steady(U, 12)), ("growing", grow(0.9 * U, steps=3, repeat=3)), ("other", roam(0.95 * U, periods=10))]
        elif "mullins_softening" in c:
            plan = [("growing", grow(U, steps=rng.choice((4, 5)))), ("steady", steady(0.7 * U, 5)), ("check", roam(0.9 * U))]
        else:
            kinds = [grow(U), roam(0.9 * U), steady(0.85 * U, 6), chirp(U) if self.kind != "orbit" else roam(U, 1.4), grow(0.95 * U, 1.5, 3)]
            first = kinds.pop(rng.choice((0, 1, 3)))
            rng.shuffle(kinds)
            plan = [("first", first), ("second", kinds[0]), ("check", kinds[1])]
        single = not any(x in c for x in ("rate_dependence", "ambient_temperature", "axial_shear_interaction", "sensor_gain"))
        if single and rng.random() < 0.3:
            del plan[1]
        runs = []
        temperatures, axials = [23.0, rng.uniform(-25.0, -5.0), rng.uniform(0.0, 12.0)], [0.4, 1.5, 1.0]
        for i, (name, (dt, motion)) in enumerate(plan):
            role = "holdout" if i == len(plan) - 1 else "fit"
            motions = [motion]
            if self.orbit:
                motions = self.orbits(rng, dt, motion, i)
            P, T = self.P0, 23.0
            if "axial_shear_interaction" in c:
                P = self.P0 * axials[i if len(plan) == 3 else 2 * i]
            if "ambient_temperature" in c:
                T = temperatures[i]
            run = Run(name, role, dt, motions, T, P)
            if "varying_axial_load" in c:
                self.shake_vertically(rng, run)
            runs.append(run)
        return runs

    def orbits(self, rng, dt, motion, i):
        """The second direction: a quarter of a cycle later, of double frequency, or on its own."""
        n = len(motion)
        kind = ("late", "own", "eight")[(i + rng.randint(0, 1)) % 3]
        seconds = (n - 1) * dt
        if kind == "own":
            return [motion, signals.wander(rng, 0.9 * self.U, 3 / seconds, 12 / seconds, seconds, dt)[:n]]
        f = 6.0 / seconds
        x, y = [], []
        for j in range(n):
            a = 2 * math.pi * f * j * dt
            env = signals.fade(j / (n - 1)) * self.U
            x.append(env * math.sin(a))
            y.append(0.8 * env * (math.cos(a) if kind == "late" else math.sin(2 * a)))
        return [x, y]

    def shake_vertically(self, rng, run):
        a, b = rng.uniform(0.25, 0.4), rng.uniform(0.1, 0.25)
        u = run.motions[0]
        f = rng.uniform(3.0, 9.0) / run.seconds
        run.vertical = [self.P0 * (a * v / self.U + b * signals.fade(i / len(u)) * math.sin(2 * math.pi * f * i * run.dt)) for i, v in enumerate(u)]

    # -------------------------------------------------------------- response

    def respond(self, run, p, effects):
        if self.orbit:
            return self.respond_orbit(run, p, effects)
        law = self.law(p)
        law.start()
        for e in effects:
            e.start()
            e.install(law)
        c = State()
        c.T, c.P0 = run.T, self.P0
        u = run.motions[0]
        h = run.dt / SUB
        out = [0.0]
        for i in range(1, len(u)):
            du = (u[i] - u[i - 1]) / SUB
            c.v, c.h = du / h, h
            for j in range(1, SUB + 1):
                c.u = u[i - 1] + du * j
                c.t = (i - 1) * run.dt + j * h
                c.P = run.axial + (run.vertical[i] if run.vertical else 0.0)
                f = drive(law, effects, c)
            out.append(f)
        return {"force": out}

    def respond_orbit(self, run, p, effects):
        """Park, Wen and Ang (1986) for the coupled share of the hysteretic force."""
        share = effects[0].s if effects else 0.0
        k2 = p["alpha"] * p["ko"]
        uy = p["Qd"] / (p["ko"] - k2)
        alone = [BoucWen(k2, p["Qd"], p["ko"], self.n) for _ in range(2)]
        x, y = run.motions
        zx = zy = 0.0
        outx, outy = [0.0], [0.0]

        def rate(zx, zy, dx, dy):
            s = 0.5 * (abs(dx * zx) + dx * zx + abs(dy * zy) + dy * zy)
            return (dx - zx * s) / uy, (dy - zy * s) / uy

        for i in range(1, len(x)):
            for j in range(1, SUB + 1):
                a = (j - 1) / SUB
                dx, dy = (x[i] - x[i - 1]) / SUB, (y[i] - y[i - 1]) / SUB
                ex, fx = alone[0].move(x[i - 1] + dx * (j), 0.0, 1.0)
                ey, fy = alone[1].move(y[i - 1] + dy * (j), 0.0, 1.0)
                if share:
                    rx, ry = rate(zx, zy, dx, dy)
                    rx, ry = rate(zx + 0.5 * rx, zy + 0.5 * ry, dx, dy)
                    zx += rx
                    zy += ry
            fx = (1.0 - share) * fx + share * p["Qd"] * zx
            fy = (1.0 - share) * fy + share * p["Qd"] * zy
            outx.append(ex + fx)
            outy.append(ey + fy)
        return {"force_x": outx, "force_y": outy}

    def scale(self, cause):
        if self.known is None:
            self.known = self.measure()
        return self.known

    def measure(self):
        fit = [r for r in self.runs if r.role == "fit"]
        top, work, speed = 0.0, 0.0, 0.0
        for r in fit:
            f = next(iter(self.respond(r, self.parameters, []).values()))
            u = r.motions[0]
            top = max(top, signals.peak(f))
            work = max(work, sum(0.5 * (f[i] + f[i - 1]) * (u[i] - u[i - 1]) for i in range(1, len(u))))
            speed = max(speed, math.sqrt(2 * sum((u[i] - u[i - 1]) ** 2 for i in range(1, len(u))) / len(u)) / r.dt)
        U = max(signals.peak(r.motions[0]) for r in fit)
        return Scale(U, top, self.Q, speed, max(work, 1e-12 * top * U), fit[0].seconds, max(r.axial for r in self.runs))

    # -------------------------------------------------------------- script

    def write_script(self):
        un, tol = self.units, number(1e-9 * self.units.L)
        ps = "".join(f"pset {n} @{n}@\n" for n in self.parameters)
        head = f"# {self.title}\n# units: {un.text}\nwipe\n"
        uy = "set uy [expr $Qd/((1.0-$alpha)*$ko)]\n"
        wen = f"uniaxialMaterial BoucWen 1 $alpha $ko {number(self.n)} [expr 0.5/pow($uy,{number(self.n)})] [expr 0.5/pow($uy,{number(self.n)})] 1.0 0.0 0.0 0.0\n"
        drive = "timeSeries Path 1 -dt $dt -filePath $motion\npattern Plain 1 1 {\n    sp 2 1 1.0\n}\nrecorder Element -file force.out -time -ele 1 force\n"
        static = STATIC.format(tol=tol) + loop().replace("analyze 1 $dt", "analyze 1")
        k = self.kind
        if k in ("bearing", "plastic"):
            return head + self.bearing_script(ps)
        if k == "orbit":
            return (head + "model basic -ndm 2 -ndf 2\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1\n" + ps + uy
                    + "# one spring per direction\n" + wen + wen.replace("BoucWen 1", "BoucWen 2")
                    + "element zeroLength 1 1 2 -mat 1 2 -dir 1 2\n"
                    + "timeSeries Path 1 -dt $dt -filePath $motionx\ntimeSeries Path 2 -dt $dt -filePath $motiony\n"
                    + "pattern Plain 1 1 {\n    sp 2 1 1.0\n}\npattern Plain 2 2 {\n    sp 2 2 1.0\n}\n"
                    + "recorder Element -file force.out -time -ele 1 force\n" + static)
        if k == "link":
            return (head + "model basic -ndm 2 -ndf 3\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1 1\nfix 2 0 1 1\n" + ps + uy + wen
                    + "element twoNodeLink 1 1 2 -mat 1 -dir 1 -orient 1 0 0 0 1 0\n" + drive + static)
        if k == "vertical":
            return (head + "model basic -ndm 2 -ndf 3\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1 1\nfix 2 1 0 1\nmass 2 "
                    + f"{number(20 * un.k)} {number(20 * un.k)} {number(20 * un.k)}\n" + ps
                    + "uniaxialMaterial Elastic 1 $k\nuniaxialMaterial Viscous 2 $c 1.0\n"
                    + "element zeroLength 1 1 2 -mat 1 2 -dir 2 2\n" + drive.replace("sp 2 1", "sp 2 2")
                    + ACTUATOR.format(how=f"Penalty {number(1e5 * self.k2)} {number(1e5 * self.k2)}", tol=tol) + loop())
        body = "model basic -ndm 1 -ndf 1\nnode 1 0.0\nnode 2 0.0\nfix 1 1\n"
        if k == "visco":
            return (head + body + f"mass 2 {number(20 * un.k)}\n" + ps + "uniaxialMaterial Elastic 1 $k\nuniaxialMaterial Viscous 2 $c 1.0\n"
                    + "element zeroLength 1 1 2 -mat 1 2 -dir 1 1\n" + drive
                    + ACTUATOR.format(how=f"Penalty {number(1e5 * self.k2)} {number(1e5 * self.k2)}", tol=tol) + loop())
        if k == "steel01":
            mats = "uniaxialMaterial Steel01 1 $Fy $E0 $b\nelement zeroLength 1 1 2 -mat 1 -dir 1\n"
        elif k == "steel02":
            mats = (f"uniaxialMaterial Steel02 1 $Fy $E0 {number(self.b)} 18.0 0.925 0.15\nuniaxialMaterial Elastic 2 $ks\n"
                    + "element zeroLength 1 1 2 -mat 1 2 -dir 1 1\n")
        else:
            mats = uy + wen + "element zeroLength 1 1 2 -mat 1 -dir 1\n"
        return head + body + ps + mats + drive + static

    def bearing_script(self, ps):
        un = self.units
        tol = number(1e-9 * un.L)
        kv = number(2000.0 * self.k2)
        if self.kind == "bearing":
            element = "elastomericBearingBoucWen 1 1 2 $kInit $Fy $alpha 0.0 2.0 1.0 0.5 0.5"
        else:
            element = "elastomericBearingPlasticity 1 1 2 $kInit $Qd $alpha 0.0 2.0"
        varying = ""
        if "varying_axial_load" in self.causes and self.vertical_in_script:
            varying = "\n# overturning and vertical shaking\ntimeSeries Path 3 -dt $dt -filePath $vertical\npattern Plain 3 3 {\n    load 2 0.0 -1.0 0.0\n}\n"
        m = number(50 * un.k)
        return f"""model basic -ndm 2 -ndf 3
{ps}
if {{![info exists axial]}} {{set axial {number(self.P0)}}}
node 1 0.0 0.0
node 2 0.0 {number(0.2 * un.L)}
fix 1 1 1 1
fix 2 0 0 1
mass 2 {m} {m} {m}

uniaxialMaterial Elastic 1 {kv}
uniaxialMaterial Elastic 2 {number(float(kv) * (0.1 * un.L) ** 2)}
element {element} -P 1 -Mz 2 -orient 0 1 0 -1 0 0

# vertical load first
timeSeries Linear 1
pattern Plain 1 1 {{
    load 2 0.0 [expr -$axial] 0.0
}}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr {tol} 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis
{varying}
# actuator
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {{
    sp 2 1 1.0
}}
recorder Element -file force.out -time -ele 1 force

""" + ACTUATOR.format(how="Transformation", tol=tol) + loop()

    def settings(self, run):
        """Tcl variables of a run and the files that they name."""
        files, values = {}, {}
        if self.orbit:
            for d, motion in zip("xy", run.motions):
                files[f"{run.name}-{d}.dat"] = motion
                values["motion" + d] = f"{run.name}-{d}.dat"
        else:
            files[run.name + ".dat"] = run.motions[0]
            values["motion"] = run.name + ".dat"
        values.update(dt=run.dt, npts=run.npts)
        if self.kind in ("bearing", "plastic"):
            values["axial"] = float(number(run.axial))
        if run.vertical and self.vertical_in_script:
            files[run.name + "-vertical.dat"] = run.vertical
            values["vertical"] = run.name + "-vertical.dat"
        return values, files

    # -------------------------------------------------------------- what is concealed



    @property
    def slow(self):
        """The period of a lag: that of the fastest cycles."""
        fit = [r for r in self.runs if r.role == "fit"]
        return min(self.period(r) for r in fit)

    def period(self, run):
        u = run.motions[0]
        top = signals.peak(u)
        v = math.sqrt(sum((u[i] - u[i - 1]) ** 2 for i in range(1, len(u))) / len(u)) / run.dt
        rms = math.sqrt(sum(x * x for x in u) / len(u))
        return 2 * math.pi * rms / v if top else run.seconds

    def place(self, effect, rng):
        fit = [r for r in self.runs if r.role == "fit"]
        if effect in DEVICE or effect == "bidirectional_coupling":
            return "element 1"
        channel = rng.choice(self.channels).name
        if effect == "sensor_gain":
            return channel, (fit[-1].name if len(self.channels) == 1 else None)
        if effect == "sensor_drift":
            return channel, fit[0].name
        return channel, None

    def conceal(self, effect, s, seed, place):
        return DEVICE.get(effect, Coupling)(seed, s, self.scale(effect))

    def context(self, run, times, rng):
        """Columns that no observation names."""
        out = []
        if "ambient_temperature" in self.causes or rng.random() < 0.2:
            out.append(("temperature[degC]", [f"{run.T + rng.gauss(0, 0.15):.4g}" for _ in times]))
        if run.axial and (run.vertical or "axial_shear_interaction" in self.causes):
            def axial(t):
                extra = signals.interpolate([i * run.dt for i in range(run.npts)], run.vertical, t) if run.vertical else 0.0
                return (run.axial + extra) * (1 + rng.gauss(0, 0.005))
            out.append((f"axial[{self.units.force}]", [f"{axial(t):.5g}" for t in times]))
        return out
