"""Scores of answers against truths. An answer has the keys of `diagnosis.json` that README.md here lists."""

import math

NO_CAUSE = ("none", "unknown")


def causes(truth):
    return [truth["cause"], *(truth.get("also") or [])]


def named(answer):
    verdict = answer["verdict"]
    return [verdict["cause"], *(verdict.get("also") or [])]


def any_right(truth, answer):
    """One of the effects is named; `none` and `unknown` only as such."""
    if truth["cause"] in NO_CAUSE:
        return answer["verdict"]["cause"] == truth["cause"]
    return bool(set(named(answer)) & set(causes(truth)))


def all_right(truth, answer):
    """Every effect is named and no other."""
    return set(named(answer)) == set(causes(truth))


def place_right(truth, answer):
    """The first mismatch is in a run and a channel that hold the effect; None where the truth names none."""
    where, mismatch = truth.get("where"), answer.get("mismatch")
    if not where or not mismatch or "accept_runs" not in where:
        return None
    return mismatch[0]["run"] in where["accept_runs"] and mismatch[0]["channel"] in where["accept_channels"]


def element_right(truth, answer):
    """The repair sits at an element or node that the truth names; None where it names none."""
    at = (truth.get("where") or {}).get("at")
    places = (answer["verdict"].get("summary") or {}).get("places")
    if not at or not places or truth["cause"] in NO_CAUSE:
        return None
    if any(word in at for word in ("storey", "level", "floor")):
        return None  # the number is not a tag
    wanted = {w for w in at.replace(",", " ").split() if w.isdigit()}
    if not wanted:
        return None
    found = set()
    for place in places:
        found |= {str(tag) for key in ("elements", "nodes") for tag in numbers(place.get(key))}
    return bool(wanted & found)


def numbers(x):
    """All whole numbers in a value of JSON."""
    if isinstance(x, bool):
        return
    if isinstance(x, int):
        yield x
    elif isinstance(x, dict):
        for key in ("tag", "node", "element"):
            yield from numbers(x.get(key))
    elif isinstance(x, list):
        for each in x:
            yield from numbers(each)


def gap_closed(truth, answer):
    """Part of the way from the baseline to the noise that the repair goes on runs held out; None where there is no way."""
    base, after, floor = answer["baseline"].get("holdout_nmse"), (answer.get("corrected") or {}).get("holdout_nmse"), truth["noise_floor_nmse_holdout"]
    if truth["cause"] in NO_CAUSE or base is None or after is None or base <= 2.0 * floor:
        return None
    return (base - after) / (base - floor)


def parameter_errors(truth, answer):
    """(name, error before, error after) of the user's own parameters: |ln| of the ratio to the truth."""
    before, after = answer["baseline"].get("parameters", {}), (answer.get("corrected") or {}).get("parameters", {})
    out = []
    for name, value in (truth.get("underlying_parameters") or {}).items():
        pair = [x.get(name) for x in (before, after)]
        if isinstance(value, (int, float)) and value > 0 and all(isinstance(p, (int, float)) and p > 0 for p in pair):
            out.append((name, *(abs(math.log(p / value)) for p in pair)))
    return out


def brier(truth, answer):
    """Sum of squared differences of the probabilities from the truth, which one right cause meets with 0 and a wrong one with 2."""
    verdict = answer["verdict"]
    p = {verdict["cause"]: verdict["confidence"], **{c["cause"]: c["confidence"] for c in verdict.get("also_possible", [])}}
    right = [c for c in causes(truth) if c in p] or causes(truth)[:1]
    share = sum(p.get(c, 0.0) for c in right)
    return (1.0 - share) ** 2 + sum(q * q for c, q in p.items() if c not in right)


def risk_coverage(scored):
    """[(coverage, share of wrong answers among them)] of the surest answers, by falling confidence. `scored`: (confidence, right)."""
    ordered = sorted(scored, key=lambda s: -s[0])
    wrong, out = 0, []
    for n, (_, right) in enumerate(ordered, 1):
        wrong += not right
        out.append((n / len(ordered), wrong / n))
    return out


def median(values):
    ordered = sorted(values)
    n = len(ordered)
    return (ordered[(n - 1) // 2] + ordered[n // 2]) / 2 if n else None
