"""Questions that programs on top ask of a model: opsvis, opstool, vfo and o3seespy.

Each of them is asked of every model of `cases.json`, which has one for each kind of element, material and section.
"""

import re

#: Responses of an element, by one word. The first lines are those of opsvis 1.3.7 and opstool 1.0.26.
WORDS = (
    "force forces localForce localForces basicForce basicForces axialForce basicDeformation basicDeformations deformation "
    "deformations basicDisplacement basicDisplacements chordRotation chordDeformation plasticRotation plasticDeformation "
    "xaxis yaxis zaxis xlocal ylocal zlocal offsets integrationPoints stress strain stresses strains stressAtNodes "
    "localDisplacement localDispJump forcescalars forcescalar slip "
    # Further words of OpenSees' own recorders.
    "globalForce globalForces stressesAtNodes strainsAtNodes integrationWeights basicStiffness stiffness sectionTags energy "
    "Energy defoANDforce deformationsANDforces relVel dampingForces damage inflectionPoint tangentDrift sectionDisplacements"
).split()
#: Responses of a material within an element.
OF_MATERIAL = "stress strain stresses strains tangent stressStrain stressStrainTangent energy".split()
#: Responses of a section.
OF_SECTION = "force forces deformation deformations forceAndDeformation stiffness flexibility fiberData fiberData2".split()
#: Commands that ask of element 1.
OF_ELEMENT = (
    "eleForce eleNodes basicForce basicDeformation basicStiffness eleDynamicalForce getEleClassTags sectionLocation "
    "sectionWeight sectionTag getNumElements"
).split()
#: Commands that ask of section 1 or 2 of element 1.
OF_ONE_SECTION = "sectionLocation sectionWeight sectionTag sectionStiffness sectionFlexibility sectionDisplacement".split()
#: Commands that ask of the model or a node.
OF_MODEL = "getNodeTags getEleTags getNDM getNDF getFixedNodes getEleClassTags getCrdTransfTags getPatterns getNumElements".split()
OF_NODE = "nodeCoord nodeDisp nodeReaction nodeUnbalance nodeDOFs getNDF getFixedDOFs nodeMass".split()


def questions():
    """All questions, each a command and its words."""
    out = [("eleResponse", 1, w) for w in WORDS]
    for where in ("material", "integrPoint"):
        out += [("eleResponse", 1, where, i, w) for i in "12" for w in OF_MATERIAL]
    out += [("eleResponse", 1, "Material", "1", "fiber", k, w) for k in "12" for w in ("stresses", "strains", "stress")]
    out += [("eleResponse", 1, "section", w) for w in OF_SECTION]
    out += [("eleResponse", 1, "section", i, w) for i in "12" for w in OF_SECTION]
    out += [("eleResponse", 1, "section", "fiberData2", 1), ("eleResponse", 1, "section", "1", "fiber", 0.1, 0.05, "stressStrain")]
    out += [("eleResponse", 1, "section", "fiber", 0.1, 0.05, "stressStrain")]
    out += [(c, 1) for c in OF_ELEMENT]
    out += [(c, 1, i) for i in (1, 2) for c in OF_ONE_SECTION]
    out += [(c, 1, 1, dof) for c in ("sectionForce", "sectionDeformation") for dof in (1, 2)]
    out += [("cbdiDisplacement", 1, 0.3), ("sectionDisplacement", 1, 2, "-local")]
    out += [(c,) for c in OF_MODEL] + [(c, n) for n in (1, 2) for c in OF_NODE]
    return out


def name(question):
    """A question as it stands in the stored answers."""
    return " ".join(str(w) for w in question)


def kind(case):
    """`element`, `bearing`, `material` or `section`."""
    return case["name"].split(" ", 1)[0]


_WHOLE = re.compile(r"[+-]?\d+$")


def _word(text):
    if _WHOLE.match(text):
        return int(text)
    try:
        return float(text)
    except ValueError:
        return text


def calls(text):
    """Commands of a text in Tcl without variables, each a name and its words; a body in braces follows its command."""
    text = re.sub(r"\\\n", " ", text)
    for head, body in re.findall(r"^[ \t]*([^\n{}]+)(?:\{([^}]*)\})?[ \t]*$", text, re.M):
        words = head.split()
        yield words[0], [_word(w) for w in words[1:]]
        if body:
            yield from calls(body)


def needed(parts, commands):
    """Those of the parts whose tags the commands name, also through other parts."""
    groups = []
    for command, words in calls(parts):
        if command in ("patch", "layer", "fiber"):
            groups[-1].append((command, words))
        else:
            groups.append([(command, words)])
    named = {w for _, words in calls(commands) for w in words if isinstance(w, int)}
    kept = []
    for group in reversed(groups):
        if group[0][1][1] in named:
            kept.insert(0, group)
            named |= {w for _, words in group for w in words if isinstance(w, int)}
    return [call for group in kept for call in group]


def build(ops, data, case):
    """Make the model of a case and take it to a state; the code of the analysis.

    All degrees of freedom are moved, so that the state is given by the question and not by an analysis.
    """
    ops.wipe()
    for command, words in calls(case["nodes"]):
        getattr(ops, command)(*words)
    for command, words in needed(data["parts"][case["parts"]], case["commands"]):
        try:
            getattr(ops, command)(*words)
        except Exception:  # noqa: BLE001, PERF203: a tag may be that of a part that the element does not take
            continue
    for command, words in calls(case["commands"]):
        getattr(ops, command)(*words)
    if 1 not in ops.getEleTags():
        raise ValueError("the program does not make the element")
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    size = {"bearing": 1e-4}.get(kind(case), 1e-3)
    dofs = ops.getNDF()[0]
    for node in ops.getNodeTags():
        for dof in range(1, dofs + 1):
            # Any numbers of both signs, none of them like another.
            ops.sp(node, dof, size * ((7 * node + 5 * dof + 3 * node * dof) % 19 - 9.3) / 10)
    ops.constraints("Penalty", 1e13, 1e13)
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormDispIncr", 1e-10, 50)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    code = ops.analyze(1)
    ops.reactions()
    return code


def ask(ops, question):
    """The answer to a question: a list of numbers, a text, or `raises`."""
    try:
        answer = getattr(ops, question[0])(*question[1:])
    except Exception:  # noqa: BLE001: openseespy raises errors of several types
        return "raises"
    return plain(answer)


def plain(answer):
    """An answer as it is stored: numbers with seven digits, nothing as an empty list."""
    if answer is None:
        return []
    if isinstance(answer, str):
        return answer
    items = list(answer) if isinstance(answer, (list, tuple)) else [answer]
    return [float(f"{x:.7g}") for x in items]


def same(a, b):
    """True if two answers agree."""
    if isinstance(a, str) or isinstance(b, str):
        return a == b
    if len(a) != len(b):
        return False
    peak = max((abs(x) for x in a if x == x), default=0.0)
    return all(abs(x - y) <= 1e-5 * peak + 1e-9 or (x != x and y != y) for x, y in zip(a, b))
