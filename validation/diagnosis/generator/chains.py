"""Masses in a row under ground motion: isolated shear buildings, fixed-base frames, isolated bridge piers.

Central differences in small steps; links between neighbours carry the laws, link 0 stands on the ground."""

import math
import random

from . import signals
from .effects import DEVICE, Scale, State, drive
from .laws import Bilinear, BoucWen, Concrete, MenegottoPinto, Viscoelastic
from .model import TRANSIENT, Channel, Model, Run, Units, loop, number

STEP = 0.0025
OUT = 0.005
G = 9.81


class Yielding:
    """An elastic link that yields: bilinear, Menegotto-Pinto, or with the stiffness lost of concrete."""

    def __init__(self, seed, s, link, scale):
        rng = random.Random(seed)
        self.link = link
        self.kind = rng.choice(("bilinear", "steel", "concrete"))
        self.Fy = (1.0 - 0.8 * s) * scale.F
        self.b = rng.uniform(0.02, 0.1)
        self.a, self.c = rng.uniform(0.0, 0.4), rng.uniform(-0.3, 0.3)

    def law(self, k):
        if self.kind == "bilinear":
            return Bilinear(self.b * k, self.Fy * (1 - self.b), k)
        if self.kind == "steel":
            return MenegottoPinto(self.Fy, k, self.b, 0.0)
        return Concrete(k, self.Fy, self.b, self.a, self.c)


class Soil:
    """A footing below link 0: a spring, a radiation dashpot and a mass. A rocking one is written as the sway at the top that it
    causes, and the ground does not shake its inertia."""

    def __init__(self, seed, s, k0, m0):
        rng = random.Random(seed)
        self.rocks = rng.random() < 0.5
        self.k = k0 * (0.6 + 3.0 * (1.0 - s) / s) * rng.uniform(0.8, 1.2)
        self.m = max((0.02 if self.rocks else 0.12) * m0, self.k * (2.0 * STEP) ** 2)
        self.c = 2.0 * rng.uniform(0.03, 0.15) * math.sqrt(self.k * m0)


class Absorber:
    """Unknown: a small mass on a spring that hangs on a floor (tank, tuned damper)."""

    def __init__(self, seed, s, dof, mass, w):
        rng = random.Random(seed)
        self.dof, self.m = dof, s * 0.35 * mass
        w *= rng.uniform(0.8, 1.1)
        self.k, self.c = self.m * w * w, 2 * 0.02 * self.m * w


class Blows:
    """Unknown: something strikes a mass at times of its own."""

    def __init__(self, seed, s, dof, mass, seconds):
        rng = random.Random(seed)
        self.dof = dof
        self.force = s * 3.0 * mass
        self.each = [(rng.uniform(0.05, 0.95), rng.uniform(0.08, 0.2), rng.choice((-1, 1)) * rng.uniform(0.5, 1)) for _ in range(6)]

    def at(self, t, seconds):
        f = 0.0
        for a, width, size in self.each:
            x = (t - a * seconds) / width
            if abs(x) < 0.5:
                f += size * self.force * math.cos(math.pi * x) ** 2
        return f


class Placed:
    """An effect of a device in a link."""

    def __init__(self, effect, link):
        self.effect, self.link = effect, link


class Chain(Model):
    def __init__(self, rng, causes, family):
        self.units = un = Units(rng)
        self.family, self.causes = family, causes
        self.known = {}
        self.slow = 0.5 if family == "building" else 0.4
        self.law_kind = rng.choice(("wen", "wen", "bilinear"))
        self.parameters = {}
        seconds = rng.choice((8.0, 10.0))
        self.mass_damping = 0.0
        self.substeps = {"building": 5, "frame": 7, "pier": 10}[family]
        if family == "pier":
            self.draw_pier(rng)
        else:
            self.draw_building(rng)
        self.runs = []
        pga = rng.uniform(2.5, 4.5)
        names = [("event-1", "fit", 1.0), ("event-2", "fit", rng.uniform(0.5, 0.9)), ("check", "holdout", rng.uniform(0.7, 1.0))]
        if rng.random() < 0.35 and "sensor_gain" not in causes:
            del names[1]
        for name, role, size in names:
            self.runs.append(Run(name, role, 0.02, [signals.quake(rng, pga * size * un.L, seconds, 0.02)], every=OUT))
        self.draw_channels(rng)
        self.script = self.write_script()

    # -------------------------------------------------------------- what stands there

    def draw_isolator(self, rng, mass):
        T = rng.uniform(1.8, 3.0)
        Kd = mass * (2 * math.pi / T) ** 2
        Qd = rng.uniform(0.03, 0.07) * mass * G * self.units.L
        self.ratio = rng.choice((0.08, 0.1, 0.15))
        self.parameters.update(Kd=Kd, Qd=Qd)

    def draw_building(self, rng):
        un = self.units
        n = rng.choice((1, 2, 3)) if self.family == "building" else rng.choice((2, 3))
        m = rng.uniform(0.8e5, 2.5e5) * un.k
        self.masses = [m * rng.uniform(0.9, 1.2) for _ in range(n)]
        self.masses[-1] *= 0.8
        T1 = rng.uniform(0.1, 0.15) * (n + 1) * (1.4 if self.family == "frame" else 1.0)
        w1 = 2 * math.pi / T1
        k = m * (w1 * (2 * n + 1) / math.pi) ** 2
        self.k = [float(f"{k * (1 - 0.4 * j / n):.3g}") for j in range(n)]
        zeta = rng.uniform(0.02, 0.04)
        self.c = [float(f"{2 * zeta / w1 * kj:.3g}") for kj in self.k]
        self.w1 = w1
        if self.family == "building":
            self.masses.insert(0, 1.2 * m)
            self.draw_isolator(rng, sum(self.masses))
            if rng.random() < 0.5:
                self.parameters["rk"] = rng.uniform(0.8, 1.2)
        else:
            self.parameters["rk"] = rng.uniform(0.8, 1.2)
            if "damping" not in self.causes and rng.random() < 0.6:
                self.parameters["rc"] = rng.uniform(0.7, 1.4)
        self.masses = [float(f"{x:.4g}") for x in self.masses]
        what = {"building": "on isolators", "frame": "on a fixed base"}[self.family]
        self.title = f"{('one', 'two', 'three')[n - 1]}-storey " + rng.choice(("school ", "clinic ", "office block ", "archive ")) + what

    def draw_pier(self, rng):
        un = self.units
        deck = rng.uniform(4e5, 8e5) * un.k
        self.masses = [float(f"{x:.4g}") for x in (deck * rng.uniform(0.15, 0.3), deck)]
        self.draw_isolator(rng, deck)
        self.H = rng.choice((6.0, 8.0, 10.0)) * un.L
        k = self.parameters["Kd"] / self.ratio * rng.uniform(0.5, 1.1)
        self.E = 3.0e10 * un.F / un.L**2
        self.I = float(f"{k * self.H**3 / 3 / self.E:.4g}")
        self.parameters["rE"] = rng.uniform(0.8, 1.15)
        self.mass_damping = 0.4
        self.title = "isolated bridge pier"

    def draw_channels(self, rng):
        un = self.units
        acc = un.len + "/s2"
        n = len(self.masses)
        if self.family == "pier":
            self.channels = [Channel("pier_disp", un.len, "disp.out", 1, "pier"), Channel("pier_acc", acc, "acc.out", 1, "pier"),
                             Channel("deck_acc", acc, "acc.out", 2, "deck"), Channel("bearing_def", un.len, "bearing.out", 1, "bearing")]
            self.reads = {"pier_disp": ("x", 0), "pier_acc": ("a", 0), "deck_acc": ("a", 1), "bearing_def": ("d", 1)}
        elif self.family == "building":
            self.channels = [Channel("base_disp", un.len, "basedisp.out", 1, "isolation layer"), Channel("base_acc", acc, "acc.out", 1, "base slab"),
                             Channel("roof_acc", acc, "acc.out", n, "roof")]
            self.reads = {"base_disp": ("x", 0), "base_acc": ("a", 0), "roof_acc": ("a", n - 1)}
        else:
            self.channels = [Channel("floor1_acc", acc, "acc.out", 1, "floor 1"), Channel("roof_acc", acc, "acc.out", n, "roof"),
                             Channel("roof_disp", un.len, "floordisp.out", n, "roof")]
            self.reads = {"floor1_acc": ("a", 0), "roof_acc": ("a", n - 1), "roof_disp": ("x", n - 1)}

    def isolator(self, p):
        k1 = p["Kd"] / self.ratio
        if self.law_kind == "wen":
            return BoucWen(p["Kd"], p["Qd"], k1)
        return Bilinear(p["Kd"], p["Qd"], k1)

    def links(self, p):
        if self.family == "pier":
            return [Viscoelastic(3 * self.E * p["rE"] * self.I / self.H**3, 0.0), self.isolator(p)]
        storeys = [Viscoelastic(k * p.get("rk", 1.0), c * p.get("rc", 1.0)) for k, c in zip(self.k, self.c)]
        return [self.isolator(p)] + storeys if self.family == "building" else storeys

    # -------------------------------------------------------------- response

    def respond(self, run, p, concealed, watch=None):
        laws = self.links(p)
        n = len(laws)
        effects = [[] for _ in laws]
        dash = [law.c if isinstance(law, Viscoelastic) else 0.0 for law in laws]
        m, shaken = list(self.masses), [1.0] * n
        soil = absorber = blows = None
        for e in concealed:
            if isinstance(e, Placed):
                effects[e.link].append(e.effect)
                e.effect.start()
                e.effect.install(laws[e.link])
            elif isinstance(e, Yielding):
                laws[e.link] = e.law(laws[e.link].k)
            elif isinstance(e, Soil):
                soil = e
            elif isinstance(e, Absorber):
                absorber = e
            else:
                blows = e
        for law in laws:
            law.start()
        yields = [isinstance(law, (Bilinear, MenegottoPinto, Concrete)) for law in laws]
        h, sub, out_each = STEP, round(run.dt / STEP), round(OUT / STEP)
        ground = run.motions[0]
        x, v, a = [0.0] * n, [0.0] * n, [0.0] * n
        xs = vs = 0.0  # soil
        xt = vt = 0.0  # absorber
        c = State()
        c.h, c.P, c.P0, c.T = h, 0.0, 1.0, 23.0
        kinds = list(self.reads.items())
        out = {name: [] for name, _ in kinds}
        f = [0.0] * n
        aM = self.mass_damping
        steps = (len(ground) - 1) * sub
        for i in range(steps + 1):
            j, r = divmod(i, sub)
            ag = ground[j] if r == 0 else ground[j] + (ground[j + 1] - ground[j]) * r / sub
            vp = [vi + 0.5 * h * ai for vi, ai in zip(v, a)]
            below, speed = xs, vs
            for q in range(n):
                d, w = x[q] - below, vp[q] - speed
                if effects[q]:
                    c.u, c.v, c.t = d, w, i * h
                    f[q] = drive(laws[q], effects[q], c)
                else:
                    e1, e2 = laws[q].move(d, w, h)
                    f[q] = e1 + e2
                if yields[q]:
                    f[q] += dash[q] * w
                below, speed = x[q], vp[q]
            if watch is not None:
                watch([x[0] - xs] + [x[q] - x[q - 1] for q in range(1, n)], f)
            for q in range(n):
                up = f[q + 1] if q + 1 < n else 0.0
                a[q] = (up - f[q]) / m[q] - aM * vp[q] - ag
            if absorber:
                q = absorber.dof
                pull = absorber.k * (xt - x[q]) + absorber.c * (vt - vp[q])
                a[q] += pull / m[q]
                vt += h * (-pull / absorber.m - ag)
                xt += h * vt
            if blows:
                a[blows.dof] += blows.at(i * h, run.seconds) / m[blows.dof]
            if i % out_each == 0:
                for name, (kind, q) in kinds:
                    if kind == "x":
                        out[name].append(x[q])
                    elif kind == "a":
                        out[name].append(a[q] + ag)
                    else:
                        out[name].append(x[q] - x[q - 1])
            if soil:
                pull = f[0] - soil.k * xs - soil.c * vs
                vs += h * (pull / soil.m - (0.0 if soil.rocks else ag))
                xs += h * vs
            for q in range(n):
                v[q] += h * a[q]
                x[q] += h * v[q]
        return out

    def scale(self, link):
        if link not in self.known:
            run = self.runs[0]
            us, fs = [], []
            self.respond(run, self.parameters, [], lambda d, f: (us.append(d[link]), fs.append(f[link])))
            speed = math.sqrt(2 * sum((us[i] - us[i - 1]) ** 2 for i in range(1, len(us))) / len(us)) / STEP
            work = sum(0.5 * (fs[i] + fs[i - 1]) * (us[i] - us[i - 1]) for i in range(1, len(us)))
            self.known[link] = Scale(signals.peak(us), signals.peak(fs), self.parameters.get("Qd", 0.0), speed, work, run.seconds)
        return self.known[link]

    # -------------------------------------------------------------- what is concealed

    def place(self, effect, rng):
        n = len(self.masses)
        if effect.startswith("sensor") or effect == "bursts":
            names = [c.name for c in self.channels]
            if effect == "sensor_gain":
                names = [x for x in names if x.endswith("acc")]
            return rng.choice(names), None
        if effect in ("superstructure_yielding", "damping"):
            if self.family == "pier":
                return "pier"
            first = 1 if self.family == "building" else 0
            return f"storey {1 + rng.choice((0, 0, n - 1 - first))}"
        if effect in ("foundation_flexibility",):
            return "support"
        if effect in ("absorber", "blows"):
            return "roof" if self.family != "pier" else "deck"
        return "isolation layer" if self.family == "building" else "bearing"

    def link(self, place):
        if place.startswith("storey"):
            return int(place[7:]) - 1 + (1 if self.family == "building" else 0)
        return 1 if place == "bearing" else 0

    def conceal(self, effect, s, seed, place):
        link = self.link(place)
        if effect == "superstructure_yielding":
            return Yielding(seed, s, link, self.scale(link))
        if effect == "foundation_flexibility":
            return Soil(seed, s, self.links(self.parameters)[0].k, sum(self.masses))
        top = len(self.masses) - 1
        if effect == "absorber":
            w = self.w1 if self.family == "frame" else math.sqrt(self.parameters["Kd"] / sum(self.masses)) * 1.5
            return Absorber(seed, s, top, sum(self.masses), w)
        if effect == "blows":
            return Blows(seed, s, top, self.masses[top] * self.units.L, self.runs[0].seconds)
        return Placed(DEVICE[effect](seed, s, self.scale(link)), link)

    def context(self, run, times, rng):
        return []

    def settings(self, run):
        return {"motion": run.name + ".dat", "dt": run.dt, "npts": run.npts, "nsub": self.substeps}, {run.name + ".dat": run.motions[0]}

    # -------------------------------------------------------------- script

    def isolator_script(self, tag):
        r = number(self.ratio)
        if self.law_kind == "wen":
            return (f"set ki [expr $Kd/{r}]\nset uy [expr $Qd/((1.0-{r})*$ki)]\n"
                    f"uniaxialMaterial BoucWen {tag} {r} $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0\n")
        return f"set ki [expr $Kd/{r}]\nuniaxialMaterial Steel01 {tag} [expr $Qd/(1.0-{r})] $ki {r}\n"

    def write_script(self):
        un = self.units
        ps = "".join(f"pset {n} @{n}@\n" for n in self.parameters)
        end = TRANSIENT.format(tol=number(1e-9 * un.L)) + loop(substeps=True)
        shake = "\ntimeSeries Path 1 -dt $dt -filePath $motion\npattern UniformExcitation 1 1 -accel 1\n"
        head = f"# {self.title}\n# units: {un.text}\nwipe\n"
        n = len(self.masses)
        if self.family == "pier":
            m1, m2 = (number(x) for x in self.masses)
            H = number(self.H)
            A = number(3.0 * un.L**2)
            return (head + "model basic -ndm 2 -ndf 3\n" + ps
                    + f"node 1 0.0 0.0\nnode 2 0.0 {H}\nnode 20 0.0 {H}\nfix 1 1 1 1\nfix 20 0 1 1\n"
                    + f"mass 2 {m1} {m1} 0.0\nmass 20 {m2} {m2} 0.0\ngeomTransf Linear 1\n"
                    + f"element elasticBeamColumn 1 1 2 {A} [expr $rE*{number(self.E)}] {number(self.I)} 1\n"
                    + f"rayleigh {number(self.mass_damping)} 0.0 0.0 0.0\n" + self.isolator_script(1) + "element zeroLength 20 2 20 -mat 1 -dir 1\n" + shake
                    + "recorder Node -file disp.out -time -node 2 20 -dof 1 disp\n"
                    + "recorder Node -file acc.out -timeSeries 1 -time -node 2 20 -dof 1 accel\n"
                    + "recorder Element -file bearing.out -time -ele 20 deformation\n" + end)
        nodes = list(range(2, n + 2))
        text = head + "model basic -ndm 1 -ndf 1\n" + ps + "node 1 0.0\nfix 1 1\n"
        text += "".join(f"node {t} 0.0 -mass {number(m)}\n" for t, m in zip(nodes, self.masses))
        below = 1
        if self.family == "building":
            text += "\n# isolation layer\n" + self.isolator_script(1) + "element zeroLength 1 1 2 -mat 1 -dir 1\n"
            below = 2
        text += "\n# storeys\n"
        for j, (k, c) in enumerate(zip(self.k, self.c)):
            rk = f"[expr $rk*{number(k)}]" if "rk" in self.parameters else number(k)
            rc = f"[expr $rc*{number(c)}]" if "rc" in self.parameters else number(c)
            text += (f"uniaxialMaterial Elastic {11 + j} {rk}\nuniaxialMaterial Viscous {21 + j} {rc} 1.0\n"
                     f"element zeroLength {11 + j} {below + j} {below + j + 1} -mat {11 + j} {21 + j} -dir 1 1\n")
        listed = " ".join(str(t) for t in nodes)
        text += shake
        if self.family == "building":
            text += "recorder Node -file basedisp.out -time -node 2 -dof 1 disp\n"
        return (text + f"recorder Node -file acc.out -timeSeries 1 -time -node {listed} -dof 1 accel\n"
                + f"recorder Node -file floordisp.out -time -node {listed} -dof 1 disp\n" + end)
