"""Rig tests under imposed motion, first half."""
import numpy as np
import core as c
import laws as L


def run(name, role, dt, u, every, **extra):
    return dict(name=name, role=role, every=every, dats={name + ".dat": u},
                set=dict(motion=name + ".dat", dt=dt, npts=len(u), **extra))


def path(r, key=None):
    u = r["dats"][key or r["set"]["motion"]]
    return np.arange(u.size) * r["set"]["dt"], u


FORCE = lambda unit, at, col=3: [dict(channel="force", unit=unit, output="force.out", column=col, at=at)]
P = lambda ps: [(k, v[3]) for k, v in ps.items()]


def iona():
    ps = {"K": (215., 120., 330., 200.0), "Fy": (46., 28., 70., 50.0), "Hk": (9.5, 3., 25., 8.0)}
    model = c.static1(("Shear link of a braced frame, component tests", "kip, in, s"), P(ps),
                      "uniaxialMaterial Hardening 1 $K $Fy 0.0 $Hk", "element zeroLength 1 1 2 -mat 1 -dir 1")
    dt = 0.05
    runs = [run("link-1", "fit", dt, c.cyc([(1.3, 11, .25), ("hold", 45.), (1.3, 10, .25)], dt), 0.085),
            run("link-2", "fit", dt, c.cyc([(1.3, 7, .05)], dt), 0.11),
            run("link-3", "holdout", dt, c.cyc([(.7, 4, .2), (1.6, 5, .2), (.7, 4, .2), ("hold", 20.), (1.0, 6, .25), (1.6, 3, .2)], dt), 0.085)]

    def simulate(r, on):
        t, u = path(r)
        f, D = L.fatigue_hardening(u, 215., 46., 9.5, "cyclic_degradation" in on, 32., 1.35, 0.42, 0.12)
        return t, {"force": f}, {"temperature": 21.4 + .25 * np.sin(t / 70)}
    return dict(name="iona", title="shear link, three specimens from one plate", model=model, params=ps, runs=runs,
                channels=FORCE("kip", "link"), simulate=simulate, noise={"*": ("ar0.7", .022)}, skew=0, seed=5101,
                context={"temperature": ("degC", .15, 1)}, effects=["cyclic_degradation"], cause="cyclic_degradation", difficulty="medium",
                confusable=["self_heating", "mullins_softening"],
                note="kinematic bilinear link; strength (towards -42 %) and stiffness (towards -12 %) fall exponentially with a Miner sum of plastic excursions "
                     "weighted by a power 1.35 of their size; each run has a fresh specimen, no recovery in the pauses, same loss per cycle at a fifth of the speed")


def ulva():
    ps = {"K1": (9.2, 5., 18., 8.0), "Fy": (172., 100., 300., 150.0), "b": (.115, .05, .25, .1)}
    model = c.static1(("Lead-rubber bearing LR-3, prototype tests", "kN, mm, s"), P(ps),
                      "uniaxialMaterial Steel01 1 $Fy $K1 $b", "element zeroLength 1 1 2 -mat 1 -dir 1")
    dt = 0.025
    runs = [run("proto-a", "fit", dt, c.cyc([(125., 10, .4), ("hold", 60.), (125., 5, .4)], dt), 0.06),
            run("proto-b", "fit", 0.05, c.cyc([(125., 4, .03)], 0.05), 0.12),
            run("proto-c", "holdout", dt, c.cyc([(80., 6, .4), ("hold", 25.), (150., 6, .4), ("hold", 40.), (80., 4, .2)], dt), 0.06)]

    def simulate(r, on):
        t, u = path(r)
        k, q = 9.2 * (1 - .115), 172. * (1 - .115)
        f, T = L.lead_heat(u, r["set"]["dt"], k, q, "self_heating" in on, .0069, 17000., .0021, 60000., .012, 19.5)
        return t, {"force": f + 9.2 * .115 * u}, {"temperature": T}
    return dict(name="ulva", title="lead-rubber bearing LR-3", model=model, params=ps, runs=runs, channels=FORCE("kN", "upper plate"),
                simulate=simulate, noise={"*": ("ar0.8", .034)}, seed=5102, context={"temperature": ("degC", .2, 1)},
                effects=["self_heating"], cause="self_heating", difficulty="hard", confusable=["cyclic_degradation", "mullins_softening"],
                note="lead plug strength q0*exp(-0.0069 dT) (Kalpakidis and Constantinou) with a two-mass thermal network (plug; shims and plates): "
                     "most of the loss returns in the pauses, much less in the slow run; the thermocouple sits on the end plate")


def yell():
    ps = {"kInit": (2.6, 1.4, 4.5, 2.2), "qd": (11.5, 6., 20., 13.), "alpha": (.23, .1, .42, .2)}
    model = """# Square pad under constant vertical load
# units: kN, mm, s
wipe
model basic -ndm 2 -ndf 3
pset kInit 2.2
pset qd 13.0
pset alpha 0.2
set H 180.0
node 1 0.0 0.0
node 2 0.0 $H
fix 1 1 1 1
fix 2 0 0 1
uniaxialMaterial Elastic 1 900.0
uniaxialMaterial Elastic 2 1.0e7
element elastomericBearingPlasticity 1 1 2 $kInit $qd $alpha 0.0 2.0 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
}
""" + c.solve() + """integrator LoadControl 0.5
analysis Static
analyze 2
loadConst -time 0.0
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
""" + c.solve() + c.LOOP_S
    dt = .02
    rng = np.random.default_rng(77)
    runs = [run("ladder", "fit", dt, c.cyc([(25., 2, .2), (50., 2, .2), (75., 2, .2), (100., 2, .2), (125., 3, .2)], dt), .045, axial=240.0),
            run("design", "fit", dt, c.cyc([(60., 6, .25), (110., 3, .25)], dt), .04, axial=240.0),
            run("broad", "holdout", dt, c.band(rng, 2600, dt, .06, .9, 138.), .04, axial=240.0)]

    def simulate(r, on):
        t, u = path(r)
        k2 = 2.6 * .23
        el = L.langevin(u, k2, 196.) if "strain_stiffening" in on else k2 * u
        return t, {"force": el + L.epp_path(u, 2.6 * .77, 11.5)}, {}
    return dict(name="yell", title="square pad, constant vertical load", model=model, params=ps, runs=runs, channels=FORCE("kN", "upper plate", 4),
                simulate=simulate, noise={"*": ("pink", .03)}, seed=5103, effects=["strain_stiffening"], cause="strain_stiffening",
                difficulty="medium", confusable=["axial_shear_interaction", "mullins_softening"],
                note="the rubber spring follows Cohen's rational form of the inverse Langevin function (limited chains) with locking at 196 mm; the plastic part is as modelled")


def gigha():
    ps = {"mu": (.068, .03, .12, .08), "kr": (.62, .3, 1.1, .5)}
    model = c.static1(("Flat slider with recentring springs, vertical actuator", "kN, mm, s"), P(ps),
                      "set k0 60.0\nuniaxialMaterial ElasticPP 1 $k0 [expr $mu*$axial/$k0]\nuniaxialMaterial Elastic 2 $kr",
                      "element zeroLength 1 1 2 -mat 1 2 -dir 1 1")
    dt = .02
    rng = np.random.default_rng(311)
    runs = [run("va", "fit", dt, c.cyc([(60., 5, .2), (90., 3, .2)], dt), .04, axial=420.0),
            run("vb", "fit", dt, c.cyc([(70., 12, .25)], dt), .033, axial=420.0),
            run("vc", "holdout", dt, c.band(rng, 2700, dt, .08, .8, 95.), .033, axial=420.0)]

    def load(r, t):
        N0 = 420.
        if r["name"] == "va":
            return np.full(t.size, N0) + 1.5 * np.sin(.4 * t)
        if r["name"] == "vb":
            e = np.clip(t / 6, 0, 1)
            return N0 * (1 + .3 * e * np.sin(2 * np.pi * .61 * t + .5))
        q = np.random.default_rng(312)
        return N0 * (1 + c.band(q, t.size, .02, .2, 2.2, .42))

    def simulate(r, on):
        t, u = path(r)
        N = load(r, t)
        x = N / 420. if "varying_axial_load" in on else np.ones(t.size)
        f = L.epp_path(u, 60., .068 * 420. * x ** .82) + .62 * u
        return t, {"force": f}, {"axial": N}
    return dict(name="gigha", title="flat slider with recentring springs", model=model, params=ps, runs=runs, channels=FORCE("kN", "slide plate"),
                simulate=simulate, noise={"*": ("ar0.75", .045)}, seed=5104, context={"axial": ("kN", 2.5, 1)}, effects=["varying_axial_load"],
                cause="varying_axial_load", difficulty="hard", confusable=["friction", "bidirectional_coupling"],
                note="slider force ~ N(t)^0.82 (friction coefficient falls a little with pressure); the analyst holds N at its mean; two runs have a moving vertical load")


def kerrera():
    ps = {"kt": (75., 30., 150., 85.), "kc": (310., 180., 500., 280.), "qv": (9., 3., 20., 12.)}
    model = c.static1(("Bearing in the vertical rig, pull and push (positive = pull)", "kN, mm, s"), P(ps),
                      "uniaxialMaterial Elastic 1 $kt 0.0 $kc\nuniaxialMaterial ElasticPP 2 [expr 8.0*$qv] 0.125",
                      "element zeroLength 1 1 2 -mat 1 2 -dir 1 1")
    dt = .05

    def pp(seq, T=4.0):
        b = [("hold", .5)]
        for lo, hi in seq:
            b += [("to", hi, T / 2), ("to", lo, T / 2)]
        return c.cyc(b + [("to", 0., 1.)], dt)
    runs = [run("pull-1", "fit", dt, pp([(-.3, .4)] * 3 + [(-.4, .8)] * 3 + [(-.5, 1.2)] * 3 + [(-.6, 1.9)] * 3 + [(-.6, 1.2)] * 2, 6.), .07),
            run("pull-2", "fit", dt, pp([(-.5, .6)] * 6 + [(-.5, 1.2)] * 4 + [(-.5, 1.9)] * 3, 6.), .07),
            run("pull-3", "holdout", dt, pp([(-.4, .5), (-.5, 1.6), (-.4, .9), (-.5, 1.6), (-.3, .5), (-.6, 2.2), (-.5, 1.2), (-.5, 2.2), (-.4, .7)] * 2, 5.), .06)]

    def simulate(r, on):
        t, u = path(r)
        f, cav = L.tension(u, 75., 310., 62., "cavitation" in on, .42, .62, .55, 1.1)
        return t, {"force": f + L.epp_path(u, 72., 9.)}, {"mask": cav}
    return dict(name="kerrera", title="bearing, vertical pull and push", model=model, params=ps, runs=runs, channels=FORCE("kN", "upper plate"),
                simulate=simulate, noise={"*": ("ar0.5", .042)}, seed=5105, effects=["cavitation"], cause="cavitation", difficulty="medium",
                confusable=["mullins_softening", "cyclic_degradation"], use_windows=False,
                note="in tension the stiffness is lost at 62 kN: power-law envelope Fc(1+0.62((u/uc)^0.42-1)), the cavitation force of later cycles lower by up to 55 % "
                     "(exponential in the largest pull); fresh bearing in every run; compression as modelled")


def orkney():
    ps = {"ko": (3.4, 1.8, 6.5, 3.0), "Qd": (31., 15., 55., 36.), "alpha": (.14, .05, .3, .1)}
    model = c.static1(("Timber wall panel on brackets, racking", "kN, mm, s"), P(ps),
                      "set uy [expr $Qd/((1.0-$alpha)*$ko)]\nuniaxialMaterial BoucWen 1 $alpha $ko 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0",
                      "element zeroLength 1 1 2 -mat 1 -dir 1")
    dt = .025
    rng = np.random.default_rng(9)
    runs = [run("rack-a", "fit", dt, c.cyc([(12., 2, .1), (24., 3, .1), (40., 3, .1), (24., 2, .1)], dt, "tri"), .06),
            run("rack-b", "fit", dt, c.cyc([(32., 8, .12)], dt, "sin"), .05),
            run("rack-c", "holdout", dt, c.band(rng, 3600, dt, .04, .25, 48.), .06)]

    def simulate(r, on):
        t, u = path(r)
        uy = 31. / (.86 * 3.4)
        z = L.sliplock(u, uy, "pinching" in on, 1.1, 6.0, .22, .08)
        return t, {"force": .14 * 3.4 * u + 31. * z}, {}
    return dict(name="orkney", title="timber wall panel on brackets", model=model, params=ps, runs=runs, channels=FORCE("kN", "top rail"),
                simulate=simulate, noise={"*": ("ar0.6", .028)}, seed=5106, effects=["pinching"], cause="pinching", difficulty="medium",
                confusable=["gap_impact", "cyclic_degradation"],
                note="slip-lock element in series with the Bouc-Wen spring (Baber and Noori's idea, own Gaussian offset in z and weaker slip on unloading), slip length grows with dissipated work")


CASES = [iona, ulva, yell, gigha, kerrera, orkney]
