"""buildings and bridges under recorded ground motions"""
import numpy as np
from lib import gm, ramp, merge_windows
from frame import Chain, chain_tcl, chaincase, event

AC = lambda ch, unit, col, at: (ch, unit, 'acc.out', col, at)
DI = lambda ch, unit, col, at: (ch, unit, 'disp.out', col, at)


def nz(obs, frac, kind, q=None):
    return {o[0]: ((frac, kind) if q is None else (frac, kind, q.get(o[0], -1))) for o in obs}


def quiet_house():
    m, k, c = [120.0, 95.0], [42000.0, 30000.0], [170.0, 120.0]
    tcl = chain_tcl('Two-storey school, fixed base', 'kN, m, t, s', dict(rk1=1.0, rk2=1.0, cs=1.0), m, k, c, None, ['rk1', 'rk2'], 'cs')
    runs = [event('shock', 'fit', 'northridge_1994_arleta_360', 0.01, 2001, 0.5, t0=2), event('after', 'fit', 'bigbear_1992_hospitality_180', 0.01, 2001, 0.8, t0=10),
            event('later', 'holdout', 'northridge_1994_castaic_090', 0.01, 2201, 0.4)]
    obs = [AC('floor1_acc', 'm/s2', 1, 'floor 1'), AC('roof_acc', 'm/s2', 2, 'roof'), DI('roof_disp', 'm', 2, 'roof')]
    return chaincase('school, two storeys', tcl, dict(rk1=(0.88, 0.5, 1.6), rk2=(1.14, 0.5, 1.6), cs=(1.3, 0.3, 3.0)), runs, obs,
                     Chain(m, k, c, None, ['rk1', 'rk2'], 'cs'), lambda U, A: dict(floor1_acc=A[:, 0], roof_acc=A[:, 1], roof_disp=U[:, 1]),
                     cause='none', effects=[], noise={'floor1_acc': (0.035, 'pink0.7', 0.02), 'roof_acc': (0.03, 'ar0.5', 0.02), 'roof_disp': (0.04, 'pink1.5')},
                     note='fixed-base frame exactly as modelled; coarse 0.02 m/s2 accelerometers with coloured noise, a wandering displacement transducer')


def tank():
    m, k, c = [160000.0, 150000.0, 120000.0], [9.0e7, 8.0e7, 6.0e7], [5.0e5, 4.4e5, 3.3e5]
    tcl = chain_tcl('Three-storey laboratory', 'N, m, kg, s', dict(rk=1.0, cs=1.0), m, k, c, None, 'rk', 'cs')
    runs = [event('main', 'fit', 'elcentro_1940_180', 0.01, 2201, 0.7), event('second', 'fit', 'northridge_1994_arleta_360', 0.01, 2001, 0.6, t0=2),
            event('third', 'holdout', 'imperial_valley_1979_meloland_ff_360', 0.01, 2201, 0.8, t0=2)]
    obs = [AC('floor1_acc', 'm/s2', 1, 'floor 1'), AC('floor2_acc', 'm/s2', 2, 'floor 2'), AC('roof_acc', 'm/s2', 3, 'roof')]

    def extra(s, p, eff):
        w = 10.4
        return dict(m=[3400.0], springs=[(2, 3, 3400.0 * w * w, 2 * 0.012 * w * 3400.0)])
    return chaincase('laboratory, three storeys', tcl, dict(rk=(1.05, 0.6, 1.5), cs=(1.1, 0.3, 4.0)), runs, obs,
                     Chain(m, k, c, None, 'rk', 'cs', extra=extra), lambda U, A: dict(floor1_acc=A[:, 0], floor2_acc=A[:, 1], roof_acc=A[:, 2]),
                     cause='unknown', effects=['tank'], noise=nz(obs, 0.03, 'ar0.5'), confusable=['damping', 'foundation_flexibility'],
                     note='an appendage on the roof (tank, 0.8 % of the mass, lightly damped) resonates near the first mode: split peak and beat')


def tilt():
    m, k, c = [210.0, 180.0, 150.0], [280000.0, 210000.0], [640.0, 500.0]
    tcl = chain_tcl('Archive on isolators', 'kN, m, t, s', dict(Kd=2500.0, Qd=220.0), m, k, c, 'bw', None)
    runs = [event('shake-1', 'fit', 'kobe_1995_nishi_akashi_090', 0.01, 2201, 0.7, t0=2), event('shake-2', 'fit', 'elcentro_1940_180', 0.01, 2201, 1.1),
            event('shake-3', 'holdout', 'northridge_1994_castaic_090', 0.01, 2201, 0.8)]
    vert = {'shake-1': gm('northridge_1994_castaic_090', 0.008, 2201, 0.5, t0=1), 'shake-2': gm('bigbear_1992_hospitality_180', 0.007, 2201, 2.6, t0=8),
            'shake-3': gm('kobe_1995_nishi_akashi_090', 0.007, 2201, 0.45, t0=3)}
    obs = [DI('base_disp', 'm', 1, 'isolation layer'), AC('base_acc', 'm/s2', 1, 'base slab'), AC('roof_acc', 'm/s2', 3, 'roof')]

    def sensor(y, r, eff):
        v = vert[r['name']]
        # vertical response of the roof beam: a 9 Hz, 4 % oscillator (absolute acceleration)
        w, x, xd, out = 56.5, 0.0, 0.0, np.zeros(v.size)
        for i in range(v.size - 1):
            for s in range(4):
                g = v[i] + (v[i + 1] - v[i]) * s / 4
                xd += 0.0025 * (-g - 2 * 0.04 * w * xd - w * w * x)
                x += 0.0025 * xd
            out[i + 1] = -2 * 0.04 * w * xd - w * w * x
        return dict(y, roof_acc=y['roof_acc'] + 0.085 * out)
    return chaincase('archive on isolators', tcl, dict(Kd=(2650.0, 1200, 5000), Qd=(205.0, 90, 420)), runs, obs, Chain(m, k, c, 'bw', None),
                     lambda U, A: dict(base_disp=U[:, 0], base_acc=A[:, 0], roof_acc=A[:, 2]), sensor, cause='unknown', effects=['tilt'], noise=nz(obs, 0.03, 'ar0.6'),
                     only_channels=['roof_acc'], at='roof', confusable=['damping', 'superstructure_yielding', 'gap_impact'],
                     note='the roof accelerometer stands 4.9 degrees out of level and picks up the vertical motion (amplified by the roof beam), which nobody recorded')


def fan():
    m, k, c = [1.15, 0.95, 0.95, 0.75], [1500.0, 1250.0, 1000.0], [3.6, 3.0, 2.4]
    tcl = chain_tcl('Plant building on isolators', 'kip, in, s', dict(Kd=16.0, Qd=50.0, rk=1.0), m, k, c, 'bw', 'rk')
    runs = [event('eq-1', 'fit', 'imperial_valley_1979_meloland_ff_270', 0.01, 2401, 1.1, 386.09, 2), event('eq-2', 'holdout', 'kobe_1995_nishi_akashi_090', 0.01, 2401, 0.5, 386.09, 2)]
    obs = [DI('base_disp', 'in', 1, 'isolation layer'), AC('base_acc', 'in/s2', 1, 'base slab'), AC('floor2_acc', 'in/s2', 3, 'floor 2'), AC('roof_acc', 'in/s2', 4, 'roof')]

    def force(s, r, eff, fe):
        t = np.arange(fe.shape[0]) * 0.01
        f = np.interp(t, [0, 4, 13, 15, 24] if r['name'] == 'eq-1' else [0, 6, 16, 19, 24], [5.2, 5.2, 5.2, 4.6, 1.2])
        ph = 2 * np.pi * np.cumsum(f) * 0.01
        fe[:, 2] += 0.0155 * (2 * np.pi * f) ** 2 * np.sin(ph + 0.6)
    return chaincase('plant building on isolators', tcl, dict(Kd=(14.5, 7, 30), Qd=(56.0, 20, 110), rk=(0.93, 0.6, 1.5)), runs, obs,
                     Chain(m, k, c, 'bw', 'rk', force=force), lambda U, A: dict(base_disp=U[:, 0], base_acc=A[:, 0], floor2_acc=A[:, 2], roof_acc=A[:, 3]),
                     cause='unknown', effects=['fan'], accept=['floor2_acc', 'base_acc'], noise=nz(obs, 0.03, 'ar0.7'), confusable=['damping', 'superstructure_yielding'],
                     note='an unbalanced machine on floor 2 runs at 5.2 Hz and coasts down during the record; its force is not in the model')


def iso_stiff():
    m, k, c = [150000.0, 120000.0, 100000.0], [2.1e8, 1.5e8], [4.8e5, 3.6e5]
    tcl = chain_tcl('Fire station on isolators', 'N, m, kg, s', dict(Kd=1500000.0, Qd=120000.0, rk=1.0), m, k, c, 'bw', 'rk')
    runs = [event('near', 'fit', 'kobe_1995_takatori_000', 0.01, 2201, 0.5, t0=1), event('far', 'fit', 'elcentro_1940_180', 0.01, 2201, 0.8),
            event('next', 'holdout', 'northridge_1994_rinaldi_228', 0.01, 1401, 0.62)]
    obs = [DI('base_disp', 'm', 1, 'isolation layer'), AC('base_acc', 'm/s2', 1, 'base slab'), AC('roof_acc', 'm/s2', 3, 'roof')]

    def extra(s, p, eff):
        return dict(links=[(1, [0.16 * p['Kd'], 0.42], -1, 0)])
    return chaincase('fire station on isolators', tcl, dict(Kd=(1350000.0, 700000, 3200000), Qd=(130000.0, 50000, 260000), rk=(1.1, 0.6, 1.5)), runs, obs,
                     Chain(m, k, c, 'bw', 'rk', extra=extra), lambda U, A: dict(base_disp=U[:, 0], base_acc=A[:, 0], roof_acc=A[:, 2]),
                     cause='strain_stiffening', effects=['strain_stiffening'], noise=nz(obs, 0.03, 'ar0.6'), at='isolation layer', confusable=['gap_impact', 'superstructure_yielding'],
                     note='Gent-type limiting extensibility of the isolators in parallel with the bilinear-like law')


def extra_damp():
    m, k, c = [95.0, 90.0, 90.0, 70.0], [62000.0, 56000.0, 46000.0, 36000.0], [60.0, 54.0, 46.0, 36.0]
    tcl = chain_tcl('Four-storey flats, fixed base', 'kN, m, t, s', dict(rk=1.0, rt=1.0), m, k, c, None, ['rk', 'rk', 'rt', 'rt'])
    runs = [event('quake-a', 'fit', 'northridge_1994_arleta_360', 0.01, 2201, 0.5, t0=2), event('quake-b', 'fit', 'imperial_valley_1979_meloland_ff_270', 0.01, 2001, 0.35, t0=3),
            event('quake-c', 'holdout', 'elcentro_1940_180', 0.01, 2201, 0.6)]
    obs = [AC('floor1_acc', 'm/s2', 1, 'floor 1'), AC('floor3_acc', 'm/s2', 3, 'floor 3'), AC('roof_acc', 'm/s2', 4, 'roof'), DI('roof_disp', 'm', 4, 'roof')]

    def extra(s, p, eff):
        cc = [15.0, 13.5, 11.5, 8.5]
        return dict(links=[(4, [cc[i], 0.65, 0.004], i - 1, i) for i in range(4)])
    return chaincase('flats, four storeys', tcl, dict(rk=(0.95, 0.6, 1.5), rt=(1.08, 0.6, 1.5)), runs, obs, Chain(m, k, c, None, ['rk', 'rk', 'rt', 'rt'], extra=extra),
                     lambda U, A: dict(floor1_acc=A[:, 0], floor3_acc=A[:, 2], roof_acc=A[:, 3], roof_disp=U[:, 3]), cause='damping', effects=['damping'],
                     noise=nz(obs, 0.035, 'ar0.5'), at='storeys', confusable=['superstructure_yielding', 'friction'],
                     note='partitions dissipate: sub-linear dashpots |v|^0.65 in every storey beside the 1 % linear damping of the model')


def gain():
    m, k, c = [0.30, 0.26, 0.21], [430.0, 330.0], [1.0, 0.8]
    tcl = chain_tcl('Two-storey museum on isolators', 'kN, mm, s', dict(Kd=3.4, Qd=260.0, rk=1.0), m, k, c, 'bw', 'rk', tol='1.0e-6')
    runs = [event('event-1', 'fit', 'northridge_1994_castaic_090', 0.01, 2201, 0.7, 9806.65), event('event-2', 'fit', 'imperial_valley_1979_meloland_ff_270', 0.01, 2201, 1.0, 9806.65, 2),
            event('event-3', 'holdout', 'kobe_1995_takatori_000', 0.01, 2201, 0.45, 9806.65, 1)]
    obs = [DI('base_disp', 'mm', 1, 'isolation layer'), AC('base_acc', 'mm/s2', 1, 'base slab'), AC('floor1_acc', 'mm/s2', 2, 'floor 1'), AC('roof_acc', 'mm/s2', 3, 'roof')]
    return chaincase('museum on isolators', tcl, dict(Kd=(3.1, 1.5, 7.0), Qd=(240.0, 100, 480), rk=(1.06, 0.6, 1.5)), runs, obs, Chain(m, k, c, 'bw', 'rk'),
                     lambda U, A: dict(base_disp=U[:, 0], base_acc=A[:, 0], floor1_acc=A[:, 1], roof_acc=A[:, 2]),
                     lambda y, r, e: dict(y, floor1_acc=1.16 * y['floor1_acc']), cause='sensor_gain', effects=['sensor_gain'], noise=nz(obs, 0.03, 'ar0.6'),
                     only_channels=['floor1_acc'], at='floor 1', confusable=['damping', 'superstructure_yielding'], note='the accelerometer of floor 1 reads 1.16 of the truth (wrong sensitivity entered)')


def clip():
    m, k, c = [0.62, 0.50], [330.0, 250.0], [1.0, 0.8]
    tcl = chain_tcl('Two-storey shop, fixed base', 'kip, in, s', dict(rk1=1.0, rk2=1.0, cs=1.0), m, k, c, None, ['rk1', 'rk2'], 'cs')
    runs = [event('first', 'fit', 'elcentro_1940_180', 0.01, 2001, 0.6, 386.09), event('second', 'fit', 'northridge_1994_alhambra_360', 0.01, 2001, 1.6, 386.09, 6),
            event('third', 'holdout', 'northridge_1994_arleta_360', 0.01, 2001, 0.7, 386.09, 2)]
    obs = [AC('floor1_acc', 'in/s2', 1, 'floor 1'), AC('roof_acc', 'in/s2', 2, 'roof'), DI('roof_disp', 'in', 2, 'roof')]
    lev = 150.0

    def sensor(y, r, e):
        x = y['roof_acc'] / lev
        return dict(y, roof_acc=lev * x / (1 + np.abs(x) ** 24) ** (1 / 24))
    model = Chain(m, k, c, None, ['rk1', 'rk2'], 'cs')
    P = dict(rk1=(0.92, 0.5, 1.6), rk2=(1.1, 0.5, 1.6), cs=(1.2, 0.3, 4.0))

    def win(r):
        U, A = model({a: b[0] for a, b in P.items()}, r)
        return merge_windows(np.arange(A.shape[0]) * 0.01, np.abs(A[:, 1]) > lev, 0.5, 0.05)
    return chaincase('shop, two storeys', tcl, P, runs, obs, model, lambda U, A: dict(floor1_acc=A[:, 0], roof_acc=A[:, 1], roof_disp=U[:, 1]), sensor,
                     cause='sensor_clipping', effects=['sensor_clipping'], noise=nz(obs, 0.03, 'ar0.6'), only_channels=['roof_acc'], at='roof', windows=win,
                     confusable=['superstructure_yielding', 'damping'], note='the roof accelerometer saturates (slightly rounded) at +-150 in/s2')


def abut():
    # node 2: pier top; node 3: deck on the bearing
    m, k = [0.55, 2.6], None
    head = ['# Isolated span on a pier', '# units: kip, in, s', 'wipe', 'model basic -ndm 1 -ndf 1', '', 'pset Kd 16.0', 'pset Qd 70.0', 'pset kp 260.0', 'node 1 0.0', 'fix 1 1',
            'node 2 0.0 -mass 0.55', 'node 3 0.0 -mass 2.6', 'uniaxialMaterial Elastic 1 $kp', 'uniaxialMaterial Viscous 2 1.1 1.0', 'element zeroLength 1 1 2 -mat 1 2 -dir 1 1',
            'set ki [expr $Kd/0.1]', 'set uy [expr $Qd/(0.9*$ki)]', 'uniaxialMaterial BoucWen 3 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0',
            'element zeroLength 2 2 3 -mat 3 -dir 1', '', 'timeSeries Path 1 -dt $dt -filePath $motion', 'pattern UniformExcitation 1 1 -accel 1',
            'recorder Node -file disp.out -time -node 2 3 -dof 1 disp', 'recorder Node -file acc.out -timeSeries 1 -time -node 2 3 -dof 1 accel']
    from frame import TAIL
    tcl = '\n'.join(head) + TAIL % '1.0e-8'
    runs = [event('ev-1', 'fit', 'northridge_1994_rinaldi_228', 0.01, 1401, 0.55, 386.09), event('ev-2', 'fit', 'elcentro_1940_180', 0.01, 2001, 0.9, 386.09),
            event('ev-3', 'holdout', 'kobe_1995_takatori_000', 0.01, 2001, 0.5, 386.09, 1)]
    obs = [DI('pier_disp', 'in', 1, 'pier top'), DI('deck_disp', 'in', 2, 'deck'), AC('deck_acc', 'in/s2', 2, 'deck')]

    class Span(Chain):
        def __call__(self, p, r, eff=()):
            self.k, self.c, self.base = [p['kp']], [1.1], None
            ki = p['Kd'] / 0.1
            L = [(0, [0.1, ki, p['Qd'] / (0.9 * ki), 1.0], 0, 1)]
            if 'gap_impact' in eff:
                L.append((2, [4.6, 30.0, 0.25, 2.6, 1.0], -1, 1))
            self.extra = lambda s, p, e: dict(links=L)
            return Chain.__call__(self, p, r, eff or ('on',))
    model = Span(m, [1.0], [1.1], None, None, sub=16)
    P = dict(Kd=(14.0, 6, 40), Qd=(78.0, 30, 160), kp=(285.0, 120, 500))

    def win(r):
        U, A = model({a: b[0] for a, b in P.items()}, r, ('gap_impact',))
        return merge_windows(np.arange(A.shape[0]) * 0.01, U[:, 1] > 4.6, 0.6, 0.1)
    c = chaincase('isolated span between abutments', tcl, P, runs, obs, model, lambda U, A: dict(pier_disp=U[:, 0], deck_disp=U[:, 1], deck_acc=A[:, 1]),
                  cause='gap_impact', effects=['gap_impact'], accept=['deck_acc', 'deck_disp'], noise=nz(obs, 0.03, 'ar0.6'), at='deck', windows=win, confusable=['strain_stiffening', 'superstructure_yielding'],
                  note='the deck strikes one abutment only (4.6 in on the positive side), Jankowski contact damped on approach')
    return c


def rub():
    m, k, c = [90000.0, 70000.0], [1.1e8], [2.6e5]
    tcl = chain_tcl('Control room on rubber pads', 'N, m, kg, s', dict(Kd=1200000.0, cb=90000.0), m, k, c, 'lin', None)
    runs = [event('strong', 'fit', 'kobe_1995_nishi_akashi_090', 0.01, 2401, 0.5, t0=2), event('weak', 'fit', 'elcentro_1940_180', 0.01, 2401, 0.4),
            event('other', 'holdout', 'imperial_valley_1979_meloland_ff_270', 0.01, 2401, 0.7, t0=2)]
    obs = [DI('base_disp', 'm', 1, 'isolation layer'), AC('base_acc', 'm/s2', 1, 'base slab'), AC('roof_acc', 'm/s2', 2, 'roof')]

    def extra(s, p, eff):
        return dict(links=[(3, [4200.0, 2300.0, 25.0, 0.0012], -1, 0)])
    return chaincase('control room on rubber pads', tcl, dict(Kd=(1300000.0, 600000, 2500000), cb=(70000.0, 10000, 250000)), runs, obs,
                     Chain(m, k, c, 'lin', None, extra=extra, sub=12), lambda U, A: dict(base_disp=U[:, 0], base_acc=A[:, 0], roof_acc=A[:, 1]), cause='friction',
                     effects=['friction'], noise=nz(obs, 0.03, 'ar0.6'), at='isolation layer', confusable=['damping', 'rate_dependence'],
                     note='cover plates and service joints rub: friction with the exponential velocity law of Constantinou and a 1.2 mm bristle')


def yield_gain():
    m, k, c = [0.11, 0.10, 0.08], [62.0, 54.0, 42.0], [0.22, 0.19, 0.15]
    tcl = chain_tcl('Three-storey office, fixed base', 'kN, mm, s', dict(rk=1.0, cs=1.0), m, k, c, None, 'rk', 'cs', tol='1.0e-6')
    runs = [event('day-1', 'fit', 'elcentro_1940_180', 0.01, 2001, 0.75, 9806.65), event('day-2', 'fit', 'bigbear_1992_hospitality_180', 0.01, 2001, 1.0, 9806.65, 10),
            event('day-3', 'holdout', 'northridge_1994_arleta_360', 0.01, 2001, 0.8, 9806.65, 2)]
    obs = [DI('floor1_disp', 'mm', 1, 'floor 1'), AC('floor1_acc', 'mm/s2', 1, 'floor 1'), AC('floor2_acc', 'mm/s2', 2, 'floor 2'), AC('roof_acc', 'mm/s2', 3, 'roof')]

    def extra(s, p, eff):
        if 'superstructure_yielding' not in eff:
            return {}
        return dict(drop=[0], links=[(5, [p['rk'] * 62.0, 0.1, 16.0, 40.0], -1, 0)])
    return chaincase('office, three storeys', tcl, dict(rk=(1.04, 0.5, 1.6), cs=(1.1, 0.3, 5.0)), runs, obs, Chain(m, k, c, None, 'rk', 'cs', extra=extra),
                     lambda U, A: dict(floor1_disp=U[:, 0], floor1_acc=A[:, 0], floor2_acc=A[:, 1], roof_acc=A[:, 2]),
                     lambda y, r, e: dict(y, floor2_acc=0.72 * y['floor2_acc']) if 'sensor_gain' in e else y, cause='superstructure_yielding', also=['sensor_gain'],
                     effects=['superstructure_yielding', 'sensor_gain'], noise=nz(obs, 0.03, 'ar0.5'), confusable=['damping', 'foundation_flexibility'],
                     note='storey 1 yields (Iwan assembly of six Jenkins elements with 10 % residual stiffness); the accelerometer of floor 2 reads 0.72 of the truth')


ALL = dict(quiet_house=quiet_house, tank=tank, tilt=tilt, fan=fan, iso_stiff=iso_stiff, extra_damp=extra_damp, gain=gain, clip=clip, abut=abut, rub=rub, yield_gain=yield_gain)
