"""shear chains (isolated or on a fixed base): Tcl text and own matrices"""
import numpy as np
from lib import Case, gm
from kern import mdof

TAIL = """
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr %s 40
algorithm Newton
integrator Newmark 0.5 0.25
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


def chain_tcl(head, units, psets, m, k, c, base, kmul, cmul=None, tol='1.0e-8', rb=0.1):
    """base: 'bw' (Kd, Qd), 'lin' (Kd, cb) or None; kmul: name of the storeys' factor(s)"""
    s = [f'# {head}', f'# units: {units}', 'wipe', 'model basic -ndm 1 -ndf 1', '']
    s += [f'pset {a} {b}' for a, b in psets.items()]
    s += ['node 1 0.0', 'fix 1 1'] + [f'node {i + 2} 0.0 -mass {x}' for i, x in enumerate(m)] + ['']
    if base == 'bw':
        s += ['# isolation layer', f'set ki [expr $Kd/{rb}]', f'set uy [expr $Qd/((1.0-{rb})*$ki)]',
              f'uniaxialMaterial BoucWen 1 {rb} $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0', 'element zeroLength 1 1 2 -mat 1 -dir 1', '']
    if base == 'lin':
        s += ['# isolation layer', 'uniaxialMaterial Elastic 1 $Kd', 'uniaxialMaterial Viscous 2 $cb 1.0',
              'element zeroLength 1 1 2 -mat 1 2 -dir 1 1', '']
    s += ['# storeys']
    n0 = 2 if base else 1
    for i, (a, b) in enumerate(zip(k, c)):
        f = kmul if isinstance(kmul, str) or kmul is None else kmul[i]
        ks = f'[expr ${f}*{a}]' if f else f'{a}'
        cs = f'[expr ${cmul}*{b}]' if cmul else f'{b}'
        s += [f'uniaxialMaterial Elastic {11 + i} {ks}', f'uniaxialMaterial Viscous {21 + i} {cs} 1.0',
              f'element zeroLength {11 + i} {n0 + i} {n0 + i + 1} -mat {11 + i} {21 + i} -dir 1 1']
    nodes = ' '.join(str(i + 2) for i in range(len(m)))
    s += ['', 'timeSeries Path 1 -dt $dt -filePath $motion', 'pattern UniformExcitation 1 1 -accel 1', '',
          f'recorder Node -file disp.out -time -node {nodes} -dof 1 disp',
          f'recorder Node -file acc.out -timeSeries 1 -time -node {nodes} -dof 1 accel']
    return '\n'.join(s) + TAIL % tol


def spring(n, i, j, x, M):
    """adds x between dofs i and j (-1: ground)"""
    if i >= 0:
        M[i, i] += x
    M[j, j] += x
    if i >= 0:
        M[i, j] -= x
        M[j, i] -= x


def row(n, i, j):
    b = np.zeros(n)
    b[j] = 1.0
    if i >= 0:
        b[i] = -1.0
    return b


class Chain:
    """own model; extra(p, eff) may add masses, springs, links"""

    def __init__(self, m, k, c, base, kmul, cmul=None, rb=0.1, sub=8, extra=None, force=None):
        self.__dict__.update(locals())

    def __call__(self, p, r, eff=()):
        n = len(self.m)
        m = list(self.m)
        links = []
        ks = [x * (p[f] if f else 1.0) for x, f in zip(self.k, [self.kmul] * n if isinstance(self.kmul, str) or self.kmul is None else self.kmul)]
        cs = [x * (p[self.cmul] if self.cmul else 1.0) for x in self.c]
        ex = self.extra(self, p, eff) if (self.extra and eff) else {}
        m += ex.get('m', [])
        N = len(m)
        K = np.zeros((N, N))
        C = np.zeros((N, N))
        o = 1 if self.base else 0
        for i in range(len(ks)):
            a, b = i + o - 1, i + o
            if i not in ex.get('drop', ()):
                spring(N, a, b, ks[i], K)
            spring(N, a, b, cs[i], C)
        if self.base == 'bw':
            ki = p['Kd'] / self.rb
            links.append((0, [self.rb, ki, p['Qd'] / ((1 - self.rb) * ki), 1.0], -1, 0))
        if self.base == 'lin':
            spring(N, -1, 0, p['Kd'], K)
            spring(N, -1, 0, p['cb'], C)
        for i, j, kk, cc in ex.get('springs', []):
            spring(N, i, j, kk, K)
            spring(N, i, j, cc, C)
        links += ex.get('links', [])
        B = np.array([row(N, i, j) for _, _, i, j in links]).reshape(len(links), N)
        P = np.zeros((len(links), 6))
        for q, (code, pp, i, j) in enumerate(links):
            P[q, :len(pp)] = pp
        code = np.array([l[0] for l in links], np.int64)
        dt = r['set']['dt']
        ag = r['ag'].reshape(-1, 1)
        fe = np.zeros((ag.size, N))
        if self.force and eff:
            self.force(self, r, eff, fe)
        U, V, A = mdof(np.diag(1.0 / np.array(m)), C, K, B, code, P, np.ones((N, 1)), ag, fe, dt, self.sub)
        return U[:, :n], A[:, :n] + ag


def event(name, role, rec, dt, npts, scale, g=9.80665, t0=0.0, nsub=4, every=None):
    a = gm(rec, dt, npts, scale, g, t0)
    a = np.array([float(f'{x:.8g}') for x in a])
    r = dict(name=name, role=role, ag=a, files={f'{name}.dat': a}, set=dict(motion=f'{name}.dat', dt=dt, npts=npts, nsub=nsub))
    if every:
        r['every'] = every
    return r


def chaincase(title, tcl, params, runs, observe, model, pick, sensor=None, **k):
    """pick(U, Aabs) -> channels; sensor(y, r, eff) may spoil them"""
    c = Case(title=title, tcl=tcl, params=params, runs=runs, observe=observe, **k)
    c.base = lambda p, r: pick(*model(p, r))

    def truth(r, eff):
        y = pick(*model({a: b[0] for a, b in params.items()}, r, eff))
        return sensor(y, r, eff) if sensor and eff else y
    c.truth = truth
    return c
