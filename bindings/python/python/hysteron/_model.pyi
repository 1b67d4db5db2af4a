"""Generated from the usages of the commands by `python -m hysteron._stubs`."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, NoReturn, overload

import numpy as np

_Tags = Sequence[int] | np.ndarray
_Word = float | str | np.ndarray | PathLike[str] | Sequence["_Word"]

class Recording(dict[str, np.ndarray]):
    code: int

class Model:
    def __init__(
        self, ndm: int | None = None, ndf: int | None = None, *, strict: bool = False, compat: bool = False,
        ladder: bool = False,
    ) -> None: ...
    def accelCPU(self, *args: Any) -> NoReturn: ...
    def addToParameter(self, *args: _Word, **options: _Word) -> None:
        """addToParameter(tag, 'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz' | 'loadPattern', pattern, 'loadAtNode', node, dof | 'element'|'region', tag, name, ...)

        Adds a quantity to a parameter that exists.
        """
    def algorithm(self, *args: _Word, **options: _Word) -> None:
        """algorithm('Linear' | 'Newton' | 'ModifiedNewton' | 'NewtonLineSearch' | 'KrylovNewton' | 'SecantNewton' | 'BFGS' | 'Broyden' | ..., <'options'>)

        Chooses the solution algorithm of a step.
        """
    def amend(self, *args: _Word, **options: _Word) -> None:
        """amend('element', tag, <tag, ...>, kind, '-option', value, ..., <'-dir', dir1, <dir2>>, <'-axial', dir | '-axialSeries', ts>, <'-share', k, elastic, <rest> | '-strengthBeside', k> | 'amend', 'element', tag, <tag, ...>, 'learned', '-range', U, V, T, '-hysteresis', form, level, strength, <'-spring', k>, <'-piece', side, at, k, ...>, <'-moving', k>, <'-curve', slope, ...>, <'-unequal', strength>, <'-stop', level, strength, ...>, <'-maxwell', time, k, ...>, <'-dashpot', power, c, ...>, <'-viscous', width, force, ...>, <'-work', D>, <'-factor', part, variable, ...>, <'-channel', name, mean, deviation, ...>, <'-force', name, a, low, high, ...>, <'-series', ts, ...>, <'-beyond', 'clamp'|'continue'>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'learned', '-file', file, <'-series', ts, ...>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'hinges', '-mat', mat, <'-end', 'i'|'j'> | 'amend', 'element', tag, <tag, ...>, 'ends', '-from', old, '-to', new | 'amend', 'node', tag, 'dampedAs', other | 'amend', 'node', tag, 'late', '-by', delay | 'amend', 'parameter', name, '-factor', f, <'-from', t1>, <'-reached', t2>, <'-to', t3>, <'-recovered', t4>)

        Adds physics to an element that exists; see Amendments.
        """
    def analysis(self, *args: _Word, **options: _Word) -> None:
        """analysis('Static' | 'Transient' | 'VariableTransient')

        Makes the analysis of the chosen parts.
        """
    def barrier(self) -> None:
        """barrier()

        Has no effect: there is one process.
        """
    @overload
    def basicDeformation(self, element: float, dof: float = ..., /) -> list[float] | float:
        """basicDeformation(element, <dof>)

        Returns the basic deformations of an element.
        """
    @overload
    def basicDeformation(self, element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    @overload
    def basicForce(self, element: float, dof: float = ..., /) -> list[float] | float:
        """basicForce(element, <dof>)

        Returns the basic forces of an element.
        """
    @overload
    def basicForce(self, element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    def basicStiffness(self, element: _Word) -> list[float]:
        """basicStiffness(element)

        Returns the basic stiffness of an element.
        """
    def Bcast(self, data: _Word) -> None:
        """Bcast(data)

        Has no effect: there is one process.
        """
    def beamIntegration(self, *args: _Word, **options: _Word) -> None:
        """beamIntegration('Lobatto'|'Legendre'|'Radau'|'NewtonCotes'|'Trapezoidal'|'CompositeSimpson', tag, section, n | 'HingeRadau'|'HingeRadauTwo'|'HingeMidpoint'|'HingeEndpoint', tag, secI, lpI, secJ, lpJ, secE | 'UserHinge', tag, secE, n, sections, ..., places, ..., weights, ..., n, sections, ..., places, ..., weights, ... | 'UserDefined'|'FixedLocation'|'LowOrder'|'MidDistance', tag, n, sections, ..., places, ..., <weights, ...>)

        Makes a rule of integration along a beam, with its sections.
        """
    def block2D(self, nx: _Word, ny: _Word, firstNode: _Word, firstElement: _Word, kind: _Word) -> None:
        """block2D(nx, ny, firstNode, firstElement, kind)

        Makes a grid of nodes and of elements between them, in the plane.
        """
    def block3D(self, nx: _Word, ny: _Word, nz: _Word, firstNode: _Word, firstElement: _Word, kind: _Word) -> None:
        """block3D(nx, ny, nz, firstNode, firstElement, kind)

        Makes a grid of nodes and of bricks between them.
        """
    def build(self) -> None: ...
    def cbdiDisplacement(self, element: _Word, x: _Word) -> list[float]:
        """cbdiDisplacement(element, x)

        Returns the global displacements along x, y and z of a place of a force-based beam.
        """
    def classType(self, *args: _Word, **options: _Word) -> str:
        """classType('section'|'element', tag)

        Returns the name of the class of a section or an element.
        """
    def columns(self, file: _Word) -> None:
        """columns(file)

        Returns the columns of a table of numbers as a list of lists.
        """
    def computeGradients(self) -> None:
        """computeGradients()

        Has no effect: derivatives are those of the last step.
        """
    def constraints(self, *args: _Word, **options: _Word) -> None:
        """constraints('Plain' | 'Transformation' | 'Penalty', alphaS, alphaM | 'Lagrange', <alphaS, alphaM>)

        Chooses how constraints are enforced.
        """
    def convertBinaryToText(self, *args: Any) -> NoReturn: ...
    def convertTextToBinary(self, *args: Any) -> NoReturn: ...
    def copy(self) -> Model: ...
    def correlate(self, *args: Any) -> NoReturn: ...
    def damping(self, *args: _Word, **options: _Word) -> None:
        """damping(kind, tag, ...)

        Makes a damping of single elements, for their option -damp and for region -damp.
        """
    def database(self, *args: _Word, **options: _Word) -> None:
        """database('File', name)

        Names the files of save and restore.
        """
    def defaultUnits(self, *args: _Word) -> None: ...
    def display(self, *args: _Word, **options: _Word) -> None:
        """display(...)

        Accepted without effect.
        """
    def domainChange(self) -> None:
        """domainChange()

        Accepted without effect: a change of the model is noticed by itself.
        """
    def domainCommitTag(self, *args: Any) -> NoReturn: ...
    def eigen(self, *args: _Word, **options: _Word) -> list[float]:
        """eigen(<solver>, <'-generalized' | '-standard'>, <'-findLargest'>, count)

        Computes modes; returns the eigenvalues, squares of the circular frequencies.
        """
    def eleDynamicalForce(self, element: _Word, dof: _Word = ...) -> list[float] | float:
        """eleDynamicalForce(element, <dof>)

        Returns the global forces of an element with those of its damping and its inertia.
        """
    @overload
    def eleForce(self, element: float, dof: float = ..., /) -> list[float] | float:
        """eleForce(element, <dof>)

        Returns the global forces of an element.
        """
    @overload
    def eleForce(self, element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    def eleLoad(self, *args: _Word, **options: _Word) -> None:
        """eleLoad('-ele', tag, ... | '-range', first, last, '-type', '-beamUniform', ... | '-beamUniformMoment', mz | '-beamPoint', ..., <'-pattern', tag>)

        Adds loads on beams to a pattern.
        """
    def element(self, *args: _Word, **options: _Word) -> None:
        """element(kind, tag, iNode, jNode, ...)

        Makes an element between nodes.
        """
    def eleNodes(self, element: _Word, /) -> list[int]:
        """eleNodes(element)

        Returns the tags of the nodes of an element.
        """
    def eleResponse(self, *args: _Word, **options: _Word) -> list[float]:
        """eleResponse(element, response, ...)

        Returns a response of an element, by the names that recorders use.
        """
    def eleType(self, element: _Word) -> str:
        """eleType(element)

        Returns the kind of an element.
        """
    def equalDOF(self, *args: _Word, **options: _Word) -> None:
        """equalDOF(retained, constrained, dof1, <dof2, ...>)

        Gives degrees of freedom of two nodes the same displacement.
        """
    def equalDOF_Mixed(self, *args: _Word, **options: _Word) -> None:
        """equalDOF_Mixed(retained, constrained, count, retainedDof1, constrainedDof1, <retainedDof2, constrainedDof2, ...>)

        Gives degrees of freedom of two nodes the same displacement, pair by pair.
        """
    def fiber(self, y: _Word, z: _Word, area: _Word, material: _Word) -> None:
        """fiber(y, z, area, material)

        Adds one fibre to the section.
        """
    def figure(self, *args: _Word, **options: _Word) -> None:
        """figure(file.svg, '-title', text, '-x', label, '-y', label, <'-xrange', low, high>, <'-yrange', low, high>, <'-equal'>, '-line', name, xs, ys, ..., <'-dots', name, xs, ys, ...>)

        Draws curves into an SVG file.
        """
    def fill(self, mode: _Word) -> None:
        """fill(mode)

        Accepted without effect.
        """
    def filter(self, *args: Any) -> NoReturn: ...
    def findCurvatures(self, *args: Any) -> NoReturn: ...
    def findDesignPoint(self, *args: Any) -> NoReturn: ...
    def fix(self, *args: _Word, **options: _Word) -> None:
        """fix(node, flag1, <flag2, ...> (1 held, 0 free))

        Holds degrees of freedom of a node.
        """
    def fixX(self, *args: _Word, **options: _Word) -> None:
        """fixX(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)

        Holds degrees of freedom of all nodes at a coordinate x.
        """
    def fixY(self, *args: _Word, **options: _Word) -> None:
        """fixY(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)

        Holds degrees of freedom of all nodes at a coordinate y.
        """
    def fixZ(self, *args: _Word, **options: _Word) -> None:
        """fixZ(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)

        Holds degrees of freedom of all nodes at a coordinate z.
        """
    def frictionModel(self, *args: _Word, **options: _Word) -> None:
        """frictionModel(kind, tag, ...)

        Makes a law of friction, for sliding bearings.
        """
    def functionEvaluator(self, *args: Any) -> NoReturn: ...
    def geomTransf(self, *args: _Word, **options: _Word) -> None:
        """geomTransf('Linear'|'PDelta'|'Corotational', tag, <x, y, z, 'of', 'a', 'vector', 'in', 'the', 'local', 'x-z', 'plane,', 'in', 'space'>, <'-jntOffset', dxi, dyi, <dzi>, dxj, dyj, <dzj>>)

        Makes a transformation between local and global coordinates, for beams.
        """
    def getCDF(self, *args: Any) -> NoReturn: ...
    def getConstrainedDOFs(self, *args: _Word, **options: _Word) -> list[int]:
        """getConstrainedDOFs(node, <retained>, <dof>)

        Returns the degrees of freedom of a node that follow others.
        """
    def getConstrainedNodes(self, retained: _Word = ...) -> list[int]:
        """getConstrainedNodes(<retained>)

        Returns the tags of the nodes that follow others.
        """
    def getCrdTransfTags(self) -> list[int]:
        """getCrdTransfTags()

        Returns the tags of all geometric transformations.
        """
    def getDampTangent(self) -> None:
        """getDampTangent()

        Returns the derivative of the stress of the chosen law with respect to the strain rate.
        """
    def getEleClassTags(self, element: _Word = ...) -> list[int]:
        """getEleClassTags(<element>)

        Returns OpenSees' numbers of the classes of all elements, or of one.
        """
    def getEleLoadClassTags(self, pattern: _Word = ...) -> list[int]:
        """getEleLoadClassTags(<pattern>)

        Returns OpenSees' number of the class of each element load.
        """
    def getEleLoadData(self, pattern: _Word = ...) -> list[float]:
        """getEleLoadData(<pattern>)

        Returns the numbers of all element loads, in OpenSees' order.
        """
    def getEleLoadTags(self, pattern: _Word = ...) -> list[int]:
        """getEleLoadTags(<pattern>)

        Returns the element of each element load, of all patterns or of one.
        """
    def getEleTags(self) -> list[int]:
        """getEleTags()

        Returns the tags of all elements.
        """
    def getFixedDOFs(self, node: _Word) -> list[int]:
        """getFixedDOFs(node)

        Returns the degrees of freedom of a node that are held.
        """
    def getFixedNodes(self) -> list[int]:
        """getFixedNodes()

        Returns the tags of all nodes with a constraint of their own.
        """
    def getInverseCDF(self, *args: Any) -> NoReturn: ...
    def getLoadFactor(self, pattern: _Word) -> float:
        """getLoadFactor(pattern)

        Returns the load factor of a pattern.
        """
    def getLSFTags(self, *args: Any) -> NoReturn: ...
    def getMean(self, *args: Any) -> NoReturn: ...
    def getNDF(self, node: _Word = ...) -> list[int]:
        """getNDF(<node>)

        Returns the number of degrees of freedom of a node.
        """
    def getNDM(self) -> list[int]:
        """getNDM()

        Returns the number of dimensions.
        """
    def getNodeLoadData(self, pattern: _Word = ...) -> list[float]:
        """getNodeLoadData(<pattern>)

        Returns the forces of all nodal loads.
        """
    def getNodeLoadTags(self, pattern: _Word = ...) -> list[int]:
        """getNodeLoadTags(<pattern>)

        Returns the node of each nodal load, of all patterns or of one.
        """
    def getNodeTags(self) -> list[int]:
        """getNodeTags()

        Returns the tags of all nodes.
        """
    def getNodeTemperature(self, *args: Any) -> NoReturn: ...
    def getNP(self) -> int:
        """getNP()

        Returns 1: there is one process.
        """
    def getNumElements(self) -> list[int]:
        """getNumElements()

        Returns the number of elements.
        """
    def getNumThreads(self) -> int: ...
    def getParamTags(self) -> list[int]:
        """getParamTags()

        Returns the tags of all parameters.
        """
    def getParamValue(self, tag: _Word) -> float:
        """getParamValue(tag)

        Returns the value of a parameter.
        """
    def getPatterns(self) -> list[int]:
        """getPatterns()

        Returns the tags of all load patterns.
        """
    def getPDF(self, *args: Any) -> NoReturn: ...
    def getPID(self) -> int:
        """getPID()

        Returns 0: there is one process.
        """
    def getRetainedDOFs(self, *args: _Word, **options: _Word) -> list[int]:
        """getRetainedDOFs(node, <constrained>, <dof>)

        Returns the degrees of freedom of a node that others follow.
        """
    def getRetainedNodes(self, constrained: _Word = ...) -> list[int]:
        """getRetainedNodes(<constrained>)

        Returns the tags of the nodes that others follow.
        """
    def getRVParamTag(self, *args: Any) -> NoReturn: ...
    def getRVTags(self, *args: Any) -> NoReturn: ...
    def getRVValue(self, *args: Any) -> NoReturn: ...
    def getStdv(self, *args: Any) -> NoReturn: ...
    def getStrain(self) -> float:
        """getStrain()

        Returns the strain of the chosen law.
        """
    def getStress(self) -> float:
        """getStress()

        Returns the stress of the chosen law.
        """
    def getTangent(self) -> float:
        """getTangent()

        Returns the tangent of the chosen law.
        """
    def getTime(self) -> float:
        """getTime()

        Returns the time of the domain.
        """
    def gradientEvaluator(self, *args: Any) -> NoReturn: ...
    def gradPerformanceFunction(self, *args: Any) -> NoReturn: ...
    def groundMotion(self, *args: _Word, **options: _Word) -> None:
        """groundMotion(tag, 'Plain', <'-accel', series>, <'-vel', series>, <'-disp', series>, <'-int', 'Trapezoidal'>, <'-dtInt', dt>, <'-fact', factor> | 'groundMotion', tag, 'Interpolated', motion, ..., '-fact', factor, ...)

        Makes a motion of supports, in a pattern MultipleSupport.
        """
    def hystereticBackbone(self, *args: _Word, **options: _Word) -> None:
        """hystereticBackbone(kind, tag, ...)

        Makes a curve of stress over strain, for uniaxialMaterial Backbone.
        """
    def IGA(self, *args: Any) -> NoReturn: ...
    def imposedMotion(self, *args: _Word, **options: _Word) -> None:
        """imposedMotion(node, dof, groundMotion, <'-other'>)

        Moves a support by a ground motion.
        """
    def imposedSupportMotion(self, *args: _Word, **options: _Word) -> None:
        """imposedSupportMotion(node, dof, groundMotion, <'-other'>)

        Moves a support by a ground motion.
        """
    def initialize(self) -> None:
        """initialize()

        Accepted without effect.
        """
    def InitialStateAnalysis(self, *args: Any) -> NoReturn: ...
    def integrator(self, *args: _Word, **options: _Word) -> None:
        """integrator('LoadControl' | 'DisplacementControl' | 'ArcLength' | 'Newmark' | 'HHT' | ..., <'options'>)

        Chooses how a step advances time or load.
        """
    def ladder(self, *args: _Word, **options: _Word) -> None:
        """ladder('on' | 'off')

        Turns the remedies for failed steps on or off, as --ladder does.
        """
    def layer(self, *args: _Word, **options: _Word) -> None:
        """layer('straight', material, n, area, y1, z1, y2, z2 | 'circ', material, n, area, y, z, radius, <angle1, angle2>)

        Adds fibres along a line or an arc, as reinforcing bars.
        """
    def limitCurve(self, *args: _Word, **options: _Word) -> None:
        """limitCurve(kind, tag, element, ...)

        Makes a surface of deformations and forces at which a column fails.
        """
    def load(self, *args: _Word, **options: _Word) -> None:
        """load(node, f1, <f2, ...>, <'-const'>, <'-pattern', tag>)

        Adds a nodal load to a pattern.
        """
    def loadConst(self, *args: _Word, **options: _Word) -> None:
        """loadConst(<'-time', time>)

        Keeps the loads of all patterns at their present level.
        """
    @overload
    def localForce(self, element: float, dof: float = ..., /) -> list[float] | float:
        """localForce(element, <dof>)

        Returns the local forces of an element.
        """
    @overload
    def localForce(self, element: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    def logCommands(self, *args: _Word, **options: _Word) -> None:
        """logCommands(...)

        Accepted without effect.
        """
    def logFile(self, *args: _Word, **options: _Word) -> None:
        """logFile(file, ...)

        Accepted without effect.
        """
    def mass(self, *args: _Word, **options: _Word) -> None:
        """mass(node, m1, <m2, ...>)

        Sets the mass of a node in each of its directions.
        """
    def meritFunctionCheck(self, *args: Any) -> NoReturn: ...
    def mesh(self, *args: Any) -> NoReturn: ...
    def metaData(self, *args: _Word) -> None: ...
    def modalDamping(self, *args: _Word, **options: _Word) -> None:
        """modalDamping(ratio | ratio1, ratio2, ...)

        Damps modes that eigen has found, each by a ratio.
        """
    def modalDampingQ(self, *args: _Word, **options: _Word) -> None:
        """modalDampingQ(ratio | ratio1, ratio2, ...)

        As modalDamping, in the forces only and not in the tangent.
        """
    def modalProperties(self, *args: _Word, **options: _Word) -> dict[str, list[float]] | None:
        """modalProperties(<'-print'>, <'-file', file>, <'-unorm'>, <'-return'>)

        Computes participation factors and effective masses of the modes.
        """
    def model(self, *args: _Word, **options: _Word) -> None:
        """model('BasicBuilder', '-ndm', ndm, <'-ndf', ndf>)

        Sets the dimensions of the model and the degrees of freedom of its nodes. It comes before all that it counts for. basic is another name of the kind.
        """
    def modulatingFunction(self, *args: Any) -> NoReturn: ...
    def motionFile(self, *args: _Word, **options: _Word) -> list[float]:
        """motionFile(series, file, <'-factor', c>, <'-dt', dt>, <'-useLast'>, <'-channel', name>, <'-quantity', word>, <'-unit', unit>, <'-layout', word>, <'-to', unit>)

        Reads a ground motion into a Path series and returns the time step and the number of values.
        """
    def nDMaterial(self, *args: _Word, **options: _Word) -> None:
        """nDMaterial(kind, tag, ...)

        Makes a law of a continuum, for quad, bricks and plates.
        """
    def NDTest(self, *args: Any) -> NoReturn: ...
    def node(self, *args: _Word, **options: _Word) -> None:
        """node(tag, x, <y, <z>>, <'-ndf', ndf>, <'-mass', m, ...>, <'-disp', u, ...>, <'-vel', v, ...>)

        Makes a node.
        """
    @overload
    def nodeAccel(self, node: float, dof: float = ..., /) -> list[float] | float:
        """nodeAccel(node, <dof>)

        Returns the acceleration of a node.
        """
    @overload
    def nodeAccel(self, node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    def nodeBounds(self) -> list[float]:
        """nodeBounds()

        Returns the smallest and largest coordinates of all nodes.
        """
    @overload
    def nodeCoord(self, node: float, direction: float = ..., /) -> list[float] | float:
        """nodeCoord(node, <direction>)

        Returns the coordinates of a node.
        """
    @overload
    def nodeCoord(self, node: _Tags = ..., direction: _Word = ..., /) -> np.ndarray: ...
    @overload
    def nodeDisp(self, node: float, dof: float = ..., /) -> list[float] | float:
        """nodeDisp(node, <dof>)

        Returns the displacement of a node.
        """
    @overload
    def nodeDisp(self, node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    def nodeDOFs(self, node: _Word) -> list[int]:
        """nodeDOFs(node)

        Returns the numbers of the equations of a node.
        """
    def nodeEigenvector(self, node: _Word, mode: _Word, dof: _Word = ...) -> list[float] | float:
        """nodeEigenvector(node, mode, <dof>)

        Returns the mode shape at a node.
        """
    def nodeMass(self, node: _Word, dof: _Word = ...) -> list[float] | float:
        """nodeMass(node, <dof>)

        Returns the mass of a node.
        """
    def nodePressure(self, node: _Word) -> float: ...
    @overload
    def nodeReaction(self, node: float, dof: float = ..., /) -> list[float] | float:
        """nodeReaction(node, <dof>)

        Returns the reaction of a node in the present state; reactions chooses what it includes.
        """
    @overload
    def nodeReaction(self, node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    def nodeResponse(self, *args: _Word, **options: _Word) -> float:
        """nodeResponse(node, dof, response (1 displacement, 2 velocity, 3 acceleration))

        Returns a displacement, velocity or acceleration of a node by number.
        """
    def nodeUnbalance(self, node: _Word, dof: _Word = ...) -> list[float] | float:
        """nodeUnbalance(node, <dof>)

        Returns the unbalanced load of a node.
        """
    @overload
    def nodeVel(self, node: float, dof: float = ..., /) -> list[float] | float:
        """nodeVel(node, <dof>)

        Returns the velocity of a node.
        """
    @overload
    def nodeVel(self, node: _Tags = ..., dof: _Word = ..., /) -> np.ndarray: ...
    def numberer(self, *args: _Word, **options: _Word) -> None:
        """numberer('Plain' | 'RCM' | 'AMD')

        Chooses the order of the equations. Every name is accepted.
        """
    def numFact(self) -> None:
        """numFact()

        Returns the number of factorisations of the last step.
        """
    def numIter(self) -> int:
        """numIter()

        Returns the number of iterations of the last step; 0 of an algorithm that searches along lines or has no test.
        """
    def OpenSeesParameter(self, *args: Any) -> NoReturn: ...
    def parameter(self, *args: _Word, **options: _Word) -> int:
        """parameter(tag, <value> | <'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz'> | <'node', node, 'disp', dof> | <'loadPattern', pattern, 'loadAtNode', node, dof> | <'loadPattern', pattern, 'lambda'> | <'element'|'region', tag, name, ...>)

        Declares a quantity that updateParameter can change. Of an element it is a number of its command, or of the command of a law in it, also one that was left out. OpenSees has few of them: its names are known too.
        """
    def partition(self, element: _Word = ...) -> None:
        """partition(<element>)

        Has no effect: there is one process.
        """
    def patch(self, *args: _Word, **options: _Word) -> None:
        """patch('quad', material, nIJ, nJK, yI, zI, yJ, zJ, yK, zK, yL, zL | 'rect', material, nY, nZ, yI, zI, yK, zK | 'circ', material, nCirc, nRad, y, z, rInner, rOuter, <angle1, angle2>)

        Adds fibres that fill an area.
        """
    def pattern(self, *args: _Word, **options: _Word) -> None:
        """pattern('Plain', tag, series, <'-fact', factor>)

        Makes a pattern of loads that follow a time series, or an excitation.
        """
    def performanceFunction(self, *args: Any) -> NoReturn: ...
    def plane(self, front: _Word, back: _Word) -> None:
        """plane(front, back)

        Accepted without effect.
        """
    def plot(self, file: str | PathLike[str] | None = None, *, title: str = ..., units: tuple[str, str] = ..., modes: int = ..., show: bool = ...) -> Any: ...
    def port(self, xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word) -> None:
        """port(xmin, xmax, ymin, ymax)

        Accepted without effect.
        """
    def pressureConstraint(self, *args: Any) -> NoReturn: ...
    def printA(self, *args: _Word, **options: _Word) -> list[float] | None:
        """printA(<'-file', file>, <'-ret'>)

        Prints the matrix of the equations, under system Diagonal its diagonal.
        """
    def printB(self, *args: _Word, **options: _Word) -> list[float] | None:
        """printB(<'-file', file>, <'-ret'>)

        Prints the right-hand side of the equations.
        """
    def printGID(self, *args: Any) -> NoReturn: ...
    def printModel(self, *args: _Word, **options: _Word) -> None:
        """printModel(<'-file', file>, <'-JSON'>, <'-node', <'-flag', n>, <tag, ...>>, <'-ele', <'-flag', n>, <tag, ...>>)

        Prints nodes and elements.
        """
    def printX(self, *args: _Word, **options: _Word) -> list[float] | None:
        """printX(<'-file', file>, <'-ret'>)

        Prints the solution of the equations that the last iteration has found.
        """
    def probabilityTransformation(self, *args: Any) -> NoReturn: ...
    def projection(self, mode: _Word) -> None:
        """projection(mode)

        Accepted without effect.
        """
    def prp(self, x: _Word, y: _Word, z: _Word) -> None:
        """prp(x, y, z)

        Accepted without effect.
        """
    def pyversion(self, *args: _Word) -> str: ...
    def randomNumberGenerator(self, *args: Any) -> NoReturn: ...
    def randomVariable(self, *args: Any) -> NoReturn: ...
    def rayleigh(self, *args: _Word, **options: _Word) -> None:
        """rayleigh(alphaM, betaK, betaK0, betaKc, <'-ele', tag, ...>, <'-node', tag, ...>)

        Sets Rayleigh damping of the model: C = \\alpha_M M + \\beta_K K + \\beta_{K0} K_0 + \\beta_{Kc} K_c$ with the current, initial and committed stiffness.
        """
    def reactions(self, *args: _Word, **options: _Word) -> None:
        """reactions(<'-dynamic'>, <'-rayleigh'>)

        Chooses what nodeReaction includes: inertia with -dynamic, Rayleigh damping with -rayleigh.
        """
    def record(self) -> None:
        """record()

        Makes all recorders write a row now.
        """
    def recorder(self, *args: _Word, **options: _Word) -> int:
        """recorder(kind, '-file', file, ...)

        Records responses in a file.
        """
    def recv(self, *args: _Word, **options: _Word) -> None:
        """recv('-pid', process, variable)

        Has no effect: there is one process. The variable stays as it is.
        """
    def region(self, *args: _Word, **options: _Word) -> None:
        """region(tag, <'-ele', tag, ...>, <'-eleOnly', tag, ...>, <'-eleRange', first, last>, <'-eleOnlyRange', ...>, <'-node', tag, ...>, <'-nodeOnly', ...>, <'-nodeRange', first, last>, <'-nodeOnlyRange', ...>, <'-rayleigh', alphaM, betaK, betaK0, betaKc>, <'-damp', damping>)

        Names nodes and elements together, for recorders, parameters or Rayleigh damping of their own.
        """
    def reliabilityConvergenceCheck(self, *args: Any) -> NoReturn: ...
    def remesh(self, *args: Any) -> NoReturn: ...
    def remove(self, *args: _Word, **options: _Word) -> None:
        """remove('loadPattern', tag | 'recorders' | 'recorder', tag | 'element', tag | 'node', tag | 'sp', tag | 'sp', node, dof, <pattern> | 'mp', tag | 'material', tag | 'timeSeries', tag | 'parameter', tag)

        Removes something from the model.
        """
    def reset(self) -> None:
        """reset()

        Returns to the state at the start.
        """
    def responseSpectrumAnalysis(self, *args: _Word, **options: _Word) -> None:
        """responseSpectrumAnalysis(series, direction | direction, '-Tn', periods, '-Sa', accelerations, <'-scale', factor>, <'-mode', mode>)

        Makes a step for each mode with its largest displacements under a response spectrum. The script combines the modes.
        """
    def restore(self, tag: _Word) -> None:
        """restore(tag)

        Goes back to a saved state of the same model, in this run or another one.
        """
    def revertToStart(self) -> None:
        """revertToStart()

        Returns to the state at the start.
        """
    def rigidDiaphragm(self, *args: _Word, **options: _Word) -> None:
        """rigidDiaphragm(perpendicular, retained, constrained1, <constrained2, ...>)

        Makes nodes move in a plane like one rigid body. In a plane model 1 and 2 make that displacement equal, and 3 makes a rigid body.
        """
    def rigidLink(self, *args: _Word, **options: _Word) -> None:
        """rigidLink('beam'|'bar', retained, constrained)

        Makes a node follow another: beam with its rotation, bar without.
        """
    def rootFinding(self, *args: Any) -> NoReturn: ...
    def runFORMAnalysis(self, *args: Any) -> NoReturn: ...
    def runFOSMAnalysis(self, *args: Any) -> NoReturn: ...
    def runImportanceSamplingAnalysis(self, *args: Any) -> NoReturn: ...
    def runSORMAnalysis(self, *args: Any) -> NoReturn: ...
    def save(self, tag: _Word) -> None:
        """save(tag)

        Saves the committed state, exact to the bit. The next step begins anew, as it does after restore.
        """
    def sdfResponse(self, *args: _Word, **options: _Word) -> list[float]:
        """sdfResponse(m, zeta, k, Fy, alpha, dtF, file, dt) or m, zeta, k, Fy, alpha, series, dt, <'-uresid', u>, <'-umaxprev', u>, <'-tend', t>

        Returns the largest and the last displacement, the plastic one, the largest acceleration and its time of an elastic-plastic system of one degree of freedom under a series of forces.
        """
    def searchDirection(self, *args: Any) -> NoReturn: ...
    def searchPeerNGA(self, *args: Any) -> NoReturn: ...
    def section(self, *args: _Word, **options: _Word) -> None:
        """section(kind, tag, ...)

        Makes a cross-section.
        """
    def sectionDeformation(self, element: _Word, section: _Word, dof: _Word = ...) -> list[float] | float:
        """sectionDeformation(element, section, <dof>)

        Returns the deformations of a section of a beam.
        """
    def sectionDisplacement(self, *args: _Word, **options: _Word) -> list[float]:
        """sectionDisplacement(element, section, <'-local'>)

        Returns the displacements along x, y and z of a section of a force-based beam. Its deflection is the double integral of the polynomial through the curvatures of the sections.
        """
    def sectionFlexibility(self, element: _Word, section: _Word, dof: _Word = ...) -> list[float]:
        """sectionFlexibility(element, section, <dof>)

        Returns the inverse of the tangent of a section of a beam.
        """
    def sectionForce(self, element: _Word, section: _Word, dof: _Word = ...) -> list[float] | float:
        """sectionForce(element, section, <dof>)

        Returns the resultants of a section of a beam.
        """
    def sectionLocation(self, element: _Word, section: _Word = ...) -> list[float] | float:
        """sectionLocation(element, <section>)

        Returns the places of the sections along a beam.
        """
    def sectionStiffness(self, element: _Word, section: _Word, dof: _Word = ...) -> list[float]:
        """sectionStiffness(element, section, <dof>)

        Returns the tangent of a section of a beam.
        """
    def sectionTag(self, element: _Word, section: _Word = ...) -> list[int] | int:
        """sectionTag(element, <section>)

        Returns the tags of the sections along a beam.
        """
    def sectionWeight(self, element: _Word, section: _Word = ...) -> list[float] | float:
        """sectionWeight(element, <section>)

        Returns the weights of the sections along a beam.
        """
    def send(self, *args: _Word, **options: _Word) -> None:
        """send('-pid', process, data)

        Has no effect: there is one process.
        """
    def sensitivityAlgorithm(self, *args: _Word, **options: _Word) -> None:
        """sensitivityAlgorithm('-computeAtEachStep' | '-computeByCommand')

        Begins derivatives of the response with respect to all parameters. They are central differences of two more analyses for each parameter, which make the same steps. Every law and element has them.
        """
    def sensLambda(self, pattern: _Word, parameter: _Word) -> float:
        """sensLambda(pattern, parameter)

        Returns the derivative of the load factor of a pattern with respect to a parameter.
        """
    def sensNodeAccel(self, node: _Word, dof: _Word, parameter: _Word) -> float:
        """sensNodeAccel(node, dof, parameter)

        Returns the derivative of an acceleration with respect to a parameter.
        """
    def sensNodeDisp(self, node: _Word, dof: _Word, parameter: _Word) -> float:
        """sensNodeDisp(node, dof, parameter)

        Returns the derivative of a displacement with respect to a parameter.
        """
    def sensNodePressure(self, *args: Any) -> NoReturn: ...
    def sensNodeVel(self, node: _Word, dof: _Word, parameter: _Word) -> float:
        """sensNodeVel(node, dof, parameter)

        Returns the derivative of a velocity with respect to a parameter.
        """
    def sensSectionForce(self, *args: _Word, **options: _Word) -> list[float]:
        """sensSectionForce(element, <section>, dof, parameter)

        Returns the derivative of a resultant of a section with respect to a parameter.
        """
    def setCreep(self, *args: Any) -> NoReturn: ...
    def setElementRayleighDampingFactors(self, element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word) -> None:
        """setElementRayleighDampingFactors(element, alphaM, betaK, betaK0, betaKc)

        Sets Rayleigh damping of one element.
        """
    def setElementRayleighFactors(self, element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word) -> None:
        """setElementRayleighFactors(element, alphaM, betaK, betaK0, betaKc)

        Sets Rayleigh damping of one element.
        """
    def setMaxOpenFiles(self, n: _Word) -> None:
        """setMaxOpenFiles(n)

        Accepted without effect.
        """
    def setNodeAccel(self, *args: _Word, **options: _Word) -> None:
        """setNodeAccel(node, dof, value, <'-commit'>)

        Sets the acceleration of a node.
        """
    def setNodeCoord(self, node: _Word, direction: _Word, value: _Word) -> None:
        """setNodeCoord(node, direction, value)

        Moves a node that has no displacement.
        """
    def setNodeDisp(self, *args: _Word, **options: _Word) -> None:
        """setNodeDisp(node, dof, value, <'-commit'>)

        Sets the displacement of a node.
        """
    def setNodeMass(self, node: _Word, dof: _Word, mass: _Word) -> None:
        """setNodeMass(node, dof, mass)

        Sets the mass of a node in one direction.
        """
    def setNodePressure(self, *args: Any) -> NoReturn: ...
    def setNodeTemperature(self, *args: Any) -> NoReturn: ...
    def setNodeVel(self, *args: _Word, **options: _Word) -> None:
        """setNodeVel(node, dof, value, <'-commit'>)

        Sets the velocity of a node.
        """
    def setNumThreads(self, number: int) -> None: ...
    def setParameter(self, *args: _Word, **options: _Word) -> None:
        """setParameter('-val', value, <'-ele', element, ... | '-eleRange', first, last>, name, ... | '-node', node, ..., 'mass', 'x'|'y'|'z'|'xy'|'xyz')

        Changes a quantity of elements or nodes once.
        """
    def setPrecision(self, digits: _Word) -> None:
        """setPrecision(digits)

        Sets the digits of recorders that are made afterwards.
        """
    def setStartNodeTag(self, tag: _Word) -> None:
        """setStartNodeTag(tag)

        Has no effect: the nodes that it counts are those of OpenSees' meshes.
        """
    def setStrain(self, strain: _Word, rate: _Word = ...) -> None:
        """setStrain(strain, <rate>)

        Strains the chosen law and commits its state.
        """
    def setTime(self, time: _Word) -> None:
        """setTime(time)

        Sets the clock of the domain.
        """
    def ShallowFoundationGen(self, *args: Any) -> NoReturn: ...
    def solveCPU(self, *args: Any) -> NoReturn: ...
    def sp(self, *args: _Word, **options: _Word) -> None:
        """sp(node, dof, value, <'-const'>, <'-subtractInit'>, <'-pattern', tag>)

        Imposes the displacement of a degree of freedom, in a pattern.
        """
    def spectrum(self, *args: Any) -> NoReturn: ...
    def start(self) -> None:
        """start()

        Accepted without effect.
        """
    def startPoint(self, *args: Any) -> NoReturn: ...
    def stepSizeRule(self, *args: Any) -> NoReturn: ...
    def stiffnessDegradation(self, *args: Any) -> NoReturn: ...
    def stop(self) -> None:
        """stop()

        Accepted without effect.
        """
    def strengthControl(self, *args: Any) -> NoReturn: ...
    def strengthDegradation(self, *args: Any) -> NoReturn: ...
    def stripXML(self, *args: Any) -> NoReturn: ...
    def system(self, *args: _Word, **options: _Word) -> None:
        """system('BandGeneral' | 'BandSPD' | 'ProfileSPD' | 'SparseGeneral' | 'UmfPack' | 'FullGeneral' | ...)

        Chooses the solver. Every name is accepted; see Solvers.
        """
    def systemSize(self) -> int:
        """systemSize()

        Returns the number of equations.
        """
    def test(self, *args: _Word, **options: _Word) -> None:
        """test(kind, tolerance, maxIterations, <printFlag>, <norm>)

        Chooses the test of convergence.
        """
    def testIter(self) -> int:
        """testIter()

        Returns the number of iterations of the last step.
        """
    def testNorm(self) -> list[float]:
        """testNorm()

        Returns the norms of the last test: one of each iteration, and zeros up to the iterations allowed.
        """
    def testNorms(self) -> list[float]:
        """testNorms()

        Returns the norms of the last test: one of each iteration, and zeros up to the iterations allowed.
        """
    def testUniaxialMaterial(self, tag: _Word) -> None:
        """testUniaxialMaterial(tag)

        Chooses the law that setStrain drives.
        """
    def timeSeries(self, *args: _Word, **options: _Word) -> None:
        """timeSeries(kind, tag, ...)

        Makes a factor that varies with time.
        """
    def totalCPU(self, *args: Any) -> NoReturn: ...
    def transformUtoX(self, *args: Any) -> NoReturn: ...
    def uniaxialMaterial(self, *args: _Word, **options: _Word) -> None:
        """uniaxialMaterial(kind, tag, ...)

        Makes a uniaxial law: stress over strain, or force over deformation.
        """
    def unloadingRule(self, *args: Any) -> NoReturn: ...
    def updateElementDomain(self, *args: Any) -> NoReturn: ...
    def updateMaterialStage(self, *args: _Word, **options: _Word) -> None:
        """updateMaterialStage('-material', material, '-stage', stage, <'-parameter', parameter>)

        Has no effect and warns: no law here has stages. In OpenSees it switches soils from elastic to plastic.
        """
    def updateParameter(self, tag: _Word, value: _Word) -> int:
        """updateParameter(tag, value)

        Gives a parameter a new value.
        """
    def verify(self, *args: _Word, **options: _Word) -> None:
        """verify('value'|'error', result, reference, <tolerance>, <text>)

        Compares a result with a number: value by the difference, error by its share of the reference. It prints that they agree, or ends the script.
        """
    def version(self) -> str:
        """version()

        Returns the version of hysteron.
        """
    def viewWindow(self, xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word) -> None:
        """viewWindow(xmin, xmax, ymin, ymax)

        Accepted without effect.
        """
    def vpn(self, x: _Word, y: _Word, z: _Word) -> None:
        """vpn(x, y, z)

        Accepted without effect.
        """
    def vrp(self, x: _Word, y: _Word, z: _Word) -> None:
        """vrp(x, y, z)

        Accepted without effect.
        """
    def vup(self, x: _Word, y: _Word, z: _Word) -> None:
        """vup(x, y, z)

        Accepted without effect.
        """
    def watch(self) -> None: ...
    def wipe(self) -> None:
        """wipe()

        Removes the model, the analysis and the recorders.
        """
    def wipeAnalysis(self) -> None:
        """wipeAnalysis()

        Removes the analysis and keeps the model.
        """
    def wipeReliability(self, *args: Any) -> NoReturn: ...
    def analyze(self, *args: _Word, record: dict[str, Any] | None = None, progress: bool = False) -> Any: ...

USAGES: dict[str, tuple[str, list[tuple[list[str], str]]]]
