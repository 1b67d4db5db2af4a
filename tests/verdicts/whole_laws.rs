//! Bearings by whole laws of OpenSees, with their further effects switched off and on: `LeadRubberX` and `FPBearingPTV`.
//! `validation/diagnosis/whole_laws.py` writes their forces.

use super::studies::{Channel, Concealed, Noise, Record};

/// Time between two samples, s.
const DT: f64 = 0.05;

/// Column of the forces.
#[derive(Clone, Copy)]
pub enum Truth {
    Lead = 2,
    WarmLead = 3,
    Slider = 4,
    WarmFastSlider = 5,
}

fn runs(truth: Truth) -> Vec<Record> {
    let rows = || include_str!("whole_laws.csv").lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let mut noise = Noise::default();
    let run = |name: &'static str| {
        let column = |n: usize| -> Vec<f64> {
            rows().filter(|row| row[0] == name).map(|row| row[n].parse::<f64>().unwrap()).collect()
        };
        let pure = column(truth as usize);
        let size = 0.01 * pure.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        Record {
            name,
            holdout: name == "others",
            set: String::new(),
            motions: vec![("motion", column(1).iter().map(|u| u / 1000.0).collect())],
            columns: vec![("force[kN]".to_owned(), pure.iter().map(|f| f + size * noise.next()).collect())],
        }
    };
    ["strong", "others"].map(run).into()
}

/// The motion of a bearing in a plane, after what makes it.
fn model(parameters: &str, bearing: &str, weight: &str) -> String {
    let settings = "constraints Transformation\nsystem FullGeneral\ntest NormDispIncr 1e-9 50\nalgorithm Newton\n";
    format!(
        "wipe\nmodel basic -ndm 2 -ndf 3\n{parameters}node 1 0. 0.\nnode 2 0. 0.\nfix 1 1 1 1\nfix 2 0 0 1\n\
         uniaxialMaterial Elastic 7 1e7\nuniaxialMaterial Elastic 8 1e6\n{bearing}\n{settings}{weight}\
         timeSeries Path 1 -dt $dt -filePath $motion\npattern Plain 1 1 {{ sp 2 1 1.0 }}\n\
         recorder Element -file force.out -time -ele 1 force\nintegrator LoadControl [expr {{$dt/4}}]\nanalysis Static\n\
         for {{set i 1}} {{$i < $npts}} {{incr i}} {{ if {{[analyze 4] != 0}} {{ error \"no convergence\" }} }}\n"
    )
}

fn study(model: String, parameters: [(&'static str, f64, f64); 3], truth: Truth) -> Concealed {
    let channels = vec![Channel { name: "force", output: "force.out", column: 4 }];
    Concealed { model, parameters: parameters.into(), channels, dt: DT, runs: runs(truth) }
}

const OF_LEAD: [(&str, f64, f64); 3] = [("k1", 1500.0, 60000.0), ("qd", 50.0, 400.0), ("kd", 200.0, 2000.0)];

fn lead(bearing: &str, truth: Truth) -> Concealed {
    let parameters = "pset k1 8000.0\npset qd 150.0\npset kd 700.0\n";
    study(model(parameters, &format!("{bearing} -P 7 -Mz 8 -orient 0 1 0 -1 0 0"), ""), OF_LEAD, truth)
}

/// The model's bearing has sharp corners.
pub fn sharp_lead(truth: Truth) -> Concealed {
    lead("element elastomericBearingPlasticity 1 1 2 $k1 $qd [expr {$kd/$k1}] 0.0 1.0", truth)
}

/// The model's bearing has the corners of `LeadRubberX`.
pub fn smooth_lead(truth: Truth) -> Concealed {
    lead("element elastomericBearingBoucWen 1 1 2 $k1 $qd [expr {$kd/$k1}] 0.0 1.0 2.0 0.9 0.1", truth)
}

/// The model's pendulum has a constant coefficient.
pub fn slider(truth: Truth) -> Concealed {
    let bearing = "frictionModel Coulomb 1 $mu\nelement singleFPBearing 1 1 2 1 $R $ki -P 7 -Mz 8 -orient 0 1 0 -1 0 0";
    let weight = "timeSeries Linear 9\npattern Plain 9 9 { load 2 0. -500. 0. }\nintegrator LoadControl 0.1\n\
        analysis Static\nanalyze 10\nloadConst -time 0.0\n";
    let parameters = [("mu", 0.02, 0.2), ("R", 1.0, 4.0), ("ki", 5000.0, 200_000.0)];
    study(model("pset mu 0.06\npset R 1.7\npset ki 30000.0\n", bearing, weight), parameters, truth)
}
