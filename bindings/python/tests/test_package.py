"""The build of the package beside that of the command line."""

import re
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


def test_the_source_distribution_has_the_texts_that_the_crates_contain():
    """A crate is distributed with its own folder: files beyond it are named, through links beside the package."""
    tomllib = pytest.importorskip("tomllib", reason="needs Python 3.11")
    package = ROOT / "bindings/python"
    settings = tomllib.loads((package / "pyproject.toml").read_text())["tool"]["maturin"]
    named = {file.resolve() for row in settings["include"] for file in package.glob(row["path"])}
    contained = re.compile(r'include_(?:str|bytes)!\("([^"]+)"\)')
    needed = set()
    for crate in [*(ROOT / "crates").iterdir(), package]:
        for source in (crate / "src").rglob("*.rs"):
            # A distribution is built and not tested.
            if source.name != "tests.rs":
                files = {(source.parent / name).resolve() for name in contained.findall(source.read_text())}
                needed |= {file for file in files if crate not in file.parents}
    assert len(needed) > 5
    assert needed <= named, needed - named
    # The workspace of the crates comes without the sources of its own package, which must be named then.
    assert "path" in tomllib.loads((ROOT / "Cargo.toml").read_text())["lib"]
