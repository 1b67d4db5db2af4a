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
    assert ours["package"] == packages and ours["lto"] == theirs["lto"]
    assert "mimalloc" in str(wheel["target"]) and "mimalloc" in str(product["target"])
