"""Queries of programs on top: every question of `queries/questions.py` for every kind, beside openseespy's stored answers."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "queries"))
import compare  # noqa: E402


def test_answers_are_those_of_openseespy():
    asked, _, differ = compare.differences()
    assert sum(asked.values()) > 20_000
    left, idle = compare.unknown(differ)
    listed = "\n".join(f"{case} | {question}: openseespy {theirs}, hysteron {ours}" for case, question, theirs, ours in left[:30])
    assert not left, f"{len(left)} differences without a reason in known.json:\n{listed}"
    assert not idle, f"no difference has these reasons of known.json any more: {idle}"
