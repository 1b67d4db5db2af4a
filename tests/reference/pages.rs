//! The pages of the reference of commands.

use super::page::Page;

/// The pages, in the order of the book.
pub const PAGES: &[Page] = &[
    Page {
        name: "model",
        title: "Model",
        intro: "Nodes, masses, supports, constraints between nodes, damping and parameters.",
        commands: "wipe database save restore model node mass setNodeCoord setStartNodeTag block2D block3D fix fixX fixY fixZ equalDOF equalDOF_Mixed rigidDiaphragm \
                   rigidLink rayleigh damping region setElementRayleighDampingFactors setElementRayleighFactors \
                   modalDamping modalDampingQ parameter addToParameter updateParameter setParameter \
                   getParamValue getParamTags remove domainChange defaultUnits",
    },
    Page {
        name: "material",
        title: "Materials",
        intro: "Uniaxial laws, laws of friction, and the commands that try a law by itself.",
        commands: "uniaxialMaterial hystereticBackbone limitCurve nDMaterial frictionModel testUniaxialMaterial setStrain getStrain \
                   getStress getTangent getDampTangent",
    },
    Page {
        name: "element",
        title: "Elements",
        intro: "Springs, links, trusses, beams and bearings.",
        commands: "element geomTransf beamIntegration",
    },
    Page {
        name: "section",
        title: "Sections",
        intro: "Cross-sections of beams.",
        commands: "section fiber patch layer",
    },
    Page {
        name: "load",
        title: "Loads and ground motions",
        intro: "Time series, patterns of loads, and motions of supports.",
        commands: "timeSeries pattern load sp eleLoad groundMotion imposedMotion imposedSupportMotion loadConst \
                   setTime",
    },
    Page {
        name: "analysis",
        title: "Analysis",
        intro: "The parts of an analysis, its steps, and modes.",
        commands: "constraints numberer system test algorithm integrator analysis analyze eigen modalProperties \
                   responseSpectrumAnalysis sdfResponse reset revertToStart wipeAnalysis initialize numFact numIter testIter testNorm testNorms \
                   systemSize printA printB",
    },
    Page {
        name: "output",
        title: "Output and queries",
        intro: "Recorders, and commands that return a result to the script.",
        commands: "recorder record setPrecision print printModel verify nodeDisp nodeVel nodeAccel nodeReaction nodeUnbalance \
                   nodeMass nodeCoord nodeEigenvector nodeDOFs nodeBounds reactions setNodeDisp setNodeVel \
                   setNodeAccel setNodeMass eleResponse eleForce eleDynamicalForce localForce basicForce basicDeformation \
                   basicStiffness nodeResponse classType getEleClassTags getCrdTransfTags \
                   getEleLoadTags getEleLoadClassTags getEleLoadData getNodeLoadTags getNodeLoadData \
                   getNumElements getPatterns getFixedNodes getFixedDOFs \
                   getConstrainedNodes getConstrainedDOFs getRetainedNodes getRetainedDOFs \
                   eleNodes eleType sectionForce sectionDeformation sectionStiffness sectionFlexibility \
                   sectionLocation sectionWeight sectionTag getTime getLoadFactor getNodeTags getEleTags getNDM \
                   getNDF getPID getNP barrier partition send recv Bcast version prp vrp vup vpn viewWindow plane port projection fill display \
                   plot logFile logCommands setMaxOpenFiles start stop",
    },
    Page {
        name: "hysteron",
        title: "Commands of hysteron's own",
        intro: "Commands that OpenSees does not have. [High damping rubber](material.md) has laws of its own under \
                `uniaxialMaterial` and `element`.",
        commands: "pset ladder columns motionFile figure amend",
    },
];
