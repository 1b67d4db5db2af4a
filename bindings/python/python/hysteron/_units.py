"""Units of OpenSees' command ``defaultUnits``."""

from ._hysteron import OpenSeesError

#: Each name of a unit of force as pounds, of length as inches, of time as seconds.
_FORCES = {
    "lb": 1.0, "lbs": 1.0, "kip": 1e3, "kips": 1e3, "N": 1 / 4.4482216152605, "kgf": 9.80665 / 4.4482216152605,
    "kN": 1e3 / 4.4482216152605, "MN": 1e6 / 4.4482216152605, "tonf": 9806.65 / 4.4482216152605,
}  # fmt: skip
_FORCES |= {"KN": _FORCES["kN"], "kn": _FORCES["kN"], "mN": _FORCES["MN"], "mn": _FORCES["MN"]}
_LENGTHS = {"in": 1.0, "inch": 1.0, "ft": 12.0, "feet": 12.0, "mm": 1 / 25.4, "cm": 1 / 2.54, "m": 1 / 0.0254}
_TIMES = {"sec": 1.0, "Sec": 1.0, "msec": 1e-3, "mSec": 1e-3}
_OPTIONS = {"force": _FORCES, "length": _LENGTHS, "time": _TIMES, "temperature": None, "temp": None}
#: Standard acceleration of gravity in ft/s², as OpenSees has it.
_GRAVITY = 32.174049


def units(words):
    """Values by the names of units in the system whose base units the words name."""
    chosen = {}
    for option, word in zip(words[::2], words[1::2], strict=False):
        kind = str(option).removeprefix("-").lower()
        if kind not in _OPTIONS:
            raise OpenSeesError(f"defaultUnits: unknown option {option!r}\n  expected -force, -length, -time or -temp")
        known = _OPTIONS[kind]
        if known is not None and word not in known:
            raise OpenSeesError(f"defaultUnits: unknown unit of {kind} {word!r}\n  expected one of {', '.join(known)}")
        chosen[kind] = word
    missing = [f"-{kind}" for kind in ("force", "length", "time") if kind not in chosen]
    if missing or len(words) % 2:
        raise OpenSeesError(f"defaultUnits: {', '.join(missing) or 'a unit'} is missing")
    force, length, time = 1 / _FORCES[chosen["force"]], 1 / _LENGTHS[chosen["length"]], 1 / _TIMES[chosen["time"]]
    of_force = {name: _FORCES[name] * force for name in ("lb", "kip", "N", "kN", "MN", "kgf", "tonf")}
    of_length = {name: _LENGTHS[name] * length for name in ("inch", "ft", "mm", "cm", "m")}
    newton, metre, second = of_force["N"], of_length["m"], time
    table = of_force | of_length
    table |= {"lbf": of_force["lb"], "Newton": newton, "kNewton": of_force["kN"], "meter": metre}
    table |= {"sec": second, "msec": 1e-3 * second, "g": _GRAVITY * of_length["ft"] / second**2}
    table |= {"kg": newton * second**2 / metre, "Mg": 1e3 * newton * second**2 / metre}
    table |= {"slug": of_force["lb"] * second**2 / of_length["ft"]}
    table |= {name: factor * newton / metre**2 for name, factor in (("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6))}
    for name, unit, per in (("psi", "lb", "inch"), ("ksi", "kip", "inch"), ("psf", "lb", "ft"), ("ksf", "kip", "ft")):
        table[name] = of_force[unit] / of_length[per] ** 2
    table["pcf"] = of_force["lb"] / of_length["ft"] ** 3
    for name in ("in", "ft", "mm", "cm", "m"):
        of_one = of_length["inch" if name == "in" else name]
        table |= {f"{name}2": of_one**2, f"{name}4": of_one**4}
    return table | {"pi": 3.141592653589793, "PI": 3.141592653589793}
