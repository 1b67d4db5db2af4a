"""Measured files of any format as arrays."""

import math

import numpy as np
import pytest

import hysteron

HEADER = "PEER NGA STRONG MOTION DATABASE RECORD\nA, 1/1/2000, B, 090\n{}\nNPTS= 50, DT= .0100 SEC\n"
VALUES = [0.3 * math.sin(0.2 * i) for i in range(50)]


def write(path, statement="ACCELERATION TIME SERIES IN UNITS OF G"):
    path.write_text(HEADER.format(statement) + "".join(f"{x:.7E}\n" for x in VALUES))
    return path


def test_series_have_quantity_unit_and_clock(tmp_path):
    (series,) = hysteron.read_recording(write(tmp_path / "a.AT2"))
    assert (series.quantity, series.unit, series.dt, series.azimuth) == ("acceleration", "g", 0.01, 90.0)
    np.testing.assert_allclose(series.values, VALUES, atol=1e-7)
    np.testing.assert_allclose(series.times, 0.01 * np.arange(50))
    np.testing.assert_allclose(series.to("m/s2"), 9.80665 * np.array(VALUES), atol=1e-6)


def test_what_contradicts_the_file_is_refused(tmp_path):
    path = write(tmp_path / "a.VT2", "VELOCITY TIME SERIES IN UNITS OF CM/S")
    assert hysteron.read_recording(path)[0].quantity == "velocity"
    for told in ({"dt": 0.02}, {"quantity": "acceleration"}, {"dt": -1.0}, {"layout": "rows"}):
        with pytest.raises(ValueError):
            hysteron.read_recording(path, **told)
    with pytest.raises(ValueError):
        hysteron.read_recording(path)[0].to("g")
    with pytest.raises(OSError):
        hysteron.read_recording(tmp_path / "none.AT2")


def test_numbers_alone_are_told(tmp_path):
    path = tmp_path / "list.txt"
    path.write_text("".join(f"{x:.7f}\n" for x in VALUES))
    (bare,) = hysteron.read_recording(path)
    assert bare.unit is None and bare.times is None and bare.quantity is None
    (told,) = hysteron.read_recording(path, unit="g", dt=0.01)
    assert (told.unit, told.quantity, told.dt, len(told)) == ("g", "acceleration", 0.01, 50)
