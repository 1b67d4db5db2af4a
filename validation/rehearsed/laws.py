"""Constitutive laws behind the recordings; every one is stepped explicitly along the imposed path."""
import math
import numpy as np


def bwz(z, x, n=1.0, m=3, b=0.5):
    """Bouc-Wen, normalised (A=1, beta=b, gamma=1-b): z after the increment x (in yield displacements), midpoint rule"""
    k = max(m, int(abs(x) * 25) + 1)
    h = x / k
    for _ in range(k):
        a = abs(z) ** n * ((1 - b) + b * (1 if z * h > 0 else -1))
        zm = z + .5 * h * (1 - a)
        a = abs(zm) ** n * ((1 - b) + b * (1 if zm * h > 0 else -1))
        z = z + h * (1 - a)
    return z


def bw_path(u, uy, n=1.0, m=3):
    z = np.zeros(u.size)
    for i in range(1, u.size):
        z[i] = bwz(z[i - 1], (u[i] - u[i - 1]) / uy, n, m)
    return z


def epp_path(u, k, q):
    """elastic-perfectly plastic force; q is a number or a series (strength at each step)"""
    q = np.broadcast_to(np.asarray(q, float), u.shape)
    f = np.zeros(u.size)
    s = k * u[0]
    for i in range(1, u.size):
        s += k * (u[i] - u[i - 1])
        s = min(max(s, -q[i]), q[i])
        f[i] = s
    return f


def steel02(u, Fy, E0, b, R0, c1, c2):
    """Menegotto-Pinto as in Steel02 (no isotropic hardening)"""
    Es = b * E0
    ey = Fy / E0
    out = np.zeros(u.size)
    kon = 0
    epsmin, epsmax, epspl, epss0, sigs0, epsr, sigr = -ey, ey, 0., 0., 0., 0., 0.
    epsP, sigP = 0.0, 0.0
    for i in range(1, u.size):
        eps = u[i]
        de = eps - epsP
        if kon == 0:
            if abs(de) < 1e-15:
                continue
            epsmax, epsmin = ey, -ey
            if de < 0:
                kon, epss0, sigs0, epspl = 2, epsmin, -Fy, epsmin
            else:
                kon, epss0, sigs0, epspl = 1, epsmax, Fy, epsmax
        if kon == 2 and de > 0:
            kon, epsr, sigr = 1, epsP, sigP
            epsmin = min(epsmin, epsP)
            epss0 = (Fy - Es * ey - sigr + E0 * epsr) / (E0 - Es)
            sigs0 = Fy + Es * (epss0 - ey)
            epspl = epsmax
        elif kon == 1 and de < 0:
            kon, epsr, sigr = 2, epsP, sigP
            epsmax = max(epsmax, epsP)
            epss0 = (-Fy + Es * ey - sigr + E0 * epsr) / (E0 - Es)
            sigs0 = -Fy + Es * (epss0 + ey)
            epspl = epsmin
        xi = abs((epspl - epss0) / ey)
        R = R0 * (1 - c1 * xi / (c2 + xi))
        er = (eps - epsr) / (epss0 - epsr)
        sig = b * er + (1 - b) * er / (1 + abs(er) ** R) ** (1 / R)
        sig = sig * (sigs0 - sigr) + sigr
        out[i] = sig
        epsP, sigP = eps, sig
    return out


def fatigue_hardening(u, K, Fy, Hk, on, w_ref, m, depth, kdep, work0=0.0):
    """linear kinematic hardening whose strength falls with a Miner sum of plastic excursions (Basquin-weighted); nothing recovers"""
    f = np.zeros(u.size)
    up = 0.0
    D = work0
    exc = 0.0
    sgn = 0
    hist = np.zeros(u.size)
    for i in range(1, u.size):
        g = 1 - depth * (1 - math.exp(-D)) if on else 1.0
        gk = 1 - kdep * (1 - math.exp(-D)) if on else 1.0
        k, sy, h = K * gk, Fy * g, Hk * g
        tr = k * (u[i] - up) - h * up
        if abs(tr) > sy:
            d = (abs(tr) - sy) / (k + h) * (1 if tr > 0 else -1)
            up += d
            if d * sgn < 0:
                exc = 0.0
            sgn = 1 if d > 0 else -1
            if on:
                e0 = exc
                exc += abs(d)
                D += (exc / w_ref) ** m - (e0 / w_ref) ** m
        f[i] = k * (u[i] - up)
        hist[i] = D
    return f, hist


def lead_heat(u, dt, k, q0, on, E2, C1, R12, C2, R2, T0):
    """lead plug as an elastic-plastic element, strength q0*exp(-E2*dT); two thermal masses (lead; shims and end plates) in a row"""
    f = np.zeros(u.size)
    Ts = np.full(u.size, T0)
    T1 = T2 = 0.0
    s = 0.0
    for i in range(1, u.size):
        q = q0 * math.exp(-E2 * T1) if on else q0
        du = u[i] - u[i - 1]
        tr = s + k * du
        s = min(max(tr, -q), q)
        dw = abs(s * (tr - s) / k)
        fl = (T1 - T2) / R12
        T1 += dw / C1 - fl * dt / C1
        T2 += (fl - T2 / R2) * dt / C2
        f[i] = s
        Ts[i] = T0 + (T2 if on else 0)
    return f, Ts


def langevin(u, k, ul):
    """Cohen's Pade form of the inverse Langevin function, initial stiffness k, locking at ul"""
    x = u / ul
    return k * u * (3 - x ** 2) / (3 * (1 - x ** 2))


def tension(u, kt, kc, Fc, on, q, c, phi, a):
    """vertical spring: elastic up to cavitation, then a power-law envelope Fc*(1+c*((u/uc)^q-1)); unloading on the line from the tip of the
    envelope to the damaged cavitation point, below which it is elastic again"""
    uc = Fc / kt
    um = uc
    f = np.zeros(u.size)
    cav = np.zeros(u.size, bool)
    env = lambda x: Fc * (1 + c * ((x / uc) ** q - 1))
    for i, x in enumerate(u):
        if x <= 0:
            f[i] = kc * x
        elif not on:
            f[i] = kt * x
        elif x >= um:
            um = x
            f[i] = env(x)
            cav[i] = x > uc
        else:
            Fd = Fc * (1 - phi * (1 - math.exp(-a * (um / uc - 1))))
            ud = Fd / kt
            if x < ud:
                f[i] = kt * x
            else:
                f[i] = Fd + (env(um) - Fd) * (x - ud) / max(um - ud, 1e-9)
                cav[i] = True
    return f, cav


def sliplock(u, uy, on, s_max, wref, sig, z0):
    """Bouc-Wen (n=1) in series with a slip-lock element: du = dz/h + a(z) dz, a Gaussian in z whose length grows with dissipated work"""
    z = 0.0
    out = np.zeros(u.size)
    W = 0.0
    for i in range(1, u.size):
        x = (u[i] - u[i - 1]) / uy
        k = max(6, int(abs(x) * 40) + 1)
        h = x / k
        for _ in range(k):
            def rate(y):
                b = 1 - (abs(y) if y * h > 0 else 0.0)
                if not on:
                    return b
                a = s_max * (1 - math.exp(-W / wref)) / (sig * 2.5066) * math.exp(-.5 * ((abs(y) - z0) / sig) ** 2)
                if y * h < 0:
                    a *= 0.45
                return b / (1 + a * b)
            zm = z + .5 * h * rate(z)
            z1 = z + h * rate(zm)
            W += abs(.5 * (z + z1) * (h - (z1 - z)))
            z = z1
        out[i] = z
    return out


def eyring(u, dt, kE, q0, v0):
    """spring kE in series with a sinh dashpot v = v0*sinh(q/q0), backward Euler with Newton"""
    q = 0.0
    out = np.zeros(u.size)
    for i in range(1, u.size):
        a = q + kE * (u[i] - u[i - 1])
        y = q
        for _ in range(30):
            s = y / q0
            r = y + kE * v0 * dt * math.sinh(s) - a
            d = r / (1 + kE * v0 * dt * math.cosh(s) / q0)
            d = max(min(d, q0), -q0)
            y -= d
            if abs(d) < 1e-10 * q0:
                break
        q = y
        out[i] = q
    return out


def zuniga(u, scale, b, M0=0.0, frac=1.0):
    """softening factor exp(-b*sqrt(M-m)) of Zuniga and Beatty; m = |u|/scale, M its largest value ever"""
    m = np.abs(u) / scale
    M = np.maximum.accumulate(np.maximum(m, M0))
    return np.exp(-b * frac * np.sqrt(M - m)), M[-1], M


def maxwell(u, dt, k, tau):
    e = math.exp(-dt / tau)
    g = k * tau / dt * (1 - e)
    q = np.zeros(u.size)
    for i in range(1, u.size):
        q[i] = q[i - 1] * e + g * (u[i] - u[i - 1])
    return q


def dahl(u, v, Fc, us, p, fs, vs):
    """Dahl friction dz = (1 - sgn z)^p du/us with a force that falls from fs*Fc to Fc over the speed vs"""
    z = 0.0
    out = np.zeros(u.size)
    for i in range(1, u.size):
        x = (u[i] - u[i - 1]) / us
        k = int(abs(x) * 12) + 1
        s = 1 if x > 0 else -1
        for _ in range(k):
            z += (x / k) * max(1 - s * z, 0.0) ** p
            z = min(max(z, -1.0), 1.0)
        out[i] = z * Fc * (1 + (fs - 1) * math.exp(-(abs(v[i]) / vs) ** 1.5))
    return out


def ring(u, dt, f0, zeta, gain):
    """force of a frame mode (f0, zeta) shaken by the table's acceleration; the oscillator integrated exactly for each velocity jump"""
    w = 2 * np.pi * f0
    wd = w * math.sqrt(1 - zeta ** 2)
    e = math.exp(-zeta * w * dt)
    c, s = math.cos(wd * dt), math.sin(wd * dt)
    y = yd = 0.0
    out = np.zeros(u.size)
    vp = 0.0
    for i in range(1, u.size):
        v = (u[i] - u[i - 1]) / dt
        yd -= v - vp
        vp = v
        y, yd = (e * (y * (c + zeta * w / wd * s) + yd / wd * s),
                 e * (yd * (c - zeta * w / wd * s) - y * w * w / wd * s))
        out[i] = gain * (w * w * y + 2 * zeta * w * yd)
    return out


def plane_plastic(ux, uy, k0, qd, k2):
    """two-directional plasticity with a circular yield surface"""
    n = ux.size
    fx, fy = np.zeros(n), np.zeros(n)
    px = py = 0.0
    for i in range(1, n):
        a, b = k0 * (ux[i] - px), k0 * (uy[i] - py)
        r = math.hypot(a, b)
        if r > qd:
            g = (r - qd) / k0
            px += g * a / r
            py += g * b / r
            a, b = a * qd / r, b * qd / r
        fx[i], fy[i] = a + k2 * ux[i], b + k2 * uy[i]
    return fx, fy
