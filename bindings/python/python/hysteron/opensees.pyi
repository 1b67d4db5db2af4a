"""Generated from the usages of the commands by `python -m hysteron._stubs`."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, NoReturn

import numpy as np

_Word = float | str | np.ndarray | PathLike[str] | Sequence["_Word"]

class OpenSeesError(Exception): ...

def accelCPU(*args: Any) -> NoReturn: ...
def addToParameter(*args: _Word) -> None:
    """addToParameter(tag, 'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz' | 'loadPattern', pattern, 'loadAtNode', node, dof | 'element'|'region', tag, name, ...)"""
def algorithm(*args: _Word) -> None:
    """algorithm('Linear' | 'Newton' | 'ModifiedNewton' | 'NewtonLineSearch' | 'KrylovNewton' | 'SecantNewton' | 'BFGS' | 'Broyden' | ..., <'options'>)"""
def amend(*args: _Word) -> None:
    """amend('element', tag, <tag, ...>, kind, '-option', value, ..., <'-dir', dir1, <dir2>>, <'-axial', dir | '-axialSeries', ts>, <'-share', k, elastic, <rest> | '-strengthBeside', k> | 'amend', 'element', tag, <tag, ...>, 'learned', '-range', U, V, T, '-hysteresis', form, level, strength, <'-spring', k>, <'-piece', side, at, k, ...>, <'-moving', k>, <'-curve', slope, ...>, <'-unequal', strength>, <'-stop', level, strength, ...>, <'-maxwell', time, k, ...>, <'-dashpot', power, c, ...>, <'-viscous', width, force, ...>, <'-work', D>, <'-factor', part, variable, ...>, <'-channel', name, mean, deviation, ...>, <'-force', name, a, low, high, ...>, <'-series', ts, ...>, <'-beyond', 'clamp'|'continue'>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'learned', '-file', file, <'-series', ts, ...>, <'-dir', dir1, <dir2>> | 'amend', 'element', tag, <tag, ...>, 'hinges', '-mat', mat, <'-end', 'i'|'j'> | 'amend', 'node', tag, 'dampedAs', other)"""
def analysis(*args: _Word) -> None:
    """analysis('Static' | 'Transient' | 'VariableTransient')"""
def analyze(steps: _Word, dt: _Word = ..., *more: _Word) -> int: ...
def barrier() -> None:
    """barrier()"""
def basicDeformation(element: _Word, dof: _Word = ..., /) -> list[float] | float:
    """basicDeformation(element, <dof>)"""
def basicForce(element: _Word, dof: _Word = ..., /) -> list[float] | float:
    """basicForce(element, <dof>)"""
def basicStiffness(element: _Word, /) -> list[float]:
    """basicStiffness(element)"""
def Bcast(data: _Word, /) -> None:
    """Bcast(data)"""
def beamIntegration(*args: _Word) -> None:
    """beamIntegration('Lobatto'|'Legendre'|'Radau'|'NewtonCotes'|'Trapezoidal'|'CompositeSimpson', tag, section, n | 'HingeRadau'|'HingeRadauTwo'|'HingeMidpoint'|'HingeEndpoint', tag, secI, lpI, secJ, lpJ, secE | 'UserDefined'|'FixedLocation'|'LowOrder'|'MidDistance', tag, n, sections, ..., places, ..., <weights, ...>)"""
def block2D(nx: _Word, ny: _Word, firstNode: _Word, firstElement: _Word, kind: _Word, /) -> None:
    """block2D(nx, ny, firstNode, firstElement, kind)"""
def block3D(nx: _Word, ny: _Word, nz: _Word, firstNode: _Word, firstElement: _Word, kind: _Word, /) -> None:
    """block3D(nx, ny, nz, firstNode, firstElement, kind)"""
def build() -> None: ...
def cbdiDisplacement(*args: Any) -> NoReturn: ...
def classType(*args: _Word) -> str:
    """classType('section'|'element', tag)"""
def columns(file: _Word, /) -> None:
    """columns(file)"""
def computeGradients(*args: Any) -> NoReturn: ...
def constraints(*args: _Word) -> None:
    """constraints('Plain' | 'Transformation' | 'Penalty', alphaS, alphaM | 'Lagrange', <alphaS, alphaM>)"""
def convertBinaryToText(*args: Any) -> NoReturn: ...
def convertTextToBinary(*args: Any) -> NoReturn: ...
def correlate(*args: Any) -> NoReturn: ...
def damping(*args: _Word) -> None:
    """damping(kind, tag, ...)"""
def database(*args: _Word) -> None:
    """database('File', name)"""
def defaultUnits(*args: _Word) -> None: ...
def display(*args: _Word) -> None:
    """display(...)"""
def domainChange() -> None:
    """domainChange()"""
def domainCommitTag(*args: Any) -> NoReturn: ...
def eigen(*args: _Word) -> list[float]:
    """eigen(<solver>, <'-generalized' | '-standard'>, <'-findLargest'>, count)"""
def eleDynamicalForce(element: _Word, dof: _Word = ..., /) -> list[float] | float:
    """eleDynamicalForce(element, <dof>)"""
def eleForce(element: _Word, dof: _Word = ..., /) -> list[float] | float:
    """eleForce(element, <dof>)"""
def eleLoad(*args: _Word) -> None:
    """eleLoad('-ele', tag, ... | '-range', first, last, '-type', '-beamUniform', ... | '-beamUniformMoment', mz | '-beamPoint', ...)"""
def element(*args: _Word) -> None:
    """element(kind, tag, iNode, jNode, ...)"""
def eleNodes(element: _Word, /) -> list[int]:
    """eleNodes(element)"""
def eleResponse(*args: _Word) -> list[float]:
    """eleResponse(element, response, ...)"""
def eleType(element: _Word, /) -> str:
    """eleType(element)"""
def equalDOF(*args: _Word) -> None:
    """equalDOF(retained, constrained, dof1, <dof2, ...>)"""
def equalDOF_Mixed(*args: _Word) -> None:
    """equalDOF_Mixed(retained, constrained, count, retainedDof1, constrainedDof1, <retainedDof2, constrainedDof2, ...>)"""
def fiber(y: _Word, z: _Word, area: _Word, material: _Word, /) -> None:
    """fiber(y, z, area, material)"""
def figure(*args: _Word) -> None:
    """figure(file.svg, '-title', text, '-x', label, '-y', label, <'-xrange', low, high>, <'-yrange', low, high>, <'-equal'>, '-line', name, xs, ys, ..., <'-dots', name, xs, ys, ...>)"""
def fill(mode: _Word, /) -> None:
    """fill(mode)"""
def filter(*args: Any) -> NoReturn: ...
def findCurvatures(*args: Any) -> NoReturn: ...
def findDesignPoint(*args: Any) -> NoReturn: ...
def fix(*args: _Word) -> None:
    """fix(node, flag1, <flag2, ...>, ('1', 'held,', '0', 'free'))"""
def fixX(*args: _Word) -> None:
    """fixX(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)"""
def fixY(*args: _Word) -> None:
    """fixY(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)"""
def fixZ(*args: _Word) -> None:
    """fixZ(coordinate, flag1, <flag2, ...>, <'-tol', tolerance>)"""
def frictionModel(*args: _Word) -> None:
    """frictionModel(kind, tag, ...)"""
def functionEvaluator(*args: Any) -> NoReturn: ...
def geomTransf(*args: _Word) -> None:
    """geomTransf('Linear'|'PDelta'|'Corotational', tag, <x, y, z, 'of', 'a', 'vector', 'in', 'the', 'local', 'x-z', 'plane,', 'in', 'space'>, <'-jntOffset', dxi, dyi, <dzi>, dxj, dyj, <dzj>>)"""
def getCDF(*args: Any) -> NoReturn: ...
def getConstrainedDOFs(node: _Word, retained: _Word = ..., /) -> list[int]:
    """getConstrainedDOFs(node, <retained>)"""
def getConstrainedNodes(retained: _Word = ..., /) -> list[int]:
    """getConstrainedNodes(<retained>)"""
def getCrdTransfTags() -> list[int]:
    """getCrdTransfTags()"""
def getDampTangent() -> None:
    """getDampTangent()"""
def getEleClassTags(element: _Word = ..., /) -> list[int]:
    """getEleClassTags(<element>)"""
def getEleLoadClassTags(pattern: _Word = ..., /) -> list[int]:
    """getEleLoadClassTags(<pattern>)"""
def getEleLoadData(pattern: _Word = ..., /) -> list[float]:
    """getEleLoadData(<pattern>)"""
def getEleLoadTags(pattern: _Word = ..., /) -> list[int]:
    """getEleLoadTags(<pattern>)"""
def getEleTags() -> list[int]:
    """getEleTags()"""
def getFixedDOFs(node: _Word, /) -> list[int]:
    """getFixedDOFs(node)"""
def getFixedNodes() -> list[int]:
    """getFixedNodes()"""
def getInverseCDF(*args: Any) -> NoReturn: ...
def getLoadFactor(pattern: _Word, /) -> float:
    """getLoadFactor(pattern)"""
def getLSFTags(*args: Any) -> NoReturn: ...
def getMean(*args: Any) -> NoReturn: ...
def getNDF(node: _Word = ..., /) -> list[int]:
    """getNDF(<node>)"""
def getNDM() -> list[int]:
    """getNDM()"""
def getNodeLoadData(pattern: _Word = ..., /) -> list[float]:
    """getNodeLoadData(<pattern>)"""
def getNodeLoadTags(pattern: _Word = ..., /) -> list[int]:
    """getNodeLoadTags(<pattern>)"""
def getNodeTags() -> list[int]:
    """getNodeTags()"""
def getNodeTemperature(*args: Any) -> NoReturn: ...
def getNP() -> int:
    """getNP()"""
def getNumElements() -> list[int]:
    """getNumElements()"""
def getNumThreads() -> int: ...
def getParamTags() -> list[int]:
    """getParamTags()"""
def getParamValue(tag: _Word, /) -> float:
    """getParamValue(tag)"""
def getPatterns() -> list[int]:
    """getPatterns()"""
def getPDF(*args: Any) -> NoReturn: ...
def getPID() -> int:
    """getPID()"""
def getRetainedDOFs(node: _Word, constrained: _Word = ..., /) -> list[int]:
    """getRetainedDOFs(node, <constrained>)"""
def getRetainedNodes(constrained: _Word = ..., /) -> list[int]:
    """getRetainedNodes(<constrained>)"""
def getRVParamTag(*args: Any) -> NoReturn: ...
def getRVTags(*args: Any) -> NoReturn: ...
def getRVValue(*args: Any) -> NoReturn: ...
def getStdv(*args: Any) -> NoReturn: ...
def getStrain() -> float:
    """getStrain()"""
def getStress() -> float:
    """getStress()"""
def getTangent() -> float:
    """getTangent()"""
def getTime() -> float:
    """getTime()"""
def gradientEvaluator(*args: Any) -> NoReturn: ...
def gradPerformanceFunction(*args: Any) -> NoReturn: ...
def groundMotion(*args: _Word) -> None:
    """groundMotion(tag, 'Plain', <'-accel', series>, <'-vel', series>, <'-disp', series>, <'-int', 'Trapezoidal'>, <'-dtInt', dt>, <'-fact', factor> | 'groundMotion', tag, 'Interpolated', motion, ..., '-fact', factor, ...)"""
def hystereticBackbone(*args: _Word) -> None:
    """hystereticBackbone(kind, tag, ...)"""
def IGA(*args: Any) -> NoReturn: ...
def imposedMotion(*args: _Word) -> None:
    """imposedMotion(node, dof, groundMotion, <'-other'>)"""
def imposedSupportMotion(*args: _Word) -> None:
    """imposedSupportMotion(node, dof, groundMotion, <'-other'>)"""
def initialize() -> None:
    """initialize()"""
def InitialStateAnalysis(*args: Any) -> NoReturn: ...
def integrator(*args: _Word) -> None:
    """integrator('LoadControl' | 'DisplacementControl' | 'ArcLength' | 'Newmark' | 'HHT' | ..., <'options'>)"""
def ladder(*args: _Word) -> None:
    """ladder('on' | 'off')"""
def layer(*args: _Word) -> None:
    """layer('straight', material, n, area, y1, z1, y2, z2 | 'circ', material, n, area, y, z, radius, <angle1, angle2>)"""
def limitCurve(*args: _Word) -> None:
    """limitCurve(kind, tag, element, ...)"""
def load(*args: _Word) -> None:
    """load(node, f1, <f2, ...>, <'-const'>, <'-pattern', tag>)"""
def loadConst(*args: _Word) -> None:
    """loadConst(<'-time', time>)"""
def localForce(element: _Word, dof: _Word = ..., /) -> list[float] | float:
    """localForce(element, <dof>)"""
def logCommands(*args: _Word) -> None:
    """logCommands(...)"""
def logFile(*args: _Word) -> None:
    """logFile(file, ...)"""
def mass(*args: _Word) -> None:
    """mass(node, m1, <m2, ...>)"""
def meritFunctionCheck(*args: Any) -> NoReturn: ...
def mesh(*args: Any) -> NoReturn: ...
def metaData(*args: _Word) -> None: ...
def modalDamping(*args: _Word) -> None:
    """modalDamping(ratio | ratio1, ratio2, ...)"""
def modalDampingQ(*args: _Word) -> None:
    """modalDampingQ(ratio | ratio1, ratio2, ...)"""
def modalProperties(*args: _Word) -> dict[str, list[float]] | None:
    """modalProperties(<'-print'>, <'-file', file>, <'-unorm'>, <'-return'>)"""
def model(*args: _Word) -> None:
    """model('BasicBuilder', '-ndm', ndm, <'-ndf', ndf>)"""
def modulatingFunction(*args: Any) -> NoReturn: ...
def motionFile(*args: _Word) -> list[float]:
    """motionFile(series, file, <'-factor', c>, <'-dt', dt>, <'-useLast'>, <'-channel', name>, <'-quantity', word>, <'-unit', unit>, <'-layout', word>, <'-to', unit>)"""
def nDMaterial(*args: _Word) -> None:
    """nDMaterial(kind, tag, ...)"""
def NDTest(*args: Any) -> NoReturn: ...
def node(*args: _Word) -> None:
    """node(tag, x, <y, <z>>, <'-ndf', ndf>, <'-mass', m, ...>, <'-disp', u, ...>, <'-vel', v, ...>)"""
def nodeAccel(node: _Word, dof: _Word = ..., /) -> list[float] | float:
    """nodeAccel(node, <dof>)"""
def nodeBounds() -> list[float]:
    """nodeBounds()"""
def nodeCoord(node: _Word, direction: _Word = ..., /) -> list[float] | float:
    """nodeCoord(node, <direction>)"""
def nodeDisp(node: _Word, dof: _Word = ..., /) -> list[float] | float:
    """nodeDisp(node, <dof>)"""
def nodeDOFs(node: _Word, /) -> list[int]:
    """nodeDOFs(node)"""
def nodeEigenvector(node: _Word, mode: _Word, dof: _Word = ..., /) -> list[float] | float:
    """nodeEigenvector(node, mode, <dof>)"""
def nodeMass(node: _Word, dof: _Word = ..., /) -> list[float] | float:
    """nodeMass(node, <dof>)"""
def nodePressure(node: _Word) -> float: ...
def nodeReaction(node: _Word, dof: _Word = ..., /) -> list[float] | float:
    """nodeReaction(node, <dof>)"""
def nodeResponse(*args: _Word) -> float:
    """nodeResponse(node, dof, response, ('1', 'displacement,', '2', 'velocity,', '3', 'acceleration'))"""
def nodeUnbalance(node: _Word, dof: _Word = ..., /) -> list[float] | float:
    """nodeUnbalance(node, <dof>)"""
def nodeVel(node: _Word, dof: _Word = ..., /) -> list[float] | float:
    """nodeVel(node, <dof>)"""
def numberer(*args: _Word) -> None:
    """numberer('Plain' | 'RCM' | 'AMD')"""
def numFact() -> None:
    """numFact()"""
def numIter() -> int:
    """numIter()"""
def OpenSeesParameter(*args: Any) -> NoReturn: ...
def parameter(*args: _Word) -> int:
    """parameter(tag, <value> | <'node', node, 'mass', 'x'|'y'|'z'|'xy'|'xyz'> | <'node', node, 'disp', dof> | <'loadPattern', pattern, 'loadAtNode', node, dof> | <'loadPattern', pattern, 'lambda'> | <'element'|'region', tag, name, ...>)"""
def partition(element: _Word = ..., /) -> None:
    """partition(<element>)"""
def patch(*args: _Word) -> None:
    """patch('quad', material, nIJ, nJK, yI, zI, yJ, zJ, yK, zK, yL, zL | 'rect', material, nY, nZ, yI, zI, yK, zK | 'circ', material, nCirc, nRad, y, z, rInner, rOuter, <angle1, angle2>)"""
def pattern(*args: _Word) -> None:
    """pattern('Plain', tag, series, <'-fact', factor>)"""
def performanceFunction(*args: Any) -> NoReturn: ...
def plane(front: _Word, back: _Word, /) -> None:
    """plane(front, back)"""
def plot(file: str | PathLike[str] | None = None, *, title: str = ..., units: tuple[str, str] = ..., modes: int = ...) -> Any: ...
def port(xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word, /) -> None:
    """port(xmin, xmax, ymin, ymax)"""
def pressureConstraint(*args: Any) -> NoReturn: ...
def printA(*args: _Word) -> list[float] | None:
    """printA(<'-file', file>, <'-ret'>)"""
def printB(*args: _Word) -> list[float] | None:
    """printB(<'-file', file>, <'-ret'>)"""
def printGID(*args: Any) -> NoReturn: ...
def printModel(*args: _Word) -> None:
    """printModel(<'-file', file>, <'-JSON'>, <'-node', <'-flag', n>, <tag, ...>>, <'-ele', <'-flag', n>, <tag, ...>>)"""
def printX(*args: Any) -> NoReturn: ...
def probabilityTransformation(*args: Any) -> NoReturn: ...
def projection(mode: _Word, /) -> None:
    """projection(mode)"""
def prp(x: _Word, y: _Word, z: _Word, /) -> None:
    """prp(x, y, z)"""
def pyversion(*args: _Word) -> str: ...
def randomNumberGenerator(*args: Any) -> NoReturn: ...
def randomVariable(*args: Any) -> NoReturn: ...
def rayleigh(*args: _Word) -> None:
    """rayleigh(alphaM, betaK, betaK0, betaKc, <'-ele', tag, ...>, <'-node', tag, ...>)"""
def reactions(*args: _Word) -> None:
    """reactions(<'-dynamic'>, <'-rayleigh'>)"""
def record() -> None:
    """record()"""
def recorder(*args: _Word) -> int:
    """recorder(kind, '-file', file, ...)"""
def recv(*args: _Word) -> None:
    """recv('-pid', process, variable)"""
def region(*args: _Word) -> None:
    """region(tag, <'-ele', tag, ...>, <'-eleOnly', tag, ...>, <'-eleRange', first, last>, <'-eleOnlyRange', ...>, <'-node', tag, ...>, <'-nodeOnly', ...>, <'-nodeRange', first, last>, <'-nodeOnlyRange', ...>, <'-rayleigh', alphaM, betaK, betaK0, betaKc>, <'-damp', damping>)"""
def reliabilityConvergenceCheck(*args: Any) -> NoReturn: ...
def remesh(*args: Any) -> NoReturn: ...
def remove(*args: _Word) -> None:
    """remove('loadPattern', tag | 'recorders' | 'recorder', tag | 'element', tag | 'node', tag | 'sp', tag | 'sp', node, dof, <pattern> | 'mp', tag | 'material', tag | 'timeSeries', tag | 'parameter', tag)"""
def reset() -> None:
    """reset()"""
def responseSpectrumAnalysis(*args: _Word) -> None:
    """responseSpectrumAnalysis(series, direction | direction, '-Tn', periods, '-Sa', accelerations, <'-scale', factor>, <'-mode', mode>)"""
def restore(tag: _Word, /) -> None:
    """restore(tag)"""
def revertToStart() -> None:
    """revertToStart()"""
def rigidDiaphragm(*args: _Word) -> None:
    """rigidDiaphragm(perpendicular, retained, constrained1, <constrained2, ...>)"""
def rigidLink(*args: _Word) -> None:
    """rigidLink('beam'|'bar', retained, constrained)"""
def rootFinding(*args: Any) -> NoReturn: ...
def runFORMAnalysis(*args: Any) -> NoReturn: ...
def runFOSMAnalysis(*args: Any) -> NoReturn: ...
def runImportanceSamplingAnalysis(*args: Any) -> NoReturn: ...
def runSORMAnalysis(*args: Any) -> NoReturn: ...
def save(tag: _Word, /) -> None:
    """save(tag)"""
def sdfResponse(*args: _Word) -> list[float]:
    """sdfResponse(m, zeta, k, Fy, alpha, dtF, file, dt) or m, zeta, k, Fy, alpha, series, dt, <'-uresid', u>, <'-umaxprev', u>, <'-tend', t>"""
def searchDirection(*args: Any) -> NoReturn: ...
def searchPeerNGA(*args: Any) -> NoReturn: ...
def section(*args: _Word) -> None:
    """section(kind, tag, ...)"""
def sectionDeformation(element: _Word, section: _Word, dof: _Word = ..., /) -> list[float] | float:
    """sectionDeformation(element, section, <dof>)"""
def sectionDisplacement(*args: Any) -> NoReturn: ...
def sectionFlexibility(element: _Word, section: _Word, dof: _Word = ..., /) -> list[float]:
    """sectionFlexibility(element, section, <dof>)"""
def sectionForce(element: _Word, section: _Word, dof: _Word = ..., /) -> list[float] | float:
    """sectionForce(element, section, <dof>)"""
def sectionLocation(element: _Word, section: _Word = ..., /) -> list[float] | float:
    """sectionLocation(element, <section>)"""
def sectionStiffness(element: _Word, section: _Word, dof: _Word = ..., /) -> list[float]:
    """sectionStiffness(element, section, <dof>)"""
def sectionTag(element: _Word, section: _Word = ..., /) -> list[int] | int:
    """sectionTag(element, <section>)"""
def sectionWeight(element: _Word, section: _Word = ..., /) -> list[float] | float:
    """sectionWeight(element, <section>)"""
def send(*args: _Word) -> None:
    """send('-pid', process, data)"""
def sensitivityAlgorithm(*args: Any) -> NoReturn: ...
def sensLambda(*args: Any) -> NoReturn: ...
def sensNodeAccel(*args: Any) -> NoReturn: ...
def sensNodeDisp(*args: Any) -> NoReturn: ...
def sensNodePressure(*args: Any) -> NoReturn: ...
def sensNodeVel(*args: Any) -> NoReturn: ...
def sensSectionForce(*args: Any) -> NoReturn: ...
def setCreep(*args: Any) -> NoReturn: ...
def setElementRayleighDampingFactors(element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word, /) -> None:
    """setElementRayleighDampingFactors(element, alphaM, betaK, betaK0, betaKc)"""
def setElementRayleighFactors(element: _Word, alphaM: _Word, betaK: _Word, betaK0: _Word, betaKc: _Word, /) -> None:
    """setElementRayleighFactors(element, alphaM, betaK, betaK0, betaKc)"""
def setMaxOpenFiles(n: _Word, /) -> None:
    """setMaxOpenFiles(n)"""
def setNodeAccel(*args: _Word) -> None:
    """setNodeAccel(node, dof, value, <'-commit'>)"""
def setNodeCoord(node: _Word, direction: _Word, value: _Word, /) -> None:
    """setNodeCoord(node, direction, value)"""
def setNodeDisp(*args: _Word) -> None:
    """setNodeDisp(node, dof, value, <'-commit'>)"""
def setNodeMass(node: _Word, dof: _Word, mass: _Word, /) -> None:
    """setNodeMass(node, dof, mass)"""
def setNodePressure(*args: Any) -> NoReturn: ...
def setNodeTemperature(*args: Any) -> NoReturn: ...
def setNodeVel(*args: _Word) -> None:
    """setNodeVel(node, dof, value, <'-commit'>)"""
def setNumThreads(number: int) -> None: ...
def setParameter(*args: _Word) -> None:
    """setParameter('-val', value, <'-ele', element, ... | '-eleRange', first, last>, name, ... | '-node', node, ..., 'mass', 'x'|'y'|'z'|'xy'|'xyz')"""
def setPrecision(digits: _Word, /) -> None:
    """setPrecision(digits)"""
def setStartNodeTag(tag: _Word, /) -> None:
    """setStartNodeTag(tag)"""
def setStrain(strain: _Word, rate: _Word = ..., /) -> None:
    """setStrain(strain, <rate>)"""
def setTime(time: _Word, /) -> None:
    """setTime(time)"""
def ShallowFoundationGen(*args: Any) -> NoReturn: ...
def solveCPU(*args: Any) -> NoReturn: ...
def sp(*args: _Word) -> None:
    """sp(node, dof, value, <'-const'>, <'-subtractInit'>, <'-pattern', tag>)"""
def spectrum(*args: Any) -> NoReturn: ...
def start() -> None:
    """start()"""
def startPoint(*args: Any) -> NoReturn: ...
def stepSizeRule(*args: Any) -> NoReturn: ...
def stiffnessDegradation(*args: Any) -> NoReturn: ...
def stop() -> None:
    """stop()"""
def strengthControl(*args: Any) -> NoReturn: ...
def strengthDegradation(*args: Any) -> NoReturn: ...
def stripXML(*args: Any) -> NoReturn: ...
def system(*args: _Word) -> None:
    """system('BandGeneral' | 'BandSPD' | 'ProfileSPD' | 'SparseGeneral' | 'UmfPack' | 'FullGeneral' | ...)"""
def systemSize() -> int:
    """systemSize()"""
def test(*args: _Word) -> None:
    """test(kind, tolerance, maxIterations, <printFlag>, <norm>)"""
def testIter() -> int:
    """testIter()"""
def testNorm() -> list[float]:
    """testNorm()"""
def testNorms() -> list[float]:
    """testNorms()"""
def testUniaxialMaterial(tag: _Word, /) -> None:
    """testUniaxialMaterial(tag)"""
def timeSeries(*args: _Word) -> None:
    """timeSeries(kind, tag, ...)"""
def totalCPU(*args: Any) -> NoReturn: ...
def transformUtoX(*args: Any) -> NoReturn: ...
def uniaxialMaterial(*args: _Word) -> None:
    """uniaxialMaterial(kind, tag, ...)"""
def unloadingRule(*args: Any) -> NoReturn: ...
def updateElementDomain(*args: Any) -> NoReturn: ...
def updateMaterialStage(*args: Any) -> NoReturn: ...
def updateParameter(tag: _Word, value: _Word, /) -> int:
    """updateParameter(tag, value)"""
def verify(*args: _Word) -> None:
    """verify('value'|'error', result, reference, <tolerance>, <text>)"""
def version() -> str:
    """version()"""
def viewWindow(xmin: _Word, xmax: _Word, ymin: _Word, ymax: _Word, /) -> None:
    """viewWindow(xmin, xmax, ymin, ymax)"""
def vpn(x: _Word, y: _Word, z: _Word, /) -> None:
    """vpn(x, y, z)"""
def vrp(x: _Word, y: _Word, z: _Word, /) -> None:
    """vrp(x, y, z)"""
def vup(x: _Word, y: _Word, z: _Word, /) -> None:
    """vup(x, y, z)"""
def watch() -> None: ...
def wipe() -> None:
    """wipe()"""
def wipeAnalysis() -> None:
    """wipeAnalysis()"""
def wipeReliability(*args: Any) -> NoReturn: ...
