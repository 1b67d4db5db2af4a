"""Structures under ground motion, second half."""
import numpy as np
import core as c
import dynlib as d
from dynlib import CH, qrun, chain
from dynamics_a import springs


def viscous(ks, cs, fac):
    """elastic storeys with linear dashpots above an isolation layer (element 1)"""
    L = []
    for i, (k, q) in enumerate(zip(ks, cs)):
        L += ["uniaxialMaterial Elastic %d [expr %s*%r]" % (11 + i, fac, k), "uniaxialMaterial Viscous %d %r 1.0" % (21 + i, q),
              "element zeroLength %d %d %d -mat %d %d -dir 1 1" % (11 + i, 2 + i, 3 + i, 11 + i, 21 + i)]
    return "\n".join(L)


def hoy():
    ps = {"Kd": (4600., 2800., 8000., 4000.), "Qd": (410., 220., 750., 500.), "rk": (.9, .5, 1.5, 1.0)}
    m = [260., 210., 210., 200., 150.]
    k = [4.0e5, 3.6e5, 3.0e5, 2.3e5]
    q = [950., 850., 720., 560.]
    body = ("set ki [expr $Kd/0.09]\nset uy [expr $Qd/((1.0-0.09)*$ki)]\n"
            "uniaxialMaterial BoucWen 1 0.09 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0\nelement zeroLength 1 1 2 -mat 1 -dir 1\n" + viscous(k, q, "$rk"))
    recs = "recorder Node -file disp.out -time -node 2 -dof 1 disp\nrecorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 5 6 -dof 1 accel"
    model = d.building(("Archive building on isolators, four storeys", "kN, m, t, s"), ps, m, body, recs)
    dt = .01
    runs = [qrun("north", "fit", c.gm("chichi_1999_tcu128_n", dt, 2601, 2.0, 22.), dt, .0105, 4),
            qrun("south", "holdout", c.kanai(np.random.default_rng(911), 2401, dt, 2.1, .6, 3.0, 3., 11., (6., 2.4, .35)), dt, .0105, 4)]

    def simulate(r, on):
        kk = np.r_[0, np.array(k) * .9]
        B = chain(5)
        M = np.array(m)
        C = B.T @ (np.r_[0, q][:, None] * B)
        t, ag, U, V, A = d.shake(r, M, C, B, kk, [(0, d.BW(4600. / .09, .09, 410.))], 1e-10)
        o = {"base_disp": U[:, 0], "base_acc": A[:, 0] + ag, "floor2_acc": A[:, 2] + ag, "roof_acc": A[:, 4] + ag}
        if "sensor_gain" in on:
            y = o["floor2_acc"]
            o["floor2_acc"] = .87 * y
        return t, o, {}
    ch = CH(("base_disp", "m", "disp.out", 1, "isolation layer"), ("base_acc", "m/s2", "acc.out", 1, "base slab"),
            ("floor2_acc", "m/s2", "acc.out", 3, "floor 2"), ("roof_acc", "m/s2", "acc.out", 5, "roof"))
    return dict(name="hoy", title="archive building on isolators", model=model, params=ps, runs=runs, channels=ch, simulate=simulate, noise={"*": ("ar0.7", .04)},
                seed=5401, effects=["sensor_gain"], cause="sensor_gain", difficulty="hard", confusable=["superstructure_yielding", "damping"],
                where_channels=["floor2_acc"], at="floor 2", note="the accelerometer of floor 2 reads 0.87 of the truth in every run (amplifier set for another cable)")


def pabay():
    ps = {"Kd": (10.5, 6., 18., 9.), "Qd": (55., 28., 95., 70.)}
    m = [1.15, .8, .6]
    k = [1900., 1400.]
    q = [4.6, 3.4]
    body = ("set ki [expr $Kd/0.08]\nuniaxialMaterial Steel01 1 [expr $Qd/(1.0-0.08)] $ki 0.08\nelement zeroLength 1 1 2 -mat 1 -dir 1\n" + viscous(k, q, "1.0"))
    recs = "recorder Node -file disp.out -time -node 2 4 -dof 1 disp\nrecorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel"
    model = d.building(("Pump house on isolators", "kip, in, s"), ps, m, body, recs)
    dt, inch = .01, 39.3701
    runs = [qrun("may", "fit", inch * c.gm("imperial_valley_1979_meloland_ff_360", dt, 2301, 1.3), dt, .0115, 4),
            qrun("june", "fit", inch * c.kanai(np.random.default_rng(912), 2001, dt, 1.5, .7, 1.6, 3., 9.), dt, .0115, 4),
            qrun("august", "holdout", inch * c.gm("kobe_1995_takatori_000", dt, 2301, .45), dt, .0115, 4)]

    def simulate(r, on):
        B = chain(3)
        M = np.array(m)
        C = B.T @ (np.r_[0, q][:, None] * B)
        t, ag, U, V, A = d.shake(r, M, C, B, np.r_[0, k], [(0, d.Bil(10.5 / .08, .08, 55. / .92))], 1e-9)
        o = {"base_disp": U[:, 0], "base_acc": A[:, 0] + ag, "roof_acc": A[:, 2] + ag}
        ext = {}
        if "sensor_clipping" in on:
            lo, hi, w = -47., 44., 2.0

            def soft(y):
                # a soft knee of width w on either rail
                y = hi - w * np.logaddexp(0.0, (hi - y) / w)
                return lo + w * np.logaddexp(0.0, (y - lo) / w)
            ext["after"] = {"roof_acc": soft}
            ext["mask"] = (o["roof_acc"] > hi) | (o["roof_acc"] < lo)
        return t, o, ext
    ch = CH(("base_disp", "in", "disp.out", 1, "isolation layer"), ("base_acc", "in/s2", "acc.out", 1, "base slab"), ("roof_acc", "in/s2", "acc.out", 3, "roof"))
    return dict(name="pabay", title="pump house on isolators", model=model, params=ps, runs=runs, channels=ch, simulate=simulate, noise={"*": ("ar0.5", .035)},
                seed=5402, effects=["sensor_clipping"], cause="sensor_clipping", difficulty="medium", confusable=["superstructure_yielding", "sensor_gain"],
                where_channels=["roof_acc"], at="roof", note="the roof accelerometer saturates at +44 and -47 in/s2 with a soft knee (2 in/s2); the weaker run does not reach the rails")


def lismore():
    ps = {"Ki": (41000., 22000., 80000., 50000.), "Fy": (250., 140., 420., 300.), "Hk": (6100., 3500., 10000., 5000.)}
    m = [210., 170., 170., 140.]
    k = [1.5e5, 1.4e5, 1.1e5]
    q = [420., 380., 300.]
    body = "uniaxialMaterial Hardening 1 $Ki $Fy 0.0 $Hk\nelement zeroLength 1 1 2 -mat 1 -dir 1\n" + viscous(k, q, "1.0")
    recs = "recorder Node -file disp.out -time -node 2 3 4 5 -dof 1 disp\nrecorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 5 -dof 1 accel"
    model = d.building(("Three-storey clinic on isolators", "kN, m, t, s"), ps, m, body, recs)
    dt = .01
    runs = [qrun("first", "fit", c.gm("northridge_1994_rinaldi_228", dt, 1601, .42), dt, .0105, 4),
            qrun("after", "fit", c.gm("northridge_1994_arleta_360", dt, 2001, .7), dt, .0105, 4),
            qrun("next", "holdout", c.kanai(np.random.default_rng(913), 2001, dt, 1.7, .6, 2.4, 3., 9.), dt, .0105, 4)]

    def simulate(r, on):
        B = chain(4)
        M = np.array(m)
        C = B.T @ (np.r_[0, q][:, None] * B)
        E0, H = 41000., 6100.
        b = H / (E0 + H)
        nl = [(0, d.Bil(E0, b, 250.))]
        kv = np.r_[0, k]
        if "superstructure_yielding" in on:
            kv[1] = 0
            nl.append((1, d.BW(k[0], .09, 690. * .91, 3.0)))
        t, ag, U, V, A = d.shake(r, M, C, B, kv, nl, 1e-10)
        return t, {"base_disp": U[:, 0], "roof_disp": U[:, 3], "floor1_acc": A[:, 1] + ag, "roof_acc": A[:, 3] + ag}, {}
    ch = CH(("base_disp", "m", "disp.out", 1, "isolation layer"), ("roof_disp", "m", "disp.out", 4, "roof"),
            ("floor1_acc", "m/s2", "acc.out", 2, "floor 1"), ("roof_acc", "m/s2", "acc.out", 4, "roof"))
    return dict(name="lismore", title="three-storey clinic on isolators", model=model, params=ps, runs=runs, channels=ch, simulate=simulate, noise={"*": ("ar0.6", .04)},
                seed=5403, effects=["superstructure_yielding"], cause="superstructure_yielding", difficulty="medium", confusable=["damping", "foundation_flexibility"],
                at="storey 1", note="storey 1 above the isolators yields smoothly (Bouc-Wen, exponent 3, 9 % post-yield) at 690 kN; in the second run it stays nearly elastic")


def skye():
    ps = {"rk": (1.1, .6, 1.6, 1.0), "b1": (.0024, .0006, .006, .0035)}
    m = [120., 95.]
    k = [92000., 71000.]
    body = "\n".join("uniaxialMaterial Elastic %d [expr $rk*%r]" % (i + 1, x) for i, x in enumerate(k)) + "\n" + springs(2) + "\nrayleigh 0.4 0.0 $b1 0.0"
    recs = "recorder Node -file acc.out -timeSeries 1 -time -node 1 2 3 -dof 1 accel\nrecorder Node -file disp.out -time -node 2 3 -dof 1 disp"
    model = d.building(("Two-storey house", "N, mm, t, s"), ps, m, body, recs)
    dt = .01
    runs = [qrun("sept", "fit", 1000 * c.gm("northridge_1994_castaic_090", dt, 2001, .7), dt, .011, 5),
            qrun("oct", "fit", 1000 * c.gm("petrolia_1992_riodell_ff_360", dt, 2001, .2), dt, .011, 5),
            qrun("dec", "holdout", 1000 * c.kanai(np.random.default_rng(914), 2001, dt, 2.4, .5, 3.6, 3., 9.), dt, .011, 5)]

    def simulate(r, on):
        kk = np.array(k) * 1.1
        fnd = "foundation_flexibility" in on
        M = np.r_[130., m]
        B = np.r_[chain(3), np.array([[0, 0, 1.]])]
        kv = np.r_[1.7e6, kk, 0]
        cs = np.r_[4.0e3, .0024 * kk, 0]
        if not fnd:
            M, B, kv, cs = M[1:], B[1:, 1:], kv[1:], cs[1:]
        C = B.T @ (cs[:, None] * B) + .4 * np.diag(np.r_[0, m] if fnd else M)
        nl = []
        ext = {}
        if "gap_impact" in on:
            P = d.Pound(33.0, 1.2e4, .4, 95., -1)
            nl = [(len(kv) - 1, P)]
        t, ag, U, V, A = d.shake(r, M, C, B, kv, nl, 1e-8)
        if nl:
            on_ = np.r_[False, np.array(P.on)]
            n = r["set"]["nsub"]
            ext["mask"] = np.array([on_[max(0, i * n - n + 1):i * n + 1].any() for i in range(t.size)])
        s = ag + A[:, 0] if fnd else ag
        return t, {"slab_acc": s, "floor1_acc": A[:, -2] + ag, "roof_acc": A[:, -1] + ag, "roof_disp": U[:, -1]}, ext
    ch = CH(("slab_acc", "mm/s2", "acc.out", 1, "ground slab"), ("floor1_acc", "mm/s2", "acc.out", 2, "floor 1"),
            ("roof_acc", "mm/s2", "acc.out", 3, "roof"), ("roof_disp", "mm", "disp.out", 2, "roof"))
    return dict(name="skye", accept_channels=["slab_acc", "floor1_acc", "roof_acc", "roof_disp"], where_channels=["floor1_acc", "roof_acc", "roof_disp"], title="two-storey house, three shocks", model=model, params=ps, runs=runs, channels=ch, simulate=simulate, noise={"*": ("ar0.6", .045)},
                seed=5404, effects=["gap_impact", "foundation_flexibility"], cause="pair", difficulty="medium", confusable=["damping", "unknown"],
                note="sway of the ground slab on the soil (stiffness and radiation dashpot), and the roof meets the neighbour on one side after 33 mm (Jankowski contact)")


def vatersay():
    ps = {"E0": (9500., 5000., 17000., 8000.), "Fy": (34., 18., 60., 40.), "b": (.095, .05, .18, .12)}
    model = """# Isolated machine platform on four bearings, both directions
# units: kN, m, t, s
wipe
model basic -ndm 2 -ndf 3
pset E0 8000.0
pset Fy 40.0
pset b 0.12
node 100 0.0 0.0
mass 100 480.0 480.0 9800.0
uniaxialMaterial Steel01 1 $Fy $E0 $b
foreach {i x y} {1 -6 -4 2 6 -4 3 6 4 4 -6 4} {
    node $i $x $y
    node 1$i $x $y
    fix $i 1 1 1
    rigidLink beam 100 1$i
    element zeroLength $i $i 1$i -mat 1 1 -dir 1 2
}
timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file disp.out -time -node 100 -dof 1 2 disp
recorder Node -file accx.out -timeSeries 1 -time -node 100 -dof 1 accel
recorder Node -file accy.out -timeSeries 2 -time -node 100 -dof 2 accel
""" + c.solve(num="RCM", tol="1.0e-8") + c.LOOP_T
    dt = .01

    def two(name, role, ax, ay, nsub=2):
        return dict(name=name, role=role, every=.012, dats={name + "-x.dat": ax, name + "-y.dat": ay},
                    set=dict(motionx=name + "-x.dat", motiony=name + "-y.dat", dt=dt, npts=len(ax), nsub=nsub))
    ra, rb = np.random.default_rng(915), np.random.default_rng(916)
    z = c.gm("imperial_valley_1979_meloland_ff_270", dt, 2201, 1.1)
    runs = [two("mainshock", "fit", z, c.gm("imperial_valley_1979_meloland_ff_360", dt, 2201, 1.0)),
            two("foreshock", "fit", c.gm("northridge_1994_arleta_360", dt, 2001, 1.8), c.gm("northridge_1994_castaic_090", dt, 2001, .75)),
            two("aftershock", "holdout", c.kanai(ra, 2001, dt, 1.8, .6, 2.6, 3., 9., (5., 2., .3)), c.kanai(rb, 2001, dt, 1.8, .6, 2.8, 3., 9.))]

    def simulate(r, on):
        s = r["set"]
        ax, ay = r["dats"][s["motionx"]], r["dats"][s["motiony"]]
        af = np.c_[d.fine(ax, s["nsub"]), d.fine(ay, s["nsub"])]
        M = np.array([480., 480.])
        law = d.Plane(4 * 9500., .095, 4 * 34., 2.4 if "bidirectional_coupling" in on else None)
        U, V, A = d.newmark(M, np.zeros((2, 2)), np.eye(2), np.zeros(2), [(slice(0, 2), law)], np.eye(2), af, s["dt"] / s["nsub"], s["nsub"], 1e-10)
        return np.arange(ax.size) * dt, {"disp_x": U[:, 0], "disp_y": U[:, 1], "acc_x": A[:, 0] + ax, "acc_y": A[:, 1] + ay}, {}
    ch = CH(("disp_x", "m", "disp.out", 1, "platform, x"), ("disp_y", "m", "disp.out", 2, "platform, y"),
            ("acc_x", "m/s2", "accx.out", 1, "platform, x"), ("acc_y", "m/s2", "accy.out", 1, "platform, y"))
    return dict(name="vatersay", accept_channels=["disp_x", "disp_y", "acc_x", "acc_y"], title="machine platform on four bearings", model=model, params=ps, runs=runs, channels=ch, simulate=simulate,
                noise={"*": ("ar0.6", .045)}, seed=5405, effects=["bidirectional_coupling"], cause="bidirectional_coupling", difficulty="easy",
                confusable=["friction", "torsion"],
                note="each bearing's two directions share a superelliptic yield surface (exponent 2.4, radial return); the analyst has independent springs")


CASES = [hoy, pabay, lismore, skye, vatersay]
