"""The case of a seed."""

import random

from .case import Case
from .chains import Chain
from .imperfect import Imperfections
from .pads import Pad
from .platforms import Platform

FAMILIES = {
    "rate_dependence": ("pad", "pad", "building"),
    "self_heating": ("pad",),
    "ambient_temperature": ("pad",),
    "mullins_softening": ("pad",),
    "cyclic_degradation": ("pad",),
    "strain_stiffening": ("pad", "pad", "building"),
    "axial_shear_interaction": ("pad",),
    "varying_axial_load": ("pad",),
    "cavitation": ("pad",),
    "bidirectional_coupling": ("pad", "platform"),
    "friction": ("pad", "pad", "building"),
    "gap_impact": ("pad", "building"),
    "foundation_flexibility": ("pier", "frame"),
    "superstructure_yielding": ("pier", "building", "frame"),
    "damping": ("building", "frame"),
    "torsion": ("platform",),
    "pinching": ("pad",),
    "sensor_gain": ("pad", "building", "pier", "platform"),
    "sensor_lag": ("pad", "building", "pier"),
    "sensor_drift": ("pad", "building"),
    "sensor_clipping": ("pad", "building", "pier"),
}
NULLS = ("pad", "pad", "pad", "building", "frame", "pier", "platform")
UNKNOWN = {
    "hum": ("pad",),
    "ringing": ("pad",),
    "bursts": ("pad", "building"),
    "lopsided": ("pad",),
    "cogging": ("pad",),
    "absorber": ("building", "frame"),
    "blows": ("building", "pier"),
}
PAIRS = (
    ("mullins_softening", "friction", "pad"),
    ("rate_dependence", "gap_impact", "pad"),
    ("strain_stiffening", "mullins_softening", "pad"),
    ("self_heating", "friction", "pad"),
    ("cyclic_degradation", "gap_impact", "pad"),
    ("strain_stiffening", "sensor_drift", "pad"),
    ("rate_dependence", "sensor_clipping", "pad"),
    ("gap_impact", "sensor_gain", "building"),
    ("superstructure_yielding", "sensor_lag", "pier"),
    ("foundation_flexibility", "sensor_gain", "pier"),
    ("friction", "sensor_lag", "building"),
    ("torsion", "sensor_gain", "platform"),
)
MAKERS = {"pad": Pad, "building": Chain, "frame": Chain, "pier": Chain, "platform": Platform}


def plan(seed):
    """(family, truth, effects) of a seed: of twenty, three nulls, three unknowns, two pairs, the rest one cause each."""
    rng = random.Random(f"plan {seed}")
    x = rng.random()
    if x < 0.15:
        return rng.choice(NULLS), ("none",), []
    if x < 0.30:
        kind = rng.choice(sorted(UNKNOWN))
        return rng.choice(UNKNOWN[kind]), ("unknown",), [kind]
    if x < 0.40:
        a, b, family = rng.choice(PAIRS)
        return family, (a, b), [a, b]
    causes = sorted(FAMILIES)
    cause = causes[seed % len(causes)]
    return rng.choice(FAMILIES[cause]), (cause,), [cause]


RATIOS = (1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0)


def draw(seed, ratio=None, cause=None, imperfect=False):
    """The case of a seed. `cause` and `ratio` overrule its plan. An imperfect one has other small errors too."""
    family, truth, effects = plan(seed)
    rng = random.Random(f"case {seed}")
    if cause == "none":
        family, truth, effects = rng.choice(NULLS), ("none",), []
    elif cause in UNKNOWN:
        family, truth, effects = rng.choice(UNKNOWN[cause]), ("unknown",), [cause]
    elif cause:
        family, truth, effects = rng.choice(FAMILIES[cause]), (cause,), [cause]
    drawn = rng.choice(RATIOS) * rng.uniform(0.8, 1.25)
    if truth[0] == "unknown" or len(truth) > 1:
        drawn = max(drawn, 6.0)
    model = MAKERS[family](rng, effects or ["none"], family)
    case = Case(model, truth, effects, ratio or drawn, rng)
    if imperfect:
        case.imperfections = Imperfections(seed, case)
    return case
