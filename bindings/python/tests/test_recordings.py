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


def test_several_channels_keep_their_units(tmp_path):
    path = tmp_path / "test.csv"
    rows = "".join(f"{20 * i};{i % 7},5;{3 * i};{i}\n" for i in range(20))
    path.write_text("Zeit [ms];Weg (mm);Kraft [kN];Signal\n" + rows, encoding="utf-16")
    disp, force, signal = hysteron.read_recording(path)
    assert [(s.name, s.quantity, s.unit) for s in (disp, force)] == [
        ("Weg", "displacement", "mm"),
        ("Kraft", "force", "kN"),
    ]
    assert signal.unit is None and disp.dt == force.dt == 0.02
    np.testing.assert_allclose(disp.to("m"), 1e-3 * disp.values)
    np.testing.assert_allclose(force.to("kip"), force.values / 4.4482216152605)
    # A told unit holds for the channels of its quantity, and for those of which nothing is known.
    told = hysteron.read_recording(path, unit="kN")
    assert [s.unit for s in told] == ["mm", "kN", "kN"]
    with pytest.raises(ValueError, match="the file says kN for Kraft"):
        hysteron.read_recording(path, unit="N")


def test_a_refused_file_says_where_and_what_to_do(tmp_path):
    path = tmp_path / "page.txt"
    path.write_text("0.1\n0.2\npage 2\n0.3\n")
    with pytest.raises(ValueError, match='line 3: "page" is not a number'):
        hysteron.read_recording(path)
    path.write_text("".join(f"{i % 2} {100 + i % 2} 5\n" for i in range(40)))
    with pytest.raises(ValueError, match="add layout="):
        hysteron.read_recording(path)
    assert len(hysteron.read_recording(path, layout="columns")) == 3
    path.write_bytes(b"\x89HDF\r\n\x1a\n\0\0")
    with pytest.raises(ValueError, match="HDF5"):
        hysteron.read_recording(path)


def test_a_header_is_read_with_the_file_beside_it(tmp_path):
    channel = (
        "#BEGINCHANNELHEADER\n200,{}\n202,{}\n210,EXPLICIT\n211,a.R64\n213,CHANNEL\n214,REAL64\n220,3\n221,{}\n"
        "240,0\n241,1\n#ENDCHANNELHEADER\n"
    )
    path = tmp_path / "a.DAT"
    path.write_text(channel.format("Time", "s", 1) + channel.format("Force", "kN", 4))
    with pytest.raises(ValueError, match="a.R64"):
        hysteron.read_recording(path)
    (tmp_path / "a.R64").write_bytes(np.array([0.0, 0.5, 1.0, 3.0, -7.0, 2.0]).tobytes())
    (force,) = hysteron.read_recording(path)
    assert (force.unit, force.dt, list(force.values)) == ("kN", 0.5, [3.0, -7.0, 2.0])
