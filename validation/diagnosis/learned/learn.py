"""`hysteron learn` on one thread, and what it says. Standard library only."""
import os
import re
import subprocess
import tempfile

ROWS = {"fitted": "fitted runs", "blocks": "blocks held back", "held_out": "runs held out", "simulated": "the same, simulated"}


def learned(engine, study, out):
    """Errors of the user's model and of the law, the kinds of memory and the seconds of a study, or the reason that there is no law."""
    command = [engine, "learn", study.name, "--out", str(out), "--threads", "1"]
    with tempfile.TemporaryFile("w+") as said, tempfile.TemporaryFile("w+") as failed:
        started = subprocess.Popen(command, cwd=study.parent, stdout=said, stderr=failed)
        _, status, used = os.wait4(started.pid, 0)
        started.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        failed.seek(0)
        text, message = said.read(), failed.read()
    found = {"seconds": used.ru_utime}
    if started.returncode:
        return found | {"refused": message.strip().splitlines()[-1].split(": ", 2)[-1]}
    if not (out / "learned_law.json").exists():
        return found | {"refused": "the runs held out gain too little"}
    for key, words in ROWS.items():
        if row := re.search(rf"^{words} +(\S+) +(\S+)$", text, re.M):
            found[key] = row.groups()
    found["family"] = re.search(r"of the family ([^:]+):", text)[1]
    noise = re.search(r"the noise of ([0-9.e+-]+)\.", text)
    outside = re.search(r"^([0-9.]+) % of the steps", text, re.M)
    return found | {"noise": noise[1] if noise else "", "outside": outside[1] if outside else "0"}


def held_out(found):
    """Mean NMSE of the runs held out of the user's model and of the model with the law; nan where there is no law."""
    law = found.get("simulated", found.get("held_out", ("nan", "nan")))[1]
    return float(found.get("held_out", ("nan",))[0]), float(law)


def write_table(path, name, head, rows):
    """Writes a table between the marks of its name in a page."""
    text = path.read_text()
    begin, end = f"<!-- {name} -->\n", "<!-- end -->"
    start = text.index(begin) + len(begin)
    lines = [head, "|" + " --- |" * (head.count("|") - 1), *rows]
    path.write_text(text[:start] + "\n" + "\n".join(lines) + "\n\n" + text[text.index(end, start):])
