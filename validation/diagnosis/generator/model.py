"""Shared by all families of models: runs, channels, units, and the text of scripts."""


class Units:
    """Factors from N, m, s, kg to the units of the script."""

    def __init__(self, rng):
        if rng.random() < 0.7:
            self.L, self.F, self.text, self.len, self.force = 1.0, 1.0, "N, m, s", "m", "N"
        else:
            self.L, self.F, self.text, self.len, self.force = 1e3, 1e-3, "kN, mm, s", "mm", "kN"
        self.k = self.F / self.L  # stiffness, damping coefficient, mass


class Run:
    """One motion; `every` is the step in time of the response that the generator gives."""

    def __init__(self, name, role, dt, motions, T=23.0, axial=0.0, vertical=None, every=None):
        self.name, self.role, self.dt, self.motions = name, role, dt, motions
        self.T, self.axial, self.vertical = T, axial, vertical
        self.npts = len(motions[0])
        self.seconds = (self.npts - 1) * dt
        self.every = every or dt


class Channel:
    def __init__(self, name, unit, output, column, at):
        self.name, self.unit, self.output, self.column, self.at = name, unit, output, column, at


class Model:
    """A family fills in title, units, parameters {name: true value}, runs, channels and script, and says how it responds:
    respond(run, parameters, effects) gives {channel: values at every step `every` of the run}."""

    def scales(self, run):
        """Names of effects to the Scale of the device they sit in."""
        raise NotImplementedError


def number(x):
    return f"{x:.7g}"


def loop(substeps=False):
    """The analysis loop of a script."""
    step = "analyze $sub [expr $dt/double($sub)]" if substeps else "analyze 1 $dt"
    head = "set sub 1\nif {[info exists nsub]} {set sub $nsub}\n" if substeps else ""
    return head + f"""for {{set i 1}} {{$i < $npts}} {{incr i}} {{
    set ok [{step}]
    if {{$ok != 0}} {{
        algorithm KrylovNewton
        set ok [{step}]
        algorithm Newton
    }}
    if {{$ok != 0}} {{error "no convergence at [getTime]"}}
}}
"""


TRANSIENT = """constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr {tol} 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
"""
