"""Studies whose model is a function of Python."""

import math
import pickle

import numpy as np
import pytest

import hysteron
import hysteron.opensees as ops
from hysteron import Model, OpenSeesError, OpenSeesWarning, Run, Study

pytestmark = pytest.mark.filterwarnings("ignore::hysteron.OpenSeesWarning")
DT = 0.02
#: A motion of growing amplitude, mm.
MOTION = [2.0 * t * math.sin(2.0 * math.pi * 0.5 * t) for t in (DT * i for i in range(401))]


def spring(k=3.0, fy=20.0, b=0.2, *, motion=MOTION):
    """A bilinear spring that is moved."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.node(2, 0.0)
    ops.fix(1, 1)
    ops.uniaxialMaterial("Steel01", 1, fy, k, b)
    ops.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
    ops.timeSeries("Path", 1, "-dt", DT, "-values", *motion)
    ops.pattern("Plain", 1, 1)
    ops.sp(2, 1, 1.0)
    ops.constraints("Transformation")
    ops.test("NormDispIncr", 1e-9, 50)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", DT)
    ops.analysis("Static")
    ops.analyze(len(motion) - 1)


def bilinear(u, k, fy, b):
    """The same law by hand: an elastic spring beside one with friction."""
    friction, hard, slip = (1.0 - b) * fy, b * k, 0.0
    force = []
    for x in u:
        trial = (1.0 - b) * k * (x - slip)
        trial = min(max(trial, -friction), friction)
        slip = x - trial / ((1.0 - b) * k)
        force.append(trial + hard * x)
    return np.array(force)


def recording(u, seed, extra=0.0):
    """A DataFrame, or a dictionary of arrays without pandas, of the law by hand with noise."""
    force = bilinear(u, 2.0, 12.0, 0.1)
    force = force + extra * np.sign(np.gradient(u)) + 0.02 * np.ptp(force) * np.random.default_rng(seed).standard_normal(len(u)) / 5
    return {"time": DT * np.arange(len(u)), "force": force}


OBSERVE = {"force": ("Element", "-ele", 1, "-dof", 2, "force")}
RANGES = {"k": (1.0, 5.0), "fy": (5.0, 40.0, "log"), "b": (0.02, 0.5)}


@pytest.fixture(scope="module")
def study():
    """A function and two recordings, of which one is held out."""
    other = [20.0 * math.sin(3.0 * DT * i) * math.sin(0.7 * DT * i) for i in range(301)]
    runs = [Run(recording(MOTION, 1)), Run(recording(other, 2), name="other", role="holdout", inputs={"motion": other})]
    return Study(model=spring, parameters=RANGES, runs=runs, observe=OBSERVE)


def test_a_function_is_calibrated(study):
    fit = study.calibrate(seed=1)
    assert fit.parameters == pytest.approx({"k": 2.0, "fy": 12.0, "b": 0.1}, rel=0.02)
    assert fit.table["holdout"] < 0.01 and fit.recorded["other"]["force"].shape == (301,)


def test_a_function_and_a_data_frame_are_diagnosed_in_few_lines():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(recording(MOTION, 3)).set_index("time")
    study = Study(model=spring, parameters=RANGES, runs=[table], observe=OBSERVE)
    fit, verdict = study.calibrate(seed=1), study.diagnose()
    assert fit.parameters["k"] == pytest.approx(2.0, rel=0.02)
    assert verdict.cause == "none" and "uniaxialMaterial Steel01" in verdict.script


def test_likelihoods_are_those_of_the_function(study):
    x = np.array([2.2, 13.0, 0.12])
    spring(*x)
    points = np.vstack([x, study.bounds.mean(axis=1)])
    alone = study.loglike_many(points, n=100.0)
    assert alone.tobytes() == study.loglike_many(points, n=100.0, threads=2).tobytes()
    assert pickle.loads(pickle.dumps(study)).residuals(x).tobytes() == study.residuals(x).tobytes()
    first = recording(MOTION, 1)["force"]
    expected = np.mean((bilinear(MOTION, *x) - first) ** 2) / np.var(first)
    assert study.objective(x) == pytest.approx(expected, rel=1e-6)


def test_formulas_of_parameters_are_kept():
    def model(period=1.0, zeta=0.05):
        m = Model(1, 1)
        m.node(1, 0.0)
        m.node(2, 0.0)
        m.fix(1, 1)
        m.mass(2, 2.0)
        stiffness = 2.0 * (2 * math.pi / period) ** 2
        m.uniaxialMaterial("Elastic", 1, stiffness)
        m.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1, "-doRayleigh", 1)
        m.timeSeries("Sine", 1, 0.0, 100.0, 0.8)
        m.pattern("UniformExcitation", 1, 1, "-accel", 1)
        omega = np.sqrt(m.eigen("-fullGenLapack", 1)[0])
        m.rayleigh(2 * zeta * omega, 0.0, 0.0, 0.0)
        m.integrator("Newmark", 0.5, 0.25)
        m.analysis("Transient")
        for _ in range(200):
            if m.analyze(1, 0.02) != 0:
                raise ValueError

    times = 0.02 * np.arange(1, 201)
    runs = [{"time": times, "roof": np.sin(times)}]
    study = Study(model=model, parameters={"period": (0.5, 2.0), "zeta": (0.01, 0.2)}, runs=runs, observe={"roof": ("disp", 2, 1)})
    assert "pset period 1.0" in study.script and "/$period)" in study.script and "analyze 200 0.02" in study.script
    assert "set result" in study.script and "sqrt([lindex $result" in study.script
    m = Model(1, 1)
    residuals = study.residuals([0.7, 0.1])
    # The motion by the recurrence of the linear oscillator, at half the step it is the same within its error.
    w, z, u, v, a = 2 * math.pi / 0.7, 0.1, 0.0, 0.0, 0.0
    found = []
    for i in range(1, 201):
        p = -math.sin(2 * math.pi * 0.02 * i / 0.8)
        left = 4 / 0.02**2 + 2 * z * w * 2 / 0.02 + w * w
        right = p + (4 / 0.02**2 * u + 4 / 0.02 * v + a) + 2 * z * w * (2 / 0.02 * u + v)
        new = right / left
        rate = 2 / 0.02 * (new - u) - v
        u, v, a = new, rate, p - 2 * z * w * rate - w * w * new
        found.append(u)
    data = np.sin(times)
    assert np.sum(residuals**2) == pytest.approx(np.mean((np.array(found) - data) ** 2) / np.var(data), rel=1e-9)
    assert m.getNodeTags() == []


def test_bodies_of_sections_are_kept():
    def model(e=2e8):
        m = Model(2, 3)
        m.node(1, 0.0, 0.0)
        m.node(2, 0.0, 3.0)
        m.fix(1, 1, 1, 1)
        m.uniaxialMaterial("Elastic", 1, e)
        m.section("Fiber", 1)
        m.patch("rect", 1, 10, 1, -0.1, -0.05, 0.1, 0.05)
        m.geomTransf("Linear", 1)
        m.beamIntegration("Lobatto", 1, 1, 3)
        m.element("forceBeamColumn", 1, 1, 2, 1, 1)
        m.timeSeries("Linear", 1)
        m.pattern("Plain", 1, 1)
        m.load(2, 1.0, 0.0, 0.0)
        m.integrator("LoadControl", 0.1)
        m.analysis("Static")
        m.analyze(10)

    times = 0.1 * np.arange(1, 11)
    study = Study(model=model, parameters={"e": (1e8, 3e8)}, runs=[{"time": times, "tip": times**2}], observe={"tip": ("disp", 2, 1)})
    inertia = 0.1 * sum(0.02 * y**2 for y in np.arange(-0.09, 0.1, 0.02))
    expected = np.mean((times * 27.0 / (3 * 1.5e8 * inertia) - times**2) ** 2) / np.var(times**2)
    assert study.objective([1.5e8]) == pytest.approx(expected, rel=1e-6)


def test_loads_behind_an_analysis_stay_there():
    def model(k=3.0):
        m = Model(1, 1)
        m.node(1, 0.0)
        m.node(2, 1.0)
        m.fix(1, 1)
        m.uniaxialMaterial("Elastic", 1, k)
        m.element("truss", 1, 1, 2, 1.0, 1)
        m.timeSeries("Linear", 1)
        m.pattern("Plain", 1, 1)
        m.load(2, 1.0)
        # A query that nothing follows from leaves the body open.
        m.nodeCoord(2)
        m.load(2, 0.5)
        m.parameter(1, "element", 1, "E")
        m.integrator("LoadControl", 0.5)
        m.analysis("Static")
        m.sensitivityAlgorithm("-computeAtEachStep")
        m.analyze(2)
        # The derivative of 1.5 / k.
        m.load(2, -(k**2) * m.sensNodeDisp(2, 1, 1))
        m.analyze(2)

    times = 0.5 * np.arange(1, 5)
    study = Study(model=model, parameters={"k": (1.0, 9.0)}, runs=[{"time": times, "u": times**2}], observe={"u": ("disp", 2, 1)})
    body, behind = study.script.split("analyze 2")[:2]
    assert "{\n    load 2 1.0\n    load 2 0.5\n}" in body and "nodeCoord" not in study.script
    assert "set result" in behind and behind.count("load 2 [expr") == 1 and "-pattern 1" in behind
    simulated = times * np.array([1.5, 1.5, 3.0, 3.0]) / 2.0
    expected = np.mean((simulated - times**2) ** 2) / np.var(times**2)
    assert study.objective([2.0]) == pytest.approx(expected, rel=1e-6)


def test_what_cannot_be_recorded_is_said():
    def lost(k=3.0):
        spring(math.sqrt(k) ** 2)

    def branched(k=3.0):
        spring(k)
        if k > 3.2:
            ops.analyze(1)

    def empty(k=3.0):
        assert k

    one = {"runs": [recording(MOTION, 1)], "observe": OBSERVE, "parameters": {"k": (1.0, 5.0)}}
    with pytest.raises(OpenSeesError, match=r"uniaxialMaterial: argument 4 depends on k(.|\n)*test_functions.py:\d+(.|\n)*numpy.sqrt"):
        Study(model=lost, **one)
    with pytest.raises(OpenSeesError, match=r"analyze: argument 1 depends on k(.|\n)*compares at .*test_functions.py:\d+"):
        Study(model=branched, **one)
    with pytest.raises(OpenSeesError, match="no analysis was recorded"):
        Study(model=empty, **one)
    with pytest.raises(OpenSeesError, match="no times"):
        Study(model=spring, **(one | {"runs": [{"force": [1.0, 2.0]}]}))
    with pytest.raises(OpenSeesError, match="either the file"):
        Study()


def test_a_branch_that_is_kept_is_a_warning():
    def model(k=3.0):
        spring(k)
        if ops.nodeDisp(2, 1) > 1e9:
            ops.remove("recorders")

    with pytest.warns(OpenSeesWarning, match="keeps the branch") as said:
        study = Study(model=model, parameters={"k": (1.0, 5.0)}, runs=[recording(MOTION, 1)], observe=OBSERVE)
    assert [w.filename for w in said] == [__file__]
    assert study.names == ["k"] and hysteron.opensees.getNodeTags() == [1, 2]


def test_the_recorded_calls_end_with_the_function():
    spring()
    before = type(ops.nodeDisp(2, 1))
    with pytest.raises(ZeroDivisionError):
        Study(model=lambda k: k / 0.0, parameters={"k": (1.0, 2.0)}, runs=[recording(MOTION, 1)], observe=OBSERVE)
    assert type(ops.nodeDisp(2, 1)) is before is float
