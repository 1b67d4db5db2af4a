"""Compare hysteron's answers with the stored ones of openseespy.

    python bindings/python/tests/queries/compare.py [WORD ...]

It prints how many questions differ by kind of case and by question, and with words the differences of the cases and questions that
have all of them in their names.
"""

import collections
import fnmatch
import json
import sys
import warnings
from pathlib import Path

import questions as q

HERE = Path(__file__).parent


def stored():
    """Cases with their names, and openseespy's answers by case."""
    data = json.loads((HERE / "cases.json").read_text())
    return data, json.loads((HERE / "openseespy.json").read_text())


def answers(data, case, skipped, **settings):
    """Answers to the questions of a case by their names, or what keeps them from being asked."""
    from hysteron import Model

    model = Model(**settings)
    try:
        code = q.build(model, data, case)
    except Exception as e:  # noqa: BLE001: shown as the difference that it is
        return {"model": str(e)}
    if code != 0:
        return {"model": "the analysis fails"}
    return {q.name(k): q.ask(model, k) for k in q.questions() if q.name(k) not in skipped}


def differences():
    """Number of questions by kind of case, those that only hysteron answers, and the differences.

    A difference has the case, the question, openseespy's answer and hysteron's.
    """
    warnings.simplefilter("ignore")
    data, theirs = stored()
    asked, more, differ = collections.Counter(), collections.Counter(), []
    for case in data["cases"]:
        found = theirs[case["name"]]
        if "refused" in found:
            continue
        skipped = set(found["undefined"])
        names = [q.name(k) for k in q.questions() if q.name(k) not in skipped]
        asked[q.kind(case)] += len(names)
        ours = answers(data, case, skipped)
        if "model" in ours:
            differ += [(case["name"], n, found["answers"].get(n, []), ours["model"]) for n in names]
            continue
        wrong = {n for n in names if not q.same(found["answers"].get(n, []), ours[n])}
        # OpenSees' slips, which a default answer does not follow, are answers too.
        slips = answers(data, case, skipped, compat=True) if wrong else {}
        wrong = {n for n in wrong if "model" in slips or not q.same(found["answers"].get(n, []), slips[n])}
        only_ours = {n for n in wrong if n not in found["answers"] and isinstance(ours[n], list)}
        more[q.kind(case)] += len(only_ours)
        differ += [(case["name"], n, found["answers"].get(n, []), ours[n]) for n in names if n in wrong - only_ours]
    return asked, more, differ


def reasons():
    """Known differences: for each reason patterns of cases with patterns of questions."""
    known = json.loads((HERE / "known.json").read_text())
    return [(reason, case, question) for reason, rows in known.items() for case, qs in rows.items() for question in qs]


def unknown(differ):
    """Differences without a reason, and reasons without a difference."""
    rows, used = reasons(), set()
    left = []
    for case, question, *answers in differ:
        hits = [r for r in rows if fnmatch.fnmatchcase(case, r[1]) and fnmatch.fnmatchcase(question, r[2])]
        used.update(hits)
        if not hits:
            left.append((case, question, *answers))
    return left, [r for r in rows if r not in used]


def shown(answer):
    text = str(answer)
    return text if len(text) < 100 else f"{text[:97]}... ({len(answer)})"


def main(words):
    asked, more, differ = differences()
    by_kind = collections.Counter(case.split(" ", 1)[0] for case, *_ in differ)
    for kind, count in asked.items():
        print(f"{kind:10} {count:6} questions, {more[kind]:4} answered by hysteron alone, {by_kind[kind]:4} differ")
    print(f"{'all':10} {sum(asked.values()):6} questions, {sum(more.values()):4} answered by hysteron alone, {len(differ):4} differ")
    for question, count in collections.Counter(d[1] for d in differ).most_common():
        print(f"{count:5} {question}")
    for case, question, theirs, ours in differ:
        if words and all(w in f"{case} | {question}" for w in words):
            print(f"{case} | {question}\n    openseespy {shown(theirs)}\n    hysteron   {shown(ours)}")


if __name__ == "__main__":
    main(sys.argv[1:])
