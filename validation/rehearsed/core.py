"""Tools of the generator: motions, noise, recordings, running the analyst's script, least squares."""
import os, sys, json, subprocess, tempfile, shutil
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
G = 9.80665


# ---------------------------------------------------------------- motions
def cyc(blocks, dt, shape="sin", lead=0.5, tail=0.5):
    """blocks of (amplitude, cycles, frequency) or ('hold', seconds) or ('to', value, seconds); sine with soft ends, or triangles"""
    out = [np.zeros(int(round(lead / dt)))]
    last = 0.0
    for b in blocks:
        if b[0] == "hold":
            out.append(np.full(int(round(b[1] / dt)), last))
            continue
        if b[0] == "to":
            n = int(round(b[2] / dt))
            s = np.arange(1, n + 1) / n
            out.append(last + (b[1] - last) * s)
            last = b[1]
            continue
        a, n, f = b
        t = np.arange(1, int(round(n / f / dt)) + 1) * dt
        ph = (t * f) % 1.0
        if shape == "sin":
            y = a * np.sin(2 * np.pi * ph)
        else:
            y = a * np.where(ph < .25, 4 * ph, np.where(ph < .75, 2 - 4 * ph, 4 * ph - 4))
        out.append(y)
        last = y[-1] if abs(y[-1]) > 1e-9 * a else 0.0
    out.append(np.full(int(round(tail / dt)), last))
    return np.concatenate(out)


def band(rng, n, dt, f1, f2, peak, rise=2.0):
    f = np.fft.rfftfreq(n, dt)
    X = np.where((f >= f1) & (f <= f2), 1.0 / np.maximum(f, f1) ** 0.7, 0) * np.exp(2j * np.pi * rng.random(f.size))
    x = np.fft.irfft(X, n)
    t = np.arange(n) * dt
    env = np.clip(t / rise, 0, 1) * np.clip((t[-1] - t) / rise, 0, 1)
    x = x * np.sin(env * np.pi / 2) ** 2
    return peak * x / np.abs(x).max()


def gm(name, dt, n, scale=1.0, start=0.0):
    """a recorded accelerogram in m/s2, resampled, tapered at both ends"""
    root = os.environ["GROUND_MOTIONS"]
    for p in (os.path.join(root, "ground_motions", name + ".csv"), os.path.join(root, name + ".csv")):
        if os.path.exists(p):
            d = np.loadtxt(p, delimiter=",", skiprows=1)
            break
    t = np.arange(n) * dt
    a = np.interp(t + start, d[:, 0], d[:, 1], right=0.0) * G * scale
    return taper(a, dt)


def taper(a, dt, s=0.4):
    k = int(s / dt)
    w = np.ones(a.size)
    w[:k] = np.sin(np.linspace(0, np.pi / 2, k)) ** 2
    w[-k:] = w[:k][::-1]
    return a * w


def kanai(rng, n, dt, fg, zg, peak, t1, t2, pulse=None):
    """filtered noise (Kanai-Tajimi with a Clough-Penzien high pass by FFT), Housner-Jennings envelope; pulse = (t0, period, velocity)"""
    f = np.fft.rfftfreq(n, dt)
    w = np.fft.rfft(rng.standard_normal(n))
    r = f / fg
    H = (1 + 2j * zg * r) / (1 - r ** 2 + 2j * zg * r)
    rf = f / 0.25
    H = H * (-rf ** 2) / (1 - rf ** 2 + 1.2j * rf) * -1 / (1 + (f / 18.0) ** 6)
    a = np.fft.irfft(w * H, n)
    t = np.arange(n) * dt
    env = np.where(t < t1, (t / t1) ** 2, np.where(t < t2, 1.0, np.exp(-0.28 * (t - t2))))
    a = a * env
    a *= peak / np.abs(a).max()
    if pulse:
        t0, T, v = pulse
        x = (t - t0) / T
        a = a + np.where(np.abs(x) < 1.0, -v * np.pi / T * (np.sin(2 * np.pi * x) * np.cos(np.pi * x / 2) ** 2 + .5 * np.sin(np.pi * x) * np.cos(2 * np.pi * x) / 2), 0)
    return taper(a, dt)


# ---------------------------------------------------------------- noise
def noise(kind, n, rng, dt=0.01):
    w = rng.standard_normal(n)
    if kind == "white":
        x = w
    elif kind.startswith("ar"):
        p = float(kind[2:])
        x = np.empty(n)
        s = 0.0
        for i in range(n):
            s = p * s + w[i]
            x[i] = s
        x = x + 0.3 * np.std(x) * rng.standard_normal(n)
    elif kind == "pink":
        f = np.fft.rfftfreq(n)
        f[0] = f[1]
        x = np.fft.irfft(np.fft.rfft(w) / f ** 0.5, n)
    elif kind == "reddish":
        f = np.fft.rfftfreq(n)
        f[0] = f[1]
        x = np.fft.irfft(np.fft.rfft(w) / f ** 0.72, n)
        x = x / x.std() + 0.35 * rng.standard_normal(n)
    elif kind.startswith("reson"):
        fr = float(kind[5:]) * dt
        r = 0.94
        a1, a2 = 2 * r * np.cos(2 * np.pi * fr), -r * r
        x = np.zeros(n)
        for i in range(2, n):
            x[i] = a1 * x[i - 1] + a2 * x[i - 2] + w[i]
        x = x / x.std() + 0.5 * rng.standard_normal(n)
    elif kind == "clicks":
        x = 0.6 * w
        hits = rng.random(n) < 0.012
        amp = rng.laplace(0, 3.2, n) * hits
        dec = np.exp(-np.arange(6) / 1.6)
        x = x + np.convolve(amp, dec)[:n]
    else:
        raise ValueError(kind)
    x = x - x.mean()
    return x / x.std()


# ---------------------------------------------------------------- text of the scripts
SOLVE = """constraints Transformation
numberer {num}
system {sys}
test NormDispIncr {tol} 50
algorithm Newton
"""
LOOP_S = """integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
"""
LOOP_T = """integrator Newmark 0.5 0.25
analysis Transient
set sub 1
if {[info exists nsub]} {set sub $nsub}
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze $sub [expr $dt/double($sub)]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze $sub [expr $dt/double($sub)]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
"""


def solve(num="Plain", sys="BandGeneral", tol="1.0e-9"):
    return SOLVE.format(num=num, sys=sys, tol=tol)


def static1(head, psets, mats, els, tol="1.0e-9"):
    """one spring on a rig: nodes 1 (fixed) and 2 (imposed)"""
    ps = "\n".join("pset %s %s" % (k, repr(v)) for k, v in psets)
    return ("# %s\n# units: %s\nwipe\nmodel basic -ndm 2 -ndf 2\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1\n\n%s\n\n%s\n\n%s\n# vertical guide of the rig\nuniaxialMaterial Elastic 99 1.0e6\nelement zeroLength 99 1 2 -mat 99 -dir 2\n\n"
            "timeSeries Path 1 -dt $dt -filePath $motion\npattern Plain 1 1 {\n    sp 2 1 1.0\n}\n"
            "recorder Element -file force.out -time -ele 1 force\nrecorder Node -file disp.out -time -node 2 -dof 1 disp\n\n"
            % (head[0], head[1], ps, mats, els)) + solve(tol=tol) + LOOP_S


# ---------------------------------------------------------------- OpenSees
def opensees(case, psets, runs):
    """the analyst's script for every parameter set and run -> list (per set) of {run: {channel: series at script times 0, dt, ...}}"""
    d = tempfile.mkdtemp(prefix="s5")
    folder = os.path.join(HERE, "cases", case["name"])
    w = ["proc pset {n v} {if {[info exists ::P($n)]} {set v $::P($n)}; uplevel 1 [list set $n $v]}"]
    for k, p in enumerate(psets):
        for r in runs:
            sub = os.path.join(d, "%d-%s" % (k, r["name"]))
            os.mkdir(sub)
            for f in r["dats"]:
                os.symlink(os.path.join(folder, f), os.path.join(sub, f))
            w.append("array unset ::P")
            w += ["set ::P(%s) %r" % (a, float(b)) for a, b in p.items()]
            w += ["set %s %s" % (a, b) for a, b in r["set"].items()]
            w.append("cd %s" % sub)
            w.append("if {[catch {source %s} msg]} {puts \"FAILED $msg\"}" % os.path.join(folder, "model.tcl"))
            w.append("wipe")
    sc = os.path.join(d, "w.tcl")
    open(sc, "w").write("\n".join(w) + "\n")
    q = subprocess.run(["nice", "timeout", "300", sys.executable, os.environ["OPENSEES_TCL"], sc], cwd=d, capture_output=True, text=True)
    txt = q.stdout + q.stderr
    if "FAILED" in txt or q.returncode:
        raise RuntimeError(case["name"] + ": " + txt[-1500:])
    res = []
    for k, p in enumerate(psets):
        o = {}
        for r in runs:
            n = r["set"]["npts"]
            c = {}
            files = {}
            for ch in case["channels"]:
                if ch["output"] not in files:
                    files[ch["output"]] = np.loadtxt(os.path.join(d, "%d-%s" % (k, r["name"]), ch["output"]))
                y = files[ch["output"]]
                t = np.arange(n) * r["set"]["dt"]
                c[ch["channel"]] = np.interp(t, np.r_[0, y[:, 0]], np.r_[y[0, ch["column"]] if ch.get("first") else 0.0, y[:, ch["column"]]])
            o[r["name"]] = c
        res.append(o)
    shutil.rmtree(d)
    return res


# ---------------------------------------------------------------- least squares
def nmse(sim, rec):
    return float(np.mean((sim - rec) ** 2) / np.var(rec))


def resid(case, sim, runs):
    v = []
    nch = len(runs) * len(case["channels"])
    for r in runs:
        t = np.arange(r["set"]["npts"]) * r["set"]["dt"]
        for ch in case["channels"]:
            rec = r["rec"][ch["channel"]]
            s = np.interp(r["trec"], t, sim[r["name"]][ch["channel"]])
            v.append((s - rec) / np.sqrt(rec.size * np.var(rec) * nch))
    return np.concatenate(v)


def fit(case, start, iters=9):
    runs = [r for r in case["runs"] if r["role"] == "fit"]
    names = list(case["params"])
    lo = np.array([case["params"][n][1] for n in names])
    hi = np.array([case["params"][n][2] for n in names])
    x = (np.array([start[n] for n in names]) - lo) / (hi - lo)
    P = lambda y: dict(zip(names, lo + (hi - lo) * y))
    lam = 1e-3
    best = None
    for it in range(iters):
        h = 0.004
        pts = [x] + [x + h * e * (1 if x[i] < .98 else -1) for i, e in enumerate(np.eye(len(x)))]
        out = [resid(case, s, runs) for s in opensees(case, [P(p) for p in pts], runs)]
        r0 = out[0]
        f0 = r0 @ r0
        J = np.array([(o - r0) / (p - x)[i] for i, (o, p) in enumerate(zip(out[1:], pts[1:]))]).T
        A, g = J.T @ J, J.T @ r0
        cand = []
        for m in (lam * 0.03, lam, lam * 100):
            free = np.ones(len(x), bool)
            for _ in range(3):
                s = np.zeros(len(x))
                Af = A[np.ix_(free, free)]
                s[free] = -np.linalg.solve(Af + m * np.diag(np.diag(Af) + 1e-12), g[free])
                bad = ((x + s < 0) & (x <= 1e-9)) | ((x + s > 1) & (x >= 1 - 1e-9))
                if not (bad & free).any():
                    break
                free &= ~bad
            cand.append(np.clip(x + s, 0, 1))
        fs = [float(q @ q) for q in (resid(case, s, runs) for s in opensees(case, [P(c) for c in cand], runs))]
        k = int(np.argmin(fs))
        if fs[k] < f0:
            gain = (f0 - fs[k]) / f0
            x = cand[k]
            lam = max(lam * (0.03, 0.5, 50)[k], 1e-7)
            best = fs[k]
            if gain < 2e-3:
                break
        else:
            best = f0
            lam *= 300
            if lam > 1e3 or f0 - min(fs) > -1e-3 * f0:
                break
    return P(x), best


# ---------------------------------------------------------------- writing
def windows(t, mask, pad=0.15, merge=0.8):
    w = []
    for a in t[mask]:
        if w and a - w[-1][1] < merge:
            w[-1][1] = a
        else:
            w.append([a, a])
    return [[round(max(a - pad, 0), 2), round(b + pad, 2)] for a, b in w]


def fmt(x, sig):
    return "%.*g" % (sig, x) if x == x else ""


def toml(case):
    L = ['title = "%s"' % case["title"], 'model = "model.tcl"', ""]
    for n, (_, lo, hi, _) in case["params"].items():
        L += ["[[parameter]]", 'name  = "%s"' % n, "lower = %r" % float(lo), "upper = %r" % float(hi), ""]
    for r in case["runs"]:
        s = ", ".join('%s = %s' % (k, '"%s"' % v if isinstance(v, str) else repr(v)) for k, v in r["set"].items())
        L += ["[[run]]", 'name      = "%s"' % r["name"], 'role      = "%s"' % r["role"], 'recording = "%s.csv"' % r["name"],
              "set       = { %s }" % s, ""]
        for ch in case["channels"]:
            L += ["[[run.observe]]", 'channel = "%s"' % ch["channel"], 'output  = "%s"' % ch["output"], "column  = %d" % ch["column"],
                  'at      = "%s"' % ch["at"], ""]
    return "\n".join(L)


def write_case(case):
    """simulates and writes what the analyst has; keeps the recordings in case['runs']"""
    folder = os.path.join(HERE, "cases", case["name"])
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    open(os.path.join(folder, "model.tcl"), "w").write(case["model"])
    open(os.path.join(folder, "study.toml"), "w").write(toml(case))
    on = set(case["effects"])
    for ir, r in enumerate(case["runs"]):
        rng = np.random.default_rng([case["seed"], ir])
        for f, a in r["dats"].items():
            with open(os.path.join(folder, f), "w") as h:
                h.write("\n".join("%.8g" % x for x in list(a) + [a[-1]] * 2) + "\n")
            r["dats"][f] = np.array([float("%.8g" % x) for x in a])
        t, cols, ext = case["simulate"](r, on)
        r["ext"] = ext
        r["clean"], r["tfine"] = cols, t
        D = r["every"]
        n = int((t[-1] - 0.8 * D) / D)
        tr = (0.4 + np.arange(n)) * D + D * rng.uniform(-.12, .12, n)
        if case.get("skew"):
            tr = tr * (1 - case["skew"])
        tr = np.round(tr, 5)
        r["trec"], r["rec"], r["noise"] = tr, {}, {}
        head, data = ["time[s]"], ["%.5f" % x for x in tr]
        rows = [data]
        for ch in case["channels"]:
            c = ch["channel"]
            y = np.interp(tr, t, cols[c])
            if "sensor" in ext and c in ext["sensor"]:
                y = ext["sensor"][c](y)
            kind, lev = case["noise"][c] if c in case["noise"] else case["noise"]["*"]
            e = noise(kind, n, rng, D) * lev * np.sqrt(np.mean(y ** 2))
            z = y + e
            if "after" in ext and c in ext["after"]:
                z = ext["after"][c](z)
            q = 10.0 ** (np.floor(np.log10(np.abs(z).max())) - 4)
            z = np.round(z / q) * q
            r["rec"][c], r["noise"][c] = z, e
            head.append("%s[%s]" % (c, ch["unit"]))
            rows.append(["%.6g" % v for v in z])
        for c, (unit, lev, dig) in case.get("context", {}).items():
            y = np.interp(tr, t, ext[c]) + lev * noise("ar0.6", n, rng)
            head.append("%s[%s]" % (c, unit))
            rows.append(["%.*f" % (dig, v) for v in y])
        with open(os.path.join(folder, r["name"] + ".csv"), "w") as h:
            h.write(",".join(head) + "\n")
            h.write("\n".join(",".join(x) for x in zip(*rows)) + "\n")


def check_off(case):
    """largest NMSE of the generator with the effect off against the analyst's script in OpenSees"""
    tp = {n: p[0] for n, p in case["params"].items()}
    o = opensees(case, [tp], case["runs"])[0]
    worst = 0.0
    for r in case["runs"]:
        t, cols, ext = case["simulate"](r, set())
        for ch in case["channels"]:
            e = nmse(cols[ch["channel"]], o[r["name"]][ch["channel"]])
            r.setdefault("off", {})[ch["channel"]] = e
            worst = max(worst, e)
    return worst
