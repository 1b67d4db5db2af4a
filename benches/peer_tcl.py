"""A Tcl script in openseespy: Tcl comes from tkinter, every OpenSees command goes to the function of its name.

Only what the benchmarks and the cases against OpenSees use. Drift recorders, which openseespy cannot make, are passed over.
"""
import sys
import tkinter

import openseespy.opensees as ops

tcl = tkinter.Tcl()


def word(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def words(args):
    out, names = [], False
    for arg in map(str, args):
        # Names of files may look like numbers; lists of values are several words.
        if names:
            out.append(arg)
        elif out and out[-1] in ("-values", "-time") and " " in arg.strip():
            out += [float(x) for x in tcl.splitlist(arg)]
        else:
            out.append(word(arg))
        names = arg in ("-file", "-filePath", "-fileTime")
    return out


def text(value):
    if value is None:
        return ""
    if isinstance(value, (list, tuple)):
        return " ".join(map(text, value))
    return repr(value) if isinstance(value, float) else str(value)


made = [9000]  # tag of the last object that a script leaves to OpenSees


def new_tag():
    made[0] += 1
    return made[0]


def as_in_python(name, args):
    """Two forms that OpenSees has in Tcl alone: a series by its name, and a beam by section and number of points."""
    if name == "pattern" and len(args) > 2 and args[2] in ("Linear", "Constant"):
        tag = new_tag()
        ops.timeSeries(args[2], tag)
        return [*args[:2], tag, *args[3:]]
    if name == "element" and args[0] in RULES and len(args) > 6 and all(isinstance(a, int) for a in args[1:7]):
        tag = new_tag()
        ops.beamIntegration(RULES[args[0]], tag, args[5], args[4])
        return [*args[:4], args[6], tag, *args[7:]]
    return args


RULES = {"forceBeamColumn": "Lobatto", "dispBeamColumn": "Legendre"}


def command(name):
    function = getattr(ops, name)

    def call(*args):
        args = as_in_python(name, words(args))
        if name == "recorder" and args[0] in ("Drift", "EnvelopeDrift"):
            return ""
        return text(function(*args))

    return call


for name in dir(ops):
    if callable(getattr(ops, name)) and not name.startswith("_") and name not in ("pattern", "section"):
        tcl.createcommand(name, command(name))
tcl.createcommand("__pattern", command("pattern"))
tcl.createcommand("__section", command("section"))
tcl.eval("""
    proc with_body {command kinds words} {
        if {[lindex $words 0] in $kinds} {
            $command {*}[lrange $words 0 end-1]
            uplevel 2 [lindex $words end]
        } else {
            $command {*}$words
        }
    }
    proc pattern args { with_body __pattern {Plain MultipleSupport} $args }
    proc section args { with_body __section {Fiber fiberSec NDFiber} $args }
    proc pset {name value} { uplevel 1 [list set $name $value] }
""")
tcl.setvar("argv0", sys.argv[1])
tcl.setvar("argv", " ".join(sys.argv[2:]))
try:
    tcl.eval("source {" + sys.argv[1] + "}")
except tkinter.TclError as error:
    print(error, tcl.getvar("errorInfo"), sep="\n", file=sys.stderr)
    sys.exit(1)
finally:
    ops.wipe()
