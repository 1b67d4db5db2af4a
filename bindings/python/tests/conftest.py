"""Models for the tests."""

import pytest

import hysteron


@pytest.fixture
def ops():
    """The module that stands for openseespy's, wiped."""
    import hysteron.opensees as module

    module.wipe()
    yield module
    module.wipe()


@pytest.fixture
def frame():
    """A cantilever in the plane under a force at its end."""
    model = hysteron.Model(ndm=2, ndf=3)
    model.node(1, 0.0, 0.0)
    model.node(2, 0.0, 3.0)
    model.fix(1, 1, 1, 1)
    model.mass(2, 2.0, 2.0, 1e-6)
    model.geomTransf("Linear", 1)
    model.element("elasticBeamColumn", 1, 1, 2, 0.01, 2e8, 1e-4, 1)
    model.timeSeries("Linear", 1)
    model.pattern("Plain", 1, 1)
    model.load(2, 10.0, 0.0, 0.0)
    model.integrator("LoadControl", 0.5)
    model.analysis("Static")
    return model
