"""Structures under ground motion, first half."""
import numpy as np
import core as c
import dynlib as d
from dynlib import CH, qrun, chain


def springs(n, start=1, ray=True):
    return "\n".join("element zeroLength %d %d %d -mat %d -dir 1%s" % (i, i, i + 1, i, " -doRayleigh 1" if ray else "") for i in range(start, n + start))


def unst():
    ps = {"rk": (.88, .5, 1.4, 1.0), "b1": (.0027, .0005, .006, .002)}
    m = [180000., 180000., 140000.]
    k = [2.4e8, 2.0e8, 1.5e8]
    body = "\n".join("uniaxialMaterial Elastic %d [expr $rk*%r]" % (i + 1, x) for i, x in enumerate(k)) + "\n" + springs(3) + "\nrayleigh 0.35 0.0 $b1 0.0"
    recs = "recorder Node -file acc.out -timeSeries 1 -time -node 1 2 3 4 -dof 1 accel\nrecorder Node -file disp.out -time -node 2 3 4 -dof 1 disp"
    model = d.building(("School wing, three storeys", "N, m, kg, s"), ps, m, body, recs)
    dt = .01
    runs = [qrun("quake-1", "fit", c.gm("northridge_1994_castaic_090", dt, 2201, .45), dt, .011, 4),
            qrun("quake-2", "fit", c.gm("petrolia_1992_riodell_ff_360", dt, 2001, .35), dt, .011, 4),
            qrun("quake-3", "holdout", c.kanai(np.random.default_rng(901), 2201, dt, 2.2, .5, 2.6, 4., 11.), dt, .011, 4)]

    def simulate(r, on):
        kk = np.array(k) * .88
        Bs = chain(3)
        if "foundation_flexibility" not in on:
            M = np.array(m)
            C = .35 * np.diag(M) + .0027 * Bs.T @ (kk[:, None] * Bs)
            t, ag, U, V, A = d.shake(r, M, C, Bs, kk, [], 1e-11)
            s = ag
        else:
            # unknowns: slab, rocking angle, floors (all relative to the free field); impedances of a disc on a half space
            Vs, rho, rad, nu = 215., 1850., 6.5, .38
            Gs = rho * Vs ** 2
            kx, kt = 8 * Gs * rad / (2 - nu), 8 * Gs * rad ** 3 / (3 * (1 - nu))
            cx = .58 * kx * rad / Vs
            ct = .3 / (1 + 3 * (1 - nu) * 2.2e7 / (8 * rho * rad ** 5)) * kt * rad / Vs * .4
            H = np.array([3.6, 3.3, 3.3])
            B = np.zeros((5, 5))
            B[0, 0] = B[1, 1] = 1
            for i in range(3):
                B[2 + i, 2 + i] = 1
                B[2 + i, 1 + i if i else 0] = -1
                B[2 + i, 1] = -H[i]
            M = np.array([230000., 4.6e6] + m)
            ks = np.r_[kx, kt, kk]
            cs = np.r_[cx, ct, .0027 * kk]
            C = B.T @ (cs[:, None] * B) + .35 * np.diag(np.r_[0, 0, m])
            r["R"] = np.array([1, 0, 1, 1, 1.])[:, None]
            t, ag, U, V, A = d.shake(r, M, C, B, ks, [], 1e-11)
            r["R"] = None
            s = ag + A[:, 0]
            A = A[:, 2:]
        return t, {"slab_acc": s, "floor1_acc": A[:, 0] + ag, "roof_acc": A[:, 2] + ag}, {}
    ch = CH(("slab_acc", "m/s2", "acc.out", 1, "ground floor slab"), ("floor1_acc", "m/s2", "acc.out", 2, "floor 1"), ("roof_acc", "m/s2", "acc.out", 4, "roof"))
    return dict(name="unst", title="school wing, three storeys", model=model, params=ps, runs=runs, channels=ch, simulate=simulate,
                noise={"*": ("ar0.5", .035)}, seed=5301, effects=["foundation_flexibility"], cause="foundation_flexibility", difficulty="medium",
                confusable=["damping", "unknown"], at="foundation",
                note="slab on the soil: sway and rocking impedances of a disc on a half space (Vs 215 m/s, radiation damping); the analyst has a fixed base moved by the free field")


def arran():
    ps = {"k1": (255., 140., 420., 290.), "k2": (195., 100., 330., 170.)}
    m = [.52, .41]
    body = "uniaxialMaterial Elastic 1 $k1\nuniaxialMaterial Elastic 2 $k2\n" + springs(2) + "\nrayleigh 0.24 0.0 0.0016 0.0"
    recs = "recorder Node -file acc.out -timeSeries 1 -time -node 2 3 -dof 1 accel\nrecorder Node -file disp.out -time -node 2 3 -dof 1 disp"
    model = d.building(("Two-storey steel frame", "kip, in, s"), ps, m, body, recs)
    dt = .01
    inch = 39.3701
    runs = [qrun("strong", "fit", inch * c.gm("elcentro_1940_180", dt, 2401, .8), dt, .012, 3),
            qrun("weak", "fit", inch * c.gm("northridge_1994_alhambra_360", dt, 2401, .4), dt, .012, 3),
            qrun("second", "holdout", inch * c.kanai(np.random.default_rng(902), 2401, dt, 2.0, .6, 2.8, 3., 12.), dt, .012, 3)]

    def simulate(r, on):
        k = np.array([255., 195.])
        B = chain(2)
        M = np.array(m)
        C = .24 * np.diag(M) + .0016 * B.T @ (k[:, None] * B)
        nl = [(0, d.PowDash(.062, 1.6)), (1, d.PowDash(.05, 1.6))] if "damping" in on else []
        t, ag, U, V, A = d.shake(r, M, C, B, k, nl, 1e-10)
        return t, {"floor1_acc": A[:, 0] + ag, "roof_acc": A[:, 1] + ag, "roof_disp": U[:, 1]}, {}
    ch = CH(("floor1_acc", "in/s2", "acc.out", 1, "floor 1"), ("roof_acc", "in/s2", "acc.out", 2, "roof"), ("roof_disp", "in", "disp.out", 2, "roof"))
    return dict(name="arran", title="two-storey steel frame", model=model, params=ps, runs=runs, channels=ch, simulate=simulate,
                noise={"*": ("ar0.6", .045)}, seed=5302, effects=["damping"], cause="damping", difficulty="medium", confusable=["friction", "superstructure_yielding"],
                note="storeys lose more than the Rayleigh model: dashpots c|v|^1.6 in the storeys, so the missing damping grows with amplitude (less in the weak motion)")


def noss():
    ps = {"rE": (1.12, .6, 1.7, 1.0), "rF": (.86, .5, 1.5, 1.0), "b": (.055, .01, .12, .03)}
    m = [160., 160., 160., 130.]
    E = [2.6e5, 2.3e5, 1.9e5, 1.4e5]
    F = [1500., 1300., 1000., 650.]
    body = "\n".join("uniaxialMaterial Steel01 %d [expr $rF*%r] [expr $rE*%r] $b" % (i + 1, f, e) for i, (e, f) in enumerate(zip(E, F)))
    body += "\n" + springs(4) + "\nrayleigh 0.3 0.0 0.0018 0.0"
    recs = "recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 5 -dof 1 accel\nrecorder Node -file disp.out -time -node 2 3 4 5 -dof 1 disp"
    model = d.building(("Four-storey frame", "kN, m, t, s"), ps, m, body, recs)
    dt = .01
    runs = [qrun("event-a", "fit", c.gm("northridge_1994_arleta_360", dt, 2301, 1.5), dt, .012, 4),
            qrun("event-b", "fit", c.kanai(np.random.default_rng(903), 2001, dt, 1.8, .55, 4.2, 3., 9., (5., 1.1, .35)), dt, .012, 4),
            qrun("event-c", "holdout", c.gm("kobe_1995_nishi_akashi_090", dt, 2201, .9), dt, .012, 4)]

    def simulate(r, on):
        k = np.array(E) * 1.12
        B = chain(4)
        M = np.array(m)
        C = .3 * np.diag(M) + .0018 * B.T @ (k[:, None] * B)
        nl = [(i, d.Bil(k[i], .055, .86 * F[i])) for i in range(4)]
        t, ag, U, V, A = d.shake(r, M, C, B, 0 * k, nl, 1e-10)
        return t, {"floor2_acc": A[:, 1] + ag, "roof_acc": A[:, 3] + ag, "floor2_disp": U[:, 1], "roof_disp": U[:, 3]}, {}
    ch = CH(("floor2_acc", "m/s2", "acc.out", 2, "floor 2"), ("roof_acc", "m/s2", "acc.out", 4, "roof"), ("floor2_disp", "m", "disp.out", 2, "floor 2"), ("roof_disp", "m", "disp.out", 4, "roof"))
    return dict(name="noss", title="four-storey frame", model=model, params=ps, runs=runs, channels=ch, simulate=simulate,
                noise={"*": ("clicks", .045)}, seed=5303, effects=[], cause="none", difficulty="null", confusable=[],
                note="model right (storeys yield as modelled); impulsive but stationary noise: Poisson clicks with a Laplace size and a short decay")


def jura():
    ps = {"rk": (1.16, .6, 1.7, 1.0), "b1": (.0022, .0006, .005, .003)}
    m = [240000., 230000., 190000.]
    k = [3.1e8, 2.6e8, 1.9e8]
    body = "\n".join("uniaxialMaterial Elastic %d [expr $rk*%r]" % (i + 1, x) for i, x in enumerate(k)) + "\n" + springs(3) + "\nrayleigh 0.3 0.0 $b1 0.0"
    recs = "recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel\nrecorder Node -file disp.out -time -node 2 3 4 -dof 1 disp"
    model = d.building(("Laboratory building, three storeys", "N, m, kg, s"), ps, m, body, recs)
    dt = .01
    runs = [qrun("eq-1", "fit", c.gm("bigbear_1992_hospitality_180", dt, 3001, 1.3, 6.), dt, .0125, 3),
            qrun("eq-2", "fit", c.kanai(np.random.default_rng(904), 2401, dt, 2.6, .45, 1.8, 3., 9.), dt, .0125, 3),
            qrun("eq-3", "holdout", c.gm("elcentro_1940_180", dt, 2401, .6), dt, .0125, 3)]

    def simulate(r, on):
        M, kk = np.array(m), np.array(k) * 1.16
        B = chain(3)
        w, _ = np.linalg.eig(np.diag(1 / M) @ (B.T @ (kk[:, None] * B)))
        w1 = np.sqrt(np.min(w.real))
        cs = .0022 * kk
        a0 = .3 * M
        if "unknown" in on:
            mt = .005 * M.sum()
            kt = mt * (.87 * w1) ** 2
            B = np.block([[B, np.zeros((3, 1))], [np.array([[0, 0, -1., 1.]])]])
            M, kk, cs, a0 = np.r_[M, mt], np.r_[kk, kt], np.r_[cs, 2 * .012 * np.sqrt(kt * mt)], np.r_[a0, 0]
        C = np.diag(a0) + B.T @ (cs[:, None] * B)
        t, ag, U, V, A = d.shake(r, M, C, B, kk, [], 1e-11)
        return t, {"floor1_acc": A[:, 0] + ag, "roof_acc": A[:, 2] + ag, "roof_disp": U[:, 2]}, {}
    ch = CH(("floor1_acc", "m/s2", "acc.out", 1, "floor 1"), ("roof_acc", "m/s2", "acc.out", 3, "roof"), ("roof_disp", "m", "disp.out", 3, "roof"))
    return dict(name="jura", title="laboratory building, three storeys", model=model, params=ps, runs=runs, channels=ch, simulate=simulate,
                noise={"*": ("ar0.6", .045)}, seed=5304, effects=["unknown"], cause="unknown", difficulty="medium", confusable=["damping", "foundation_flexibility"],
                note="a sloshing tank on the roof (0.5 % of the mass, 0.87 of the first frequency, 1.2 % damping) acts as a small tuned mass: beats and a second peak below the first mode")


def danna():
    ps = {"Fy": (430., 220., 800., 350.), "b": (.072, .03, .15, .1), "rE": (.84, .5, 1.4, 1.0)}
    model = """# Isolated span on one pier, longitudinal
# units: kN, m, t, s
wipe
model basic -ndm 2 -ndf 3
pset Fy 350.0
pset b 0.1
pset rE 1.0    ;# pier rigidity / drawing value
node 1 0.0 0.0
node 2 0.0 8.0
node 3 0.0 8.0
fix 1 1 1 1
fix 3 0 1 1
mass 2 90.0 90.0 0.0
mass 3 700.0 700.0 0.0
geomTransf Linear 1
element elasticBeamColumn 1 1 2 2.6 [expr $rE*3.0e7] 0.9 1
uniaxialMaterial Steel01 1 $Fy 52000.0 $b
element zeroLength 2 2 3 -mat 1 -dir 1
rayleigh 0.12 0.0 0.003 0.0
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 -dof 1 accel
""" + c.solve(num="RCM", tol="1.0e-8") + c.LOOP_T
    dt = .01
    runs = [qrun("record-1", "fit", c.gm("imperial_valley_1979_meloland_ff_270", dt, 2201, .62), dt, .0115, 4),
            qrun("record-2", "holdout", c.kanai(np.random.default_rng(905), 2201, dt, 1.6, .6, 3.6, 3., 10., (6., 2.2, 1.3)), dt, .0115, 4)]

    def simulate(r, on):
        kp = 3 * .84 * 3e7 * .9 / 8 ** 3
        M = np.array([90., 700.])
        B = np.array([[1., 0], [-1, 1], [0, 1]])
        C = .12 * np.diag(M) + np.diag([.003 * kp, 0])
        nl = [(1, d.Bil(52000., .072, 430.))]
        if "gap_impact" in on:
            P = d.Pound(.204, 1.2e5, .35, 700.)
            nl.append((2, P))
        t, ag, U, V, A = d.shake(r, M, C, B, np.array([kp, 0, 0]), nl, 1e-10)
        ext = {}
        if "gap_impact" in on:
            on_ = np.r_[False, np.array(P.on)]
            n = r["set"]["nsub"]
            ext["mask"] = np.array([on_[max(0, i * n - n + 1):i * n + 1].any() for i in range(t.size)])
        return t, {"deck_disp": U[:, 1], "pier_acc": A[:, 0] + ag, "deck_acc": A[:, 1] + ag}, ext
    ch = CH(("deck_disp", "m", "disp.out", 2, "deck"), ("pier_acc", "m/s2", "acc.out", 1, "pier head"), ("deck_acc", "m/s2", "acc.out", 2, "deck"))
    return dict(name="danna", accept_channels=["deck_disp", "pier_acc", "deck_acc"], title="isolated span on one pier", model=model, params=ps, runs=runs, channels=ch, simulate=simulate,
                noise={"*": ("ar0.6", .045)}, seed=5305, effects=["gap_impact"], cause="gap_impact", difficulty="easy", confusable=["strain_stiffening", "sensor_clipping"],
                at="abutment", note="deck meets one abutment after 204 mm (one side only): Jankowski's contact beta*d^1.5 with a dashpot on approach only")


CASES = [unst, arran, noss, jura, danna]
