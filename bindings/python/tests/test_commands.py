"""Commands: their words, answers and messages."""

import gc
import random
import subprocess
import sys
import warnings

import numpy as np
import pytest

import hysteron
from hysteron import Model, OpenSeesError, OpenSeesWarning
from hysteron._model import USAGES
from hysteron._scope import REASONS

#: Deflection of the cantilever: P L^3 / (3 E I).
DEFLECTION = 10.0 * 3.0**3 / (3 * 2e8 * 1e-4)


def test_answers_have_the_types_of_openseespy(frame):
    assert frame.analyze(2) == 0
    assert frame.nodeDisp(2, 1) == pytest.approx(DEFLECTION, rel=1e-12)
    assert isinstance(frame.nodeDisp(2, 1), float) and isinstance(frame.nodeDisp(2), list)
    assert len(frame.nodeDisp(2)) == 3
    assert frame.nodeReaction(1, 1) == pytest.approx(-10.0)
    assert frame.getTime() == 1.0
    assert frame.getNodeTags() == [1, 2] and frame.eleNodes(1) == [1, 2]
    assert frame.eleForce(1) == frame.eleResponse(1, "force")
    assert frame.eleForce(1, 1) == pytest.approx(-10.0)
    assert isinstance(frame.eigen(1), list)
    assert frame.nodeEigenvector(2, 1)[0] == frame.nodeEigenvector(2, 1, 1)
    assert frame.getPatterns() == [1] and frame.getParamTags() == []
    assert frame.wipe() is None and frame.getNodeTags() == []
    assert isinstance(frame.version(), str)


def test_words_are_flattened_and_numbers_of_numpy_are_numbers():
    model = Model(2, 2)
    model.node(np.int64(1), np.array([0.0, 0.0]))
    model.node(2, (np.float32(4.0), 0))
    model.node([3, [2.0, 1.5]])
    model.fix(1, *np.ones(2, dtype=int))
    assert model.nodeCoord(2) == [4.0, 0.0] and model.nodeCoord(3, 2) == 1.5
    assert model.getFixedDOFs(1) == [1, 2]


def test_reactions_follow_the_state(frame):
    frame.analyze(1)
    assert frame.nodeReaction(1, 1) == pytest.approx(-5.0)
    frame.analyze(1)
    assert frame.nodeReaction(1, 1) == pytest.approx(-10.0)


def test_fibers_follow_their_section():
    def moment(order):
        model = Model(2, 3)
        model.node(1, 0.0, 0.0)
        model.node(2, 0.0, 3.0)
        model.fix(1, 1, 1, 1)
        model.uniaxialMaterial("Elastic", 1, 2e8)
        model.section("Fiber", 1)
        model.patch("rect", 1, 10, 1, -0.1, -0.05, 0.1, 0.05)
        if order == "between":
            model.geomTransf("Linear", 1)
        model.layer("straight", 1, 2, 0.001, 0.09, 0.0, -0.09, 0.0)
        model.fiber(0.0, 0.0, 0.001, 1)
        if order == "behind":
            model.geomTransf("Linear", 1)
        model.beamIntegration("Lobatto", 1, 1, 3)
        model.element("forceBeamColumn", 1, 1, 2, 1, 1)
        model.timeSeries("Linear", 1)
        model.pattern("Plain", 1, 1)
        model.load(2, 1.0, 0.0, 0.0)
        model.analysis("Static")
        assert model.analyze(1) == 0
        return model.nodeDisp(2, 1)

    inertia = 0.1 * sum(0.02 * y**2 for y in np.arange(-0.09, 0.1, 0.02)) + 2 * 0.001 * 0.09**2
    assert moment("between") == pytest.approx(27.0 / (3 * 2e8 * inertia), rel=1e-6)
    assert moment("between") == moment("behind")


@pytest.mark.parametrize(
    ("words", "parts"),
    [
        (("uniaxialMaterial", "Stel01", 1, 250.0, 2e5, 0.01), ["'Stel01'", '"Steel01"', "^^^^^^^^"]),
        (("node", 3, "abc", 0.0), ["not a number", "'abc'", "usage: node(tag"]),
        (("nodeDisp", 99), ["there is no node 99"]),
        (("nodeDisp", 2, 9), ["degree of freedom", "1 to 3"]),
        (("element", "Truss", 7, 1, 2, 1.0, 55), ["uniaxial material 55"]),
        (("load", 2, 1.0), ["degree of freedom 2", "missing"]),
        (("fix", 1, None), ["argument 2 is None"]),
        (("mass", 2, float("nan"), 1.0, 1.0), ["number"]),
        (("eigen", 10**30), ["64 bits"]),
    ],
)
def test_a_wrong_word_is_named(frame, words, parts):
    before = frame.getNodeTags()
    with pytest.raises(OpenSeesError) as error:
        getattr(frame, words[0])(*words[1:])
    for part in parts:
        assert part in str(error.value)
    assert frame.getNodeTags() == before


def test_an_unknown_name_gives_the_nearest(frame, ops):
    with pytest.raises(AttributeError, match="nodeDisp"):
        frame.nodeDips
    with pytest.raises(AttributeError):
        ops.uniaxialMatrial
    # Python names it where it shows the error.
    program = "import hysteron.opensees as ops\nops.uniaxialMatrial"
    shown = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True).stderr
    assert "Did you mean: 'uniaxialMaterial'" in shown


def test_all_names_of_openseespy_are_there(ops):
    openseespy = pytest.importorskip("openseespy.opensees")
    names = [n for n in dir(openseespy) if not n.startswith("_") and n != "sys"]
    assert len(names) > 200
    assert [n for n in names if not hasattr(ops, n)] == []


def test_what_is_out_of_scope_says_so(ops):
    assert set(REASONS).isdisjoint(USAGES)
    for name in REASONS:
        with pytest.raises(OpenSeesError, match=f"{name} is out of hysteron's scope"):
            getattr(ops, name)()


def test_a_failed_analysis_is_a_code():
    model = Model(2, 2)
    model.node(1, 0.0, 0.0)
    model.node(2, 1.0, 0.0)
    model.fix(1, 1, 1)
    model.uniaxialMaterial("ElasticPP", 1, 100.0, 0.01)
    model.element("Truss", 1, 1, 2, 1.0, 1)
    model.fix(2, 0, 1)
    model.timeSeries("Linear", 1)
    model.pattern("Plain", 1, 1)
    model.load(2, 1.0, 0.0)
    model.test("NormUnbalance", 1e-8, 5)
    model.integrator("LoadControl", 0.9)
    model.analysis("Static")
    assert model.analyze(1) == 0
    with pytest.warns(OpenSeesWarning):
        code = model.analyze(1)
    assert isinstance(code, int) and code < 0


def test_a_warning_is_an_error_under_strict():
    with pytest.warns(OpenSeesWarning, match="not an option"):
        Model(1, 1).timeSeries("Linear", 1, "-faktor", 2.0)
    with pytest.raises(OpenSeesError, match="not an option"):
        Model(1, 1, strict=True).timeSeries("Linear", 1, "-faktor", 2.0)


def test_joint_offsets_without_numbers_are_zero():
    model = Model(2, 3)
    with pytest.warns(OpenSeesWarning, match="offsets are missing"):
        model.geomTransf("Linear", 1, "-jntOffset")
    with pytest.raises(OpenSeesError, match="offset at node i"):
        model.geomTransf("Linear", 2, "-jntOffset", 0.1)
    assert model.getCrdTransfTags() == [1]


def test_an_unknown_response_is_empty_as_in_openseespy(frame):
    frame.analyze(1)
    with pytest.warns(OpenSeesWarning, match="no response"):
        assert frame.eleResponse(1, "nonsense") == []


def test_models_are_independent(frame):
    other = Model(1, 1)
    other.node(1, 0.0)
    assert frame.getNodeTags() == [1, 2] and other.getNodeTags() == [1]


def test_histories_are_arrays(frame, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    frame.recorder("Node", "-file", "u.out", "-time", "-node", 2, "-dof", 1, "disp")
    record = {"u": ("disp", 2, 1), "both": ("disp", [1, 2], 1, 2), "force": ("Element", "-ele", 1, "force")}
    histories = frame.analyze(4, record=record)
    frame.wipe()
    written = np.loadtxt(tmp_path / "u.out")
    assert histories.code == 0
    assert histories["u"].shape == (4,) and histories["both"].shape == (4, 4) and histories["force"].shape == (4, 6)
    np.testing.assert_allclose(histories["time"], written[:, 0])
    np.testing.assert_allclose(histories["u"], written[:, 1], rtol=1e-4)


def test_files_go_to_the_folder_of_the_process(frame, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    frame.recorder("Node", "-file", "u.out", "-node", 2, "-dof", 1, "disp")
    frame.analyze(2)
    # As in programs for openseespy, which read files of recorders that are still at work.
    assert len((tmp_path / "u.out").read_text().splitlines()) == 2
    frame.remove("recorders")
    assert len((tmp_path / "u.out").read_text().splitlines()) == 2


def test_other_threads_run_during_an_analysis_and_models_move_between_them():
    from concurrent.futures import ThreadPoolExecutor

    def build(stiffness):
        model = Model(1, 1)
        model.node(1, 0.0)
        model.node(2, 0.0)
        model.fix(1, 1)
        model.mass(2, 1.0)
        model.uniaxialMaterial("Elastic", 1, stiffness)
        model.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
        model.timeSeries("Constant", 1)
        model.pattern("Plain", 1, 1)
        model.load(2, 1.0)
        model.integrator("Newmark", 0.5, 0.25)
        model.analysis("Transient")
        assert model.analyze(2000, 0.01) == 0
        return model

    with ThreadPoolExecutor(4) as pool:
        models = list(pool.map(build, [1.0 + i for i in range(8)]))
    alone = [build(1.0 + i).nodeDisp(2, 1) for i in range(8)]
    assert [m.nodeDisp(2, 1) for m in models] == alone


def test_ctrl_c_ends_an_analysis():
    script = """
import _thread, threading, hysteron
m = hysteron.Model(1, 1)
m.node(1, 0.0); m.node(2, 0.0); m.fix(1, 1); m.mass(2, 1.0)
m.uniaxialMaterial("Elastic", 1, 1.0)
m.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
m.integrator("Newmark", 0.5, 0.25); m.analysis("Transient")
threading.Timer(0.5, _thread.interrupt_main).start()
try:
    m.analyze(2_000_000_000, 0.001)
except KeyboardInterrupt:
    print("interrupted", m.getTime() > 0, m.analyze(10, 0.001))
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    assert done.stdout.split() == ["interrupted", "True", "0"], done.stderr


def test_memory_stays_flat_over_many_models():
    resource = pytest.importorskip("resource")

    def used():
        gc.collect()
        with open("/proc/self/statm") as f:
            return int(f.read().split()[1]) * resource.getpagesize()

    def one():
        model = Model(2, 3)
        for i in range(50):
            model.node(i, float(i), 0.0)
        with pytest.raises(OpenSeesError):
            model.uniaxialMaterial("Stel01", 1)
        for _ in range(200):
            model.nodeCoord(1)

    if not sys.platform.startswith("linux"):
        pytest.skip("reads /proc")
    for _ in range(50):
        one()
    before = used()
    for _ in range(300):
        one()
    assert used() - before < 8e6


def test_random_calls_raise_at_most_the_errors_of_commands():
    chance = random.Random(1)
    kinds = {name: [k for names, _ in kinds for k in names] for name, (_, kinds) in USAGES.items()}
    names = sorted(n for n in USAGES if hasattr(Model, n) and n not in {"print", "printModel", "figure", "plot"})
    words = [0, 1, 2, -1, 3.5, 1e308, "-node", "-dof", "-ele", "x", "", [1, 2], (), 10**9, "1", True, -0.0]

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for _ in range(30):
            model = Model(2, 3)
            for _ in range(150):
                name = chance.choice(names)
                given = [chance.choice(words) for _ in range(chance.randrange(9))]
                if kinds[name] and chance.random() < 0.9:
                    given = [chance.choice(kinds[name]), *given]
                if any("-file" in str(g) for g in given) or name in {"recorder", "analyze", "record"}:
                    continue
                try:
                    getattr(model, name)(*given)
                except OpenSeesError as error:
                    assert str(error)
                except TypeError:
                    assert name == "getTime"


def test_stubs_are_those_of_the_usages():
    from importlib.resources import files

    from hysteron._stubs import stubs

    for file, text in stubs().items():
        assert (files(hysteron) / file).read_text(encoding="utf-8") == text, "python -m hysteron._stubs renews them"


def test_a_checker_of_types_knows_the_commands(tmp_path):
    pytest.importorskip("mypy", reason="needs mypy: pip install mypy")
    program = """
import numpy as np

import hysteron.opensees as ops
from hysteron import Model, Study

model = Model(ndm=2, ndf=3)
model.node(1, 0.0, np.float64(1.0))
tags: list[int] = ops.getNodeTags()
time: float = model.getTime()
{}
"""
    for line, status in [("code = model.analyze(1)", 0), ("text: str = model.getTime()", 1), ("model.nodeDips(1)", 1)]:
        file = tmp_path / "program.py"
        file.write_text(program.format(line))
        command = [sys.executable, "-m", "mypy", "--no-incremental", "--cache-dir", str(tmp_path / "cache"), str(file)]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == status, done.stdout + done.stderr


def test_a_model_is_shown_as_a_page(frame, tmp_path):
    frame.watch()
    frame.analyze(4)
    page = frame.plot(tmp_path / "model.html", title="a <frame>", units=("kN", "m"), modes=1)
    text = (tmp_path / "model.html").read_text()
    assert text == page.html and "a &lt;frame&gt;" in text and "<script" in text and len(text) < 3e6
    assert page._repr_html_().startswith("<iframe") and frame.plot().html != page.html
    assert frame.analyze(1) == 0
    with pytest.raises(OpenSeesError, match="no nodes"):
        Model(1, 1).plot()


def test_units_are_variables_of_the_script(ops):
    import __main__

    ops.defaultUnits("-force", "kN", "-length", "m", "-time", "sec", "-temp", "C")
    assert (__main__.kN, __main__.m, __main__.sec) == (1.0, 1.0, 1.0)
    assert __main__.kip == pytest.approx(4.4482216152605) and __main__.g == pytest.approx(9.80665, rel=1e-5)
    with pytest.raises(OpenSeesError, match="-length is missing"):
        ops.defaultUnits("-force", "kN", "-time", "sec")
    with pytest.raises(OpenSeesError, match="unknown unit of force 'Kn'"):
        ops.defaultUnits("-force", "Kn", "-length", "m", "-time", "sec")


def test_texts_may_have_spaces_at_their_ends():
    model = Model(1, 1)
    model.node(1, 0.0)
    model.fix(1, 1)
    assert model.nodeDisp(1, 1) == 0.0
    model.timeSeries("Linear ", 1, " -factor", 2.0)
    assert model.getNodeTags() == [1]


def test_joint_offsets_are_a_response():
    model = Model(2, 3)
    model.node(1, 0.0, 0.0)
    model.node(2, 4.0, 0.0)
    model.geomTransf("Linear", 1, "-jntOffset", 0.5, 0.0, -0.25, 0.0)
    model.element("elasticBeamColumn", 1, 1, 2, 0.01, 2e8, 1e-4, 1)
    assert model.eleResponse(1, "offsets") == [0.5, 0.0, 0.0, -0.25, 0.0, 0.0]


def test_settings_of_the_drop_in():
    code = """
import hysteron
ops = hysteron.install(strict=True)
import openseespy.opensees as other
assert other is ops
ops.wipe(); ops.model("basic", "-ndm", 1, "-ndf", 1)
try:
    ops.timeSeries("Linear", 1, "-faktor", 2.0)
except hysteron.OpenSeesError:
    print("strict")
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout == "strict\n", done.stderr


def test_usages_are_there_for_every_command():
    assert hysteron.commands()["nodeDisp"] == "nodeDisp(node, <dof>)"
    assert "Steel01" in hysteron.commands("uniaxialMaterial")


def test_nodes_that_come_after_the_modes_take_no_part_in_them(frame):
    lam = frame.eigen(1)
    frame.node(3, 1.0, 1.0)
    assert frame.nodeEigenvector(3, 1) == [0.0, 0.0, 0.0] and frame.nodeEigenvector(2, 1, 1) != 0.0
    assert frame.modalProperties("-return")["eigenLambda"] == pytest.approx(lam)


def test_an_exception_of_a_number_is_the_callers():
    class Broken:
        def __float__(self):
            raise ZeroDivisionError("no number")

    class Counted:
        def __index__(self):
            return 1

    model = Model(1, 1)
    with pytest.raises(ZeroDivisionError, match="no number"):
        model.node(1, Broken())
    model.node(Counted(), 0.5)
    assert model.nodeCoord(1, 1) == 0.5


def test_texts_are_not_run_as_scripts(tmp_path):
    model = Model(2, 2)
    model.timeSeries("Linear", 1)
    made = tmp_path / "made"
    with pytest.raises(OpenSeesError, match="not run as a script"):
        model.pattern("Plain", 1, 1, f"close [open {made} w]")
    assert not made.exists()


def test_the_matrix_of_a_diagonal_system_is_its_diagonal(ops):
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.node(1, 0.0, 0.0)
    ops.node(2, 0.0, 3.0, "-mass", 2.0, 3.0, 0.5)
    ops.fix(1, 1, 1, 1)
    ops.geomTransf("Linear", 1)
    ops.element("elasticBeamColumn", 1, 1, 2, 0.01, 2e8, 1e-4, 1)
    ops.algorithm("Linear")
    ops.system("Diagonal")
    ops.integrator("GimmeMCK", 1.0, 0.0, 0.0)
    ops.analysis("Transient")
    ops.analyze(1, 0.0)
    # As programs read the masses of a model.
    assert ops.printA("-ret") == [2.0, 3.0, 0.5]
    ops.system("FullGeneral")
    ops.analyze(1, 0.0)
    assert ops.printA("-ret") == [2.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.5]
