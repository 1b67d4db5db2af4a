"""What commands say of themselves: help, signatures, keywords, places of warnings, and histories as tables."""

import inspect
import pydoc
import subprocess
import sys
import types
import warnings

import numpy as np
import pytest

import hysteron
from hysteron import Model, OpenSeesError, OpenSeesWarning
from hysteron._model import USAGES


def test_help_of_a_command_has_its_usage_meaning_and_arguments(frame):
    text = pydoc.plain(pydoc.render_doc(frame.fix))
    assert "fix(node, " in text and "tag of the node" in text and "one model" not in text
    assert "Makes a node" in Model.node.__doc__ and "Makes a node" in frame.node.__doc__
    assert "Kinds:" in frame.uniaxialMaterial.__doc__ and "Steel01" in frame.uniaxialMaterial.__doc__


def test_every_command_has_a_text_of_its_own():
    texts = {}
    for name in set(USAGES) & set(dir(Model)):
        text = getattr(Model, name).__doc__
        assert text and text.split("\n")[0] != "", name
        texts.setdefault(text, []).append(name)
    assert [names for names in texts.values() if len(names) > 1] == []


def test_about_has_the_words_of_a_kind():
    text = hysteron.about("uniaxialMaterial", "Steel01")
    assert text.startswith("uniaxialMaterial('Steel01', tag, Fy, E0, b") and "yield" in text and "`" not in text and "$" not in text
    assert "Returns the velocity of a node.\n" in hysteron.about("nodeVel") and "displacement" not in hysteron.about("nodeVel")
    with pytest.raises(OpenSeesError, match="Steel01"):
        hysteron.about("uniaxialMaterial", "Stel01")
    with pytest.raises(OpenSeesError, match="unknown command"):
        hysteron.about("nonsense")


def test_signatures_have_the_names_of_the_usage(frame):
    assert list(inspect.signature(frame.wipe).parameters) == ["words", "options"] or not inspect.signature(frame.wipe).parameters
    assert list(inspect.signature(frame.node).parameters)[:2] == ["tag", "x"]
    assert inspect.signature(frame.node).parameters["y"].default is None
    assert list(inspect.signature(frame.element).parameters)[0] == "kind"
    for name in set(USAGES) & set(dir(Model)):
        inspect.signature(getattr(frame, name))


def test_words_are_given_by_their_names(frame):
    frame.uniaxialMaterial("Steel01", 1, Fy=2.0, E=200.0, b=0.02)
    frame.uniaxialMaterial("Steel01", tag=2, b=0.02, E0=200.0, fy=2.0)
    frame.node(9, x=1.0, y=2.0, mass=[3.0, 3.0, 0.0])
    assert frame.nodeCoord(9) == [1.0, 2.0] and frame.nodeMass(9) == [3.0, 3.0, 0.0]
    for tag in (1, 2):
        frame.testUniaxialMaterial(tag)
        frame.setStrain(0.005)
        assert frame.getStress() == pytest.approx(1.0)
    frame.section("Elastic", 5, E=200.0, A=0.02, Iz=0.1)
    frame.section("Elastic", 6, E=200.0, A=0.02, Iz=0.1, G=80.0, alphaY=0.8)


def test_a_wrong_name_of_a_word_is_told(frame):
    with pytest.raises(OpenSeesError, match="'b' is missing"):
        frame.uniaxialMaterial("Steel01", 1, Fy=2.0, E=200.0)
    with pytest.raises(OpenSeesError, match="no argument 'Fyy'(.|\n)*'Fy'(.|\n)*usage: uniaxialMaterial"):
        frame.uniaxialMaterial("Steel01", 1, Fyy=2.0, Fy=2.0, E=200.0, b=0.02)
    with pytest.raises(OpenSeesError, match="no argument 'bb'(.|\n)*did you mean 'b'"):
        frame.uniaxialMaterial("Steel01", 1, Fy=2.0, E=200.0, bb=0.02)
    with pytest.raises(OpenSeesError, match="'E0' is given twice"):
        frame.uniaxialMaterial("Steel01", 1, 2.0, 200.0, E=200.0, b=0.02)


def test_warnings_are_at_the_line_of_the_caller():
    def doubtful(model):
        model.timeSeries("Linear", 1, "-faktor", 2.0)

    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        doubtful(Model(1, 1))
        line = doubtful.__code__.co_firstlineno + 1
    assert [(w.filename, w.lineno, w.category) for w in found] == [(__file__, line, OpenSeesWarning)]


@pytest.mark.parametrize(
    ("what", "parts"),
    [
        ("disp", ["record 'd'", "node is missing", "('disp', node, dof)"]),
        ("dsip", ["record 'd'", "'dsip' is no recorder", "did you mean 'disp'"]),
        (("dsip", 2, 1), ["record 'd'", "'dsip' is no recorder", "did you mean 'disp'"]),
        (7, ["record 'd'", "7 is no recorder"]),
        (("disp", 99, 1), ["node 99"]),
        (("Element", "-ele", 1, "nonsense"), ["nonsense"]),
    ],
)
def test_a_wrong_record_says_what_is_wrong(frame, what, parts):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises((OpenSeesError, OpenSeesWarning)) as error:
            frame.analyze(1, record={"d": what})
    for part in parts:
        assert part in str(error.value)
    assert "memory" not in str(error.value) and "-file" not in str(error.value)


def test_histories_are_a_table(frame):
    pandas = pytest.importorskip("pandas")
    found = frame.analyze(4, record={"roof": ("disp", 2, 1), "both": ("disp", [1, 2], 1, 2), "force": ("Element", "-ele", 1, "force")})
    table = found.to_pandas()
    assert isinstance(table, pandas.DataFrame) and table.index.name == "time" and len(table) == 4
    assert list(table.columns)[:5] == ["roof", "both_1_1", "both_1_2", "both_2_1", "both_2_2"]
    assert np.array_equal(table["both_2_1"], found["roof"]) and list(table.columns)[5] == "force_1"


def test_a_model_shows_what_it_has(frame):
    assert repr(frame) == "<Model: 2D, 3 degrees of freedom at a node, 2 nodes, 1 elements, time 0>"
    assert "empty" in repr(Model())


def module_of(name, **content):
    """A module with a content, in the place of a package that may be missing."""
    module = types.ModuleType(name)
    vars(module).update(content)
    return module


def test_a_loop_shows_its_model_in_one_place(frame, monkeypatch):
    shown = []

    class Place:
        def update(self, page):
            shown[-1] = page

    def display(page, display_id):
        assert display_id is True
        shown.append(page)
        return Place()

    monkeypatch.setitem(sys.modules, "IPython", module_of("IPython"))
    monkeypatch.setitem(sys.modules, "IPython.display", module_of("IPython.display", display=display))
    assert frame.plot(show=True) is None
    first = shown[0]
    frame.analyze(1)
    frame.plot(show=True)
    assert len(shown) == 1 and shown[0].html != first.html
    frame.copy().plot(show=True)
    assert len(shown) == 2


@pytest.mark.parametrize("record", [None, {"roof": ("disp", 2, 1)}])
def test_a_bar_shows_the_steps(frame, monkeypatch, record):
    bars = []

    class Bar:
        def __init__(self, total, unit):
            self.total, self.n, self.most = total, 0, 0
            bars.append(self)

        def update(self, steps):
            self.n += steps
            self.most = max(self.most, self.n)

        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

    monkeypatch.setitem(sys.modules, "tqdm", module_of("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", module_of("tqdm.auto", tqdm=Bar))
    frame.analyze(3, record=record, progress=True)
    frame.analyze(200_000, progress=True)
    assert [(bar.n, bar.most) for bar in bars] == [(3, 3), (200_000, 200_000)]
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    assert frame.analyze(1, progress=True) == 0 and len(bars) == 2


def test_the_package_opensees_is_there_after_install():
    code = """
import hysteron
hysteron.install()
import opensees.openseespy as ops
import opensees
assert opensees.node is ops.node
ops.model("basic", "-ndm", 1, "-ndf", 1)
ops.node(1, 0.5)
print(opensees.openseespy.nodeCoord(1, 1))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stdout == "0.5\n", done.stderr
