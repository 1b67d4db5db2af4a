"""Scripts, studies and batches: results, errors, interruptions, and the workers of Dask."""

import os
import pickle
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import hysteron
from hysteron import Model, OpenSeesError, Study

INPUTS = Path(__file__).resolve().parents[3] / "tcl-like-inputs"
pytestmark = pytest.mark.filterwarnings("ignore::hysteron.OpenSeesWarning")


@pytest.fixture
def pad():
    """Two tests of a rubber pad, with three parameters."""
    return Study(INPUTS / "pad_study" / "study.toml")


@pytest.fixture(scope="module")
def client():
    """Workers of Dask on this machine, each a process."""
    distributed = pytest.importorskip("distributed", reason="needs Dask: pip install distributed")
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def test_a_script_gives_its_text_and_messages(tmp_path):
    script = tmp_path / "model.tcl"
    script.write_text("model basic -ndm 1\nnode 1 [lindex $argv 0]\nputs [nodeCoord 1 1]\n")
    result = hysteron.run(script, [2.5])
    assert result and result.status == 0 and result.out == "2.5\n" and result.messages == []
    script.write_text("model basic -ndm 1\nnode 1 abc\n")
    result = hysteron.run(script)
    (message,) = [m for m in result.messages if m.severity == "error"]
    assert not result and result.status == 2
    assert (message.line, message.column) == (2, 8) and message.file.endswith("model.tcl")


def test_a_check_lists_all_mistakes_and_runs_nothing(tmp_path):
    script = tmp_path / "model.tcl"
    script.write_text("model basic -ndm 1\nnode 1 abc\nnode 2 1.0\nuniaxialMaterial Stel01 1 1 1 1\nputs done\n")
    result = hysteron.check(script)
    assert result.status == 2 and [m.line for m in result.messages if m.severity == "error"] == [2, 4]
    assert any("Steel01" in h for m in result.messages for h in m.help)


def test_errors_have_the_place_in_python():
    with pytest.raises(OpenSeesError) as error:
        Model(1, 1).uniaxialMaterial("Stel01", 1, 1.0, 1.0, 1.0)
    here = error.value
    assert here.file == __file__ and here.line == sys._getframe().f_lineno - 2
    assert here.column is None and "Steel01" in here.hint and "usage" not in here.hint
    assert OpenSeesError("by hand").file is None


def test_errors_of_a_study_have_the_place_in_its_file(tmp_path):
    file = tmp_path / "study.toml"
    file.write_text('title = "x"\nmodell = "pad.tcl"\n')
    with pytest.raises(OpenSeesError) as error:
        Study(file)
    assert error.value.file == str(file) and error.value.line == 2 and error.value.column == 1
    assert "model" in error.value.hint


def test_a_calibration_is_an_object_with_arrays(pad):
    fit = pad.calibrate(evaluations=300, seed=1)
    assert list(fit.parameters) == pad.names == ["k0", "Qd", "alpha"]
    x = np.array(list(fit.parameters.values()))
    assert np.array_equal(fit.x, x) and np.all((fit.intervals[:, 0] < x) & (x < fit.intervals[:, 1]))
    assert fit.objective == pytest.approx(pad.objective(x), rel=1e-9) and fit.objective < 0.05
    assert fit.recorded["growing"]["force"].shape == fit.simulated["growing"]["force"].shape
    assert np.sum(pad.residuals(x) ** 2) == pytest.approx(fit.objective, rel=1e-9)
    assert "Calibration" in repr(fit) and fit.table["objective"] == fit.objective


def test_a_diagnosis_is_an_object_with_its_script(pad):
    verdict = pad.diagnose(threads=2)
    assert isinstance(verdict.cause, str) and 0.0 <= verdict.confidence <= 1.0
    assert "model" in verdict.script and verdict.cause in repr(verdict)
    for run, channels in verdict.recorded.items():
        for channel, samples in channels.items():
            assert samples.shape == verdict.simulated[run][channel].shape


def test_likelihoods_are_the_same_for_any_number_of_threads(pad):
    points = pad.bounds[:, 0] + np.random.default_rng(1).random((40, 3)) * np.ptp(pad.bounds, axis=1)
    alone = pad.loglike_many(points)
    assert alone.tobytes() == pad.loglike_many(points, threads=3).tobytes()
    assert alone[7] == pad.loglike(points[7])
    objectives, residuals = pad.objective_many(points, threads=2), pad.residuals_many(points, threads=2)
    assert objectives.tobytes() == np.array([pad.objective(p) for p in points]).tobytes()
    assert residuals.shape[0] == 40 and residuals[7].tobytes() == pad.residuals(points[7]).tobytes()
    assert pad.objective_many(pad.bounds[None, :, 1] * 2).tolist() == [np.inf]
    with pytest.raises(OpenSeesError, match="row 1 of x is outside of the bounds"):
        pad.residuals_many(np.array([points[0], pad.bounds[:, 1] * 2]))
    assert pad.loglike(pad.bounds[:, 1] * 2) == -np.inf


def test_a_likelihood_counts_the_independent_samples_of_the_intervals(pad):
    x = pad.bounds.mean(axis=1)
    n = pad.effective_samples()
    assert 10 < n < pad.samples and n == pad.calibrate().table["uncertainty"]["effective_samples"]
    assert pad.loglike(x) == pytest.approx(-0.5 * n * np.log(pad.objective(x)), rel=1e-12)
    assert pad.loglike(x, n=7.0) == pytest.approx(-3.5 * np.log(pad.objective(x)), rel=1e-12)


def test_arrays_that_are_not_aligned_are_taken(pad):
    points = np.frombuffer(b"0" + np.repeat(pad.bounds.mean(axis=1)[None], 4, axis=0).tobytes(), offset=1).reshape(4, 3)
    assert not points.flags.aligned
    assert np.all(pad.loglike_many(points) == pad.loglike(points[0]))
    model = Model(1, 1)
    model.timeSeries("Path", 1, "-dt", 0.1, "-values", *points[0])
    model.timeSeries("Path", 2, "-dt", 0.1, "-values", points[0])
    model.node(1, points[0, :1])
    assert model.nodeCoord(1, 1) == points[0, 0]


def test_the_workers_of_dask_evaluate_with_the_same_bits(pad, client):
    points = pad.bounds[:, 0] + np.random.default_rng(2).random((60, 3)) * np.ptp(pad.bounds, axis=1)
    x = points[0]
    assert pad.loglike_many(points).tobytes() == pad.loglike_many(points, client=client).tobytes()
    assert pad.residuals(x).tobytes() == pad.residuals(x, client=client).tobytes()
    assert pad.loglike(x) == pad.loglike(x, client=client) and pad.objective(x) == pad.objective(x, client=client)
    assert pad.loglike_many(np.empty((0, 3)), client=client).shape == (0,)
    assert pad.objective_many(points).tobytes() == pad.objective_many(points, client=client).tobytes()
    assert pad.residuals_many(points[:9]).tobytes() == pad.residuals_many(points[:9], client=client).tobytes()


def cases_of(folder):
    """All files of a batch by their names, but those that name folders of this machine."""
    files = (p for p in sorted(folder.rglob("*")) if p.is_file() and p.name != "inputs.json")
    return {str(p.relative_to(folder)): p.read_bytes() for p in files}


def test_a_batch_gives_the_table_of_the_command(tmp_path, client):
    plan = INPUTS / "batch_study" / "plan.toml"
    table = hysteron.batch(plan, tmp_path / "threads", threads=2)
    assert len(table) == 12 and table.failed == 0 and set(table["status"]) == {"done"}
    assert table["displacement"].dtype == float and np.all(np.abs(table["displacement"]) < 2.0)
    assert table.csv == (tmp_path / "threads" / "results.csv").read_text()
    hysteron.batch(plan, tmp_path / "workers", client=client)
    assert cases_of(tmp_path / "threads") == cases_of(tmp_path / "workers")
    command = shutil.which("hysteron") or os.environ.get("HYSTERON")
    if command:
        subprocess.run([command, "batch", plan, "--out", tmp_path / "command"], check=True, capture_output=True)
        assert cases_of(tmp_path / "threads") == cases_of(tmp_path / "command")


def slow_plan(folder, cases):
    """A plan whose cases take about a tenth of a second."""
    (folder / "slow.tcl").write_text(
        "pset k 1.0\nset sum 0.0\nfor {set i 0} {$i < 150000} {incr i} {set sum [expr {$sum + $k / ($i + 1.0)}]}\n"
    )
    plan = folder / "plan.toml"
    plan.write_text(f'scripts = ["slow.tcl"]\nresults = ["sum"]\n[grid]\nk = {{ from = 1.0, to = 2.0, points = {cases} }}\n')
    return plan


def test_a_worker_that_is_killed_changes_nothing(tmp_path, client):
    plan = slow_plan(tmp_path, 64)
    alone = hysteron.batch(plan, tmp_path / "alone")
    pids = list(client.run(os.getpid).values())
    killed = []

    def kill():
        time.sleep(0.5)
        os.kill(pids[0], 9)
        killed.append(pids[0])

    thread = threading.Thread(target=kill)
    thread.start()
    workers = hysteron.batch(plan, tmp_path / "workers", client=client)
    thread.join()
    assert killed and alone.csv == workers.csv and len(workers) == 64
    assert cases_of(tmp_path / "alone") == cases_of(tmp_path / "workers")


def test_a_batch_goes_on_where_it_was(tmp_path):
    plan = slow_plan(tmp_path, 4)
    first = hysteron.batch(plan, tmp_path / "out")
    victim = next((tmp_path / "out" / "cases").iterdir())
    kept = {p: p.stat().st_mtime_ns for p in (tmp_path / "out" / "cases").iterdir() if p != victim}
    shutil.rmtree(victim)
    assert hysteron.batch(plan, tmp_path / "out", resume=True).csv == first.csv
    assert all(p.stat().st_mtime_ns == t for p, t in kept.items()) and victim.is_dir()


def test_a_wrong_plan_is_refused(tmp_path):
    (tmp_path / "plan.toml").write_text('scripts = []\nresults = ["x"]\n')
    with pytest.raises(OpenSeesError, match="at least one script"):
        hysteron.batch(tmp_path / "plan.toml", tmp_path / "out")


def test_studies_are_pickled_and_models_say_that_they_are_not(pad, frame):
    x = pad.bounds.mean(axis=1)
    assert pickle.loads(pickle.dumps(pad)).residuals(x).tobytes() == pad.residuals(x).tobytes()
    with pytest.raises(TypeError, match="builds its own"):
        pickle.dumps(frame)


@pytest.mark.parametrize("work", ["study.loglike_many(points)", "hysteron.batch(plan, folder)"])
def test_ctrl_c_ends_work_in_rust(work, tmp_path):
    plan = slow_plan(tmp_path, 2000)
    script = f"""
import _thread, threading, time, warnings, numpy as np, hysteron
warnings.simplefilter("ignore")
study = hysteron.Study({str(INPUTS / "pad_study" / "study.toml")!r})
points = np.repeat(study.bounds.mean(axis=1)[None], 200_000, axis=0)
plan, folder = {str(plan)!r}, {str(tmp_path / "out")!r}
threading.Timer(0.5, _thread.interrupt_main).start()
began = time.monotonic()
try:
    {work}
except KeyboardInterrupt:
    print("interrupted", time.monotonic() - began < 10)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert done.stdout.split() == ["interrupted", "True"], done.stderr


def test_other_threads_run_while_a_study_is_evaluated(pad):
    points = np.repeat(pad.bounds.mean(axis=1)[None], 1500, axis=0)
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.002)

    thread = threading.Thread(target=tick)
    thread.start()
    began = time.monotonic()
    pad.loglike_many(points)
    took = time.monotonic() - began
    done.set()
    thread.join()
    assert sum(began < t < began + took for t in ticks) > 20


def test_a_step_that_fails_is_made_again_the_same():
    """After a failure the tangents are those of the committed state, as before the step."""
    model = Model(2, 3)
    for tag, x, y in [(1, 0.0, 0.0), (2, 360.0, 0.0), (3, 0.0, 144.0), (4, 360.0, 144.0)]:
        model.node(tag, x, y)
    model.fix(1, 1, 1, 1)
    model.fix(2, 1, 1, 1)
    model.uniaxialMaterial("Concrete01", 1, -6.0, -0.004, -5.0, -0.014)
    model.uniaxialMaterial("Concrete01", 2, -5.0, -0.002, 0.0, -0.006)
    model.uniaxialMaterial("Steel01", 3, 60.0, 30000.0, 0.01)
    model.section("Fiber", 1)
    model.patch("rect", 1, 10, 1, -10.5, -6.0, 10.5, 6.0)
    for corners in [(-12, 6, 12, 7.5), (-12, -7.5, 12, -6), (-12, -6, -10.5, 6), (10.5, -6, 12, 6)]:
        model.patch("rect", 2, 10 if corners[2] == 12 and corners[0] == -12 else 2, 1, *corners)
    for y, bars in [(10.5, 3), (0.0, 2), (-10.5, 3)]:
        model.layer("straight", 3, bars, 0.6, y, 6.0, y, -6.0)
    model.beamIntegration("Lobatto", 1, 1, 5)
    model.geomTransf("PDelta", 1)
    model.element("forceBeamColumn", 1, 1, 3, 1, 1)
    model.element("forceBeamColumn", 2, 2, 4, 1, 1)
    model.geomTransf("Linear", 2)
    model.element("elasticBeamColumn", 3, 3, 4, 360.0, 4030.0, 8640.0, 2)
    model.timeSeries("Linear", 1)
    model.pattern("Plain", 1, 1)
    model.load(3, 0.0, -180.0, 0.0)
    model.load(4, 0.0, -180.0, 0.0)
    model.test("NormDispIncr", 1e-12, 10)
    model.integrator("LoadControl", 0.1)
    model.analysis("Static")
    assert model.analyze(10) == 0
    model.loadConst("-time", 0.0)
    model.pattern("Plain", 2, 1)
    model.load(3, 10.0, 0.0, 0.0)
    model.load(4, 10.0, 0.0, 0.0)
    model.integrator("DisplacementControl", 3, 1, 0.1, 1, 0.1, 0.1)
    while model.analyze(1) == 0:
        assert model.nodeDisp(3, 1) < 15.0, "no step fails"
    norms = model.testNorms()
    assert model.analyze(1) != 0 and model.testNorms() == norms
