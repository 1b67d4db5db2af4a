"""Names of openseespy that hysteron has no command for, by the reason."""

#: Names by reason. A call of one raises OpenSeesError with the reason.
OUT_OF_SCOPE = {
    "reliability": (
        "randomVariable correlate getCDF getInverseCDF getLSFTags getMean getPDF getRVParamTag getRVTags getRVValue "
        "getStdv filter findDesignPoint functionEvaluator gradPerformanceFunction gradientEvaluator "
        "meritFunctionCheck modulatingFunction performanceFunction probabilityTransformation randomNumberGenerator "
        "reliabilityConvergenceCheck rootFinding runFORMAnalysis runFOSMAnalysis runImportanceSamplingAnalysis "
        "runSORMAnalysis searchDirection spectrum startPoint stepSizeRule transformUtoX wipeReliability findCurvatures"
    ),
    "meshes that change, and fluids": "mesh remesh IGA setNodePressure sensNodePressure pressureConstraint",
    "temperature": "getNodeTemperature setNodeTemperature",
    "data bases and conversions of files": (
        "convertBinaryToText convertTextToBinary stripXML searchPeerNGA"
    ),
    "other programs and generators": "NDTest ShallowFoundationGen OpenSeesParameter",
    "parts of laws that hysteron does not have yet": (
        "stiffnessDegradation strengthDegradation strengthControl unloadingRule "
        "setCreep InitialStateAnalysis"
    ),
    "queries that hysteron does not have yet": (
        "accelCPU solveCPU totalCPU domainCommitTag printGID updateElementDomain"
    ),
}
REASONS = {name: reason for reason, names in OUT_OF_SCOPE.items() for name in names.split()}
