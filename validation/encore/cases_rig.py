"""single devices on rigs: imposed motion, recorded force"""
import numpy as np
from numba import njit
from lib import Case, cycles, multisine, chirp, gm, ramp, merge_windows
from kern import bw_z, maxwell_power

STEP = """for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1%s]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1%s]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
"""


def static_tcl(head, units, psets, mats, final=1, extra='', penalty=None):
    con, sysm = (f'Penalty {penalty} {penalty}', 'ProfileSPD') if penalty else ('Transformation', 'UmfPack')
    return f"""# {head}
# units: {units}
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1
{extra}
""" + ''.join(f'pset {k} {v}\n' for k, v in psets.items()) + f"""
{mats}
element zeroLength 1 1 2 -mat {final} -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {{
    sp 2 1 1.0
}}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

constraints {con}
numberer Plain
system {sysm}
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl $dt
analysis Static
""" + STEP % ('', '')


def bw_mat(n=1.0, tag=1):
    return f"""set uy [expr $Qd/((1.0-$alpha)*$ko)]
uniaxialMaterial BoucWen {tag} $alpha $ko {n} [expr 0.5/pow($uy,{n})] [expr 0.5/pow($uy,{n})] 1.0 0.0 0.0 0.0
"""


def pad_tcl(head, units, psets, H, axial, mass, ka, kr):
    return f"""# {head}
# units: {units}
wipe
model basic -ndm 2 -ndf 3

""" + ''.join(f'pset {k} {v}\n' for k, v in psets.items()) + f"""
set H {H}
if {{![info exists axial]}} {{set axial {axial}}}
node 1 0.0 0.0
node 2 0.0 $H
fix 1 1 1 1
fix 2 0 0 1
mass 2 {mass} {mass} {mass}

uniaxialMaterial Elastic 1 {ka}
uniaxialMaterial Elastic 2 {kr}
element elastomericBearingBoucWen 1 1 2 $kInit $Fy $alpha 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0

# vertical load first
timeSeries Linear 1
pattern Plain 1 1 {{
    load 2 0.0 [expr -$axial] 0.0
}}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis

# actuator
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {{
    sp 2 1 1.0
}}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator Newmark 0.6 0.3025
analysis Transient
""" + STEP % (' $dt', ' $dt')


def run(name, role, u, dt, **k):
    r = dict(name=name, role=role, u=np.asarray(u), files={f'{name}.dat': u},
             set=dict(motion=f'{name}.dat', dt=dt, npts=len(u)))
    ev = k.pop('every', None)
    if ev:
        r['every'] = ev
    r['x'] = k.pop('x', {})
    r['set'].update(k)
    return r


def bw(p, u, n=1.0):
    uy = p['Qd'] / ((1 - p['alpha']) * p['ko'])
    return p['alpha'] * p['ko'] * u, p['Qd'] * bw_z(u, np.full(u.size, uy), n)


def bwpad(p, u):
    uy = p["Fy"] / p["kInit"] / (1 - p["alpha"])
    return p["alpha"] * p["kInit"] * u, p["Fy"] * bw_z(u, np.full(u.size, uy), 1.0)


def under(c):
    return {k: v[0] for k, v in c.params.items()}


F = lambda unit, col=2, at='upper plate': [('force', unit, 'force.out', col, at)]


def rigcase(title, tcl, params, runs, observe, basef, truef, **k):
    c = Case(title=title, tcl=tcl, params=params, runs=runs, observe=observe, **k)
    c.base = lambda p, r: {'force': basef(p, r)}
    c.truth = lambda r, eff: {'force': truef(under(c), r, eff)}
    return c


# ------------------------------------------------------------------ nothing missing
def quiet_damper():
    rng = np.random.default_rng(501)
    dt = 0.005
    tcl = """# Fluid damper in the rig
# units: kN, mm, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
mass 2 0.01
fix 1 1
pset C 18.0
pset a 0.6
pset K 40.0
uniaxialMaterial ViscousDamper 1 $K $C $a
element zeroLength 1 1 2 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force

constraints Penalty 1.0e8 1.0e8
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-8 50
algorithm Newton
integrator Newmark 0.6 0.3025
analysis Transient
""" + STEP % (' $dt', ' $dt')
    runs = [run('half-hertz', 'fit', cycles(0.5, [20, 40, 60], dt, 2), dt),
            run('one-hertz', 'fit', cycles(1.0, [15, 30, 45], dt, 3), dt),
            run('random', 'holdout', multisine(rng, 0.15, 1.6, 55, dt, 3201), dt)]
    f = lambda p, r: maxwell_power(r['u'], dt, p['K'], p['C'], p['a'])
    return rigcase('fluid damper, production test', tcl, dict(C=(15.2, 8, 30), a=(0.48, 0.3, 1.0), K=(55.0, 20, 120)), runs,
                   F('kN', 2, 'damper'), f, lambda p, r, e: f(p, r), cause='none', effects=[],
                   noise={'force': (0.022, 'ar0.85', 0.2)}, every=2, hetero=lambda x: 0.6 + 1.2 * np.abs(x) / np.abs(x).max(),
                   note='non-linear Maxwell damper exactly as modelled; load-cell noise that is larger at large force, short-memory coloured, coarse quantum')


def quiet_pad():
    rng = np.random.default_rng(502)
    dt = 0.01
    tcl = pad_tcl('Laminated pad, three protocols', 'kip, in, s', dict(kInit=14.0, Fy=7.0, alpha=0.2), 8.0, 60.0, 2e-4, 2500.0, 1.0e6)
    runs = [run('steady', 'fit', cycles(0.25, [2.0, 4.0], dt, 3), dt, axial=60.0),
            run('mixed', 'fit', cycles(0.4, [1.0, 5.0, 3.0], dt, 3), dt, axial=60.0),
            run('random', 'holdout', multisine(rng, 0.1, 1.0, 6.0, dt, 2601), dt, axial=60.0)]
    f = lambda p, r: sum(bwpad(p, r['u']))
    return rigcase('laminated pad, three protocols', tcl, dict(kInit=(15.5, 7, 30), Fy=(6.2, 3, 12), alpha=(0.17, 0.08, 0.35)), runs,
                   F('kip', 4), f, lambda p, r, e: f(p, r), cause='none', effects=[], noise={'force': (0.04, 'pink1.2', 0.05)},
                   note='Bouc-Wen pad exactly as modelled; strong 1/f noise of the bridge amplifier with a coarse quantum')


# ------------------------------------------------------------------ a heavy upper fixture
def fixture():
    rng = np.random.default_rng(503)
    dt = 0.0025
    tcl = static_tcl('Pad on the fast rig', 'N, m, s', dict(ko=1800000.0, Qd=9000.0, alpha=0.3), bw_mat())
    runs = [run('up', 'fit', chirp(0.3, 4.0, 0.035, 0.012, dt, 4801), dt),
            run('steps', 'fit', np.concatenate([cycles(0.5, [0.03], dt, 3)[:-1], cycles(3.0, [0.012], dt, 14)]), dt),
            run('random', 'holdout', multisine(rng, 0.3, 3.5, 0.03, dt, 4401, power=0.8), dt)]

    def true(p, r, e):
        f = sum(bw(p, r['u']))
        if 'inertia' in e:
            a = np.gradient(np.gradient(r['u'], dt), dt)
            f = f + 640.0 * a
        return f
    return rigcase('pad on the fast rig', tcl, dict(ko=(2000000.0, 900000, 4000000), Qd=(8000.0, 3000, 18000), alpha=(0.28, 0.1, 0.6)), runs,
                   F('N'), lambda p, r: sum(bw(p, r['u'])), true, cause='unknown', effects=['inertia'],
                   noise={'force': (0.025, 'ar0.6')}, every=2.4, confusable=['rate_dependence', 'sensor_lag'],
                   note='640 kg of fixture between load cell and pad: the recorded force contains its inertia')


# ------------------------------------------------------------------ listed causes
@njit(cache=True)
def _degrade(u, k, qd, alpha, n, Et, c, floor, nsub):
    """Rahnama-Krawinkler: after each excursion strength and stiffness fall by beta = (E_i / (E_t - sum E))^c"""
    N = u.size
    F = np.zeros(N)
    z = 0.0
    S = 1.0
    Ei = 0.0
    Es = 0.0
    f0 = 0.0
    for i in range(1, N):
        du = (u[i] - u[i - 1]) / nsub
        for s in range(nsub):
            uy = qd / ((1 - alpha) * k) * S ** 0.4     # stiffness falls as S^0.6
            g = abs(z) ** n if z * du > 0 else 0.0
            zm = z + 0.5 * du / uy * (1 - g)
            g = abs(zm) ** n if zm * du > 0 else 0.0
            z += du / uy * (1 - g)
            f1 = S * qd * z
            Ei += 0.5 * (f0 + f1) * du
            if f0 * f1 < 0:
                b = (max(Ei, 0.0) / max(Et - Es, 0.05 * Et)) ** c
                Es += max(Ei, 0.0)
                Ei = 0.0
                S = floor + (S - floor) * (1 - min(b, 0.6))
                f1 = S * qd * z
            f0 = f1
        F[i] = alpha * k * u[i] * S ** 0.5 + f1
    return F


def wall_degrade():
    dt = 0.02
    rng = np.random.default_rng(504)
    tcl = static_tcl('Shear panel, quasi-static', 'kN, mm, s', dict(ko=30.0, Qd=150.0, alpha=0.06), bw_mat(2.0), penalty='1.0e8')
    runs = [run('protocol', 'fit', cycles(0.2, [4, 8, 14, 20, 26], dt, 2), dt),
            run('constant', 'fit', cycles(0.25, [16], dt, 10), dt),
            run('history', 'holdout', multisine(rng, 0.06, 0.4, 24, dt, 2401), dt)]

    def true(p, r, e):
        if 'cyclic_degradation' in e:
            return _degrade(r['u'], p['ko'], p['Qd'], p['alpha'], 2.0, 160000.0, 1.0, 0.25, 6)
        return sum(bw(p, r['u'], 2.0))
    return rigcase('shear panel, three specimens', tcl, dict(ko=(34.0, 10, 60), Qd=(165.0, 60, 260), alpha=(0.05, 0.0, 0.25)), runs,
                   F('kN', 2, 'panel top'), lambda p, r: sum(bw(p, r['u'], 2.0)), true, cause='cyclic_degradation',
                   effects=['cyclic_degradation'], noise={'force': (0.018, 'ar0.7')}, every=1,
                   confusable=['mullins_softening', 'self_heating'],
                   note='Rahnama-Krawinkler energy deterioration of strength and stiffness, excursion by excursion; each run has a new specimen')


def pendulum_axial():
    dt = 0.005
    rng = np.random.default_rng(505)
    tcl = static_tcl('Curved slider under the shear rig', 'kN, m, s', dict(mu=0.07, R=1.5),
                     """set W 900.0
set kr [expr $W/$R]
set qd [expr $mu*$W]
set uy 0.002
set ko [expr $kr+$qd/$uy]
set al [expr $kr/$ko]
uniaxialMaterial BoucWen 1 $al $ko 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
""")

    def nfun(kind, n):
        t = np.arange(n) * dt
        if kind == 0:
            return 900 * (1 + 0.2 * ramp(t, 2) * np.sin(2 * np.pi * 0.31 * t + 0.4))
        if kind == 1:
            return 900 * (1 + 0.15 * ramp(t, 2) * np.sin(2 * np.pi * 1.1 * t) + 0.07 * np.sin(2 * np.pi * 0.17 * t) * ramp(t, 2))
        a = gm('kobe_1995_nishi_akashi_090', dt, n, 0.55, 1.0, 2.0)
        return 900 * (1 + np.convolve(a, np.ones(6) / 6, 'same')) + 110 * np.sin(2 * np.pi * 0.4 * t) * ramp(t, 2)
    runs = [run('slow', 'fit', cycles(0.25, [0.06, 0.1], dt, 2), dt, x=dict(N=0)),
            run('medium', 'fit', cycles(0.4, [0.05, 0.12], dt, 3), dt, x=dict(N=1)),
            run('quake', 'holdout', multisine(rng, 0.12, 0.9, 0.11, dt, 3001), dt, x=dict(N=2))]
    z = lambda u: bw_z(u, np.full(u.size, 0.002), 1.0)
    base = lambda p, r: 900 / p['R'] * r['u'] + p['mu'] * 900 * z(r['u'])

    def true(p, r, e):
        if 'varying_axial_load' not in e:
            return base(p, r)
        N = nfun(r['x']['N'], r['u'].size)
        mu = p['mu'] * (N / 900) ** -0.15
        return N / p['R'] * r['u'] + mu * N * z(r['u'])

    def ctx(r, t, rng):
        N = nfun(r['x']['N'], r['u'].size)
        x = np.interp(t, np.arange(N.size) * dt, N)
        return [('axial', 'kN', 0.1, np.round(x + 9 * rng.standard_normal(t.size), 1))]
    return rigcase('curved slider, shear rig', tcl, dict(mu=(0.062, 0.03, 0.12), R=(1.6, 0.9, 3.0)), runs, F('kN', 2, 'slider'), base, true,
                   cause='varying_axial_load', effects=['varying_axial_load'], noise={'force': (0.02, 'ar0.8')}, every=2, context=ctx,
                   confusable=['friction', 'axial_shear_interaction'],
                   note='the vertical actuators let the axial force swing; friction and restoring force follow it, friction coefficient ~ N^-0.15')


@njit(cache=True)
def _cav(u, kt, Fc, h, r, m):
    """pseudo-elastic (Dorfmann-Ogden tanh) damage of a saturating tension branch"""
    out = np.zeros(u.size)
    Wm = 0.0
    uc = Fc / kt
    for i in range(u.size):
        x = u[i]
        if x <= 0:
            continue
        # smooth knee between kt and h*kt
        k2 = h * kt
        q = ((kt - k2) * x / Fc) ** 4
        f = k2 * x + (kt - k2) * x / (1 + q) ** 0.25
        W = k2 * x * x / 2 + 0.5 * (kt - k2) * x * x / (1 + 0.6 * np.sqrt(q)) ** 0.5
        if W > Wm:
            Wm = W
        over = max(0.0, Wm - 0.5 * Fc * uc)
        eta = 1.0 - np.tanh((Wm - W) / (m * Fc * uc)) / r * over / (over + 0.5 * Fc * uc)
        out[i] = eta * f
    return out


def tension():
    dt = 0.02
    rng = np.random.default_rng(506)
    tcl = static_tcl('Vertical test of an isolator', 'kN, mm, s', dict(kc=500.0, kt=120.0, Qd=12.0),
                     """uniaxialMaterial Elastic 11 $kt 0.0 $kc
set uy 0.3
set ko [expr $Qd/$uy]
uniaxialMaterial BoucWen 12 0.0 $ko 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
uniaxialMaterial Parallel 1 11 12
""", penalty='1.0e9')
    t = np.arange(3001) * dt
    grow = 0.3 + np.interp(t, [0, 60], [0.4, 5.0]) * np.sin(2 * np.pi * 0.15 * t)
    u1 = ramp(t, 3) * np.where(grow < 0, 0.45 * grow, grow)
    t2 = np.arange(2001) * dt
    s2 = np.where(t2 < 20, 1.6, 3.6) * np.sin(2 * np.pi * 0.2 * t2)
    u2 = ramp(t2, 3) * np.where(s2 < 0, 0.5 * s2, s2)
    s3 = multisine(rng, 0.05, 0.35, 5.0, dt, 2401)
    u3 = np.where(s3 < 0, 0.4 * s3, s3)
    runs = [run('growing', 'fit', u1, dt), run('blocks', 'fit', u2, dt), run('irregular', 'holdout', u3, dt)]
    hyst = lambda p, u: p['Qd'] * bw_z(u, np.full(u.size, 0.3), 1.0)
    base = lambda p, r: np.where(r['u'] > 0, p['kt'], p['kc']) * r['u'] + hyst(p, r['u'])

    def true(p, r, e):
        if 'cavitation' not in e:
            return base(p, r)
        u = r['u']
        return np.where(u < 0, p['kc'] * u, 0.0) + _cav(u, p['kt'], 170.0, 0.06, 1.6, 1.4) + hyst(p, u)
    return rigcase('vertical test of an isolator', tcl, dict(kc=(430.0, 200, 900), kt=(150.0, 30, 260), Qd=(14.0, 2, 40)), runs,
                   F('kN', 2, 'end plate'), base, true, cause='cavitation', effects=['cavitation'], noise={'force': (0.02, 'ar0.5')}, every=1.2,
                   confusable=['cyclic_degradation', 'mullins_softening'],
                   windows=lambda r: merge_windows(np.arange(r['u'].size) * dt, r['u'] > 170 / 150.0, 0.3, 0.05),
                   note='tensile cavitation at 170 kN: saturating branch, pseudo-elastic tanh damage on unloading and reloading')


@njit(cache=True)
def _sliplock(u, k, qd, alpha, s0, rate, sig, nsub):
    """Baber-Noori slip-lock in series with a Bouc-Wen element; slip grows with the energy"""
    N = u.size
    F = np.zeros(N)
    z = 0.0
    E = 0.0
    uy = qd / ((1 - alpha) * k)
    for i in range(1, N):
        du = (u[i] - u[i - 1]) / nsub
        for s in range(nsub):
            a = s0 * (1 - np.exp(-rate * E))
            h = 2 * a * np.exp(-0.5 * (z / sig) ** 2) / (sig * 2.5066)
            g = 1 - (abs(z) if z * du > 0 else 0.0)
            dz = du / uy * g / (1 + h * g / uy)
            zm = z + 0.5 * dz
            h = 2 * a * np.exp(-0.5 * (zm / sig) ** 2) / (sig * 2.5066)
            g = 1 - (abs(zm) if zm * du > 0 else 0.0)
            dz = du / uy * g / (1 + h * g / uy)
            E += abs(qd * (z + 0.5 * dz) * du)
            z += dz
        F[i] = alpha * k * u[i] + qd * z
    return F


def panel_pinch():
    dt = 0.02
    rng = np.random.default_rng(507)
    tcl = static_tcl('Timber wall panel', 'kN, mm, s', dict(ko=3.0, Qd=25.0, alpha=0.1), bw_mat())
    runs = [run('cyclic-a', 'fit', cycles(0.15, [10, 20, 35, 50], dt, 2), dt),
            run('cyclic-b', 'fit', cycles(0.2, [40, 25], dt, 3), dt),
            run('irregular', 'holdout', multisine(rng, 0.05, 0.3, 48, dt, 2501), dt)]

    def true(p, r, e):
        if 'pinching' in e:
            return _sliplock(r['u'], p['ko'], p['Qd'], p['alpha'], 17.0, 1 / 1200.0, 0.22, 8)
        return sum(bw(p, r['u']))
    return rigcase('timber wall panel', tcl, dict(ko=(3.4, 1, 8), Qd=(27.0, 8, 50), alpha=(0.12, 0.02, 0.45)), runs, F('kN', 2, 'panel top'),
                   lambda p, r: sum(bw(p, r['u'])), true, cause='pinching', effects=['pinching'], noise={'force': (0.025, 'pink0.8')},
                   confusable=['cyclic_degradation', 'gap_impact'],
                   note='Baber-Noori slip-lock element in series with the Bouc-Wen hysteresis; the slip length grows with dissipated energy')


@njit(cache=True)
def _lead(u, dt, k, qd, alpha, Tr, E2, rad, hl, rhoc, kst, tst, ns, J):
    """lead core heated by its own work; radial conduction into the shims (finite differences), J: heat unit of work"""
    N = u.size
    F = np.zeros(N)
    T = np.zeros(N)
    uy = qd / ((1 - alpha) * k)
    nr = 24
    dr = 3.0 * rad / nr
    th = np.zeros(nr)
    TL = 0.0
    z = 0.0
    frac = ns * tst / hl
    for i in range(1, N):
        du = (u[i] - u[i - 1]) / 4
        q = qd * np.exp(-E2 * TL)
        w = 0.0
        for s in range(4):
            g = 1 - (abs(z) if z * du > 0 else 0.0)
            zm = z + 0.5 * du / uy * g
            g = 1 - (abs(zm) if zm * du > 0 else 0.0)
            z += du / uy * g
            w += abs(q * z * du)
        flux = kst * (TL - th[0]) / (0.5 * dr)                     # into the shims, per area
        cap = rhoc * np.pi * rad ** 2 * hl
        TL += (w / J - flux * 2 * np.pi * rad * hl * frac * dt) / cap
        new = th.copy()
        for m in range(nr):
            r0 = rad + m * dr
            r1 = r0 + dr
            qi = flux * r0 if m == 0 else kst * (th[m - 1] - th[m]) / dr * r0
            qo = kst * (th[m] - th[m + 1]) / dr * r1 if m < nr - 1 else kst * th[m] / dr * r1
            new[m] = th[m] + dt * (qi - qo) / (rhoc * 2.4 * 0.5 * (r1 * r1 - r0 * r0))
        th = new
        T[i] = TL
        F[i] = alpha * k * u[i] + qd * np.exp(-E2 * TL) * z
    return F, T


def lead_heat():
    dt = 0.01
    rng = np.random.default_rng(508)
    tcl = static_tcl('Lead-rubber bearing, prototype test', 'kip, in, s', dict(ko=100.0, Qd=60.0, alpha=0.1), bw_mat())
    runs = [run('design', 'fit', cycles(0.4, [8.0], dt, 10), dt), run('slow', 'fit', cycles(0.05, [8.0], dt, 2), dt, every=2),
            run('random', 'holdout', multisine(rng, 0.12, 0.7, 9.0, dt, 3001), dt)]
    # lead core 4 in radius 2.1, height 9 in; rho c of lead 1.45e6 J/m3K = 0.2104 kip in/in3/K per ... (units: kip in)
    rc = 1.45e6 / 6894757.0      # kip in per in3 and K  (1 ksi = 6.895e6 J/m3)
    kst = 50.0 / 6894757.0 / 0.0254 ** 2    # W/mK to kip in/s / in K

    def lead(p, r):
        return _lead(r['u'], dt, p['ko'], p['Qd'], p['alpha'], 20.0, 0.0069, 3.4, 9.0, rc, kst, 0.12, 20, 1.0)

    def true(p, r, e):
        return lead(p, r)[0] if 'self_heating' in e else sum(bw(p, r['u']))
    return rigcase('lead-rubber bearing, prototype test', tcl, dict(ko=(95.0, 40, 200), Qd=(68.0, 25, 120), alpha=(0.09, 0.03, 0.25)), runs,
                   F('kip'), lambda p, r: sum(bw(p, r['u'])), true, cause='self_heating', effects=['self_heating'],
                   noise={'force': (0.018, 'ar0.8')}, every=1, confusable=['cyclic_degradation', 'rate_dependence', 'mullins_softening'],
                   note='Kalpakidis-Constantinou heating of the lead core, yield stress exp(-0.0069 T), radial conduction into the shims by finite differences; the core recovers in slow cycles')


@njit(cache=True)
def _gl(u, dt, a):
    """Gruenwald-Letnikov derivative of order a"""
    N = u.size
    w = np.empty(N)
    w[0] = 1.0
    for j in range(1, N):
        w[j] = w[j - 1] * (1 - (a + 1) / j)
    out = np.zeros(N)
    for i in range(N):
        s = 0.0
        for j in range(i + 1):
            s += w[j] * u[i - j]
        out[i] = s / dt ** a
    return out


def fractional():
    rng = np.random.default_rng(509)
    tcl = static_tcl('Rubber pad at three rates', 'N, m, s', dict(ko=900000.0, Qd=6000.0, alpha=0.35), bw_mat())
    runs = [run('creeping', 'fit', cycles(0.01, [0.03, 0.06], 0.1, 2), 0.1, every=2),
            run('brisk', 'fit', cycles(0.8, [0.03, 0.06], 0.005, 4), 0.005),
            run('moderate', 'holdout', multisine(rng, 0.03, 0.4, 0.05, 0.02, 3001), 0.02, every=2)]

    def true(p, r, e):
        f = sum(bw(p, r['u']))
        if 'rate_dependence' in e:
            f = f + 48000.0 * _gl(r['u'], r['set']['dt'], 0.3)
        return f
    return rigcase('rubber pad at three rates', tcl, dict(ko=(1000000.0, 400000, 2500000), Qd=(5500.0, 1500, 16000), alpha=(0.32, 0.15, 0.7)), runs,
                   F('N'), lambda p, r: sum(bw(p, r['u'])), true, cause='rate_dependence', effects=['rate_dependence'],
                   noise={'force': (0.02, 'ar0.7')}, confusable=['damping', 'mullins_softening', 'ambient_temperature'],
                   note='fractional (springpot, order 0.3) overstress in parallel, Gruenwald-Letnikov sum')


# ------------------------------------------------------------------ two at once
def virgin_late():
    dt = 0.01
    rng = np.random.default_rng(510)
    tcl = pad_tcl('Pad 21, new, first tests', 'N, m, s', dict(kInit=1500000.0, Fy=9000.0, alpha=0.3), 0.16, 120000.0, 40.0, '3.0e8', '1.0e8')
    runs = [run('first', 'fit', cycles(0.5, [0.03, 0.06, 0.1, 0.14], dt, 3), dt, axial=120000.0),
            run('other-pad', 'fit', cycles(0.7, [0.1, 0.05], dt, 4), dt, axial=120000.0),
            run('irregular', 'holdout', multisine(rng, 0.12, 1.0, 0.15, dt, 2601), dt, axial=120000.0)]

    def true(p, r, e):
        u = r['u']
        a, h = bwpad(p, u)
        if 'mullins_softening' in e:
            m = np.maximum.accumulate(np.abs(u))
            x = np.clip(1 - (np.abs(u) / np.maximum(m, 1e-9)) ** 2, 0, 1) * (m / 0.14) ** 0.8
            d = 1 - np.exp(-3.0 * x)                   # 0 on the virgin curve, saturating below it
            a = a * (1 + 0.26 * (m / 0.14) ** 0.3 * (1 - d))
        f = a + h
        if 'sensor_lag' in e:
            t = np.arange(u.size) * dt
            f = np.interp(t - 0.029, t, f)
        return f
    return rigcase('pad 21, first tests', tcl, dict(kInit=(1400000.0, 700000, 3500000), Fy=(9500.0, 3000, 20000), alpha=(0.3, 0.12, 0.6)), runs,
                   F('N', 4), lambda p, r: sum(bwpad(p, r['u'])), true, cause='mullins_softening', also=['sensor_lag'],
                   effects=['mullins_softening', 'sensor_lag'], noise={'force': (0.02, 'ar0.6')}, confusable=['cyclic_degradation', 'rate_dependence'],
                   note='virgin-curve excess on the elastic part that decays below the largest strain so far; the load cell amplifier is 29 ms late')


def stiff_fast():
    rng = np.random.default_rng(511)
    tcl = static_tcl('High damping pad, large strain', 'kN, mm, s', dict(ko=1.4, Qd=14.0, alpha=0.3), bw_mat())
    runs = [run('slow', 'fit', cycles(0.02, [40, 90, 130], 0.05, 2), 0.05, every=2.5),
            run('fast', 'fit', cycles(0.5, [50, 110], 0.005, 4), 0.005),
            run('history', 'holdout', multisine(rng, 0.08, 0.6, 125, 0.01, 3001), 0.01, every=2)]

    def true(p, r, e):
        u = r['u']
        f = sum(bw(p, u))
        if 'strain_stiffening' in e:
            x = np.abs(u) / 190.0       # limiting chain (Pade of the inverse Langevin function) minus its linear part
            f = f + 0.32 * u * ((3 - x ** 2) / (1 - x ** 2) / 3 - 1)
        if 'rate_dependence' in e:
            dt = r['set']['dt']
            for g, tau in ((0.055, 0.08), (0.06, 0.6), (0.05, 5.0)):
                q = np.zeros(u.size)
                b = np.exp(-dt / tau)
                c = tau / dt * (1 - b)
                for i in range(1, u.size):
                    q[i] = b * q[i - 1] + g * c * (u[i] - u[i - 1])
                f = f + q
        return f
    return rigcase('high damping pad, large strain', tcl, dict(ko=(1.5, 0.6, 4), Qd=(13.0, 4, 35), alpha=(0.28, 0.1, 0.6)), runs, F('kN'),
                   lambda p, r: sum(bw(p, r['u'])), true, cause='strain_stiffening', also=['rate_dependence'],
                   effects=['strain_stiffening', 'rate_dependence'], noise={'force': (0.018, 'ar0.7')}, confusable=['mullins_softening', 'friction'],
                   note='limiting-chain hardening and a three-term Prony overstress')


ALL = dict(quiet_damper=quiet_damper, quiet_pad=quiet_pad, fixture=fixture, wall_degrade=wall_degrade, pendulum_axial=pendulum_axial,
           tension=tension, panel_pinch=panel_pinch, lead_heat=lead_heat, fractional=fractional, virgin_late=virgin_late, stiff_fast=stiff_fast)
