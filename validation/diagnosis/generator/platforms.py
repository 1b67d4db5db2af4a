"""A rigid platform on four bearings, in plan: torsion by an eccentric mass, two directions that share a circle of yielding."""

import math

from . import signals
from .laws import BoucWen
from .model import TRANSIENT, Channel, Model, Run, Units, loop, number

STEP = 0.0025
OUT = 0.005
G = 9.81
SHIFT = ((-1, -1), (1, -1), (1, 1), (-1, 1))


class Eccentricity:
    def __init__(self, s, ex, ey):
        self.ex, self.ey = s * ex, s * ey


class Circle:
    def __init__(self, s):
        self.s = s


class Platform(Model):
    family = "platform"
    slow = 0.5

    def __init__(self, rng, causes, family):
        self.units = un = Units(rng)
        self.causes = causes
        self.both = "bidirectional_coupling" in causes
        self.a, self.b = rng.uniform(4.0, 9.0) * un.L, rng.uniform(3.0, 6.0) * un.L
        self.mass = float(f"{rng.uniform(2e5, 6e5) * un.k:.3g}")
        self.inertia = float(f"{self.mass * (self.a**2 + self.b**2) / 3:.4g}")
        T = rng.uniform(1.8, 3.0)
        self.parameters = {"Kd": self.mass * (2 * math.pi / T) ** 2 / 4, "Qd": rng.uniform(0.03, 0.07) * self.mass * G * un.L / 4}
        self.ratio = 0.1
        self.n = 2.0 if self.both else 1.0
        self.title = "isolated platform on four bearings"
        pga = rng.uniform(2.5, 4.5) * un.L
        self.runs = []
        for name, role, size in (("gm-1", "fit", 1.0), ("gm-2", "fit", rng.uniform(0.6, 0.9)), ("gm-3", "holdout", rng.uniform(0.7, 1.0))):
            motions = [signals.quake(rng, pga * size, 9.0, 0.02) for _ in range(2 if self.both else 1)]
            self.runs.append(Run(name, role, 0.02, motions, every=OUT))
        acc = un.len + "/s2"
        self.channels = [Channel("south_disp", un.len, "edge.out", 1, "south edge"), Channel("north_disp", un.len, "edge.out", 2, "north edge"),
                         Channel("south_acc", acc, "acc.out", 1, "south edge"), Channel("north_acc", acc, "acc.out", 2, "north edge")]
        if self.both:
            self.channels += [Channel("east_disp", un.len, "trans.out", 1, "east edge"), Channel("east_acc", acc, "tacc.out", 1, "east edge")]
        self.ecc = (rng.uniform(-0.12, 0.12) * self.a, rng.choice((-1, 1)) * rng.uniform(0.15, 0.3) * self.b)
        self.script = self.write_script()

    def respond(self, run, p, concealed):
        ex = ey = share = 0.0
        for e in concealed:
            if isinstance(e, Eccentricity):
                ex, ey = e.ex, e.ey
            else:
                share = e.s
        m, J = self.mass, self.inertia + self.mass * (ex * ex + ey * ey)
        inverse = inverted([[m, 0.0, -m * ey], [0.0, m, m * ex], [-m * ey, m * ex, J]])
        k1 = p["Kd"] / self.ratio
        uy = p["Qd"] / (k1 - p["Kd"])
        laws = [(BoucWen(p["Kd"], p["Qd"], k1, self.n), BoucWen(p["Kd"], p["Qd"], k1, self.n)) for _ in SHIFT]
        z = [[0.0, 0.0] for _ in SHIFT]
        at = [(sx * self.a, sy * self.b) for sx, sy in SHIFT]
        h, sub, out_each = STEP, round(run.dt / STEP), round(OUT / STEP)
        gx = run.motions[0]
        gy = run.motions[1] if self.both else None
        x, v, last = [0.0] * 3, [0.0] * 3, [[0.0, 0.0] for _ in SHIFT]
        out = {c.name: [] for c in self.channels}
        for i in range((len(gx) - 1) * sub + 1):
            j, r = divmod(i, sub)
            ax = gx[j] + ((gx[j + 1] - gx[j]) * r / sub if r else 0.0)
            ay = gy[j] + ((gy[j + 1] - gy[j]) * r / sub if r else 0.0) if gy else 0.0
            F = [0.0, 0.0, 0.0]
            for q, (px, py) in enumerate(at):
                ux, uy_ = x[0] - x[2] * py, x[1] + x[2] * px
                e1, f1 = laws[q][0].move(ux, 0.0, h)
                e2, f2 = laws[q][1].move(uy_, 0.0, h)
                if share:
                    dx, dy = ux - last[q][0], uy_ - last[q][1]
                    for _ in range(2):  # Park, Wen and Ang (1986), halved steps
                        zx, zy = z[q]
                        s = 0.25 * (abs(dx * zx) + dx * zx + abs(dy * zy) + dy * zy)
                        z[q] = [zx + (0.5 * dx - zx * s) / uy, zy + (0.5 * dy - zy * s) / uy]
                    last[q] = [ux, uy_]
                    f1 = (1 - share) * f1 + share * p["Qd"] * z[q][0]
                    f2 = (1 - share) * f2 + share * p["Qd"] * z[q][1]
                f1 += e1
                f2 += e2
                F[0] -= f1
                F[1] -= f2
                F[2] += f1 * py - f2 * px
            F[0] -= m * ax
            F[1] -= m * ay
            F[2] += m * ax * ey - m * ay * ex
            a = [sum(inverse[r][c] * F[c] for c in range(3)) for r in range(3)]
            if i % out_each == 0:
                out["south_disp"].append(x[0] + x[2] * self.b)
                out["north_disp"].append(x[0] - x[2] * self.b)
                out["south_acc"].append(a[0] + a[2] * self.b + ax)
                out["north_acc"].append(a[0] - a[2] * self.b + ax)
                if self.both:
                    out["east_disp"].append(x[1] + x[2] * self.a)
                    out["east_acc"].append(a[1] + a[2] * self.a + ay)
            for q in range(3):
                v[q] += h * a[q]
                x[q] += h * v[q]
        return out

    def place(self, effect, rng):
        if effect.startswith("sensor"):
            return rng.choice([c.name for c in self.channels if "acc" in c.name]), None
        return "mass" if effect == "torsion" else "bearings"

    def conceal(self, effect, s, seed, place):
        return Eccentricity(s, *self.ecc) if effect == "torsion" else Circle(s)

    def context(self, run, times, rng):
        return []

    def settings(self, run):
        files = {run.name + ".dat": run.motions[0]}
        values = {"motion": run.name + ".dat"}
        if self.both:
            files[run.name + "-y.dat"] = run.motions[1]
            values["motiony"] = run.name + "-y.dat"
        return dict(values, dt=run.dt, npts=run.npts, nsub=3), files

    def write_script(self):
        un, r = self.units, number(self.ratio)
        ps = "".join(f"pset {n} @{n}@\n" for n in self.parameters)
        m = number(self.mass)
        n = number(self.n)
        text = (f"# {self.title}\n# units: {un.text}\nwipe\nmodel basic -ndm 2 -ndf 3\n{ps}node 100 0.0 0.0\nmass 100 {m} {m} {number(self.inertia)}\n"
                f"set ki [expr $Kd/{r}]\nset uy [expr $Qd/((1.0-{r})*$ki)]\n")
        for q, (sx, sy) in enumerate(SHIFT, 1):
            px, py = number(sx * self.a), number(sy * self.b)
            text += (f"node {q} {px} {py}\nnode {10 + q} {px} {py}\nfix {q} 1 1 1\nrigidLink beam 100 {10 + q}\n"
                     f"uniaxialMaterial BoucWen {q} {r} $ki {n} [expr 0.5/pow($uy,{n})] [expr 0.5/pow($uy,{n})] 1.0 0.0 0.0 0.0\n"
                     f"element zeroLength {q} {q} {10 + q} -mat {q} {q} -dir 1 2\n")
        text += "timeSeries Path 1 -dt $dt -filePath $motion\npattern UniformExcitation 1 1 -accel 1\n"
        if self.both:
            text += "timeSeries Path 2 -dt $dt -filePath $motiony\npattern UniformExcitation 2 2 -accel 2\n"
        text += "recorder Node -file edge.out -time -node 11 14 -dof 1 disp\nrecorder Node -file acc.out -timeSeries 1 -time -node 11 14 -dof 1 accel\n"
        if self.both:
            text += "recorder Node -file trans.out -time -node 12 -dof 2 disp\nrecorder Node -file tacc.out -timeSeries 2 -time -node 12 -dof 2 accel\n"
        return text + TRANSIENT.format(tol=number(1e-9 * un.L)) + loop(substeps=True)


def inverted(A):
    n = len(A)
    rows = [list(r) + [float(i == j) for j in range(n)] for i, r in enumerate(A)]
    for i in range(n):
        top = max(range(i, n), key=lambda j: abs(rows[j][i]))
        rows[i], rows[top] = rows[top], rows[i]
        rows[i] = [v / rows[i][i] for v in rows[i]]
        for j in range(n):
            if j != i:
                rows[j] = [v - rows[j][i] * w for v, w in zip(rows[j], rows[i])]
    return [r[n:] for r in rows]
