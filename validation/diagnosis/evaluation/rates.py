"""Rates, their intervals and medians of a column of trials."""

import statistics


def wilson(hits, n, z=1.96):
    """Interval of a rate (Wilson 1927), 95 %."""
    if not n:
        return 0.0, 1.0
    p = hits / n
    mid = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z * (p * (1 - p) / n + z * z / (4 * n * n)) ** 0.5 / (1 + z * z / n)
    return max(0.0, mid - half), min(1.0, mid + half)


def rate(rows, key="right"):
    """`hits of n (interval)` of the rows whose cell is 0 or 1."""
    hits = [int(r[key]) for r in rows if r[key] != ""]
    if not hits:
        return "-"
    low, high = wilson(sum(hits), len(hits))
    return f"{sum(hits)} of {len(hits)} ({100 * low:.0f} to {100 * high:.0f} %)"


def fraction(rows):
    """`hits of n` of the rows that are right."""
    return f"{sum(int(r['right']) for r in rows)} of {len(rows)}"


def median(rows, key, form="{:.2f}"):
    """`median (count)` of the rows that have a value."""
    values = [float(r[key]) for r in rows if r[key] not in ("", None)]
    return form.format(statistics.median(values)) + f" ({len(values)})" if values else "-"


def table(heads, rows):
    """Lines of a Markdown table."""
    return ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads), *("| " + " | ".join(map(str, row)) + " |" for row in rows)]
