"""Generated from the usages of the commands by `python -m hysteron._stubs`."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, NoReturn

import numpy as np

_Word = float | str | np.ndarray | PathLike[str] | Sequence["_Word"]

class Recording(dict[str, np.ndarray]):
    code: int

class Model:
    def __init__(
        self, ndm: int | None = None, ndf: int | None = None, *, strict: bool = False, compat: bool = False,
        ladder: bool = False,
    ) -> None: ...
    def accelCPU(self, *args: Any) -> NoReturn: ...
    def addToParameter(self, *args: _Word) -> None:
        """addToParameter(tag, 'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz' | 'loadPattern', pattern, 'loadAtNode', node, dof | 'element'|'region', tag, name, ...)"""
    def algorithm(self, *args: _Word) -> None:
        """algorithm('Linear' | 'Newton' | 'ModifiedNewton' | 'NewtonLineSearch' | 'KrylovNewton' | 'SecantNewton' | 'BFGS' | 'Broyden' | ..., <'options'>)"""
    def amend(self, *args: _Word) -> None:
        """amend('element', tag, <tag, ...>, kind, '-option', value, ..., <'-dir', dir1, <dir2>>, <'-axial', dir | '-axialSeries', ts>, <'-share', k, elastic, <rest> | '-strengthBeside', k> | 'amend', 'element', tag, <tag, ...>, 'learned', '-range', U, V, T, '-hysteresis', form, level, strength, <'-spring', k>, <'-piece', side, at, k, ...>, <'-moving', k>, <'-curve', slope, ...>, <'-unequal', strength>, <'-stop', level, strength, ...>, <'-maxwell', time, k, ...>, <'-dashpot', power, c, ...>, <'-viscous', width, force, ...>, <'-work', D>, <'-factor', part, variable, ...>, <'-channel', name, mean, deviation, ...>, <'-force', name, a, low, high, ...>, <'-series', ts, ...>, <'-beyond', 'clamp'|'continue'>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'learned', '-file', file, <'-series', ts, ...>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'hinges', '-mat', mat, <'-end', 'i'|'j'> | 'amend', 'node', tag, 'dampedAs', other)"""
    def analysis(self, *args: _Word) -> None:
        """analysis('Static' | 'Transient' | 'VariableTransient')"""
    def barrier(self) -> None:
        """barrier()"""
    def basicDeformation(self, element: _Word, dof: _Word = ..., /) -> list[float] | float:
        """basicDeformation(element, <dof>)"""
    def basicForce(self, element: _Word, dof: _Word = ..., /) -> list[float] | float:
        """basicForce(element, <dof>)"""
    def basicStiffness(self, element: _Word, /) -> list[float]:
        """basicStiffness(element)"""
    def Bcast(self, data: _Word, /) -> None:
        """Bcast(data)"""
    def beamIntegration(self, *args: _Word) -> None:
        """beamIntegration('Lobatto'|'Legendre'|'Radau'|'NewtonCotes'|'Trapezoidal'|'CompositeSimpson', tag, section, n | 'HingeRadau'|'HingeRadauTwo'|'HingeMidpoint'|'HingeEndpoint', tag, secI, lpI, secJ, lpJ, secE | 'UserDefined'|'FixedLocation'|'LowOrder'|'MidDistance', tag, n, sections, ..., places, ..., <weights, ...>)"""
    def block2D(self, nx: _Word, ny: _Word, firstNode: _Word, firstElement: _Word, kind: _Word, /) -> None:
        """block2D(nx, ny, firstNode, firstElement, kind)"""
    def block3D(self, nx: _Word, ny: _Word, nz: _Word, firstNode: _Word, firstElement: _Word, kind: _Word, /) -> None:
        """block3D(nx, ny, nz, firstNode, firstElement, kind)"""
    def build(self) -> None: ...
    def cbdiDisplacement(self, *args: Any) -> NoReturn: ...
    def classType(self, *args: _Word) -> str:
        """classType('section'|'element', tag)"""
    def columns(self, file: _Word, /) -> None:
        """columns(file)"""
    def computeGradients(self, *args: Any) -> NoReturn: ...
    def constraints(self, *args: _Word) -> None:
        """constraints('Plain' | 'Transformation' | 'Penalty', alphaS, alphaM | 'Lagrange', <alphaS, alphaM>)"""
    def convertBinaryToText(self, *args: Any) -> NoReturn: ...
    def convertTextToBinary(self, *args: Any) -> NoReturn: ...
    def correlate(self, *args: Any) -> NoReturn: ...
    def damping(self, *args: _Word) -> None:
        """damping(kind, tag, ...)"""
    def database(self, *args: _Word) -> None:
        """database('File', name)"""
    def defaultUnits(self, *args: _Word) -> None: ...
    def display(self, *args: _Word) -> None:
        """display(...)"""
    def domainChange(self) -> None:
        """domainChange()"""
    def domainCommitTag(self, *args: Any) -> NoReturn: ...
    def eigen(self, *args: _Word) -> list[float]:
        """eigen(<solver>, <'-generalized' | '-standard'>, <'-findLargest'>, count)"""
    def eleDynamicalForce(self, element: _Word, dof: _Word = ..., /) -> list[float] | float:
        """eleDynamicalForce(element, <dof>)"""
    def eleForce(self, element: _Word, dof: _Word = ..., /) -> list[float] | float:
        """eleForce(element, <dof>)"""
    def eleLoad(self, *args: _Word) -> None:
        """eleLoad('-ele', tag, ... | '-range', first, last, '-type', '-beamUniform', ... | '-beamUniformMoment', mz | '-beamPoint', ...)"""
    def element(self, *args: _Word) -> None:
        """element(kind, tag, iNode, jNode, ...)"""
    def eleNodes(self, element: _Word, /) -> list[int]:
        """eleNodes(element)"""
    def eleResponse(self, *args: _Word) -> list[float]:
        """eleResponse(element, response, ...)"""
    def eleType(self, element: _Word, /) -> str:
        """eleType(element)"""
    def equalDOF(self, *args: _Word) -> None:
        """equalDOF(retained, constrained, dof1, <dof2, ...>)"""
    def equalDOF_Mixed(self, *args: _Word) -> None:
        """equalDOF_Mixed(retained, constrained, count, retainedDof1, constrainedDof1, <retainedDof2, constrainedDof2, ...>)"""
    def fiber(self, y: _Word, z: _Word, area: _Word, material: _Word, /) -> None:
        """fiber(y, z, area, material)"""
    def figure(self, *args: _Word) -> None:
        """figure(file.svg, '-title', text, '-x', label, '-y', label, <'-xrange', low, high>, <'-yrange', low, high>, <'-equal'>, '-line', name, xs, ys, ..., <'-dots', name, xs, ys, ...>)"""
    def fill(self, mode: _Word, /) -> None:
        """fill(mode)"""
    def filter(self, *args: Any) -> NoReturn: ...
    def findCurvatures(self, *args: Any) -> NoReturn: ...
    def findDesignPoint(self, *args: Any) -> NoReturn: ...
    def fix(self, *args: _Word) -> None:
        """fix(node, flag1, <flag2, ...>, ('1', 'held,', '0', 'free'))"""
    def fixX(self, *args: _Word) -> None:
        """fixX(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)"""
    def fixY(self, *args: _Word) -> None:
        """fixY(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)"""
    def fixZ(self, *args: _Word) -> None:
        """fixZ(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)"""
    def frictionModel(self, *args: _Word) -> None:
        """frictionModel(kind, tag, ...)"""
    def functionEvaluator(self, *args: Any) -> NoReturn: ...
    def geomTransf(self, *args: _Word) -> None:
        """geomTransf('Linear'|'PDelta'|'Corotational', tag, <x, y, z, 'of', 'a', 'vector', 'in', 'the', 'local', 'x-z', 'plane,', 'in', 'space'>, <'-jntOffset', dxi, dyi, <dzi>, dxj, dyj, <dzj>>)"""
    def getCDF(self, *args: Any) -> NoReturn: ...
    def getConstrainedDOFs(self, node: _Word, retained: _Word = ..., /) -> list[int]:
        """getConstrainedDOFs(node, <retained>)"""
    def getConstrainedNodes(self, retained: _Word = ..., /) -> list[int]:
        """getConstrainedNodes(<retained>)"""
    def getCrdTransfTags(self) -> list[int]:
        """getCrdTransfTags()"""
    def getDampTangent(self) -> None:
        """getDampTangent()"""
    def getEleClassTags(self, element: _Word = ..., /) -> list[int]:
        """getEleClassTags(<element>)"""
    def getEleLoadClassTags(self, pattern: _Word = ..., /) -> list[int]:
        """getEleLoadClassTags(<pattern>)"""
    def getEleLoadData(self, pattern: _Word = ..., /) -> list[float]:
        """getEleLoadData(<pattern>)"""
    def getEleLoadTags(self, pattern: _Word = ..., /) -> list[int]:
        """getEleLoadTags(<pattern>)"""
    def getEleTags(self) -> list[int]:
        """getEleTags()"""
    def getFixedDOFs(self, node: _Word, /) -> list[int]:
        """getFixedDOFs(node)"""
    def getFixedNodes(self) -> list[int]:
        """getFixedNodes()"""
    def getInverseCDF(self, *args: Any) -> NoReturn: ...
    def getLoadFactor(self, pattern: _Word, /) -> float:
        """getLoadFactor(pattern)"""
    def getLSFTags(self, *args: Any) -> NoReturn: ...
    def getMean(self, *args: Any) -> NoReturn: ...
    def getNDF(self, node: _Word = ..., /) -> list[int]:
        """getNDF(<node>)"""
    def getNDM(self) -> list[int]:
        """getNDM()"""
    def getNodeLoadData(self, pattern: _Word = ..., /) -> list[float]:
        """getNodeLoadData(<pattern>)"""
    def getNodeLoadTags(self, pattern: _Word = ..., /) -> list[int]:
        """getNodeLoadTags(<pattern>)"""
    def getNodeTags(self) -> list[int]:
        """getNodeTags()"""
    def getNodeTemperature(self, *args: Any) -> NoReturn: ...
    def getNP(self) -> int:
        """getNP()"""
    def getNumElements(self) -> list[int]:
        """getNumElements()"""
    def getNumThreads(self) -> int: ...
    def getParamTags(self) -> list[int]:
        """getParamTags()"""
    def getParamValue(self, tag: _Word, /) -> float:
        """getParamValue(tag)"""
    def getPatterns(self) -> list[int]:
        """getPatterns()"""
    def getPDF(self, *args: Any) -> NoReturn: ...
    def getPID(self) -> int:
        """getPID()"""
    def getRetainedDOFs(self, node: _Word, constrained: _Word = ..., /) -> list[int]:
        """getRetainedDOFs(node, <constrained>)"""
    def getRetainedNodes(self, constrained: _Word = ..., /) -> list[int]:
        """getRetainedNodes(<constrained>)"""
    def getRVParamTag(self, *args: Any) -> NoReturn: ...
    def getRVTags(self, *args: Any) -> NoReturn: ...
    def getRVValue(self, *args: Any) -> NoReturn: ...
    def getStdv(self, *args: Any) -> NoReturn: ...
    def getStrain(self) -> float:
        """getStrain()"""
    def getStress(self) -> float:
        """getStress()"""
    def getTangent(self) -> float:
        """getTangent()"""
    def getTime(self) -> float:
        """getTime()"""
    def gradientEvaluator(self, *args: Any) -> NoReturn: ...
    def gradPerformanceFunction(self, *args: Any) -> NoReturn: ...
    def groundMotion(self, *args: _Word) -> None:
        """groundMotion(tag, 'Plain', <'-accel', series>, <'-vel', series>, <'-disp', series>, <'-int', 'Trapezoidal'>, <'-dtInt', dt>, <'-fact', factor> | 'groundMotion', tag, 'Interpolated', motion, ..., '-fact', factor, ...)"""
    def hystereticBackbone(self, *args: _Word) -> None:
        """hystereticBackbone(kind, tag, ...)"""
    def IGA(self, *args: Any) -> NoReturn: ...
    def imposedMotion(self, *args: _Word) -> None:
        """imposedMotion(node, dof, groundMotion, <'-other'>)"""
    def imposedSupportMotion(self, *args: _Word) -> None:
        """imposedSupportMotion(node, dof, groundMotion, <'-other'>)"""
    def initialize(self) -> None:
        """initialize()"""
    def InitialStateAnalysis(self, *args: Any) -> NoReturn: ...
    def integrator(self, *args: _Word) -> None:
        """integrator('LoadControl' | 'DisplacementControl' | 'ArcLength' | 'Newmark' | 'HHT' | ..., <'options'>)"""
    def ladder(self, *args: _Word) -> None:
        """ladder('on' | 'off')"""
    def layer(self, *args: _Word) -> None:
        """layer('straight', material, n, area, y1, z1, y2, z2 | 'circ', material, n, area, y, z, radius, <angle1, angle2>)"""
    def limitCurve(self, *args: _Word) -> None:
        """limitCurve(kind, tag, element, ...)"""
    def load(self, *args: _Word) -> None:
        """load(node, f1, <f2, ...>, <'-const'>, <'-pattern', tag>)"""
    def loadConst(self, *args: _Word) -> None:
        """loadConst(<'-time', time>)"""
    def localForce(self, element: _Word, dof: _Word = ..., /) -> list[float] | float:
        """localForce(element, <dof>)"""
    def logCommands(self, *args: _Word) -> None:
        """logCommands(...)"""
    def logFile(self, *args: _Word) -> None:
        """logFile(file, ...)"""
    def mass(self, *args: _Word) -> None:
        """mass(node, m1, <m2, ...>)"""
    def meritFunctionCheck(self, *args: Any) -> NoReturn: ...
    def mesh(self, *args: Any) -> NoReturn: ...
    def metaData(self, *args: _Word) -> None: ...
    def modalDamping(self, *args: _Word) -> None:
        """modalDamping(ratio | ratio1, ratio2, ...)"""
    def modalDampingQ(self, *args: _Word) -> None:
        """modalDampingQ(ratio | ratio1, ratio2, ...)"""
    def modalProperties(self, *args: _Word) -> dict[str, list[float]] | None:
        """modalProperties(<'-print'>, <'-file', file>, <'-unorm'>, <'-return'>)"""
    def model(self, *args: _Word) -> None:
        """model('BasicBuilder', '-ndm', ndm, <'-ndf', ndf>)"""
    def modulatingFunction(self, *args: Any) -> NoReturn: ...
    def motionFile(self, *args: _Word) -> list[float]:
        """motionFile(series, file, <'-factor', c>, <'-dt', dt>, <'-useLast'>, <'-channel', name>, <'-quantity', word>, <'-unit', unit>, <'-layout', word>, <'-to', unit>)"""
    def nDMaterial(self, *args: _Word) -> None:
        """nDMaterial(kind, tag, ...)"""
    def NDTest(self, *args: Any) -> NoReturn: ...
    def node(self, *args: _Word) -> None:
        """node(tag, x, <y, <z>>, <'-ndf', ndf>, <'-mass', m, ...>, <'-disp', u, ...>, <'-vel', v, ...>)"""
    def nodeAccel(self, node: _Word, dof: _Word = ..., /) -> list[float] | float:
        """nodeAccel(node, <dof>)"""
    def nodeBounds(self) -> list[float]:
        """nodeBounds()"""
    def nodeCoord(self, node: _Word, direction: _Word = ..., /) -> list[float] | float:
        """nodeCoord(node, <direction>)"""
    def nodeDisp(self, node: _Word, dof: _Word = ..., /) -> list[float] | float:
        """nodeDisp(node, <dof>)"""
    def nodeDOFs(self, node: _Word, /) -> list[int]:
        """nodeDOFs(node)"""
    def nodeEigenvector(self, node: _Word, mode: _Word, dof: _Word = ..., /) -> list[float] | float:
        """nodeEigenvector(node, mode, <dof>)"""
    def nodeMass(self, node: _Word, dof: _Word = ..., /) -> list[float] | float:
        """nodeMass(node, <dof>)"""
    def nodePressure(self, node: _Word) -> float: ...
    def nodeReaction(self, node: _Word, dof: _Word = ..., /) -> list[float] | float:
        """nodeReaction(node, <dof>)"""
    def nodeResponse(self, *args: _Word) -> float:
        """nodeResponse(node, dof, response, ('1', 'displacement,', '2', 'velocity,', '3', 'acceleration'))"""
    def nodeUnbalance(self, node: _Word, dof: _Word = ..., /) -> list[float] | float:
        """nodeUnbalance(node, <dof>)"""
    def nodeVel(self, node: _Word, dof: _Word = ..., /) -> list[float] | float:
        """nodeVel(node, <dof>)"""
    def numberer(self, *args: _Word) -> None:
        """numberer('Plain' | 'RCM' | 'AMD')"""
    def numFact(self) -> None:
        """numFact()"""
    def numIter(self) -> int:
        """numIter()"""
    def OpenSeesParameter(self, *args: Any) -> NoReturn: ...
    def parameter(self, *args: _Word) -> int:
        """parameter(tag, <value> | <'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz'> | <'node', node, 'disp', dof> | <'loadPattern', pattern, 'loadAtNode', node, dof> | <'loadPattern', pattern, 'lambda'> | <'element'|'region', tag, name, ...>)"""
    def partition(self, element: _Word = ..., /) -> None:
        """partition(<element>)"""
    def patch(self, *args: _Word) -> None:
        """patch('quad', material, nIJ, nJK, yI, zI, yJ, zJ, yK, zK, yL, zL | 'rect', material, nY, nZ, yI, zI, yK, zK | 'circ', material, nCirc, nRad, y, z, rInner, rOuter, <angle1, angle2>)"""
    def pattern(self, *args: _Word) -> None:
        """pattern('Plain', tag, series, <'-fact', factor>)"""
    def performanceFunction(self, *args: Any) -> NoReturn: ...
    def plane(self, front: _Word, back: _Word, /) -> None:
        """plane(front, back)"""
    def plot(self, file: str | PathLike[str] | None = None, *, title: str = ..., units: tuple[str, str] = ..., modes: int = ...) -> Any: ...
    def port(self, xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word, /) -> None:
        """port(xmin, xmax, ymin, ymax)"""
    def pressureConstraint(self, *args: Any) -> NoReturn: ...
    def printA(self, *args: _Word) -> list[float] | None:
        """printA(<'-file', file>, <'-ret'>)"""
    def printB(self, *args: _Word) -> list[float] | None:
        """printB(<'-file', file>, <'-ret'>)"""
    def printGID(self, *args: Any) -> NoReturn: ...
    def printModel(self, *args: _Word) -> None:
        """printModel(<'-file', file>, <'-JSON'>, <'-node', <'-flag', n>, <tag, ...>>, <'-ele', <'-flag', n>, <tag, ...>>)"""
    def printX(self, *args: Any) -> NoReturn: ...
    def probabilityTransformation(self, *args: Any) -> NoReturn: ...
    def projection(self, mode: _Word, /) -> None:
        """projection(mode)"""
    def prp(self, x: _Word, y: _Word, z: _Word, /) -> None:
        """prp(x, y, z)"""
    def pyversion(self, *args: _Word) -> str: ...
    def randomNumberGenerator(self, *args: Any) -> NoReturn: ...
    def randomVariable(self, *args: Any) -> NoReturn: ...
    def rayleigh(self, *args: _Word) -> None:
        """rayleigh(alphaM, betaK, betaK0, betaKc, <'-ele', tag, ...>, <'-node', tag, ...>)"""
    def reactions(self, *args: _Word) -> None:
        """reactions(<'-dynamic'>, <'-rayleigh'>)"""
    def record(self) -> None:
        """record()"""
    def recorder(self, *args: _Word) -> int:
        """recorder(kind, '-file', file, ...)"""
    def recv(self, *args: _Word) -> None:
        """recv('-pid', process, variable)"""
    def region(self, *args: _Word) -> None:
        """region(tag, <'-ele', tag, ...>, <'-eleOnly', tag, ...>, <'-eleRange', first, last>, <'-eleOnlyRange', ...>, <'-node', tag, ...>, <'-nodeOnly', ...>, <'-nodeRange', first, last>, <'-nodeOnlyRange', ...>, <'-rayleigh', alphaM, betaK, betaK0, betaKc>, <'-damp', damping>)"""
    def reliabilityConvergenceCheck(self, *args: Any) -> NoReturn: ...
    def remesh(self, *args: Any) -> NoReturn: ...
    def remove(self, *args: _Word) -> None:
        """remove('loadPattern', tag | 'recorders' | 'recorder', tag | 'element', tag | 'node', tag | 'sp', tag | 'sp', node, dof, <pattern> | 'mp', tag | 'material', tag | 'timeSeries', tag | 'parameter', tag)"""
    def reset(self) -> None:
        """reset()"""
    def responseSpectrumAnalysis(self, *args: _Word) -> None:
        """responseSpectrumAnalysis(series, direction | direction, '-Tn', periods, '-Sa', accelerations, <'-scale', factor>, <'-mode', mode>)"""
    def restore(self, tag: _Word, /) -> None:
        """restore(tag)"""
    def revertToStart(self) -> None:
        """revertToStart()"""
    def rigidDiaphragm(self, *args: _Word) -> None:
        """rigidDiaphragm(perpendicular, retained, constrained1, <constrained2, ...>)"""
    def rigidLink(self, *args: _Word) -> None:
        """rigidLink('beam'|'bar', retained, constrained)"""
    def rootFinding(self, *args: Any) -> NoReturn: ...
    def runFORMAnalysis(self, *args: Any) -> NoReturn: ...
    def runFOSMAnalysis(self, *args: Any) -> NoReturn: ...
    def runImportanceSamplingAnalysis(self, *args: Any) -> NoReturn: ...
    def runSORMAnalysis(self, *args: Any) -> NoReturn: ...
    def save(self, tag: _Word, /) -> None:
        """save(tag)"""
    def sdfResponse(self, *args: _Word) -> list[float]:
        """sdfResponse(m, zeta, k, Fy, alpha, dtF, file, dt) or m, zeta, k, Fy, alpha, series, dt, <'-uresid', u>, <'-umaxprev', u>, <'-tend', t>"""
    def searchDirection(self, *args: Any) -> NoReturn: ...
    def searchPeerNGA(self, *args: Any) -> NoReturn: ...
    def section(self, *args: _Word) -> None:
        """section(kind, tag, ...)"""
    def sectionDeformation(self, element: _Word, section: _Word, dof: _Word = ..., /) -> list[float] | float:
        """sectionDeformation(element, section, <dof>)"""
    def sectionDisplacement(self, *args: Any) -> NoReturn: ...
    def sectionFlexibility(self, element: _Word, section: _Word, dof: _Word = ..., /) -> list[float]:
        """sectionFlexibility(element, section, <dof>)"""
    def sectionForce(self, element: _Word, section: _Word, dof: _Word = ..., /) -> list[float] | float:
        """sectionForce(element, section, <dof>)"""
    def sectionLocation(self, element: _Word, section: _Word = ..., /) -> list[float] | float:
        """sectionLocation(element, <section>)"""
    def sectionStiffness(self, element: _Word, section: _Word, dof: _Word = ..., /) -> list[float]:
        """sectionStiffness(element, section, <dof>)"""
    def sectionTag(self, element: _Word, section: _Word = ..., /) -> list[int] | int:
        """sectionTag(element, <section>)"""
    def sectionWeight(self, element: _Word, section: _Word = ..., /) -> list[float] | float:
        """sectionWeight(element, <section>)"""
    def send(self, *args: _Word) -> None:
        """send('-pid', process, data)"""
    def sensitivityAlgorithm(self, *args: Any) -> NoReturn: ...
    def sensLambda(self, *args: Any) -> NoReturn: ...
    def sensNodeAccel(self, *args: Any) -> NoReturn: ...
    def sensNodeDisp(self, *args: Any) -> NoReturn: ...
    def sensNodePressure(self, *args: Any) -> NoReturn: ...
    def sensNodeVel(self, *args: Any) -> NoReturn: ...
    def sensSectionForce(self, *args: Any) -> NoReturn: ...
    def setCreep(self, *args: Any) -> NoReturn: ...
    def setElementRayleighDampingFactors(self, element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word, /) -> None:
        """setElementRayleighDampingFactors(element, alphaM, betaK, betaK0, betaKc)"""
    def setElementRayleighFactors(self, element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word, /) -> None:
        """setElementRayleighFactors(element, alphaM, betaK, betaK0, betaKc)"""
    def setMaxOpenFiles(self, n: _Word, /) -> None:
        """setMaxOpenFiles(n)"""
    def setNodeAccel(self, *args: _Word) -> None:
        """setNodeAccel(node, dof, value, <'-commit'>)"""
    def setNodeCoord(self, node: _Word, direction: _Word, value: _Word, /) -> None:
        """setNodeCoord(node, direction, value)"""
    def setNodeDisp(self, *args: _Word) -> None:
        """setNodeDisp(node, dof, value, <'-commit'>)"""
    def setNodeMass(self, node: _Word, dof: _Word, mass: _Word, /) -> None:
        """setNodeMass(node, dof, mass)"""
    def setNodePressure(self, *args: Any) -> NoReturn: ...
    def setNodeTemperature(self, *args: Any) -> NoReturn: ...
    def setNodeVel(self, *args: _Word) -> None:
        """setNodeVel(node, dof, value, <'-commit'>)"""
    def setNumThreads(self, number: int) -> None: ...
    def setParameter(self, *args: _Word) -> None:
        """setParameter('-val', value, <'-ele', element, ... | '-eleRange', first, last>, name, ... | '-node', node, ..., 'mass', 'x'|'y'|'z'|'xy'|'xyz')"""
    def setPrecision(self, digits: _Word, /) -> None:
        """setPrecision(digits)"""
    def setStartNodeTag(self, tag: _Word, /) -> None:
        """setStartNodeTag(tag)"""
    def setStrain(self, strain: _Word, rate: _Word = ..., /) -> None:
        """setStrain(strain, <rate>)"""
    def setTime(self, time: _Word, /) -> None:
        """setTime(time)"""
    def ShallowFoundationGen(self, *args: Any) -> NoReturn: ...
    def solveCPU(self, *args: Any) -> NoReturn: ...
    def sp(self, *args: _Word) -> None:
        """sp(node, dof, value, <'-const'>, <'-subtractInit'>, <'-pattern', tag>)"""
    def spectrum(self, *args: Any) -> NoReturn: ...
    def start(self) -> None:
        """start()"""
    def startPoint(self, *args: Any) -> NoReturn: ...
    def stepSizeRule(self, *args: Any) -> NoReturn: ...
    def stiffnessDegradation(self, *args: Any) -> NoReturn: ...
    def stop(self) -> None:
        """stop()"""
    def strengthControl(self, *args: Any) -> NoReturn: ...
    def strengthDegradation(self, *args: Any) -> NoReturn: ...
    def stripXML(self, *args: Any) -> NoReturn: ...
    def system(self, *args: _Word) -> None:
        """system('BandGeneral' | 'BandSPD' | 'ProfileSPD' | 'SparseGeneral' | 'UmfPack' | 'FullGeneral' | ...)"""
    def systemSize(self) -> int:
        """systemSize()"""
    def test(self, *args: _Word) -> None:
        """test(kind, tolerance, maxIterations, <printFlag>, <norm>)"""
    def testIter(self) -> int:
        """testIter()"""
    def testNorm(self) -> list[float]:
        """testNorm()"""
    def testNorms(self) -> list[float]:
        """testNorms()"""
    def testUniaxialMaterial(self, tag: _Word, /) -> None:
        """testUniaxialMaterial(tag)"""
    def timeSeries(self, *args: _Word) -> None:
        """timeSeries(kind, tag, ...)"""
    def totalCPU(self, *args: Any) -> NoReturn: ...
    def transformUtoX(self, *args: Any) -> NoReturn: ...
    def uniaxialMaterial(self, *args: _Word) -> None:
        """uniaxialMaterial(kind, tag, ...)"""
    def unloadingRule(self, *args: Any) -> NoReturn: ...
    def updateElementDomain(self, *args: Any) -> NoReturn: ...
    def updateMaterialStage(self, *args: Any) -> NoReturn: ...
    def updateParameter(self, tag: _Word, value: _Word, /) -> int:
        """updateParameter(tag, value)"""
    def verify(self, *args: _Word) -> None:
        """verify('value'|'error', result, reference, <tolerance>, <text>)"""
    def version(self) -> str:
        """version()"""
    def viewWindow(self, xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word, /) -> None:
        """viewWindow(xmin, xmax, ymin, ymax)"""
    def vpn(self, x: _Word, y: _Word, z: _Word, /) -> None:
        """vpn(x, y, z)"""
    def vrp(self, x: _Word, y: _Word, z: _Word, /) -> None:
        """vrp(x, y, z)"""
    def vup(self, x: _Word, y: _Word, z: _Word, /) -> None:
        """vup(x, y, z)"""
    def watch(self) -> None: ...
    def wipe(self) -> None:
        """wipe()"""
    def wipeAnalysis(self) -> None:
        """wipeAnalysis()"""
    def wipeReliability(self, *args: Any) -> NoReturn: ...
    def analyze(self, *args: _Word, record: dict[str, Any] | None = None) -> Any: ...

USAGES: dict[str, tuple[str, list[tuple[list[str], str]]]]
