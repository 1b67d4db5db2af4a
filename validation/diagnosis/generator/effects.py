"""Effects concealed in a device: each changes or adds to the forces of the law that the analyst has.

An effect has a strength s from 0 (absent) to about 1 (as strong as it is plausible) and keeps its other parameters,
drawn from its seed, as s varies. Its formulas are on purpose not those of `crates/engine/src/element/amendment`.
"""

import math
import random


class State:
    """The state that an effect reads and changes: deformation u, its rate v, the step h, axial load P, temperature T,
    elastic and hysteretic force of the base law, and what stands in parallel."""

    __slots__ = ("u", "v", "h", "t", "P", "P0", "T", "elastic", "hysteretic", "parallel")


class Scale:
    """Of the device without effect: largest deformation U and force F, hysteretic force Q, typical speed V,
    work done in the whole run, number of seconds, largest axial load."""

    def __init__(self, U, F, Q, V, work, seconds, Pmax=0.0):
        self.U, self.F, self.Q, self.V, self.work, self.seconds, self.Pmax = U, F, Q, V, work, seconds, Pmax


class Effect:
    def __init__(self, seed, s, scale):
        self.s, self.scale = s, scale
        self.draw(random.Random(seed))

    def draw(self, rng):
        pass

    def start(self):
        pass

    def install(self, law):
        """Of an effect that lives inside the base law."""


class Rate(Effect):
    """Overstress: two Maxwell arms (Prony), or one spring and the flow of Eyring, v = v0 sinh(f/f0), or of Norton, v = v0 (f/f0)^m."""

    def draw(self, rng):
        self.kind = rng.choice(("prony", "eyring", "norton"))
        sc = self.scale
        tau = sc.U / sc.V
        self.arms = [(self.s * 0.6 * sc.F / sc.U * rng.uniform(0.5, 1.0), tau * rng.uniform(0.03, 0.15)),
                     (self.s * 0.5 * sc.F / sc.U * rng.uniform(0.5, 1.0), tau * rng.uniform(0.3, 1.0))]
        self.k = sc.F / sc.U * rng.uniform(2.0, 5.0)
        self.f0 = self.s * sc.F * rng.uniform(0.10, 0.16)
        self.v0 = sc.V * rng.uniform(0.1, 0.3)
        self.m = rng.uniform(2.5, 4.5)

    def start(self):
        self.f = [0.0, 0.0]

    def flow(self, f):
        x = f / self.f0
        if self.kind == "eyring":
            x = max(-30.0, min(30.0, x))
            return self.v0 * math.sinh(x), self.v0 * math.cosh(x) / self.f0
        a = min(abs(x), 1e3) ** (self.m - 1.0)
        return self.v0 * x * a, self.v0 * self.m * a / self.f0

    def apply(self, c):
        if self.s == 0.0:
            return
        if self.kind == "prony":
            for i, (k, tau) in enumerate(self.arms):
                e = math.exp(-c.h / tau)
                self.f[i] = self.f[i] * e + k * tau * c.v * (1.0 - e)
            c.parallel += sum(self.f)
            return
        trial = self.f[0] + self.k * c.v * c.h
        low, high = min(0.0, trial), max(0.0, trial)
        f = self.f[0]
        for _ in range(40):  # backward Euler: f + k h flow(f) = trial, monotone
            w, slope = self.flow(f)
            g = f + self.k * c.h * w - trial
            low, high = (low, min(high, f)) if g > 0 else (max(low, f), high)
            new = f - g / (1.0 + self.k * c.h * slope)
            if not low <= new <= high:
                new = 0.5 * (low + high)
            if abs(new - f) < 1e-9 * self.scale.F:
                f = new
                break
            f = new
        self.f[0] = f
        c.parallel += f


class Heating(Effect):
    """Heat conduction through the half thickness of a layer: the work of the hysteretic force heats it evenly, the plate
    beside it stays cool behind a film; hysteresis and stiffness soften layer by layer."""

    LAYERS = 6

    def draw(self, rng):
        sc = self.scale
        self.rise = self.s * rng.uniform(70.0, 100.0)
        self.diffusion = 1.0 / (sc.seconds * rng.uniform(1.0, 6.0))  # 1/time of the half thickness
        self.film = rng.uniform(0.3, 2.0)
        self.soft = rng.uniform(0.010, 0.014)
        self.soft_elastic = self.soft * rng.uniform(0.15, 0.4)

    def start(self):
        self.T = [0.0] * self.LAYERS

    def apply(self, c):
        n, T = self.LAYERS, self.T
        mean = sum(1.0 / (1.0 + self.soft * x + 0.5 * (self.soft * x) ** 2) for x in T) / n
        c.elastic *= sum(math.exp(-self.soft_elastic * x) for x in T) / n
        c.hysteretic *= mean
        q = max(0.0, c.hysteretic * c.v) / self.scale.work * self.rise * c.h
        r = self.diffusion * n * n * c.h
        new = []
        for i in range(n):
            left = T[i - 1] if i else T[0]
            flux = left - T[i]
            flux += T[i + 1] - T[i] if i + 1 < n else -self.film / n * T[i] * 2.0
            new.append(T[i] + q + r * flux)
        self.T = new


class Ambient(Effect):
    """Arrhenius: factors exp(A (1/T - 1/T0)) in kelvin on both parts."""

    reference = 23.0

    def draw(self, rng):
        self.A = self.s * rng.uniform(1600.0, 2600.0)
        self.A_elastic = self.A * rng.uniform(0.2, 0.5)

    def apply(self, c):
        x = 1.0 / (c.T + 273.15) - 1.0 / (self.reference + 273.15)
        c.elastic *= math.exp(self.A_elastic * x)
        c.hysteretic *= math.exp(self.A * x)


class Mullins(Effect):
    """Ogden and Roxburgh (1999), eta = 1 - erf((Wm - W)/(m + b Wm))/r, written about the scragged state; or damage by the
    largest energy so far (Miehe, 1995), which no path takes back."""

    def draw(self, rng):
        self.kind = rng.choice(("ogden", "miehe"))
        U = self.scale.U
        self.gain = self.s * rng.uniform(0.5, 0.9)
        self.m = 0.5 * (rng.uniform(0.1, 0.25) * U) ** 2
        self.b = rng.uniform(0.1, 0.3)
        self.part = rng.uniform(0.2, 0.6)
        self.sat = rng.uniform(0.35, 0.6) * U

    def start(self):
        self.Wm = self.um = 0.0

    def apply(self, c):
        W = 0.5 * c.u * c.u
        self.Wm = max(self.Wm, W)
        self.um = max(self.um, abs(c.u))
        if self.kind == "ogden":
            x = 1.0 - math.erf((self.Wm - W) / (self.m + self.b * self.Wm))
        else:
            x = math.exp(-0.5 * (self.um / self.sat) ** 2)
        c.elastic *= 1.0 + self.gain * x
        c.hysteretic *= 1.0 + self.gain * self.part * x


class Degradation(Effect):
    """Strength falls as 1/(1 + d E) with the hysteretic work E (Baber and Wen 1981), or by cycle counting: each half cycle takes
    a share that grows with its range (Coffin and Manson)."""

    def draw(self, rng):
        self.kind = rng.choice(("energy", "cycles"))
        self.d = self.s * rng.uniform(1.2, 2.0)
        self.de = self.d * rng.uniform(0.0, 0.3)
        self.c = rng.uniform(1.5, 2.5)

    def start(self):
        self.E = self.D = 0.0
        self.turned = self.last = self.way = 0.0

    def apply(self, c):
        if self.kind == "energy":
            nu, eta = 1.0 + self.d * self.E, 1.0 + self.de * self.E
            c.hysteretic /= nu
            c.elastic /= eta
            self.E += max(0.0, c.hysteretic * c.v) * c.h / self.scale.work
            return
        if (c.u - self.last) * self.way < 0.0:
            span = abs(self.last - self.turned) / (2.0 * self.scale.U)
            self.D = 1.0 - (1.0 - self.D) * math.exp(-self.s * 0.09 * span**self.c)
            self.turned = self.last
        if c.u != self.last:
            self.way = c.u - self.last
        self.last = c.u
        c.hysteretic *= 1.0 - self.D
        c.elastic *= 1.0 - 0.5 * self.D


class Stiffening(Effect):
    """Limited extension of chains: a polynomial of the fifth degree, or an exponential of Fung's kind."""

    def draw(self, rng):
        self.kind = rng.choice(("quintic", "exponential"))
        self.a = rng.uniform(3.0, 5.0)
        self.f = self.s * self.scale.F

    def apply(self, c):
        x = abs(c.u) / self.scale.U
        if self.kind == "quintic":
            y = 0.2 * x**3 + 0.8 * x**5
        else:
            y = (math.expm1(self.a * x) - self.a * x) / (math.expm1(self.a) - self.a)
        c.parallel += math.copysign(self.f * y, c.u)


class Buckling(Effect):
    """Haringx' column (Gent 1964; Koh and Kelly 1988): K = P^2 / (2 q EI tan(q h/2) - P h), q^2 = P (GA + P) / (EI GA), here h = 1;
    or P-critical by the overlap of the plates in the square."""

    def draw(self, rng):
        self.kind = rng.choice(("haringx", "overlap"))
        self.Pcr = self.scale.Pmax / (0.6 * math.sqrt(max(self.s, 1e-9)))
        self.width = rng.uniform(4.0, 6.0) * self.scale.U
        self.part = rng.uniform(0.3, 0.6)

    def factor(self, P, u):
        if self.kind == "overlap":
            x = min(1.0, abs(u) / self.width)
            overlap = 1.0 - 2.0 / math.pi * (math.asin(x) + x * math.sqrt(1.0 - x * x))
            return max(0.05, 1.0 - (P / (self.Pcr * overlap)) ** 2)
        # the column buckles where q = pi: P (1 + P / GA) = pi^2 EI
        GA = 0.1 * self.Pcr
        EI = self.Pcr * (1.0 + self.Pcr / GA) / math.pi**2
        q = math.sqrt(P * (GA + P) / (EI * GA))
        K = P * P / (2.0 * q * EI * math.tan(0.5 * q) - P)
        return max(0.05, K * (1.0 / GA + 1.0 / (12.0 * EI)))

    def apply(self, c):
        f = self.factor(max(c.P, 1e-6 * self.scale.Pmax), c.u)
        c.elastic *= f
        c.hysteretic *= f**self.part


class Pressure(Effect):
    """Friction follows the axial load of the moment: a share s of the hysteretic force is mu(P) P with Constantinou's fall of mu."""

    def draw(self, rng):
        self.fall = rng.uniform(0.1, 0.35)

    def apply(self, c):
        p = max(0.0, c.P) / c.P0
        mu = 1.0 - self.fall * math.tanh(1.2 * (p - 1.0))
        c.hysteretic *= 1.0 + self.s * (mu * p - 1.0)


class Cavitation(Effect):
    """In tension the stiffness ends at a cavitation force; what was opened once reloads on a secant (damage) and the crown falls."""

    def draw(self, rng):
        self.uc = self.scale.U * (1.0 - 0.85 * self.s)
        self.rise = rng.uniform(0.05, 0.4)
        self.crown = rng.uniform(0.1, 0.3)

    def start(self):
        self.um = 0.0

    def apply(self, c):
        if c.u <= 0.0:
            return
        k = c.elastic / c.u
        self.um = max(self.um, c.u)
        if self.um <= self.uc:
            return
        open_ = (self.um - self.uc) / self.scale.U
        top = k * self.uc * (1.0 + self.rise * math.tanh(3.0 * open_))
        secant = top / self.um * (1.0 - self.crown * open_ / (open_ + 0.3))
        c.elastic = c.u * (secant if c.u < self.um else top / self.um)


class Friction(Effect):
    """A guide in parallel: Coulomb's law smoothed over speed with a peak at rest that falls by the speed itself, or a hysteretic spring
    of Bouc and Wen without hardening. (Up to seed 74099 bristles by LuGre or Dahl, which the library has had since.)"""

    def draw(self, rng):
        sc = self.scale
        self.Fc = self.s * rng.uniform(0.25, 0.4) * sc.F
        self.by_speed = rng.random() < 0.5
        self.peak = rng.choice((1.0, rng.uniform(1.1, 1.4)))
        self.vs = rng.uniform(0.05, 0.15) * sc.V
        self.v0 = rng.uniform(0.005, 0.02) * sc.V
        self.u0 = rng.uniform(0.004, 0.012) * sc.U
        self.n = rng.uniform(1.5, 4.0)

    def start(self):
        self.z = 0.0

    def apply(self, c):
        if self.by_speed:
            c.parallel += self.Fc * (1.0 + (self.peak - 1.0) * math.exp(-abs(c.v) / self.vs)) * math.tanh(c.v / self.v0)
            return
        d = c.v * c.h / self.u0
        parts = 1 + int(abs(d) / 0.05)
        for _ in range(parts):
            left = abs(self.z) ** self.n if d * self.z > 0.0 else 0.0
            self.z = min(1.0, max(-1.0, self.z + d / parts * (1.0 - left)))
        c.parallel += self.Fc * self.z


class Gap(Effect):
    """Hertz' contact with the damping of Hunt and Crossley beyond a gap, on one side or both."""

    def draw(self, rng):
        sc = self.scale
        self.gap = (1.0 - 0.55 * self.s) * sc.U
        self.k = rng.uniform(1.0, 3.0) * sc.F / (0.1 * sc.U) ** 1.5
        self.c = rng.uniform(0.1, 0.4) / sc.V
        self.side = rng.choice((-1, 0, 1))

    def apply(self, c):
        way = 1.0 if c.u > 0.0 else -1.0
        d = abs(c.u) - self.gap
        if d > 0.0 and self.side * way >= 0.0:
            c.parallel += way * max(0.0, self.k * d**1.5 * (1.0 + self.c * way * c.v))


class Pinching(Effect):
    """Slip of Baber and Noori (1986): the growth of z is h(z) = 1 - zeta exp(-((z sgn u' - q)/w)^2) times as fast; about
    where the spring's restoring force would let z through zero."""

    def draw(self, rng):
        self.zeta = min(0.97, 0.97 * self.s)
        self.q, self.w = rng.uniform(0.0, 0.15), rng.uniform(0.2, 0.35)

    def install(self, law):
        law.slip = lambda z: 1.0 - self.zeta * math.exp(-(((z - self.q) / self.w) ** 2))

    def apply(self, c):
        pass


class Damper(Effect):
    """A damper that nobody modelled: a force of a power of speed below one, or Biot's sum of dashpots and springs whose loss
    does not depend on frequency."""

    def draw(self, rng):
        self.kind = rng.choice(("power", "structural", "linear"))
        sc = self.scale
        self.f = self.s * 0.5 * sc.F
        self.n = {"power": rng.uniform(0.5, 0.8), "linear": 1.0, "structural": 0.0}[self.kind]
        w = sc.V / sc.U
        self.arms = [0.4 / w * 4.0**j for j in range(-2, 3)]

    def start(self):
        self.x = [0.0] * len(self.arms)

    def apply(self, c):
        if self.kind == "structural":
            k = self.f / self.scale.U
            for i, tau in enumerate(self.arms):
                e = math.exp(-c.h / tau)
                self.x[i] = self.x[i] * e + k * tau * c.v * (1.0 - e)
                c.parallel += self.x[i] * 0.5
        else:
            v = c.v / self.scale.V
            c.parallel += math.copysign(self.f * abs(v) ** self.n * math.tanh(abs(v) / 0.02), v)


class Lopsided(Effect):
    """Unknown to the library: loops larger on one side."""

    def draw(self, rng):
        self.way = rng.choice((-1.0, 1.0))

    def apply(self, c):
        c.hysteretic *= 1.0 + self.s * 0.6 * math.tanh(self.way * c.u / (0.15 * self.scale.U))


class Cogging(Effect):
    """Unknown to the library: a force that comes again along the stroke, as of a rack."""

    def draw(self, rng):
        self.pitch = rng.uniform(0.12, 0.22) * self.scale.U
        self.phase = rng.uniform(0.5, 2.5)

    def apply(self, c):
        c.parallel += self.s * 0.2 * self.scale.F * math.sin(2 * math.pi * c.u / self.pitch + self.phase)


class Coupling(Effect):
    """A share s of the hysteretic force of two directions has one circle of yielding: see the orbits of a pad and the platform."""


DEVICE = {
    "rate_dependence": Rate,
    "self_heating": Heating,
    "ambient_temperature": Ambient,
    "mullins_softening": Mullins,
    "cyclic_degradation": Degradation,
    "strain_stiffening": Stiffening,
    "axial_shear_interaction": Buckling,
    "varying_axial_load": Pressure,
    "cavitation": Cavitation,
    "friction": Friction,
    "gap_impact": Gap,
    "pinching": Pinching,
    "damping": Damper,
    "lopsided": Lopsided,
    "cogging": Cogging,
}


def drive(law, effects, c):
    """Force of a law with effects at the state c (u, v, h and context set)."""
    c.elastic, c.hysteretic = law.move(c.u, c.v, c.h)
    c.parallel = 0.0
    for e in effects:
        e.apply(c)
    return c.elastic + c.hysteretic + c.parallel
