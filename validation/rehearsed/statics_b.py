"""Rig tests under imposed motion, second half."""
import numpy as np
import core as c
import laws as L
from statics_a import run, path, FORCE, P

BW1 = "set uy [expr $Qd/((1.0-$alpha)*$ko)]\nuniaxialMaterial BoucWen 1 $alpha $ko 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0"


def rum():
    ps = {"kInit": (1.75e6, .9e6, 3.0e6, 1.4e6), "qd": (9800., 5000., 17000., 11000.), "alpha": (.26, .12, .45, .3)}
    model = """# Damping rubber pad at three speeds
# units: N, m, s
wipe
model basic -ndm 2 -ndf 3
pset kInit 1400000.0
pset qd 11000.0
pset alpha 0.3
node 1 0.0 0.0
node 2 0.0 0.16
fix 1 1 1 1
fix 2 0 0 1
mass 2 40.0 40.0 1.0
uniaxialMaterial Elastic 1 5.0e8
uniaxialMaterial Elastic 2 1.0e8
element elastomericBearingBoucWen 1 1 2 $kInit $qd $alpha 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
}
""" + c.solve() + """integrator LoadControl 0.25
analysis Static
analyze 4
loadConst -time 0.0
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
""" + c.solve() + c.LOOP_T.replace("Newmark 0.5 0.25", "Newmark 0.6 0.3025")
    runs = [run("creep", "fit", .02, c.cyc([(.03, 1, .04), (.05, 2, .04), ("to", .035, 2.), ("hold", 5.), ("to", 0., 2.)], .02, "tri"), .05, axial=120000.),
            run("brisk", "fit", .0025, c.cyc([(.03, 3, 1.), (.05, 5, 1.)], .0025), .006, axial=120000.),
            run("stairs", "holdout", .01, c.cyc([("to", .02, .2), ("hold", 4.), ("to", .045, .2), ("hold", 4.), ("to", -.02, .5), ("hold", 4.),
                                                ("to", -.045, .2), ("hold", 3.), ("to", 0., .4), ("hold", 1.), (.04, 4, .3)], .01), .025, axial=120000.)]

    def simulate(r, on):
        t, u = path(r)
        k0 = 1.75e6
        uy = 9800. / (k0 * .74)
        f = 9800. * L.bw_path(u, uy) + .26 * k0 * u
        if "rate_dependence" in on:
            f = f + L.eyring(u, r["set"]["dt"], 3.2e6, 640., .0016)
        return t, {"force": f}, {}
    return dict(name="rum", title="damping rubber pad, three speeds", model=model, params=ps, runs=runs, channels=FORCE("N", "upper plate", 4),
                simulate=simulate, noise={"*": ("ar0.7", .022)}, seed=5201, effects=["rate_dependence"], cause="rate_dependence", difficulty="medium",
                confusable=["damping", "friction"],
                note="parallel Maxwell branch with an Eyring (sinh) dashpot: overstress grows with the logarithm of the speed and relaxes in the holds")


def coll():
    ps = {"kr": (4.1, 2.2, 6.5, 3.5), "Fy": (3.3, 1.5, 6., 4.), "ky": (28., 12., 60., 20.)}
    model = c.static1(("Natural rubber pads N-9 and N-10", "kip, in, s"), P(ps),
                      "uniaxialMaterial Elastic 1 $kr\nuniaxialMaterial ElasticPP 2 $ky [expr $Fy/$ky]\nuniaxialMaterial Parallel 3 1 2",
                      "element zeroLength 1 1 2 -mat 3 -dir 1")
    dt = .025
    rng = np.random.default_rng(41)
    sched = [(1., 3, .2), (2., 3, .2), (3., 3, .2), (2., 2, .2)]
    runs = [run("n9-morning", "fit", dt, c.cyc(sched, dt), .055),
            run("n9-noon", "fit", dt, c.cyc([(3., 3, .2), (2., 3, .2), (1., 3, .2)], dt), .055),
            run("n10", "holdout", dt, c.cyc([(2.2, 3, .2), (1.1, 2, .2), (3.3, 3, .2), (2.2, 2, .2)], dt), .055)]

    def simulate(r, on):
        t, u = path(r)
        g, h, M = np.ones(u.size), np.ones(u.size), None
        e = L.epp_path(u, 28., 3.3)
        el = 4.1 * u
        if "mullins_softening" in on:
            M0 = 3.0 / 3.2 if r["name"] == "n9-noon" else 0.0
            g, _, M = L.zuniga(u, 3.2, .34, M0)
            el = el * g
            e = e * np.exp(-.12 * M)
        return t, {"force": el + e}, {"temperature": 20.8 + .003 * t}
    return dict(name="coll", title="natural rubber pads N-9 and N-10", model=model, params=ps, runs=runs, channels=FORCE("kip", "upper plate"),
                simulate=simulate, noise={"*": ("ar0.8", .022)}, seed=5202, context={"temperature": ("degC", .12, 1)}, effects=["mullins_softening"],
                cause="mullins_softening", difficulty="medium", confusable=["cyclic_degradation", "strain_stiffening"],
                note="Zuniga-Beatty softening exp(-0.34 sqrt(M-m)) on the rubber spring, M the largest strain measure ever, and a weak loss of the plastic part with M; "
                     "'n9-noon' is the same pad as 'n9-morning' (already softened), 'n10' is virgin")


def fetlar():
    ps = {"Fy": (15.5, 8., 28., 18.), "E0": (4.4, 2., 9., 4.), "b": (.22, .1, .45, .25)}
    model = c.static1(("High damping pads of one batch", "kN, mm, s"), P(ps), "uniaxialMaterial Steel01 1 $Fy $E0 $b",
                      "element twoNodeLink 1 1 2 -mat 1 -dir 1")
    model = model.replace("model basic -ndm 2 -ndf 2\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1\n", "model basic -ndm 2 -ndf 3\nnode 1 0.0 0.0\nnode 2 0.0 0.0\nfix 1 1 1 1\nfix 2 0 0 1\n")
    model = model.replace("-mat 1 -dir 1\n", "-mat 1 -dir 1 -orient 1 0 0 0 1 0\n")
    runs = [run("pad-1", "fit", .005, c.cyc([(25., 3, .8), (50., 3, .8), (75., 4, .8), (50., 3, .8)], .005), .011),
            run("pad-2", "fit", .05, c.cyc([(25., 2, .06), (50., 2, .06), (75., 2, .06), (50., 1, .06)], .05), .09),
            run("pad-3", "holdout", .01, c.cyc([(40., 3, .5), (80., 3, .5), (40., 1, .1), (80., 1, .1), (60., 3, .8)], .01), .022)]

    def simulate(r, on):
        t, u = path(r)
        el = .22 * 4.4 * u
        f = L.epp_path(u, 4.4 * .78, 15.5 * .78)
        if "mullins_softening" in on:
            m = np.abs(u) / 80.
            M = np.maximum.accumulate(m)
            d = .25 * (1 - np.exp(-(M - m) / .3)) + .1 * (1 - np.exp(-M / .6))
            el, f = el * (1 - d), f * (1 - .5 * d)
        if "rate_dependence" in on:
            f = f + L.maxwell(u, r["set"]["dt"], .13, .55) + L.maxwell(u, r["set"]["dt"], .07, 4.)
        return t, {"force": el + f}, {"temperature": 22.6 + .0 * t}
    return dict(name="fetlar", title="three high damping pads of one batch", model=model, params=ps, runs=runs, channels=FORCE("kN", "upper plate", 4),
                simulate=simulate, noise={"*": ("ar0.7", .02)}, seed=5203, context={"temperature": ("degC", .15, 1)},
                effects=["mullins_softening", "rate_dependence"], cause="pair", difficulty="medium", confusable=["cyclic_degradation", "damping"],
                note="softening with exponential memory of the largest strain (every run a virgin sample) and a two-branch Maxwell (Prony) overstress (0.55 s and 4 s)")


def mull():
    ps = {"ko": (5.2e5, 3e5, 1e6, 4.5e5), "Qd": (4700., 2200., 9000., 6000.), "alpha": (.38, .2, .6, .3)}
    model = c.static1(("Pad in test frame 2", "N, m, s"), P(ps), BW1, "element zeroLength 1 1 2 -mat 1 -dir 1")
    rng = np.random.default_rng(55)
    runs = [run("slow", "fit", .02, c.cyc([(.003, 2, .1), (.008, 1, .1), (.02, 2, .1), (.045, 2, .1)], .02), .045),
            run("quick", "fit", .0025, c.cyc([(.003, 2, 1.), (.008, 2, 1.), (.02, 2, 1.), (.045, 5, 1.)], .0025), .0065),
            run("random", "holdout", .005, c.band(rng, 3600, .005, .15, 1.8, .048), .0105)]

    def simulate(r, on):
        t, u = path(r)
        dt = r["set"]["dt"]
        uy = 4700. / (.62 * 5.2e5)
        f = 4700. * L.bw_path(u, uy) + .38 * 5.2e5 * u
        if "friction" in on:
            f = f + L.dahl(u, np.gradient(u, dt), 620., .0004, 1.3, 1.35, .03)
        if "sensor_lag" in on:
            f = np.interp(t - .019, t, f)
        return t, {"force": f}, {}
    return dict(name="mull", title="pad in test frame 2", model=model, params=ps, runs=runs, channels=FORCE("N", "upper plate"),
                simulate=simulate, noise={"*": ("ar0.6", .022)}, seed=5204, effects=["friction", "sensor_lag"], cause="pair", difficulty="medium",
                confusable=["rate_dependence", "damping"],
                note="Dahl friction (exponent 1.3) of the guide, breakaway force 1.35 times the running force, and a force channel 19 ms late (filter of the amplifier)")


def eigg():
    ps = {"Fy": (7600., 4000., 13000., 9000.), "E0": (2100., 1000., 4500., 1800.), "b": (.06, .01, .15, .04), "kb": (310., 100., 700., 400.)}
    model = c.static1(("Energy dissipating strut with a compression buffer", "N, mm, s"), P(ps),
                      "uniaxialMaterial Steel01 1 $Fy $E0 $b\nuniaxialMaterial ENT 2 $kb", "element zeroLength 1 1 2 -mat 1 2 -dir 1 1")
    dt = .04
    rng = np.random.default_rng(60)
    runs = [run("strut-1", "fit", dt, c.cyc([(6., 2, .08), (12., 3, .08), (20., 4, .08)], dt), .07),
            run("strut-2", "fit", dt, c.cyc([(16., 8, .1)], dt, "tri"), .06),
            run("strut-3", "holdout", dt, c.band(rng, 2400, dt, .04, .4, 22.), .06)]

    def simulate(r, on):
        t, u = path(r)
        return t, {"force": .06 * 2100 * u + L.epp_path(u, 2100 * .94, 7600 * .94) + 310. * np.minimum(u, 0)}, {}
    return dict(name="eigg", title="strut with buffer", model=model, params=ps, runs=runs, channels=FORCE("N", "strut"), simulate=simulate,
                noise={"*": ("reddish", .04)}, seed=5205, effects=[], cause="none", difficulty="null", confusable=[],
                note="model right (bilinear strut with compression-only buffer); noise between pink and brown that wanders like a zero drift, stationary")


def tiree():
    ps = {"kInit": (8200., 4500., 14000., 7000.), "qd": (56., 30., 95., 70.), "alpha": (.11, .05, .2, .13)}
    model = """# Bearing under two-way motion
# units: kN, m, s
wipe
model basic -ndm 3 -ndf 6
pset kInit 7000.0
pset qd 70.0
pset alpha 0.13
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.25
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
uniaxialMaterial Elastic 1 1.5e6
uniaxialMaterial Elastic 2 1.0e5
element elastomericBearingPlasticity 1 1 2 $kInit $qd $alpha 0.0 2.0 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 0.0 [expr -$axial] 0.0 0.0 0.0
}
""" + c.solve() + """integrator LoadControl 0.5
analysis Static
analyze 2
loadConst -time 0.0
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motionx
timeSeries Path 3 -dt $dt -filePath $motiony
pattern Plain 2 2 {
    sp 2 1 1.0
}
pattern Plain 3 3 {
    sp 2 2 1.0
}
recorder Element -file force.out -time -ele 1 force
""" + c.solve() + c.LOOP_S
    dt = .02

    def two(name, role, ux, uy):
        n = min(len(ux), len(uy))
        return dict(name=name, role=role, every=.045, dats={name + "-x.dat": ux[:n], name + "-y.dat": uy[:n]},
                    set=dict(motionx=name + "-x.dat", motiony=name + "-y.dat", dt=dt, npts=n, axial=900.))
    t = np.arange(2001) * dt
    w = np.sin(np.pi / 2 * np.clip(t / 4, 0, 1)) ** 2 * np.clip((t[-1] - t) / 3, 0, 1)
    rng = np.random.default_rng(61)
    runs = [two("spiral", "fit", .11 * w * t / 40 * np.cos(2 * np.pi * .15 * t), .11 * w * t / 40 * np.sin(2 * np.pi * .15 * t)),
            two("lissajous", "fit", .08 * w * np.sin(2 * np.pi * .1 * t), .06 * w * np.sin(2 * np.pi * .15 * t + .6)),
            two("wander", "holdout", c.band(rng, 2001, dt, .05, .6, .1), c.band(rng, 2001, dt, .05, .6, .075))]

    def simulate(r, on):
        t, ux = path(r, r["set"]["motionx"])
        fx, fy = L.plane_plastic(ux, r["dats"][r["set"]["motiony"]], 8200. * .89, 56., 8200. * .11)
        return t, {"force_x": fx, "force_y": fy}, {}
    ch = [dict(channel="force_x", unit="kN", output="force.out", column=7, at="upper plate, x"),
          dict(channel="force_y", unit="kN", output="force.out", column=8, at="upper plate, y")]
    return dict(name="tiree", title="bearing, two-way motion", model=model, params=ps, runs=runs, channels=ch, simulate=simulate,
                noise={"force_x": ("reson2.3", .045), "force_y": ("reson3.1", .03)}, seed=5206, effects=[], cause="none", difficulty="null", confusable=[],
                note="model right (coupled plasticity bearing); narrow-band coloured noise of the load cells, stationary")


def whalsay():
    ps = {"Fy": (4.3e4, 2.2e4, 8e4, 5e4), "E0": (5.5e6, 3e6, 1.1e7, 4.5e6), "b": (.035, .01, .1, .05)}
    model = c.static1(("Yielding plate damper", "N, m, s"), P(ps), "uniaxialMaterial Steel02 1 $Fy $E0 $b 15.0 0.925 0.15",
                      "element zeroLength 1 1 2 -mat 1 -dir 1")
    runs = [run("saw-1", "fit", .005, c.cyc([(.015, 3, .5), (.03, 4, .5), (.045, 4, .4)], .005, "tri"), .009),
            run("saw-2", "fit", .005, c.cyc([(.035, 7, .5)], .005, "tri"), .009),
            run("saw-3", "holdout", .005, c.cyc([(.025, 3, .6), (.05, 3, .4), ("hold", 1.), (.03, 4, .6)], .005, "tri"), .009)]

    def simulate(r, on):
        t, u = path(r)
        f = L.steel02(u, 4.3e4, 5.5e6, .035, 15., .925, .15)
        if "unknown" in on:
            f = f + L.ring(u, r["set"]["dt"], 8.7, .018, 640.)
        return t, {"force": f}, {}
    return dict(name="whalsay", title="yielding plate damper", model=model, params=ps, runs=runs, channels=FORCE("N", "damper"), simulate=simulate,
                noise={"*": ("ar0.6", .02)}, seed=5207, effects=["unknown"], cause="unknown", difficulty="medium", confusable=["damping", "sensor_drift"],
                note="the reaction frame rings at 8.7 Hz (1.8 % damping) after each reversal of the saw-tooth motion and the load cell carries its inertia force")


def bute():
    ps = {"K": (3.1, 1.6, 6., 2.5), "sy": (36., 18., 65., 45.), "H": (.42, .15, 1., .6)}
    model = c.static1(("Steel-rubber coupler", "kN, mm, s"), P(ps), "uniaxialMaterial Hardening 1 $K $sy 0.0 $H",
                      "element zeroLength 1 1 2 -mat 1 -dir 1")
    dt = .04
    rng = np.random.default_rng(62)
    runs = [run("t-1", "fit", dt, c.cyc([(30., 2, .06), (60., 3, .06)], dt, "tri"), .06),
            run("t-2", "fit", dt, c.cyc([(75., 4, .05)], dt), .06),
            run("t-3", "holdout", dt, c.band(rng, 2500, dt, .03, .2, 80.), .06)]

    def simulate(r, on):
        t, u = path(r)
        up, f = 0.0, np.zeros(u.size)
        for i in range(u.size):
            tr = 3.1 * (u[i] - up) - .42 * up
            if abs(tr) > 36.:
                up += (abs(tr) - 36.) / 3.52 * np.sign(tr)
            f[i] = 3.1 * (u[i] - up)
        if "unknown" in on:
            p = u + 2.3
            f = f + 3.6 * (np.sin(2 * np.pi * p / 9.5) + .35 * np.sin(4 * np.pi * p / 9.5 + .8)) - 3.6 * (np.sin(2 * np.pi * 2.3 / 9.5) + .35 * np.sin(4 * np.pi * 2.3 / 9.5 + .8))
        return t, {"force": f}, {}
    return dict(name="bute", title="steel-rubber coupler", model=model, params=ps, runs=runs, channels=FORCE("kN", "coupler"), simulate=simulate,
                noise={"*": ("ar0.7", .025)}, seed=5208, effects=["unknown"], cause="unknown", difficulty="medium", confusable=["friction", "pinching"],
                note="force ripple periodic in the stroke (pitch 9.5 mm and its half: ball screw of the machine), conservative, the same at all speeds and directions")


CASES = [rum, coll, fetlar, mull, eigg, tiree, whalsay, bute]
