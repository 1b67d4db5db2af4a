"""Own Newmark (average acceleration, initial-stiffness Newton) for masses joined by springs e = B u, and the springs' laws with trial and commit."""
import math
import numpy as np
import core as c
from laws import bwz


class BW:
    def __init__(s, ko, alpha, Qd, n=1.0):
        s.k, s.a, s.Q, s.n, s.uy = ko, alpha, Qd, n, Qd / ((1 - alpha) * ko)
        s.z = s.e = 0.0

    def trial(s, e, v):
        s.t = (bwz(s.z, (e - s.e) / s.uy, s.n, 1), e)
        return s.a * s.k * e + s.Q * s.t[0]

    def commit(s):
        s.z, s.e = s.t


class Bil:
    """bilinear kinematic (Steel01, Hardening)"""
    def __init__(s, E0, b, Fy):
        s.k, s.kb, s.q, s.ke = E0, b * E0, (1 - b) * Fy, (1 - b) * E0
        s.f = s.e = 0.0

    def trial(s, e, v):
        f = min(max(s.f + s.ke * (e - s.e), -s.q), s.q)
        s.t = (f, e)
        return f + s.kb * e

    def commit(s):
        s.f, s.e = s.t


class Pound:
    """Jankowski's nonlinear viscoelastic contact: beta*d^1.5, dashpot on the way in only"""
    k = 0.0

    def __init__(s, gap, beta, xi, m, side=1):
        s.g, s.b, s.x, s.m, s.side = gap, beta, xi, m, side
        s.on = []
        s.now = False

    def trial(s, e, v):
        d = s.side * e - s.g
        s.now = d > 0
        if d <= 0:
            return 0.0
        f = s.b * d ** 1.5
        w = s.side * v
        if w > 0:
            f += 2 * s.x * math.sqrt(s.b * math.sqrt(d) * s.m) * w
        return s.side * f

    def commit(s):
        s.on.append(s.now)


class PowDash:
    k = 0.0

    def __init__(s, cc, p):
        s.c, s.p = cc, p

    def trial(s, e, v):
        return math.copysign(s.c * abs(v) ** s.p, v)

    def commit(s):
        pass


class Plane:
    """two bilinear directions that share the yield surface |qx/Q|^p + |qy/Q|^p = 1 (radial return); p=None: no sharing"""
    def __init__(s, E0, b, Fy, p):
        s.k, s.kb, s.q, s.ke, s.p = E0, b * E0, (1 - b) * Fy, (1 - b) * E0, p
        s.f = np.zeros(2)
        s.e = np.zeros(2)

    def trial(s, e, v):
        f = s.f + s.ke * (e - s.e)
        if s.p is None:
            f = np.clip(f, -s.q, s.q)
        else:
            r = (abs(f[0] / s.q) ** s.p + abs(f[1] / s.q) ** s.p) ** (1 / s.p)
            if r > 1:
                f = f / r
        s.t = (f, e.copy())
        return f + s.kb * e

    def commit(s):
        s.f, s.e = s.t


def newmark(M, C, B, kv, nl, R, ag, h, nsub, tol):
    """M masses, C damping matrix, B compatibility, kv elastic springs, nl = [(index or slice, law)], R influence (ndof x nmotions),
    ag (n x nmotions) at the fine step h; -> u, v, relative a at every nsub-th step"""
    nd = M.size
    k0 = kv.copy()
    for j, l in nl:
        k0[j] += l.k
    Ki = np.linalg.inv(np.diag(M * 4 / h ** 2) + C * 2 / h + B.T @ (k0[:, None] * B))
    P = -(M[:, None] * R) @ ag.T
    P = P.T.copy()
    u, v, a = np.zeros(nd), np.zeros(nd), np.zeros(nd)
    n = ag.shape[0]
    U, V, A = [u], [v], [a]
    BT = B.T.copy()
    for i in range(1, n):
        un = u + h * v + .5 * h * h * a
        p = P[i]
        for _ in range(40):
            an = (un - u) * (4 / h ** 2) - v * (4 / h) - a
            vn = v + (a + an) * (.5 * h)
            e = B @ un
            s = kv * e
            if nl:
                ev = B @ vn
                for j, l in nl:
                    s[j] += l.trial(e[j], ev[j])
            d = Ki @ (p - M * an - C @ vn - BT @ s)
            un = un + d
            if abs(d).max() < tol:
                break
        an = (un - u) * (4 / h ** 2) - v * (4 / h) - a
        vn = v + (a + an) * (.5 * h)
        if nl:
            e = B @ un
            ev = B @ vn
            for j, l in nl:
                l.trial(e[j], ev[j])
                l.commit()
        u, v, a = un, vn, an
        if i % nsub == 0:
            U.append(u)
            V.append(v)
            A.append(a)
    return np.array(U), np.array(V), np.array(A)


def fine(a, nsub):
    n = a.size
    return np.interp(np.arange((n - 1) * nsub + 1) / nsub, np.arange(n), a)


def chain(n):
    """drifts of a chain whose foot is on the ground"""
    return np.eye(n) - np.eye(n, k=-1)


def shake(r, M, C, B, kv, nl, tol):
    s = r["set"]
    ag = r["dats"][s["motion"]]
    af = fine(ag, s["nsub"])
    R = np.ones((M.size, 1)) if r.get("R") is None else r["R"]
    U, V, A = newmark(M, C, B, kv, nl, R, af[:, None], s["dt"] / s["nsub"], s["nsub"], tol)
    return np.arange(ag.size) * s["dt"], ag, U, V, A


def qrun(name, role, a, dt, every, nsub):
    return dict(name=name, role=role, every=every, dats={name + ".dat": a}, set=dict(motion=name + ".dat", dt=dt, npts=len(a), nsub=nsub))


def building(head, ps, masses, body, recs, extra=""):
    """nodes 1 (ground), 2.. with masses; ps = {name: (.., .., .., start)}"""
    L = ["# %s" % head[0], "# units: %s" % head[1], "wipe", "model basic -ndm 1 -ndf 1", ""]
    L += ["pset %s %r" % (k, v[3]) for k, v in ps.items()]
    L += ["node 1 0.0", "fix 1 1"] + ["node %d 0.0 -mass %r" % (i + 2, m) for i, m in enumerate(masses)]
    L += ["", body.strip(), extra.strip(), "timeSeries Path 1 -dt $dt -filePath $motion", "pattern UniformExcitation 1 1 -accel 1", ""]
    L += [recs.strip(), ""]
    return "\n".join(L) + "\n" + c.solve(num="RCM", tol="1.0e-8" if head[1].endswith("m, s") or "m, t" in head[1] else "1.0e-7") + c.LOOP_T


def CH(*rows):
    return [dict(channel=a, unit=u, output=o, column=k, at=at, **({"first": True} if a.endswith("acc") else {})) for a, u, o, k, at in rows]
