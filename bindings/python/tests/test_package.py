"""The build of the package beside that of the command line."""

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


def test_the_wheel_is_built_as_the_command_line():
    tomllib = pytest.importorskip("tomllib", reason="needs Python 3.11")
    product, wheel = (tomllib.loads((ROOT / p / "Cargo.toml").read_text()) for p in ("", "bindings/python"))
    ours, theirs = wheel["profile"]["release"], product["profile"]["release"]
    # The program itself is no part of the wheel.
    packages = {name: keys for name, keys in theirs["package"].items() if name != "hysteron"}
    assert ours["lto"] == theirs["lto"]
    for name in ("hysteron-engine", "hysteron-tcl"):
        assert ours["package"][name] == packages[name], name
    assert "opt-level" not in ours["package"]["hysteron-opensees"] | packages.get("hysteron-opensees", {})
    # What takes no time in an analysis is made small.
    for name, keys in packages.items():
        assert ours["package"][name].get("opt-level") in (keys.get("opt-level"), "s"), name
    assert "mimalloc" in str(wheel["target"]) and "mimalloc" in str(product["target"])
