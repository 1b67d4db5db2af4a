"""Learned laws: evaluated along a motion, and as JSON."""

import numpy as np
import pytest

import hysteron

LAW = '{"range": [0.1, 1.0, 10.0], "hysteresis": ["bilinear", 0.01, 20.0], "spring": [100.0]}'


def test_a_law_is_evaluated_along_a_motion():
    law = hysteron.LearnedLaw(LAW)
    u = np.array([0.0, 0.005, 0.03, 0.025])
    force = law.force(u, np.arange(4.0))
    # A spring beside a slider of 20 that slips after 0.01.
    assert np.allclose(force, 100 * u + [0.0, 10.0, 20.0, 10.0])
    again = hysteron.LearnedLaw(law.json())
    assert np.array_equal(again.force(u, np.arange(4.0)), force)
    assert law.channels == [] and "-hysteresis bilinear 0.01 20" in law.words()


def test_a_law_needs_its_channels():
    law = hysteron.LearnedLaw(LAW[:-1] + ', "channel": [["V", 1.0, 1.0]], "factor": [["strength", "channel", "V", 1.5, -1, 1]]}')
    u, t = np.array([0.0, 0.05]), np.array([0.0, 1.0])
    assert np.isclose(law.force(u, t, {"V": np.array([4.0, 4.0])})[1], 5.0 + 20 * 2.5)
    with pytest.raises(ValueError, match="channel V"):
        law.force(u, t)
    with pytest.raises(ValueError, match="makes energy"):
        hysteron.LearnedLaw(LAW.replace("20.0", "-20.0"))
