"""Integrators of this set: numba RK4 for small M-C-K structures with non-linear links, and for rigs under imposed motion."""
import numpy as np
from numba import njit

NZ = 8


@njit(cache=True)
def link(code, p, d, v, z, zd):
    """force of one link; z: its states, zd: their rates"""
    if code == 0:      # Bouc-Wen: alpha, k, uy, n
        s = z[0]
        sg = 1.0 if s * v > 0 else 0.0
        zd[0] = v / p[2] * (1.0 - sg * abs(s) ** p[3])
        return p[0] * p[1] * d + (1 - p[0]) * p[1] * p[2] * s
    if code == 1:      # Gent-type limiting extensibility: k, lock
        x = min((d / p[1]) ** 2, 0.97)
        return p[0] * d * x / (1.0 - x)
    if code == 2:      # Jankowski contact: gap, kh, xi, m, sign (damping only on approach)
        e = p[4] * d - p[0]
        if e <= 0:
            return 0.0
        f = p[1] * e ** 1.5
        ev = p[4] * v
        if ev > 0:
            f += 2 * p[2] * np.sqrt(p[1] * np.sqrt(e) * p[3]) * ev
        return p[4] * f
    if code == 3:      # sliding friction after Constantinou: fmax, fmin, a, uy
        s = z[0]
        zd[0] = v / p[3] * (1.0 - (0.9 * (1.0 if s * v > 0 else -1.0) + 0.1) * s * s)
        return (p[0] - (p[0] - p[1]) * np.exp(-p[2] * abs(v))) * s
    if code == 4:      # power-law dashpot: c, a, v0
        return p[0] * v * (v * v + p[2] * p[2]) ** (0.5 * (p[1] - 1.0))
    if code == 5:      # Iwan: p0 k_total, p1 residual fraction, p2 dy_min, p3 dy_max (6 Jenkins elements)
        f = p[1] * p[0] * d
        ke = (1 - p[1]) * p[0] / 6.0
        for i in range(6):
            y = p[2] + (p[3] - p[2]) * i / 5.0
            s = z[i]
            if s >= y and v > 0 or s <= -y and v < 0:
                zd[i] = 0.0
            else:
                zd[i] = v
            f += ke * min(max(s, -y), y)
        return f
    return 0.0


@njit(cache=True)
def _acc(Mi, C, K, B, code, P, rr, ag, fe, u, v, z, zd):
    n = u.size
    nl = code.size
    q = np.empty(n)
    for i in range(n):
        s = fe[i]
        for j in range(n):
            s -= K[i, j] * u[j] + C[i, j] * v[j]
        q[i] = s
    k = 0
    while k < nl:
        d = 0.0
        w = 0.0
        for j in range(n):
            d += B[k, j] * u[j]
            w += B[k, j] * v[j]
        if code[k] == 6:     # Park-Wen-Ang pair: alpha, k, uy; couple flag p[3]
            d2 = 0.0
            w2 = 0.0
            for j in range(n):
                d2 += B[k + 1, j] * u[j]
                w2 += B[k + 1, j] * v[j]
            p = P[k]
            a1 = z[k, 0]
            a2 = z[k + 1, 0]
            g1 = 0.5 * (abs(w * a1) + w * a1)
            g2 = 0.5 * (abs(w2 * a2) + w2 * a2)
            zd[k, 0] = (w - a1 * g1 - p[3] * a1 * g2) / p[2]
            zd[k + 1, 0] = (w2 - a2 * g2 - p[3] * a2 * g1) / p[2]
            f1 = p[0] * p[1] * d + (1 - p[0]) * p[1] * p[2] * a1
            f2 = p[0] * p[1] * d2 + (1 - p[0]) * p[1] * p[2] * a2
            for j in range(n):
                q[j] -= B[k, j] * f1 + B[k + 1, j] * f2
            k += 2
            continue
        f = link(code[k], P[k], d, w, z[k], zd[k])
        for j in range(n):
            q[j] -= B[k, j] * f
        k += 1
    a = np.empty(n)
    for i in range(n):
        s = 0.0
        for j in range(n):
            s += Mi[i, j] * q[j]
        a[i] = s
        for j in range(rr.shape[1]):
            a[i] -= rr[i, j] * ag[j]
    return a


@njit(cache=True)
def mdof(Mi, C, K, B, code, P, rr, ag, fe, dt, nsub):
    """relative u, v, a at each point of ag (npts x ncomp); fe npts x n external forces; RK4 with nsub steps a point"""
    npts = ag.shape[0]
    n = Mi.shape[0]
    nl = code.size
    U = np.zeros((npts, n))
    V = np.zeros((npts, n))
    A = np.zeros((npts, n))
    u = np.zeros(n)
    v = np.zeros(n)
    z = np.zeros((nl, NZ))
    k1 = np.zeros((nl, NZ))
    k2 = np.zeros((nl, NZ))
    k3 = np.zeros((nl, NZ))
    k4 = np.zeros((nl, NZ))
    A[0] = _acc(Mi, C, K, B, code, P, rr, ag[0], fe[0], u, v, z, k1)
    h = dt / nsub
    for i in range(npts - 1):
        dg = (ag[i + 1] - ag[i]) / nsub
        df = (fe[i + 1] - fe[i]) / nsub
        for s in range(nsub):
            g0 = ag[i] + s * dg
            f0 = fe[i] + s * df
            a1 = _acc(Mi, C, K, B, code, P, rr, g0, f0, u, v, z, k1)
            u2 = u + 0.5 * h * v
            v2 = v + 0.5 * h * a1
            a2 = _acc(Mi, C, K, B, code, P, rr, g0 + 0.5 * dg, f0 + 0.5 * df, u2, v2, z + 0.5 * h * k1, k2)
            u3 = u + 0.5 * h * v2
            v3 = v + 0.5 * h * a2
            a3 = _acc(Mi, C, K, B, code, P, rr, g0 + 0.5 * dg, f0 + 0.5 * df, u3, v3, z + 0.5 * h * k2, k3)
            u4 = u + h * v3
            v4 = v + h * a3
            a4 = _acc(Mi, C, K, B, code, P, rr, g0 + dg, f0 + df, u4, v4, z + h * k3, k4)
            u = u + h / 6 * (v + 2 * v2 + 2 * v3 + v4)
            v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
            z = z + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
            for k in range(nl):
                if code[k] == 5:
                    for m in range(6):
                        y = P[k, 2] + (P[k, 3] - P[k, 2]) * m / 5.0
                        z[k, m] = min(max(z[k, m], -y), y)
        U[i + 1] = u
        V[i + 1] = v
        A[i + 1] = _acc(Mi, C, K, B, code, P, rr, ag[i + 1], fe[i + 1], u, v, z, k1)
    return U, V, A


@njit(cache=True)
def bw_z(u, uy, n, nsub=6):
    """Bouc-Wen z (A=1, beta=gamma=1/2) along a path, RK4 in the displacement; uy may vary: array per point"""
    N = u.size
    out = np.zeros(N)
    z = 0.0
    for i in range(1, N):
        h = (u[i] - u[i - 1]) / nsub
        y = uy[i]
        for s in range(nsub):
            k = np.zeros(4)
            for r in range(4):
                w = z if r == 0 else (z + 0.5 * k[r - 1] if r < 3 else z + k[2])
                k[r] = h / y * (1.0 - (abs(w) ** n if w * h > 0 else 0.0))
            z += (k[0] + 2 * k[1] + 2 * k[2] + k[3]) / 6
        out[i] = z
    return out


@njit(cache=True)
def maxwell_power(u, dt, K, C, a, nsub=16):
    """non-linear Maxwell damper: F' = K (v - sgn(F) (|F|/C)^(1/a)), implicit midpoint by bisection-safe Newton"""
    N = u.size
    out = np.zeros(N)
    F = 0.0
    h = dt / nsub
    for i in range(1, N):
        # velocity by a local parabola is smoother than the chord
        v0 = (u[i] - u[i - 1]) / dt
        va = v0 if i < 2 else 0.5 * (v0 + (u[i - 1] - u[i - 2]) / dt)
        vb = v0 if i > N - 2 else 0.5 * (v0 + (u[i + 1] - u[i]) / dt)
        for s in range(nsub):
            v = va + (vb - va) * (s + 0.5) / nsub
            v += 6 * (v0 - 0.5 * (va + vb)) * ((s + 0.5) / nsub) * (1 - (s + 0.5) / nsub)
            x = F
            for it in range(40):
                m = 0.5 * (F + x)
                am = abs(m) / C
                g = x - F - h * K * (v - (1 if m > 0 else -1) * am ** (1 / a))
                dg = 1 + 0.5 * h * K * (1 / a) * am ** (1 / a - 1) / C
                dx = g / dg
                x -= dx
                if abs(dx) < 1e-10 * (1 + abs(x)):
                    break
            F = x
        out[i] = F
    return out
