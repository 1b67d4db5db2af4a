"""noise, motions, files, fit and the check against the real OpenSees"""
import os, sys, json, shutil, subprocess, tempfile
import numpy as np
from scipy.optimize import least_squares, minimize

HERE = os.path.dirname(os.path.abspath(__file__))
GM = os.path.join(os.environ.get('GROUND_MOTIONS', ''), '')
OPS = os.environ.get('OPENSEES_TCL', '')


# ---------- motions
def gm(name, dt, npts, scale=1.0, g=9.80665, t0=0.0):
    d = np.loadtxt(GM + name + '.csv', delimiter=',', skiprows=1)
    t = t0 + np.arange(npts) * dt
    return scale * g * np.interp(t, d[:, 0], d[:, 1], right=0.0)


def ramp(t, tr):
    x = np.clip(t / tr, 0, 1)
    return x * x * (3 - 2 * x)


def cycles(f, amps, dt, n_each=3, soft=True):
    """blocks of sine cycles of growing or mixed amplitude, joined smoothly"""
    T = n_each / f
    n = int(round(T * len(amps) / dt)) + 1
    t = np.arange(n) * dt
    A = np.interp(t, [0.0] + [v for k in range(len(amps)) for v in (k * T + 0.12 / f, (k + 1) * T - 0.12 / f)],
                  [0.5 * amps[0]] + [v for a in amps for v in (a, a)])
    w = ramp(t, 0.5 / f) if soft else 1.0
    return w * A * np.sin(2 * np.pi * f * t)


def multisine(rng, f1, f2, amp, dt, n, nf=14, power=1.0):
    t = np.arange(n) * dt
    f = np.geomspace(f1, f2, nf) * (1 + 0.05 * rng.standard_normal(nf))
    x = sum(fk ** -power * np.sin(2 * np.pi * fk * t + rng.uniform(0, 2 * np.pi)) for fk in f)
    x *= ramp(t, 1.0 / f1 * 0.5) * ramp(t[-1] - t, 0.3 / f1)
    return amp * x / np.abs(x).max()


def chirp(f1, f2, a1, a2, dt, n):
    t = np.arange(n) * dt
    T = t[-1]
    L = np.log(f2 / f1)
    ph = 2 * np.pi * f1 * T / L * (np.exp(t / T * L) - 1)
    return ramp(t, 0.6 / f1) * a1 * (a2 / a1) ** (t / T) * np.sin(ph)


# ---------- noise
def colour(rng, n, kind):
    w = rng.standard_normal(n)
    if kind == 'white':
        x = w
    elif kind.startswith('ar'):
        r = float(kind[2:])
        x = np.empty(n)
        x[0] = w[0]
        c = np.sqrt(1 - r * r)
        for i in range(1, n):
            x[i] = r * x[i - 1] + c * w[i]
    else:                      # pinkP: power spectrum f^-P, flat below 8 lines
        P = float(kind[4:])
        W = np.fft.rfft(rng.standard_normal(2 * n))
        k = np.maximum(np.arange(W.size), 8)
        x = np.fft.irfft(W * k ** (-P / 2))[:n]
        x += 0.25 * x.std() * w
    return (x - x.mean()) / x.std()


def fnum(v, q):
    dec = max(0, int(np.ceil(-np.log10(q) - 1e-9)))
    return f'{v:.{dec}f}'


# ---------- files
def write_case(case, folder, recs):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    open(folder + '/model.tcl', 'w').write(case.tcl)
    s = [f'title = "{case.title}"', 'model = "model.tcl"']
    for k, (true, lo, hi) in case.params.items():
        s += ['', '[[parameter]]', f'name  = "{k}"', f'lower = {float(lo)!r}', f'upper = {float(hi)!r}']
    for r in case.runs:
        kv = ', '.join(f'{k} = ' + (f'"{v}"' if isinstance(v, str) else repr(v)) for k, v in r['set'].items())
        s += ['', '[[run]]', f'name      = "{r["name"]}"', f'role      = "{r["role"]}"', f'recording = "{r["name"]}.csv"',
              f'set       = {{ {kv} }}']
        for ch, unit, out, col, at in case.observe:
            s += ['', '[[run.observe]]', f'channel = "{ch}"', f'output  = "{out}"', f'column  = {col}', f'at      = "{at}"']
        for fn, x in r['files'].items():
            np.savetxt(folder + '/' + fn, x, fmt='%.8g')
        rec = recs[r['name']]
        with open(folder + f'/{r["name"]}.csv', 'w') as f:
            f.write(','.join(f'{c}[{u}]' for c, u, q, x in rec) + '\n')
            for i in range(len(rec[0][3])):
                f.write(','.join(fnum(x[i], q) if np.isfinite(x[i]) else '' for c, u, q, x in rec) + '\n')
    open(folder + '/study.toml', 'w').write('\n'.join(s) + '\n')


def opensees(case, run, params):
    d = tempfile.mkdtemp(prefix='kept')
    try:
        open(d + '/model.tcl', 'w').write(case.tcl)
        for fn, x in run['files'].items():
            np.savetxt(d + '/' + fn, x, fmt='%.8g')
        w = ['proc pset {n v} {upvar #0 $n x; if {[info exists ::over($n)]} {set x $::over($n)} else {set x $v}}']
        w += [f'set over({k}) {float(v)!r}' for k, v in params.items()]
        w += [f'set {k} {v}' for k, v in run['set'].items()] + ['source model.tcl', 'wipe']
        open(d + '/run.tcl', 'w').write('\n'.join(w) + '\n')
        p = subprocess.run([sys.executable, OPS, 'run.tcl'], cwd=d, capture_output=True, text=True, timeout=300)
        res = {}
        for ch, unit, out, col, at in case.observe:
            try:
                a = np.loadtxt(d + '/' + out)
            except Exception:
                raise RuntimeError(p.stderr[-1500:] + p.stdout[-500:])
            res[ch] = (a[:, 0], a[:, col])
        if p.returncode:
            raise RuntimeError(p.stderr[-800:] + p.stdout[-500:])
        return res
    finally:
        shutil.rmtree(d, ignore_errors=True)


# ---------- the work on one case
class Case:
    """title, tcl, params {name: (underlying, lower, upper)}, runs, observe, base(p, run) -> {ch: y on the dt grid},
    truth(run, effects) -> the same; noise {ch: (rms fraction, colour, [quantum])}; every: (sample spacing / dt)"""
    also = []
    context = None
    every = 1.0
    hetero = None
    note = ''
    difficulty = 'medium'
    confusable = ()
    at = None
    windows = None
    only_channels = None
    starts = 2
    accept = ()

    def __init__(self, **k):
        self.__dict__.update(k)


def nmse(a, b):
    m = np.isfinite(b)
    return float(np.mean((a[m] - b[m]) ** 2) / np.var(b[m]))


def process(case, name, seed, folder, check=True):
    rng = np.random.default_rng(seed)
    recs, floors, data, times = {}, {}, {}, {}
    for r in case.runs:
        y = case.truth(r, set(case.effects))
        dt = r['set']['dt']
        n = len(next(iter(y.values())))
        tg = np.arange(n) * dt
        ev = r.get('every', case.every)
        m = int((n - 2) / ev)
        t = (np.arange(m) + rng.uniform(0.3, 0.7)) * dt * ev + rng.uniform(-0.12, 0.12, m) * dt * ev
        t = np.round(t, 5)
        rec = [('time', 's', 1e-5, t)]
        for ch, unit, out, col, at in case.observe:
            x = np.interp(t, tg, y[ch])
            frac, kind = case.noise[ch][:2]
            sref = frac * (np.std(x) if r['role'] == 'fit' else 0.5 * (np.std(x) + case._sd.get(ch, np.std(x))))
            if r['role'] == 'fit':
                case.__dict__.setdefault('_sd', {})[ch] = np.std(x)
            e = colour(rng, m, kind)
            if case.hetero:
                e = e * case.hetero(x)
                e /= e.std()
            q = case.noise[ch][2] if len(case.noise[ch]) > 2 else 10.0 ** np.floor(np.log10(np.std(x)) - 3)
            if len(case.noise[ch]) <= 2 or q < 0:
                q = abs(q)
            obs = np.round((x + sref * e) / q) * q
            floors[r['name'], ch] = float(np.mean((obs - x) ** 2) / np.var(obs))
            rec.append((ch, unit, q, obs))
            data[r['name'], ch] = obs
        if case.context:
            rec += case.context(r, t, rng)
        recs[r['name']] = rec
        times[r['name']] = (t, tg)
    write_case(case, folder, recs)

    names = list(case.params)
    lo = np.array([case.params[k][1] for k in names], float)
    hi = np.array([case.params[k][2] for k in names], float)
    tr = np.array([case.params[k][0] for k in names], float)
    fitruns = [r for r in case.runs if r['role'] == 'fit']
    nch = len(fitruns) * len(case.observe)

    def values(x, runs):
        p = dict(zip(names, lo + (hi - lo) * np.clip(x, 0, 1)))
        out = {}
        for r in runs:
            y = case.base(p, r)
            t, tg = times[r['name']]
            for ch in y:
                if (r['name'], ch) in data:
                    out[r['name'], ch] = np.interp(t, tg, y[ch])
        return out

    def resid(x):
        v = values(x, fitruns)
        return np.concatenate([(v[k] - data[k]) / np.sqrt(data[k].size * np.var(data[k]) * nch) for k in v])

    best = None
    x0s = [np.clip((tr - lo) / (hi - lo), 0.02, 0.98)] + [rng.uniform(0.15, 0.85, len(names)) for _ in range(case.starts - 1)]
    for x0 in x0s:
        s = least_squares(resid, x0, bounds=(0, 1), diff_step=2e-4, x_scale=0.2, max_nfev=40)
        if best is None or s.cost < best.cost:
            best = s
    nm = minimize(lambda x: float(np.sum(resid(x) ** 2)) + 1e3 * float(np.sum(np.maximum(0, np.abs(x - 0.5) - 0.5))), best.x,
                  method='Nelder-Mead', options=dict(maxfev=150, initial_simplex=np.vstack([best.x] + [
                      np.clip(best.x + 0.04 * (1 if best.x[i] < 0.5 else -1) * np.eye(len(names))[i], 0, 1) for i in range(len(names))])))
    x = np.clip(nm.x if nm.fun < 2 * best.cost else best.x, 0, 1)
    v = values(x, case.runs)
    per = {k: nmse(v[k], data[k]) for k in v}
    role = {r['name']: r['role'] for r in case.runs}
    mean = lambda d, ro: float(np.mean([d[k] for k in d if role[k[0]] == ro]))
    bf, bh, ff, fh = mean(per, 'fit'), mean(per, 'holdout'), mean(floors, 'fit'), mean(floors, 'holdout')
    truth = dict(cause=case.cause)
    if case.also:
        truth['also'] = case.also
    chk = None
    if check:
        e = []
        for r in case.runs:
            o = opensees(case, r, {k: case.params[k][0] for k in names})
            y = case.truth(r, set())
            tg = times[r['name']][1]
            e += [nmse(np.interp(tg, *o[ch]), y[ch]) for ch in o]
        chk = max(e)
        truth_check_mean = float(np.mean(e))
    if len(case.effects) > 1:
        sh = {}
        for ef in case.effects:
            s = []
            for r in fitruns:
                a = case.truth(r, set(case.effects))
                b = case.truth(r, set(case.effects) - {ef})
                s += [nmse(b[ch], a[ch]) for ch in a if (r['name'], ch) in data]
            sh[ef] = float(np.mean(s))
        tot = sum(sh.values())
        truth['effect_shares'] = {k: round(s / tot, 3) for k, s in sh.items()}
    if case.cause == 'none':
        truth['where'] = {}
    else:
        fitk = {k: per[k] - floors[k] for k in per if role[k[0]] == 'fit' and (not case.only_channels or k[1] in case.only_channels)}
        top = max(fitk, key=fitk.get)
        chs = sorted({k[1] for k in fitk if fitk[k] > 0.2 * max(fitk[j] for j in fitk if j[0] == k[0]) and fitk[k] > 0.1 * fitk[top]} | set(case.accept),
                     key=[o[0] for o in case.observe].index)
        rs = [r['name'] for r in fitruns if max(fitk[k] for k in fitk if k[0] == r['name']) > 0.3 * fitk[top]]
        truth['where'] = dict(run=top[0], channel=top[1], accept_runs=rs, accept_channels=case.only_channels or chs)
        if case.at:
            truth['where']['at'] = case.at
        if case.windows:
            w = case.windows([r for r in case.runs if r['name'] == top[0]][0])
            if w:
                truth['where']['windows'] = w
    truth.update(note=case.note, noise_floor_nmse_fit=round(ff, 7), noise_floor_nmse_holdout=round(fh, 7),
                 baseline_nmse_fit=round(bf, 7), baseline_nmse_holdout=round(bh, 7),
                 baseline_parameters={k: float(f'{a:.6g}') for k, a in zip(names, lo + (hi - lo) * x)},
                 underlying_parameters={k: float(a) for k, a in zip(names, tr)},
                 confusable_with=list(case.confusable),
                 difficulty='null' if case.cause == 'none' else 'hard' if bf / ff < 8 else 'medium' if bf / ff < 30 else 'easy',
                 ratio_fit=round(bf / ff, 2), ratio_holdout=round(bh / fh, 2),
                 gap_scored=case.cause not in ('none', 'unknown'))
    if chk is not None:
        truth['self_check_effect_off_nmse'] = float(f'{truth_check_mean:.3g}')
        truth['self_check_worst_channel'] = float(f'{chk:.3g}')
    rep = {f'{k[0]}/{k[1]}': (round(per[k] / floors[k], 1)) for k in per}
    return truth, rep


def merge_windows(t, on, join=0.5, pad=0.1):
    """seconds in which `on` holds, joined and padded"""
    i = np.flatnonzero(on)
    if not i.size:
        return []
    w = []
    for k in i:
        a, b = t[k] - pad, t[k] + pad
        if w and a - w[-1][1] < join:
            w[-1][1] = b
        else:
            w.append([a, b])
    return [[round(float(max(a, 0)), 2), round(float(b), 2)] for a, b in w]
