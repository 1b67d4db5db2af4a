"""platform in plan under two components"""
import numpy as np
from lib import Case, gm
from kern import mdof
from frame import TAIL

POS = [(-8.0, -5.0), (8.0, -5.0), (8.0, 5.0), (-8.0, 5.0)]
M, J = 420000.0, 1.25e7


def plan():
    s = ['# Deck on four isolators, two components', '# units: N, m, kg, s', 'wipe', 'model basic -ndm 2 -ndf 3', 'pset Kd 520000.0', 'pset Qd 45000.0',
         'node 100 0.0 0.0', f'mass 100 {M} {M} {J}', 'set ki [expr $Kd/0.1]', 'set uy [expr $Qd/((1.0-0.1)*$ki)]']
    for i, (x, y) in enumerate(POS):
        a, b = i + 1, i + 11
        s += [f'node {a} {x} {y}', f'node {b} {x} {y}', f'fix {a} 1 1 1', f'rigidLink beam 100 {b}']
        for d in (1, 2):
            s += [f'uniaxialMaterial BoucWen {10 * a + d} 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0']
        s += [f'element zeroLength {a} {a} {b} -mat {10 * a + 1} {10 * a + 2} -dir 1 2']
    s += ['timeSeries Path 1 -dt $dt -filePath $motionx', 'timeSeries Path 2 -dt $dt -filePath $motiony', 'pattern UniformExcitation 1 1 -accel 1',
          'pattern UniformExcitation 2 2 -accel 2', 'recorder Node -file xdisp.out -time -node 11 14 -dof 1 disp', 'recorder Node -file ydisp.out -time -node 11 12 -dof 2 disp',
          'recorder Node -file xacc.out -timeSeries 1 -time -node 11 14 -dof 1 accel', 'recorder Node -file yacc.out -timeSeries 2 -time -node 11 12 -dof 2 accel']
    tcl = '\n'.join(s) + TAIL % '1.0e-8'
    dt, n = 0.01, 2001

    def ev(name, role, rx, ry, sx, sy, t0=0.0):
        f = lambda a: np.array([float(f'{v:.8g}') for v in a])
        ax, ay = f(gm(rx, dt, n, sx, t0=t0)), f(gm(ry, dt, n, sy, t0=t0))
        return dict(name=name, role=role, ax=ax, ay=ay, files={f'{name}-x.dat': ax, f'{name}-y.dat': ay},
                    set=dict(motionx=f'{name}-x.dat', motiony=f'{name}-y.dat', dt=dt, npts=n, nsub=2))
    runs = [ev('quake-1', 'fit', 'imperial_valley_1979_meloland_ff_270', 'imperial_valley_1979_meloland_ff_360', 0.8, 0.45, 2),
            ev('quake-2', 'holdout', 'elcentro_1940_180', 'northridge_1994_arleta_360', 0.8, 0.7, 1)]
    obs = [('south_disp', 'm', 'xdisp.out', 1, 'south edge'), ('north_disp', 'm', 'xdisp.out', 2, 'north edge'), ('west_disp', 'm', 'ydisp.out', 1, 'west edge'),
           ('east_disp', 'm', 'ydisp.out', 2, 'east edge'), ('south_acc', 'm/s2', 'xacc.out', 1, 'south edge'), ('north_acc', 'm/s2', 'xacc.out', 2, 'north edge'),
           ('east_acc', 'm/s2', 'yacc.out', 2, 'east edge')]

    def sim(p, r, eff=()):
        ex, ey = (0.9, 1.3) if 'torsion' in eff else (0.0, 0.0)
        ki = p['Kd'] / 0.1
        uy = p['Qd'] / (0.9 * ki)
        B, P = [], []
        for x, y in POS:
            x, y = x - ex, y - ey
            B += [[1, 0, -y], [0, 1, x]]
            P += [[0.1, ki, uy, 1.0 if 'bidirectional_coupling' in eff else 0.0, 0, 0]] * 2
        ag = np.column_stack([r['ax'], r['ay']])
        Z = np.zeros((3, 3))
        U, V, A = mdof(np.diag([1 / M, 1 / M, 1 / J]), Z, Z, np.array(B, float), np.full(8, 6), np.array(P, float), np.array([[1.0, 0], [0, 1], [0, 0]]), ag,
                       np.zeros((n, 3)), dt, 4)
        at = lambda Q, i, d: Q[:, 0] - Q[:, 2] * (POS[i][1] - ey) if d == 0 else Q[:, 1] + Q[:, 2] * (POS[i][0] - ex)
        return dict(south_disp=at(U, 0, 0), north_disp=at(U, 3, 0), west_disp=at(U, 0, 1), east_disp=at(U, 1, 1), south_acc=at(A, 0, 0) + r['ax'],
                    north_acc=at(A, 3, 0) + r['ax'], east_acc=at(A, 1, 1) + r['ay'])
    P0 = dict(Kd=(560000.0, 250000, 1000000), Qd=(41000.0, 15000, 90000))
    c = Case(title='deck on four isolators, two components', tcl=tcl, params=P0, runs=runs, observe=obs, cause='torsion', also=['bidirectional_coupling'],
             effects=['bidirectional_coupling', 'torsion'], noise={o[0]: (0.03, 'ar0.6') for o in obs}, confusable=['friction', 'sensor_gain'],
             note='the isolators share one yield surface between x and y (Park-Wen-Ang) and the mass centre lies 0.9/1.3 m off the plan centre')
    c.base = sim
    c.truth = lambda r, eff: sim({k: v[0] for k, v in P0.items()}, r, eff)
    return c


def pier_soil():
    """pier of three beam elements (rotations condensed), deck on a bearing; truth: rocking and swaying foundation with radiation dashpots"""
    L, EI, m = 3.0, 8.5e6, [52.0, 52.0, 90.0]
    s = ['# Bridge pier with isolated deck', '# units: kN, m, t, s', 'wipe', 'model basic -ndm 2 -ndf 3', 'pset Kd 4000.0', 'pset Qd 400.0',
         'pset rE 1.0     ;# flexural rigidity / drawing value'] + [f'node {i + 1} 0.0 {L * i}' for i in range(4)] + ['node 20 0.0 9.0', 'fix 1 1 1 1', 'fix 20 0 1 1']
    s += [f'mass {i + 2} {x} {x} 0.0' for i, x in enumerate(m)] + ['mass 20 560.0 560.0 0.0', 'geomTransf Linear 1']
    s += [f'element elasticBeamColumn {i} {i} {i + 1} 2.6 [expr $rE*2.833333333e7] 0.3 1' for i in (1, 2, 3)] + ['rayleigh 0.5 0.0 0.0015 0.0']
    s += ['set ki [expr $Kd/0.08]', 'set uy [expr $Qd/((1.0-0.08)*$ki)]', 'uniaxialMaterial BoucWen 1 0.08 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0',
          'element zeroLength 20 4 20 -mat 1 -dir 1', 'timeSeries Path 1 -dt $dt -filePath $motion', 'pattern UniformExcitation 1 1 -accel 1',
          'recorder Node -file disp.out -time -node 2 4 20 -dof 1 disp', 'recorder Node -file acc.out -timeSeries 1 -time -node 2 4 20 -dof 1 accel']
    tcl = '\n'.join(s) + TAIL % '1.0e-8'
    from frame import event
    runs = [event('quake-1', 'fit', 'northridge_1994_castaic_090', 0.01, 2201, 0.8, nsub=8), event('quake-2', 'fit', 'elcentro_1940_180', 0.01, 2001, 0.7, nsub=8),
            event('quake-3', 'holdout', 'kobe_1995_nishi_akashi_090', 0.01, 2001, 0.6, t0=2, nsub=8)]
    obs = [('mid_disp', 'm', 'disp.out', 1, 'pier at 3 m'), ('pier_disp', 'm', 'disp.out', 2, 'pier head'), ('pier_acc', 'm/s2', 'acc.out', 2, 'pier head'),
           ('deck_acc', 'm/s2', 'acc.out', 3, 'deck')]

    def sim(p, r, eff=()):
        e = p['rE'] * EI
        K = np.zeros((8, 8))           # u0 t0 u1 t1 u2 t2 u3 t3
        # horizontal u to the right, rotation theta such that du/dy = theta
        k = e / L ** 3 * np.array([[12, 6 * L, -12, 6 * L], [6 * L, 4 * L * L, -6 * L, 2 * L * L], [-12, -6 * L, 12, -6 * L], [6 * L, 2 * L * L, -6 * L, 4 * L * L]])
        for i in range(3):
            K[2 * i:2 * i + 4, 2 * i:2 * i + 4] += k
        keep, out = [2, 4, 6, 0, 1], [3, 5, 7]
        Kc = K[np.ix_(keep, keep)] - K[np.ix_(keep, out)] @ np.linalg.solve(K[np.ix_(out, out)], K[np.ix_(out, keep)])
        soil = bool(eff)
        nd = 5 if soil else 3
        N = nd + 1
        KK, CC = np.zeros((N, N)), np.zeros((N, N))
        KK[:nd, :nd] = Kc[:nd, :nd]
        CC[:nd, :nd] = 0.0015 * Kc[:nd, :nd]
        mm = np.array(m + ([180.0, 900.0] if soil else []) + [560.0])
        CC += np.diag(0.5 * mm)
        rr = np.ones((N, 1))
        if soil:
            KK[3, 3] += 9.0e5
            CC[3, 3] += 6.0e3
            KK[4, 4] += 1.0e7
            CC[4, 4] += 3.0e4
            rr[4] = 0.0
        ki = p['Kd'] / 0.08
        B = np.zeros((1, N))
        B[0, 2], B[0, N - 1] = -1, 1
        ag = r['ag'].reshape(-1, 1)
        U, V, A = mdof(np.diag(1 / mm), CC, KK, B, np.array([0]), np.array([[0.08, ki, p['Qd'] / (0.92 * ki), 1.0, 0, 0]]), rr, ag, np.zeros((ag.size, N)), 0.01, 16)
        return dict(mid_disp=U[:, 0], pier_disp=U[:, 2], pier_acc=A[:, 2] + r['ag'], deck_acc=A[:, N - 1] + r['ag'])
    P0 = dict(Kd=(4300.0, 1800, 9000), Qd=(380.0, 150, 800), rE=(0.95, 0.3, 1.6))
    c = Case(title='bridge pier with isolated deck', tcl=tcl, params=P0, runs=runs, observe=obs, cause='foundation_flexibility', effects=['foundation_flexibility'],
             noise={o[0]: (0.03, 'ar0.6') for o in obs}, at='pier foot', confusable=['superstructure_yielding', 'damping'],
             note='the footing sways and rocks on springs with radiation dashpots and its own mass; the model is clamped')
    c.base = sim
    c.truth = lambda r, eff: sim({k: v[0] for k, v in P0.items()}, r, eff)
    return c


ALL = dict(plan=plan, pier_soil=pier_soil)
