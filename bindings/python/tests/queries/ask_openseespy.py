"""Ask openseespy all questions of all cases, and store its answers.

    PYTHON bindings/python/tests/queries/ask_openseespy.py [--only WORD]

PYTHON has openseespy 3.7.1. With a word only the cases with it in their names are asked again, and those without answers. Each case is asked in two processes whose memory is filled in different ways: answers that differ are
not defined by the model, and are left out with the questions that end the process. Empty answers are left out as well.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import questions as q

HERE = Path(__file__).parent


def ask(number, skipped):
    """Ask one case, and write each question before it is asked."""
    import openseespy.opensees as ops

    data = json.loads((HERE / "cases.json").read_text())
    out = os.fdopen(os.dup(1), "w")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)

    def tell(what):
        out.write(json.dumps(what) + "\n")
        out.flush()

    try:
        code = q.build(ops, data, data["cases"][number])
    except Exception as e:  # noqa: BLE001: openseespy raises errors of several types
        return tell(["refused", str(e)])
    if code != 0:
        return tell(["refused", "the analysis fails"])
    for question in q.questions():
        name = q.name(question)
        if name in skipped:
            continue
        tell(["ask", name])
        tell(["answer", name, q.ask(ops, question)])
    tell(["end"])


def answers(number, fill):
    """Answers of one case, and the questions that end the process."""
    skipped, found = [], {}
    while True:
        words = [sys.executable, __file__, str(number), *skipped]
        done = subprocess.run(words, capture_output=True, text=True, env={**os.environ, "MALLOC_PERTURB_": str(fill)}, timeout=120)
        told = [json.loads(line) for line in done.stdout.splitlines()]
        found.update({t[1]: t[2] for t in told if t[0] == "answer"})
        if told and told[-1][0] == "refused":
            return {"refused": told[-1][1]}
        if told and told[-1][0] == "end":
            return {"answers": found, "fatal": skipped}
        if not told or told[-1][0] != "ask" or len(skipped) > 40:
            return {"refused": "the process ends while the model is made"}
        skipped.append(told[-1][1])


def both(number):
    first, second = answers(number, 85), answers(number, 170)
    if "refused" in first or "refused" in second:
        return {"refused": first.get("refused") or second.get("refused")}
    kept = {n: a for n, a in first["answers"].items() if n in second["answers"] and q.same(a, second["answers"][n])}
    undefined = sorted({*first["answers"], *second["answers"], *first["fatal"], *second["fatal"]} - set(kept))
    return {"answers": {n: a for n, a in kept.items() if a != []}, "undefined": undefined}


def main(word):
    cases = json.loads((HERE / "cases.json").read_text())["cases"]
    file = HERE / "openseespy.json"
    known = json.loads(file.read_text()) if word and file.exists() else {}
    lines = []
    for number, case in enumerate(cases):
        found = known.get(case["name"])
        if found is None or word in case["name"]:
            found = both(number)
            print(f"{number + 1}/{len(cases)} {case['name'][:60]}: {found.get('refused') or len(found['answers'])}", flush=True)
        lines.append(f"{json.dumps(case['name'])}: {json.dumps(found, separators=(',', ':'))}")
    file.write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    if len(sys.argv) > 1 and sys.argv[1] != "--only":
        ask(int(sys.argv[1]), sys.argv[2:])
    else:
        main(sys.argv[2] if len(sys.argv) > 2 else "")
