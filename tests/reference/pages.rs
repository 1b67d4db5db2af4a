//! The pages of the reference of commands.

use super::page::Page;

/// The pages, in the order of the book.
pub const PAGES: &[Page] = &[
    Page {
        name: "model",
        title: "Model",
        intro: "Nodes, masses, supports, constraints between nodes, damping and parameters.",
    },
    Page {
        name: "material",
        title: "Materials",
        intro: "Uniaxial laws, laws of friction, and the commands that try a law by itself.",
    },
    Page { name: "element", title: "Elements", intro: "Springs, links, trusses, beams and bearings." },
    Page { name: "section", title: "Sections", intro: "Cross-sections of beams." },
    Page {
        name: "load",
        title: "Loads and ground motions",
        intro: "Time series, patterns of loads, and motions of supports.",
    },
    Page { name: "analysis", title: "Analysis", intro: "The parts of an analysis, its steps, and modes." },
    Page {
        name: "output",
        title: "Output and queries",
        intro: "Recorders, and commands that return a result to the script.",
    },
    Page {
        name: "hysteron",
        title: "Commands of hysteron's own",
        intro: "Commands that OpenSees does not have. [High damping rubber](material.md) has laws of its own under \
                `uniaxialMaterial` and `element`.",
    },
];
