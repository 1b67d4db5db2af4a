"""Generated from the usages of the commands by `python -m hysteron._stubs`."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, NoReturn, overload

import numpy as np

_Tags = Sequence[int] | np.ndarray
_Word = float | str | np.ndarray | PathLike[str] | Sequence["_Word"]

class OpenSeesError(Exception): ...

def accelCPU(*args: Any) -> NoReturn: ...
def addToParameter(*args: _Word, **options: _Word) -> None:
    """addToParameter(tag, 'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz' | 'loadPattern', pattern, 'loadAtNode', node, dof | 'element'|'region', tag, name, ...)

    Adds a quantity to a parameter that exists.
    """
def algorithm(*args: _Word, **options: _Word) -> None:
    """algorithm('Linear' | 'Newton' | 'ModifiedNewton' | 'NewtonLineSearch' | 'KrylovNewton' | 'SecantNewton' | 'BFGS' | 'Broyden' | ..., <'options'>)

    Chooses the solution algorithm of a step.
    """
def amend(*args: _Word, **options: _Word) -> None:
    """amend('element', tag, <tag, ...>, kind, '-option', value, ..., <'-dir', dir1, <dir2>>, <'-axial', dir | '-axialSeries', ts>, <'-share', k, elastic, <rest> | '-strengthBeside', k> | 'amend', 'element', tag, <tag, ...>, 'learned', '-range', U, V, T, '-hysteresis', form, level, strength, <'-spring', k>, <'-piece', side, at, k, ...>, <'-moving', k>, <'-curve', slope, ...>, <'-unequal', strength>, <'-stop', level, strength, ...>, <'-maxwell', time, k, ...>, <'-dashpot', power, c, ...>, <'-viscous', width, force, ...>, <'-work', D>, <'-factor', part, variable, ...>, <'-channel', name, mean, deviation, ...>, <'-force', name, a, low, high, ...>, <'-series', ts, ...>, <'-beyond', 'clamp'|'continue'>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'learned', '-file', file, <'-series', ts, ...>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'hinges', '-mat', mat, <'-end', 'i'|'j'> | 'amend', 'element', tag, <tag, ...>, 'ends', '-from', old, '-to', new | 'amend', 'node', tag, 'dampedAs', other | 'amend', 'node', tag, 'late', '-by', delay | 'amend', 'parameter', name, '-factor', f, <'-from', t1>, <'-reached', t2>, <'-to', t3>, <'-recovered', t4>)

    Adds physics to an element that exists; see Amendments.
    """
def analysis(*args: _Word, **options: _Word) -> None:
    """analysis('Static' | 'Transient' | 'VariableTransient')

    Makes the analysis of the chosen parts.
    """
def analyze(steps: _Word, dt: _Word = ..., *more: _Word, progress: bool = False) -> int: ...
def barrier() -> None:
    """barrier()

    Has no effect: there is one process.
    """
@overload
def basicDeformation(element: float, dof: float = ..., /) -> list[float] | float:
    """basicDeformation(element, <dof>)

    Returns the basic deformations of an element.
    """
@overload
def basicDeformation(element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
@overload
def basicForce(element: float, dof: float = ..., /) -> list[float] | float:
    """basicForce(element, <dof>)

    Returns the basic forces of an element.
    """
@overload
def basicForce(element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
def basicStiffness(element: _Word) -> list[float]:
    """basicStiffness(element)

    Returns the basic stiffness of an element.
    """
def Bcast(data: _Word) -> None:
    """Bcast(data)

    Has no effect: there is one process.
    """
def beamIntegration(*args: _Word, **options: _Word) -> None:
    """beamIntegration('Lobatto'|'Legendre'|'Radau'|'NewtonCotes'|'Trapezoidal'|'CompositeSimpson', tag, section, n | 'HingeRadau'|'HingeRadauTwo'|'HingeMidpoint'|'HingeEndpoint', tag, secI, lpI, secJ, lpJ, secE | 'UserHinge', tag, secE, n, sections, ..., places, ..., weights, ..., n, sections, ..., places, ..., weights, ... | 'UserDefined'|'FixedLocation'|'LowOrder'|'MidDistance', tag, n, sections, ..., places, ..., <weights, ...>)

    Makes a rule of integration along a beam, with its sections.
    """
def block2D(nx: _Word, ny: _Word, firstNode: _Word, firstElement: _Word, kind: _Word) -> None:
    """block2D(nx, ny, firstNode, firstElement, kind)

    Makes a grid of nodes and of elements between them, in the plane.
    """
def block3D(nx: _Word, ny: _Word, nz: _Word, firstNode: _Word, firstElement: _Word, kind: _Word) -> None:
    """block3D(nx, ny, nz, firstNode, firstElement, kind)

    Makes a grid of nodes and of bricks between them.
    """
def build() -> None: ...
def cbdiDisplacement(element: _Word, x: _Word) -> list[float]:
    """cbdiDisplacement(element, x)

    Returns the global displacements along x, y and z of a place of a force-based beam.
    """
def classType(*args: _Word, **options: _Word) -> str:
    """classType('section'|'element', tag)

    Returns the name of the class of a section or an element.
    """
def columns(file: _Word) -> None:
    """columns(file)

    Returns the columns of a table of numbers as a list of lists.
    """
def computeGradients() -> None:
    """computeGradients()

    Has no effect: derivatives are those of the last step.
    """
def constraints(*args: _Word, **options: _Word) -> None:
    """constraints('Plain' | 'Transformation' | 'Penalty', alphaS, alphaM | 'Lagrange', <alphaS, alphaM>)

    Chooses how constraints are enforced.
    """
def convertBinaryToText(*args: Any) -> NoReturn: ...
def convertTextToBinary(*args: Any) -> NoReturn: ...
def correlate(*args: Any) -> NoReturn: ...
def damping(*args: _Word, **options: _Word) -> None:
    """damping(kind, tag, ...)

    Makes a damping of single elements, for their option -damp and for region -damp.
    """
def database(*args: _Word, **options: _Word) -> None:
    """database('File', name)

    Names the files of save and restore.
    """
def defaultUnits(*args: _Word) -> None: ...
def display(*args: _Word, **options: _Word) -> None:
    """display(...)

    Accepted without effect.
    """
def domainChange() -> None:
    """domainChange()

    Accepted without effect: a change of the model is noticed by itself.
    """
def domainCommitTag(*args: Any) -> NoReturn: ...
def eigen(*args: _Word, **options: _Word) -> list[float]:
    """eigen(<solver>, <'-generalized' | '-standard'>, <'-findLargest'>, count)

    Computes modes; returns the eigenvalues, squares of the circular frequencies.
    """
def eleDynamicalForce(element: _Word, dof: _Word = ...) -> list[float] | float:
    """eleDynamicalForce(element, <dof>)

    Returns the global forces of an element with those of its damping and its inertia.
    """
@overload
def eleForce(element: float, dof: float = ..., /) -> list[float] | float:
    """eleForce(element, <dof>)

    Returns the global forces of an element.
    """
@overload
def eleForce(element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
def eleLoad(*args: _Word, **options: _Word) -> None:
    """eleLoad('-ele', tag, ... | '-range', first, last, '-type', '-beamUniform', ... | '-beamUniformMoment', mz | '-beamPoint', ..., <'-pattern', tag>)

    Adds loads on beams to a pattern.
    """
def element(*args: _Word, **options: _Word) -> None:
    """element(kind, tag, iNode, jNode, ...)

    Makes an element between nodes.
    """
def eleNodes(element: _Word, /) -> list[int]:
    """eleNodes(element)

    Returns the tags of the nodes of an element.
    """
def eleResponse(*args: _Word, **options: _Word) -> list[float]:
    """eleResponse(element, response, ...)

    Returns a response of an element, by the names that recorders use.
    """
def eleType(element: _Word) -> str:
    """eleType(element)

    Returns the kind of an element.
    """
def equalDOF(*args: _Word, **options: _Word) -> None:
    """equalDOF(retained, constrained, dof1, <dof2, ...>)

    Gives degrees of freedom of two nodes the same displacement.
    """
def equalDOF_Mixed(*args: _Word, **options: _Word) -> None:
    """equalDOF_Mixed(retained, constrained, count, retainedDof1, constrainedDof1, <retainedDof2, constrainedDof2, ...>)

    Gives degrees of freedom of two nodes the same displacement, pair by pair.
    """
def fiber(y: _Word, z: _Word, area: _Word, material: _Word) -> None:
    """fiber(y, z, area, material)

    Adds one fibre to the section.
    """
def figure(*args: _Word, **options: _Word) -> None:
    """figure(file.svg, '-title', text, '-x', label, '-y', label, <'-xrange', low, high>, <'-yrange', low, high>, <'-equal'>, '-line', name, xs, ys, ..., <'-dots', name, xs, ys, ...>)

    Draws curves into an SVG file.
    """
def fill(mode: _Word) -> None:
    """fill(mode)

    Accepted without effect.
    """
def filter(*args: Any) -> NoReturn: ...
def findCurvatures(*args: Any) -> NoReturn: ...
def findDesignPoint(*args: Any) -> NoReturn: ...
def fix(*args: _Word, **options: _Word) -> None:
    """fix(node, flag1, <flag2, ...> (1 held, 0 free))

    Holds degrees of freedom of a node.
    """
def fixX(*args: _Word, **options: _Word) -> None:
    """fixX(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)

    Holds degrees of freedom of all nodes at a coordinate x.
    """
def fixY(*args: _Word, **options: _Word) -> None:
    """fixY(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)

    Holds degrees of freedom of all nodes at a coordinate y.
    """
def fixZ(*args: _Word, **options: _Word) -> None:
    """fixZ(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)

    Holds degrees of freedom of all nodes at a coordinate z.
    """
def frictionModel(*args: _Word, **options: _Word) -> None:
    """frictionModel(kind, tag, ...)

    Makes a law of friction, for sliding bearings.
    """
def functionEvaluator(*args: Any) -> NoReturn: ...
def geomTransf(*args: _Word, **options: _Word) -> None:
    """geomTransf('Linear'|'PDelta'|'Corotational', tag, <x, y, z, 'of', 'a', 'vector', 'in', 'the', 'local', 'x-z', 'plane,', 'in', 'space'>, <'-jntOffset', dxi, dyi, <dzi>, dxj, dyj, <dzj>>)

    Makes a transformation between local and global coordinates, for beams.
    """
def getCDF(*args: Any) -> NoReturn: ...
def getConstrainedDOFs(*args: _Word, **options: _Word) -> list[int]:
    """getConstrainedDOFs(node, <retained>, <dof>)

    Returns the degrees of freedom of a node that follow others.
    """
def getConstrainedNodes(retained: _Word = ...) -> list[int]:
    """getConstrainedNodes(<retained>)

    Returns the tags of the nodes that follow others.
    """
def getCrdTransfTags() -> list[int]:
    """getCrdTransfTags()

    Returns the tags of all geometric transformations.
    """
def getDampTangent() -> None:
    """getDampTangent()

    Returns the derivative of the stress of the chosen law with respect to the strain rate.
    """
def getEleClassTags(element: _Word = ...) -> list[int]:
    """getEleClassTags(<element>)

    Returns OpenSees' numbers of the classes of all elements, or of one.
    """
def getEleLoadClassTags(pattern: _Word = ...) -> list[int]:
    """getEleLoadClassTags(<pattern>)

    Returns OpenSees' number of the class of each element load.
    """
def getEleLoadData(pattern: _Word = ...) -> list[float]:
    """getEleLoadData(<pattern>)

    Returns the numbers of all element loads, in OpenSees' order.
    """
def getEleLoadTags(pattern: _Word = ...) -> list[int]:
    """getEleLoadTags(<pattern>)

    Returns the element of each element load, of all patterns or of one.
    """
def getEleTags() -> list[int]:
    """getEleTags()

    Returns the tags of all elements.
    """
def getFixedDOFs(node: _Word) -> list[int]:
    """getFixedDOFs(node)

    Returns the degrees of freedom of a node that are held.
    """
def getFixedNodes() -> list[int]:
    """getFixedNodes()

    Returns the tags of all nodes with a constraint of their own.
    """
def getInverseCDF(*args: Any) -> NoReturn: ...
def getLoadFactor(pattern: _Word) -> float:
    """getLoadFactor(pattern)

    Returns the load factor of a pattern.
    """
def getLSFTags(*args: Any) -> NoReturn: ...
def getMean(*args: Any) -> NoReturn: ...
def getNDF(node: _Word = ...) -> list[int]:
    """getNDF(<node>)

    Returns the number of degrees of freedom of a node.
    """
def getNDM() -> list[int]:
    """getNDM()

    Returns the number of dimensions.
    """
def getNodeLoadData(pattern: _Word = ...) -> list[float]:
    """getNodeLoadData(<pattern>)

    Returns the forces of all nodal loads.
    """
def getNodeLoadTags(pattern: _Word = ...) -> list[int]:
    """getNodeLoadTags(<pattern>)

    Returns the node of each nodal load, of all patterns or of one.
    """
def getNodeTags() -> list[int]:
    """getNodeTags()

    Returns the tags of all nodes.
    """
def getNodeTemperature(*args: Any) -> NoReturn: ...
def getNP() -> int:
    """getNP()

    Returns 1: there is one process.
    """
def getNumElements() -> list[int]:
    """getNumElements()

    Returns the number of elements.
    """
def getNumThreads() -> int: ...
def getParamTags() -> list[int]:
    """getParamTags()

    Returns the tags of all parameters.
    """
def getParamValue(tag: _Word) -> float:
    """getParamValue(tag)

    Returns the value of a parameter.
    """
def getPatterns() -> list[int]:
    """getPatterns()

    Returns the tags of all load patterns.
    """
def getPDF(*args: Any) -> NoReturn: ...
def getPID() -> int:
    """getPID()

    Returns 0: there is one process.
    """
def getRetainedDOFs(*args: _Word, **options: _Word) -> list[int]:
    """getRetainedDOFs(node, <constrained>, <dof>)

    Returns the degrees of freedom of a node that others follow.
    """
def getRetainedNodes(constrained: _Word = ...) -> list[int]:
    """getRetainedNodes(<constrained>)

    Returns the tags of the nodes that others follow.
    """
def getRVParamTag(*args: Any) -> NoReturn: ...
def getRVTags(*args: Any) -> NoReturn: ...
def getRVValue(*args: Any) -> NoReturn: ...
def getStdv(*args: Any) -> NoReturn: ...
def getStrain() -> float:
    """getStrain()

    Returns the strain of the chosen law.
    """
def getStress() -> float:
    """getStress()

    Returns the stress of the chosen law.
    """
def getTangent() -> float:
    """getTangent()

    Returns the tangent of the chosen law.
    """
def getTime() -> float:
    """getTime()

    Returns the time of the domain.
    """
def gradientEvaluator(*args: Any) -> NoReturn: ...
def gradPerformanceFunction(*args: Any) -> NoReturn: ...
def groundMotion(*args: _Word, **options: _Word) -> None:
    """groundMotion(tag, 'Plain', <'-accel', series>, <'-vel', series>, <'-disp', series>, <'-int', 'Trapezoidal'>, <'-dtInt', dt>, <'-fact', factor> | 'groundMotion', tag, 'Interpolated', motion, ..., '-fact', factor, ...)

    Makes a motion of supports, in a pattern MultipleSupport.
    """
def hystereticBackbone(*args: _Word, **options: _Word) -> None:
    """hystereticBackbone(kind, tag, ...)

    Makes a curve of stress over strain, for uniaxialMaterial Backbone.
    """
def IGA(*args: Any) -> NoReturn: ...
def imposedMotion(*args: _Word, **options: _Word) -> None:
    """imposedMotion(node, dof, groundMotion, <'-other'>)

    Moves a support by a ground motion.
    """
def imposedSupportMotion(*args: _Word, **options: _Word) -> None:
    """imposedSupportMotion(node, dof, groundMotion, <'-other'>)

    Moves a support by a ground motion.
    """
def initialize() -> None:
    """initialize()

    Accepted without effect.
    """
def InitialStateAnalysis(*args: Any) -> NoReturn: ...
def integrator(*args: _Word, **options: _Word) -> None:
    """integrator('LoadControl' | 'DisplacementControl' | 'ArcLength' | 'Newmark' | 'HHT' | ..., <'options'>)

    Chooses how a step advances time or load.
    """
def ladder(*args: _Word, **options: _Word) -> None:
    """ladder('on' | 'off')

    Turns the remedies for failed steps on or off, as --ladder does.
    """
def layer(*args: _Word, **options: _Word) -> None:
    """layer('straight', material, n, area, y1, z1, y2, z2 | 'circ', material, n, area, y, z, radius, <angle1, angle2>)

    Adds fibres along a line or an arc, as reinforcing bars.
    """
def limitCurve(*args: _Word, **options: _Word) -> None:
    """limitCurve(kind, tag, element, ...)

    Makes a surface of deformations and forces at which a column fails.
    """
def load(*args: _Word, **options: _Word) -> None:
    """load(node, f1, <f2, ...>, <'-const'>, <'-pattern', tag>)

    Adds a nodal load to a pattern.
    """
def loadConst(*args: _Word, **options: _Word) -> None:
    """loadConst(<'-time', time>)

    Keeps the loads of all patterns at their present level.
    """
@overload
def localForce(element: float, dof: float = ..., /) -> list[float] | float:
    """localForce(element, <dof>)

    Returns the local forces of an element.
    """
@overload
def localForce(element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
def logCommands(*args: _Word, **options: _Word) -> None:
    """logCommands(...)

    Accepted without effect.
    """
def logFile(*args: _Word, **options: _Word) -> None:
    """logFile(file, ...)

    Accepted without effect.
    """
def mass(*args: _Word, **options: _Word) -> None:
    """mass(node, m1, <m2, ...>)

    Sets the mass of a node in each of its directions.
    """
def meritFunctionCheck(*args: Any) -> NoReturn: ...
def mesh(*args: Any) -> NoReturn: ...
def metaData(*args: _Word) -> None: ...
def modalDamping(*args: _Word, **options: _Word) -> None:
    """modalDamping(ratio | ratio1, ratio2, ...)

    Damps modes that eigen has found, each by a ratio.
    """
def modalDampingQ(*args: _Word, **options: _Word) -> None:
    """modalDampingQ(ratio | ratio1, ratio2, ...)

    As modalDamping, in the forces only and not in the tangent.
    """
def modalProperties(*args: _Word, **options: _Word) -> dict[str, list[float]] | None:
    """modalProperties(<'-print'>, <'-file', file>, <'-unorm'>, <'-return'>)

    Computes participation factors and effective masses of the modes.
    """
def model(*args: _Word, **options: _Word) -> None:
    """model('BasicBuilder', '-ndm', ndm, <'-ndf', ndf>)

    Sets the dimensions of the model and the degrees of freedom of its nodes. It comes before all that it counts for. basic is another name of the kind.
    """
def modulatingFunction(*args: Any) -> NoReturn: ...
def motionFile(*args: _Word, **options: _Word) -> list[float]:
    """motionFile(series, file, <'-factor', c>, <'-dt', dt>, <'-useLast'>, <'-channel', name>, <'-quantity', word>, <'-unit', unit>, <'-layout', word>, <'-to', unit>)

    Reads a ground motion into a Path series and returns the time step and the number of values.
    """
def nDMaterial(*args: _Word, **options: _Word) -> None:
    """nDMaterial(kind, tag, ...)

    Makes a law of a continuum, for quad, bricks and plates.
    """
def NDTest(*args: Any) -> NoReturn: ...
def node(*args: _Word, **options: _Word) -> None:
    """node(tag, x, <y, <z>>, <'-ndf', ndf>, <'-mass', m, ...>, <'-disp', u, ...>, <'-vel', v, ...>)

    Makes a node.
    """
@overload
def nodeAccel(node: float, dof: float = ..., /) -> list[float] | float:
    """nodeAccel(node, <dof>)

    Returns the acceleration of a node.
    """
@overload
def nodeAccel(node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
def nodeBounds() -> list[float]:
    """nodeBounds()

    Returns the smallest and largest coordinates of all nodes.
    """
@overload
def nodeCoord(node: float, direction: float = ..., /) -> list[float] | float:
    """nodeCoord(node, <direction>)

    Returns the coordinates of a node.
    """
@overload
def nodeCoord(node: _Tags = ..., direction: _Word = ..., /) -> np.ndarray: ...
@overload
def nodeDisp(node: float, dof: float = ..., /) -> list[float] | float:
    """nodeDisp(node, <dof>)

    Returns the displacement of a node.
    """
@overload
def nodeDisp(node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
def nodeDOFs(node: _Word) -> list[int]:
    """nodeDOFs(node)

    Returns the numbers of the equations of a node.
    """
def nodeEigenvector(node: _Word, mode: _Word, dof: _Word = ...) -> list[float] | float:
    """nodeEigenvector(node, mode, <dof>)

    Returns the mode shape at a node.
    """
def nodeMass(node: _Word, dof: _Word = ...) -> list[float] | float:
    """nodeMass(node, <dof>)

    Returns the mass of a node.
    """
def nodePressure(node: _Word) -> float: ...
@overload
def nodeReaction(node: float, dof: float = ..., /) -> list[float] | float:
    """nodeReaction(node, <dof>)

    Returns the reaction of a node in the present state; reactions chooses what it includes.
    """
@overload
def nodeReaction(node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
def nodeResponse(*args: _Word, **options: _Word) -> float:
    """nodeResponse(node, dof, response (1 displacement, 2 velocity, 3 acceleration))

    Returns a displacement, velocity or acceleration of a node by number.
    """
def nodeUnbalance(node: _Word, dof: _Word = ...) -> list[float] | float:
    """nodeUnbalance(node, <dof>)

    Returns the unbalanced load of a node.
    """
@overload
def nodeVel(node: float, dof: float = ..., /) -> list[float] | float:
    """nodeVel(node, <dof>)

    Returns the velocity of a node.
    """
@overload
def nodeVel(node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
def numberer(*args: _Word, **options: _Word) -> None:
    """numberer('Plain' | 'RCM' | 'AMD')

    Chooses the order of the equations. Every name is accepted.
    """
def numFact() -> None:
    """numFact()

    Returns the number of factorisations of the last step.
    """
def numIter() -> int:
    """numIter()

    Returns the number of iterations of the last step; 0 of an algorithm that searches along lines or has no test.
    """
def OpenSeesParameter(*args: Any) -> NoReturn: ...
def parameter(*args: _Word, **options: _Word) -> int:
    """parameter(tag, <value> | <'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz'> | <'node', node, 'disp', dof> | <'loadPattern', pattern, 'loadAtNode', node, dof> | <'loadPattern', pattern, 'lambda'> | <'element'|'region', tag, name, ...>)

    Declares a quantity that updateParameter can change. Of an element it is a number of its command, or of the command of a law in it, also one that was left out. OpenSees has few of them: its names are known too.
    """
def partition(element: _Word = ...) -> None:
    """partition(<element>)

    Has no effect: there is one process.
    """
def patch(*args: _Word, **options: _Word) -> None:
    """patch('quad', material, nIJ, nJK, yI, zI, yJ, zJ, yK, zK, yL, zL | 'rect', material, nY, nZ, yI, zI, yK, zK | 'circ', material, nCirc, nRad, y, z, rInner, rOuter, <angle1, angle2>)

    Adds fibres that fill an area.
    """
def pattern(*args: _Word, **options: _Word) -> None:
    """pattern('Plain', tag, series, <'-fact', factor>)

    Makes a pattern of loads that follow a time series, or an excitation.
    """
def performanceFunction(*args: Any) -> NoReturn: ...
def plane(front: _Word, back: _Word) -> None:
    """plane(front, back)

    Accepted without effect.
    """
def plot(file: str | PathLike[str] | None = None, *, title: str = ..., units: tuple[str, str] = ..., modes: int = ..., show: bool = ...) -> Any: ...
def port(xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word) -> None:
    """port(xmin, xmax, ymin, ymax)

    Accepted without effect.
    """
def pressureConstraint(*args: Any) -> NoReturn: ...
def printA(*args: _Word, **options: _Word) -> list[float] | None:
    """printA(<'-file', file>, <'-ret'>)

    Prints the matrix of the equations, under system Diagonal its diagonal.
    """
def printB(*args: _Word, **options: _Word) -> list[float] | None:
    """printB(<'-file', file>, <'-ret'>)

    Prints the right-hand side of the equations.
    """
def printGID(*args: Any) -> NoReturn: ...
def printModel(*args: _Word, **options: _Word) -> None:
    """printModel(<'-file', file>, <'-JSON'>, <'-node', <'-flag', n>, <tag, ...>>, <'-ele', <'-flag', n>, <tag, ...>>)

    Prints nodes and elements.
    """
def printX(*args: _Word, **options: _Word) -> list[float] | None:
    """printX(<'-file', file>, <'-ret'>)

    Prints the solution of the equations that the last iteration has found.
    """
def probabilityTransformation(*args: Any) -> NoReturn: ...
def projection(mode: _Word) -> None:
    """projection(mode)

    Accepted without effect.
    """
def prp(x: _Word, y: _Word, z: _Word) -> None:
    """prp(x, y, z)

    Accepted without effect.
    """
def pyversion(*args: _Word) -> str: ...
def randomNumberGenerator(*args: Any) -> NoReturn: ...
def randomVariable(*args: Any) -> NoReturn: ...
def rayleigh(*args: _Word, **options: _Word) -> None:
    """rayleigh(alphaM, betaK, betaK0, betaKc, <'-ele', tag, ...>, <'-node', tag, ...>)

    Sets Rayleigh damping of the model: C = \\alpha_M M + \\beta_K K + \\beta_{K0} K_0 + \\beta_{Kc} K_c$ with the current, initial and committed stiffness.
    """
def reactions(*args: _Word, **options: _Word) -> None:
    """reactions(<'-dynamic'>, <'-rayleigh'>)

    Chooses what nodeReaction includes: inertia with -dynamic, Rayleigh damping with -rayleigh.
    """
def record() -> None:
    """record()

    Makes all recorders write a row now.
    """
def recorder(*args: _Word, **options: _Word) -> int:
    """recorder(kind, '-file', file, ...)

    Records responses in a file.
    """
def recv(*args: _Word, **options: _Word) -> None:
    """recv('-pid', process, variable)

    Has no effect: there is one process. The variable stays as it is.
    """
def region(*args: _Word, **options: _Word) -> None:
    """region(tag, <'-ele', tag, ...>, <'-eleOnly', tag, ...>, <'-eleRange', first, last>, <'-eleOnlyRange', ...>, <'-node', tag, ...>, <'-nodeOnly', ...>, <'-nodeRange', first, last>, <'-nodeOnlyRange', ...>, <'-rayleigh', alphaM, betaK, betaK0, betaKc>, <'-damp', damping>)

    Names nodes and elements together, for recorders, parameters or Rayleigh damping of their own.
    """
def reliabilityConvergenceCheck(*args: Any) -> NoReturn: ...
def remesh(*args: Any) -> NoReturn: ...
def remove(*args: _Word, **options: _Word) -> None:
    """remove('loadPattern', tag | 'recorders' | 'recorder', tag | 'element', tag | 'node', tag | 'sp', tag | 'sp', node, dof, <pattern> | 'mp', tag | 'material', tag | 'timeSeries', tag | 'parameter', tag)

    Removes something from the model.
    """
def reset() -> None:
    """reset()

    Returns to the state at the start.
    """
def responseSpectrumAnalysis(*args: _Word, **options: _Word) -> None:
    """responseSpectrumAnalysis(series, direction | direction, '-Tn', periods, '-Sa', accelerations, <'-scale', factor>, <'-mode', mode>)

    Makes a step for each mode with its largest displacements under a response spectrum. The script combines the modes.
    """
def restore(tag: _Word) -> None:
    """restore(tag)

    Goes back to a saved state of the same model, in this run or another one.
    """
def revertToStart() -> None:
    """revertToStart()

    Returns to the state at the start.
    """
def rigidDiaphragm(*args: _Word, **options: _Word) -> None:
    """rigidDiaphragm(perpendicular, retained, constrained1, <constrained2, ...>)

    Makes nodes move in a plane like one rigid body. In a plane model 1 and 2 make that displacement equal, and 3 makes a rigid body.
    """
def rigidLink(*args: _Word, **options: _Word) -> None:
    """rigidLink('beam'|'bar', retained, constrained)

    Makes a node follow another: beam with its rotation, bar without.
    """
def rootFinding(*args: Any) -> NoReturn: ...
def runFORMAnalysis(*args: Any) -> NoReturn: ...
def runFOSMAnalysis(*args: Any) -> NoReturn: ...
def runImportanceSamplingAnalysis(*args: Any) -> NoReturn: ...
def runSORMAnalysis(*args: Any) -> NoReturn: ...
def save(tag: _Word) -> None:
    """save(tag)

    Saves the committed state, exact to the bit. The next step begins anew, as it does after restore.
    """
def sdfResponse(*args: _Word, **options: _Word) -> list[float]:
    """sdfResponse(m, zeta, k, Fy, alpha, dtF, file, dt) or m, zeta, k, Fy, alpha, series, dt, <'-uresid', u>, <'-umaxprev', u>, <'-tend', t>

    Returns the largest and the last displacement, the plastic one, the largest acceleration and its time of an elastic-plastic system of one degree of freedom under a series of forces.
    """
def searchDirection(*args: Any) -> NoReturn: ...
def searchPeerNGA(*args: Any) -> NoReturn: ...
def section(*args: _Word, **options: _Word) -> None:
    """section(kind, tag, ...)

    Makes a cross-section.
    """
def sectionDeformation(element: _Word, section: _Word, dof: _Word = ...) -> list[float] | float:
    """sectionDeformation(element, section, <dof>)

    Returns the deformations of a section of a beam.
    """
def sectionDisplacement(*args: _Word, **options: _Word) -> list[float]:
    """sectionDisplacement(element, section, <'-local'>)

    Returns the displacements along x, y and z of a section of a force-based beam. Its deflection is the double integral of the polynomial through the curvatures of the sections.
    """
def sectionFlexibility(element: _Word, section: _Word, dof: _Word = ...) -> list[float]:
    """sectionFlexibility(element, section, <dof>)

    Returns the inverse of the tangent of a section of a beam.
    """
def sectionForce(element: _Word, section: _Word, dof: _Word = ...) -> list[float] | float:
    """sectionForce(element, section, <dof>)

    Returns the resultants of a section of a beam.
    """
def sectionLocation(element: _Word, section: _Word = ...) -> list[float] | float:
    """sectionLocation(element, <section>)

    Returns the places of the sections along a beam.
    """
def sectionStiffness(element: _Word, section: _Word, dof: _Word = ...) -> list[float]:
    """sectionStiffness(element, section, <dof>)

    Returns the tangent of a section of a beam.
    """
def sectionTag(element: _Word, section: _Word = ...) -> list[int] | int:
    """sectionTag(element, <section>)

    Returns the tags of the sections along a beam.
    """
def sectionWeight(element: _Word, section: _Word = ...) -> list[float] | float:
    """sectionWeight(element, <section>)

    Returns the weights of the sections along a beam.
    """
def send(*args: _Word, **options: _Word) -> None:
    """send('-pid', process, data)

    Has no effect: there is one process.
    """
def sensitivityAlgorithm(*args: _Word, **options: _Word) -> None:
    """sensitivityAlgorithm('-computeAtEachStep' | '-computeByCommand')

    Begins derivatives of the response with respect to all parameters. They are central differences of two more analyses for each parameter, which make the same steps. Every law and element has them.
    """
def sensLambda(pattern: _Word, parameter: _Word) -> float:
    """sensLambda(pattern, parameter)

    Returns the derivative of the load factor of a pattern with respect to a parameter.
    """
def sensNodeAccel(node: _Word, dof: _Word, parameter: _Word) -> float:
    """sensNodeAccel(node, dof, parameter)

    Returns the derivative of an acceleration with respect to a parameter.
    """
def sensNodeDisp(node: _Word, dof: _Word, parameter: _Word) -> float:
    """sensNodeDisp(node, dof, parameter)

    Returns the derivative of a displacement with respect to a parameter.
    """
def sensNodePressure(*args: Any) -> NoReturn: ...
def sensNodeVel(node: _Word, dof: _Word, parameter: _Word) -> float:
    """sensNodeVel(node, dof, parameter)

    Returns the derivative of a velocity with respect to a parameter.
    """
def sensSectionForce(*args: _Word, **options: _Word) -> list[float]:
    """sensSectionForce(element, <section>, dof, parameter)

    Returns the derivative of a resultant of a section with respect to a parameter.
    """
def setCreep(*args: Any) -> NoReturn: ...
def setElementRayleighDampingFactors(element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word) -> None:
    """setElementRayleighDampingFactors(element, alphaM, betaK, betaK0, betaKc)

    Sets Rayleigh damping of one element.
    """
def setElementRayleighFactors(element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word) -> None:
    """setElementRayleighFactors(element, alphaM, betaK, betaK0, betaKc)

    Sets Rayleigh damping of one element.
    """
def setMaxOpenFiles(n: _Word) -> None:
    """setMaxOpenFiles(n)

    Accepted without effect.
    """
def setNodeAccel(*args: _Word, **options: _Word) -> None:
    """setNodeAccel(node, dof, value, <'-commit'>)

    Sets the acceleration of a node.
    """
def setNodeCoord(node: _Word, direction: _Word, value: _Word) -> None:
    """setNodeCoord(node, direction, value)

    Moves a node that has no displacement.
    """
def setNodeDisp(*args: _Word, **options: _Word) -> None:
    """setNodeDisp(node, dof, value, <'-commit'>)

    Sets the displacement of a node.
    """
def setNodeMass(node: _Word, dof: _Word, mass: _Word) -> None:
    """setNodeMass(node, dof, mass)

    Sets the mass of a node in one direction.
    """
def setNodePressure(*args: Any) -> NoReturn: ...
def setNodeTemperature(*args: Any) -> NoReturn: ...
def setNodeVel(*args: _Word, **options: _Word) -> None:
    """setNodeVel(node, dof, value, <'-commit'>)

    Sets the velocity of a node.
    """
def setNumThreads(number: int) -> None: ...
def setParameter(*args: _Word, **options: _Word) -> None:
    """setParameter('-val', value, <'-ele', element, ... | '-eleRange', first, last>, name, ... | '-node', node, ..., 'mass', 'x'|'y'|'z'|'xy'|'xyz')

    Changes a quantity of elements or nodes once.
    """
def setPrecision(digits: _Word) -> None:
    """setPrecision(digits)

    Sets the digits of recorders that are made afterwards.
    """
def setStartNodeTag(tag: _Word) -> None:
    """setStartNodeTag(tag)

    Has no effect: the nodes that it counts are those of OpenSees' meshes.
    """
def setStrain(strain: _Word, rate: _Word = ...) -> None:
    """setStrain(strain, <rate>)

    Strains the chosen law and commits its state.
    """
def setTime(time: _Word) -> None:
    """setTime(time)

    Sets the clock of the domain.
    """
def ShallowFoundationGen(*args: Any) -> NoReturn: ...
def solveCPU(*args: Any) -> NoReturn: ...
def sp(*args: _Word, **options: _Word) -> None:
    """sp(node, dof, value, <'-const'>, <'-subtractInit'>, <'-pattern', tag>)

    Imposes the displacement of a degree of freedom, in a pattern.
    """
def spectrum(*args: Any) -> NoReturn: ...
def start() -> None:
    """start()

    Accepted without effect.
    """
def startPoint(*args: Any) -> NoReturn: ...
def stepSizeRule(*args: Any) -> NoReturn: ...
def stiffnessDegradation(*args: Any) -> NoReturn: ...
def stop() -> None:
    """stop()

    Accepted without effect.
    """
def strengthControl(*args: Any) -> NoReturn: ...
def strengthDegradation(*args: Any) -> NoReturn: ...
def stripXML(*args: Any) -> NoReturn: ...
def system(*args: _Word, **options: _Word) -> None:
    """system('BandGeneral' | 'BandSPD' | 'ProfileSPD' | 'SparseGeneral' | 'UmfPack' | 'FullGeneral' | ...)

    Chooses the solver. Every name is accepted; see Solvers.
    """
def systemSize() -> int:
    """systemSize()

    Returns the number of equations.
    """
def test(*args: _Word, **options: _Word) -> None:
    """test(kind, tolerance, maxIterations, <printFlag>, <norm>)

    Chooses the test of convergence.
    """
def testIter() -> int:
    """testIter()

    Returns the number of iterations of the last step.
    """
def testNorm() -> list[float]:
    """testNorm()

    Returns the norms of the last test: one of each iteration, and zeros up to the iterations allowed.
    """
def testNorms() -> list[float]:
    """testNorms()

    Returns the norms of the last test: one of each iteration, and zeros up to the iterations allowed.
    """
def testUniaxialMaterial(tag: _Word) -> None:
    """testUniaxialMaterial(tag)

    Chooses the law that setStrain drives.
    """
def timeSeries(*args: _Word, **options: _Word) -> None:
    """timeSeries(kind, tag, ...)

    Makes a factor that varies with time.
    """
def totalCPU(*args: Any) -> NoReturn: ...
def transformUtoX(*args: Any) -> NoReturn: ...
def uniaxialMaterial(*args: _Word, **options: _Word) -> None:
    """uniaxialMaterial(kind, tag, ...)

    Makes a uniaxial law: stress over strain, or force over deformation.
    """
def unloadingRule(*args: Any) -> NoReturn: ...
def updateElementDomain(*args: Any) -> NoReturn: ...
def updateMaterialStage(*args: _Word, **options: _Word) -> None:
    """updateMaterialStage('-material', material, '-stage', stage, <'-parameter', parameter>)

    Has no effect and warns: no law here has stages. In OpenSees it switches soils from elastic to plastic.
    """
def updateParameter(tag: _Word, value: _Word) -> int:
    """updateParameter(tag, value)

    Gives a parameter a new value.
    """
def verify(*args: _Word, **options: _Word) -> None:
    """verify('value'|'error', result, reference, <tolerance>, <text>)

    Compares a result with a number: value by the difference, error by its share of the reference. It prints that they agree, or ends the script.
    """
def version() -> str:
    """version()

    Returns the version of hysteron.
    """
def viewWindow(xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word) -> None:
    """viewWindow(xmin, xmax, ymin, ymax)

    Accepted without effect.
    """
def vpn(x: _Word, y: _Word, z: _Word) -> None:
    """vpn(x, y, z)

    Accepted without effect.
    """
def vrp(x: _Word, y: _Word, z: _Word) -> None:
    """vrp(x, y, z)

    Accepted without effect.
    """
def vup(x: _Word, y: _Word, z: _Word) -> None:
    """vup(x, y, z)

    Accepted without effect.
    """
def watch() -> None: ...
def wipe() -> None:
    """wipe()

    Removes the model, the analysis and the recorders.
    """
def wipeAnalysis() -> None:
    """wipeAnalysis()

    Removes the analysis and keeps the model.
    """
def wipeReliability(*args: Any) -> NoReturn: ...
