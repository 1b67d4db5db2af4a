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


def command(name):
    function = getattr(ops, name)

    def call(*args):
        args = words(args)
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
