"""Rules that choose among the same fits as the diagnosis. Each gives an answer in the form of `diagnosis.json`.

Every rule sees the fitted hypotheses (`evidence.hypotheses`) and none of what the verdict adds: surrogates, bootstrap, runs held out, `unknown`.
"""

import csv
import math
import tomllib


def fitted_samples(folder):
    """Number of samples of the fitted channels of a study."""
    with open(f"{folder}/study.toml", "rb") as f:
        study = tomllib.load(f)
    total = 0
    for run in study["run"]:
        if run["role"] == "fit":
            with open(f"{folder}/{run['recording']}", newline="") as f:
                rows = sum(1 for row in csv.reader(f) if row and not row[0].startswith("#")) - 1
            total += rows * len(run["observe"])
    return total


def by_score(evidence, score):
    """(hypothesis, probability) of the largest score, in nats."""
    scores = [score(h) for h in evidence["hypotheses"]]
    most = max(scores)
    weights = [math.exp(s - most) for s in scores]
    first = scores.index(most)
    return evidence["hypotheses"][first], weights[first] / sum(weights)


def aic(evidence, n):
    """Akaike's criterion on the fitted samples."""
    return by_score(evidence, lambda h: -0.5 * n * math.log(h["nmse"]) - h["parameters"])


def bic(evidence, n):
    """Schwarz' criterion on the fitted samples."""
    return by_score(evidence, lambda h: -0.5 * n * math.log(h["nmse"]) - 0.5 * h["parameters"] * math.log(n))


def held_back(evidence, _):
    """The error of blocks of time that were not fitted, without any prior."""
    return by_score(evidence, lambda h: h["log_likelihood"])


def bayes(evidence, _):
    """The same with the prior odds of the diagnosis."""
    return by_score(evidence, lambda h: h["log_likelihood"] + h["prior_log_odds"])


RULES = {"AIC": aic, "BIC": bic, "held-back blocks alone": held_back, "Bayes, no unknown": bayes}


def answer(rule, said, folder):
    """The answer of a rule to a diagnosed case."""
    hypothesis, p = RULES[rule](said["evidence"], fitted_samples(folder))
    also = [hypothesis["also"]] if hypothesis.get("also") else []
    verdict = {"cause": hypothesis["cause"], "also": also, "confidence": p, "also_possible": []}
    return {"verdict": verdict, "baseline": said["baseline"], "corrected": None, "mismatch": []}
