"""Copies of models, and queries of many nodes or elements in one call."""

import copy

import numpy as np
import pytest

import hysteron


def hysteretic():
    """A mass on a spring with hysteresis under a force that swings."""
    model = hysteron.Model(ndm=1, ndf=1)
    model.node(1, 0.0)
    model.node(2, 0.0)
    model.mass(2, 1.0)
    model.fix(1, 1)
    model.uniaxialMaterial("Steel01", 1, 5.0, 400.0, 0.1)
    model.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
    model.timeSeries("Trig", 1, 0.0, 100.0, 0.8)
    model.pattern("Plain", 1, 1)
    model.load(2, 8.0)
    model.constraints("Plain")
    model.test("NormUnbalance", 1e-8, 20)
    model.algorithm("Newton")
    model.integrator("Newmark", 0.5, 0.25)
    model.analysis("Transient")
    return model


def motion(model, steps):
    out = []
    for _ in range(steps):
        assert model.analyze(1, 0.01) == 0
        out.append((model.getTime(), model.nodeDisp(2, 1), model.nodeVel(2, 1), model.eleForce(1, 1)))
    return out


def test_a_copy_goes_on_to_the_same_bits():
    model = hysteretic()
    motion(model, 60)
    model.analyze(20, 0.01)
    other = model.copy()
    assert (other.getTime(), other.nodeDisp(2), other.eleForce(1)) == (model.getTime(), model.nodeDisp(2), model.eleForce(1))
    after = motion(other, 50)
    # The model has not moved with its copy.
    assert model.getTime() == pytest.approx(0.8)
    assert motion(model, 50) == after
    assert max(abs(u) for _, u, *_ in after) > 5.0 / 400.0


def test_a_copy_of_a_copy_and_of_a_part_of_the_course():
    model = hysteretic()
    model.analyze(30, 0.01)
    model.loadConst("-time", 0.0)
    model.remove("loadPattern", 1)
    model.setNodeVel(2, 1, 0.4, "-commit")
    twice = copy.deepcopy(copy.copy(model))
    assert motion(twice, 20) == motion(model, 20)


def test_a_copy_has_the_settings_and_what_a_class_adds():
    class Named(hysteron.Model):
        def __init__(self, name):
            super().__init__(ndm=1, ndf=1, strict=True)
            self.name = name

        def __new__(cls, name):
            return super().__new__(cls, strict=True)

    # A class may take other arguments than Model; its copy needs none of them.
    model = Named("left")
    model.node(1, 0.0)
    assert repr(model) == "<Model: 1D, 1 degrees of freedom at a node, 1 nodes, 0 elements, time 0>"
    other = model.copy()
    assert type(other) is Named and other.name == "left" and other.getNodeTags() == [1]
    # Without its kind, of which a strict model makes an error.
    with pytest.raises(hysteron.OpenSeesError, match="the kind of model is missing"):
        other.model("-ndm", 2)


def test_recorders_and_files_stay_with_the_model(tmp_path):
    model = hysteretic()
    model.recorder("Node", "-file", str(tmp_path / "a.out"), "-node", 2, "-dof", 1, "disp")
    histories = model.analyze(5, 0.01, record={"u": ("disp", 2, 1)})
    written = (tmp_path / "a.out").read_bytes()
    other = model.copy()
    assert (tmp_path / "a.out").read_bytes() == written
    assert other.nodeDisp(2, 1) == histories["u"][-1]
    other.analyze(5, 0.01)
    assert (tmp_path / "a.out").read_bytes() == written


def test_what_cannot_be_made_again_is_refused(tmp_path):
    model = hysteretic()
    model.database("File", str(tmp_path / "state"))
    model.analyze(5, 0.01)
    model.save(1)
    assert model.copy().getTime() == model.getTime()
    model.restore(1)
    with pytest.raises(hysteron.OpenSeesError, match="it has read a state from a database"):
        model.copy()
    # A file that has changed gives another state.
    series = tmp_path / "a.txt"
    series.write_text("0 1 2 3\n")
    model = hysteretic()
    model.timeSeries("Path", 2, "-dt", 0.01, "-filePath", str(series), "-factor", 50.0)
    model.pattern("UniformExcitation", 2, 1, "-accel", 2)
    model.analyze(3, 0.01)
    assert model.copy().nodeDisp(2) == model.nodeDisp(2)
    series.write_text("0 3 2 1\n")
    with pytest.raises(hysteron.OpenSeesError, match="another state"):
        model.copy()


def test_queries_of_many_are_those_of_each(frame):
    frame.node(7, 1.0, 3.0)
    frame.element("elasticBeamColumn", 4, 2, 7, 0.01, 2e8, 1e-4, 1)
    assert frame.analyze(2) == 0
    nodes, elements = frame.getNodeTags(), frame.getEleTags()
    for name in ("nodeDisp", "nodeVel", "nodeAccel", "nodeCoord", "nodeReaction"):
        query = getattr(frame, name)
        each = np.array([query(n) for n in nodes])
        assert isinstance(query(), np.ndarray) and query().tobytes() == each.tobytes() and query().shape == each.shape
        assert query([7, 1]).tolist() == [query(7), query(1)]
        assert query((7, 1), 2).tolist() == [query(7, 2), query(1, 2)]
        assert query(np.array([2]), 1).tolist() == [query(2, 1)]
    for name in ("eleForce", "basicForce", "basicDeformation", "localForce"):
        query = getattr(frame, name)
        assert query().tolist() == [query(e) for e in elements]
        assert query([4], 1).tolist() == [query(4, 1)]
    assert frame.eleResponse(elements, "localForce").tolist() == [frame.eleResponse(e, "localForce") for e in elements]
    assert np.any(frame.eleResponse([4], "localForce") != 0.0)


def test_many_that_make_no_array_are_refused(frame):
    frame.uniaxialMaterial("Elastic", 1, 1.0)
    frame.element("truss", 9, 1, 2, 1.0, 1)
    with pytest.raises(hysteron.OpenSeesError, match="1 has 3 values and 9 has 1, which make no array"):
        frame.basicForce()
    assert frame.basicForce([9, 1], 1).shape == (2,)
    with pytest.raises(hysteron.OpenSeesError, match="33"):
        frame.nodeDisp([1, 33])
    with pytest.raises(hysteron.OpenSeesError, match="33"):
        frame.eleForce([1, 33])
    with pytest.raises(hysteron.OpenSeesError, match="33"):
        frame.eleResponse([1, 33], "force")
    with pytest.raises(hysteron.OpenSeesError, match="1 has no such response"):
        frame.eleResponse([1, 9], "plasticRotation")
    with pytest.raises(hysteron.OpenSeesError):
        frame.nodeDisp([1, 2], 4)
    with pytest.raises(hysteron.OpenSeesError):
        frame.nodeDisp(["a"])
    assert hysteron.Model(ndm=1, ndf=1).nodeDisp().shape == (0, 0)


def test_the_module_of_openseespy_keeps_the_name_copy_free():
    import hysteron.opensees as module

    assert "copy" not in module.__all__
