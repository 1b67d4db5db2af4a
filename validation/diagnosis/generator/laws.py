"""The laws that the analyst has right: force by deformation, in small steps, as an elastic part and a hysteretic part."""

import math


class BoucWen:
    """z' = u' (1 - |z|^n (1 + sgn(u' z)) / 2), forces k2 u and Q z; midpoint rule. `slip` thins the loop near z = 0 (see effects)."""

    slip = None

    def __init__(self, k2, Q, k1, n=1.0):
        self.k2, self.Q, self.uy, self.n = k2, Q, Q / (k1 - k2), n
        self.start()

    def start(self):
        self.z = self.u = 0.0

    def rate(self, z, way):
        s = 1.0 if z * way > 0.0 else 0.0
        r = (1.0 - s * abs(z) ** self.n) / self.uy
        return r * self.slip(z * way) if self.slip else r

    def move(self, u, v, h):
        du = u - self.u
        self.u = u
        n = 1 + int(abs(du) / (0.08 * self.uy))
        way = 1.0 if du > 0.0 else -1.0
        for _ in range(n):
            d = du / n
            mid = self.z + 0.5 * d * self.rate(self.z, way)
            self.z += d * self.rate(mid, way)
        return self.k2 * u, self.Q * self.z


class Bilinear:
    """Elastic up to a yield force in parallel to a spring."""

    def __init__(self, k2, Q, k1):
        self.k2, self.Q, self.k0 = k2, Q, k1 - k2
        self.start()

    def start(self):
        self.q = self.u = 0.0

    def move(self, u, v, h):
        self.q = max(-self.Q, min(self.Q, self.q + self.k0 * (u - self.u)))
        self.u = u
        return self.k2 * u, self.q


class MenegottoPinto:
    """The curve of Menegotto and Pinto (1973) between asymptotes of stiffness E and b E, with Filippou's rule of memory,
    without isotropic hardening; in parallel to a spring."""

    def __init__(self, Fy, E, b, spring, R0=18.0, c1=0.925, c2=0.15):
        self.Fy, self.E, self.b, self.spring, self.R = Fy, E, b, spring, (R0, c1, c2)
        self.start()

    def start(self):
        self.way = 0
        self.u = self.f = self.ur = self.fr = 0.0
        self.uy = self.Fy / self.E
        self.most = {1: self.uy, -1: -self.uy}

    def turn(self, way):
        """The asymptote ahead: f = way Fy + b E (u - way uy), and where the elastic line through the reversal meets it."""
        hard = self.b * self.E
        self.us = (way * (self.Fy - hard * self.uy) - self.fr + self.E * self.ur) / (self.E - hard)
        self.fs = way * self.Fy + hard * (self.us - way * self.uy)
        xi = abs((self.most[way] - self.us) / self.uy)
        R0, c1, c2 = self.R
        self.r = R0 * (1.0 - c1 * xi / (c2 + xi))

    def move(self, u, v, h):
        du = u - self.u
        if du != 0.0:
            way = 1 if du > 0.0 else -1
            if way != self.way:
                if self.way:
                    self.ur, self.fr = self.u, self.f
                    pick = min if way > 0 else max
                    self.most[-way] = pick(self.most[-way], self.u)
                self.way = way
                self.turn(way)
            x = (u - self.ur) / (self.us - self.ur)
            y = self.b * x + (1.0 - self.b) * x / (1.0 + abs(x) ** self.r) ** (1.0 / self.r)
            self.f = self.fr + y * (self.fs - self.fr)
            self.u = u
        return self.spring * u, self.f


class Viscoelastic:
    """A spring and a dashpot in parallel; the dashpot's force counts as the hysteretic part."""

    def __init__(self, k, c):
        self.k, self.c = k, c

    def start(self):
        pass

    def move(self, u, v, h):
        return self.k * u, self.c * v


class Concrete:
    """Bilinear envelope; unloading softer after larger deformations (Takeda, Sozen and Nielsen, 1970), and reloading towards the
    largest deformation reached on that side along a curve, as cracks close or bars yield on the way."""

    def __init__(self, k, Fy, hardening, a, c):
        self.k, self.Fy, self.b, self.a, self.c = k, Fy, hardening, a, c
        self.start()

    def start(self):
        uy = self.Fy / self.k
        self.u = self.f = 0.0
        self.way, self.anchor = 0, (0.0, 0.0)
        self.most = {1: uy, -1: -uy}

    def envelope(self, u):
        way = 1.0 if u > 0.0 else -1.0
        uy = self.Fy / self.k
        return self.k * u if abs(u) < uy else way * (self.Fy + self.b * self.k * (abs(u) - uy))

    def move(self, u, v, h):
        du = u - self.u
        if du == 0.0:
            return 0.0, self.f
        way, uy = (1 if du > 0.0 else -1), self.Fy / self.k
        if way != self.way:
            self.way, self.anchor = way, (self.u, self.f)
        f = None
        if self.f * way < 0.0:
            soft = self.k * (uy / abs(self.most[-way])) ** self.a
            f = self.f + soft * du
            if f * way > 0.0:  # zero force lies within the step
                self.anchor, f = (self.u - self.f / soft, 0.0), None
        if f is None:
            top = self.most[way]
            if way * u >= way * top:
                f = self.envelope(u)
            else:
                (u0, f0), end = self.anchor, self.envelope(top)
                x = (u - u0) / (top - u0)
                bend = self.c if abs(top) > uy else 0.0
                f = f0 + (end - f0) * (x + bend * x * (1.0 - x))
        self.most[way] = way * max(way * self.most[way], way * u)
        self.u, self.f = u, f
        return 0.0, f
