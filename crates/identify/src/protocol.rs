//! Test protocols of a single bearing, and the scripts that run them.
//!
//! The bearing is element 1. Its lower node is fixed. The upper node moves without rotation, as between the plates of a
//! testing machine. The last axis is vertical.

use std::fmt::Write as _;

/// Motion of the upper node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Sines along a horizontal direction.
    Cycles {
        /// Angle from x in degrees.
        angle: f64,
    },
    /// Circles about the lower node, after a ramp along x.
    Circles,
    /// Figures of eight: a sine along x, and a sine of half the amplitude and twice the frequency along y.
    Eights,
    /// Axial sines at a constant lateral displacement.
    Axial {
        /// Displacement along x.
        offset: f64,
    },
    /// Ramps along x to each amplitude in turn, with a hold after each.
    Ramps {
        /// Speed of the ramps.
        speed: f64,
        /// Duration of a hold.
        hold: f64,
    },
    /// The path of a recording, [`Protocol::recorded`].
    Recorded,
}

/// A recorded path of the upper node.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedPath {
    /// Step of time.
    pub dt: f64,
    /// Displacements along x, and along y where the path has two directions; of one length.
    pub displacements: Vec<Vec<f64>>,
}

impl Motion {
    /// Description for messages and headings.
    fn title(self) -> &'static str {
        match self {
            Self::Cycles { .. } => "cycles of shear",
            Self::Circles => "circles",
            Self::Eights => "figures of eight",
            Self::Axial { .. } => "axial cycles",
            Self::Ramps { .. } => "ramps and holds",
            Self::Recorded => "a recorded path",
        }
    }
}

/// A test protocol.
#[derive(Clone, Debug, PartialEq)]
pub struct Protocol {
    /// Motion of the upper node.
    pub motion: Motion,
    /// Amplitudes of displacement, in order; the peak of a recorded path.
    pub amplitudes: Vec<f64>,
    /// The path of [`Motion::Recorded`]; empty for others.
    pub recorded: RecordedPath,
    /// Number of cycles of each amplitude.
    pub cycles: usize,
    /// Number of cycles in a unit of time.
    pub frequency: f64,
    /// Number of steps of a cycle, or of a ramp as long as the largest amplitude.
    pub steps: usize,
    /// Axial load, compression positive.
    pub axial: f64,
    /// Amplitude of a sine that is added to the axial load.
    pub axial_amplitude: f64,
    /// Number of cycles of the axial load in a cycle of the motion.
    pub axial_ratio: f64,
    /// True to impose velocities too, in a transient analysis, for rate-dependent devices.
    pub rates: bool,
}

/// The bearing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bearing {
    /// Path of the script that defines it.
    pub file: String,
    /// The call that makes element 1 between nodes 1 and 2; `None` if the script itself makes it.
    pub call: Option<String>,
    /// Its nodes, the lower one first.
    pub nodes: [i32; 2],
    /// Dimensions of space, 2 or 3.
    pub ndm: usize,
    /// The upper node is held along the vertical: the bearing has no stiffness there.
    pub is_held: bool,
}

impl Bearing {
    /// Degrees of freedom of each node.
    fn ndf(&self) -> usize {
        if self.ndm == 2 { 3 } else { 6 }
    }

    /// Commands of a static step without loads in which the vertical alone is free; the result of the last one is 0 if the
    /// bearing has a stiffness there.
    pub fn vertical_step(&self) -> String {
        let ([lower, upper], ndf) = (self.nodes, self.ndf());
        let flags: Vec<&str> = (1..=ndf).map(|d| if d == self.ndm { "0" } else { "1" }).collect();
        format!(
            "{}fix {lower} {}\nfix {upper} {}\nconstraints Plain\nnumberer Plain\nsystem FullGeneral\n\
             test NormDispIncr 1e-9 50\nalgorithm Newton\nintegrator LoadControl 1.0\nanalysis Static\nanalyze 1\n",
            self.definition(),
            vec!["1"; ndf].join(" "),
            flags.join(" ")
        )
    }

    /// The commands that make it, for the current folder.
    pub fn definition(&self) -> String {
        self.definition_from(&word(&self.file))
    }

    /// The commands that make it, with its script as a word of Tcl.
    fn definition_from(&self, file: &str) -> String {
        let source = format!("source {file}\n");
        match &self.call {
            Some(call) => {
                let model = "model BasicBuilder -ndm 3 -ndf 6\nnode 1 0.0 0.0 0.0\nnode 2 0.0 0.0 0.0\n";
                format!("{model}{source}{call}\n")
            }
            None => source,
        }
    }
}

/// Tcl procedure: a straight path along x in n steps.
const RAMP: &str = "proc ramp {to n} {\n    global xs\n    set from [lindex $xs end]\n    \
    for {set i 1} {$i <= $n} {incr i} { place [expr {$from + ($to - $from)*$i/double($n)}] 0.0 0.0 }\n}\n";

/// The error of a quantity that is not `good`, or not finite.
fn check(what: &str, value: f64, good: bool, expected: &str) -> Result<(), String> {
    if good && value.is_finite() { Ok(()) } else { Err(format!("the {what} is {value}: expected {expected}")) }
}

impl Protocol {
    /// Check the protocol for a bearing in `ndm` dimensions.
    ///
    /// # Errors
    /// A quantity is out of range, or the motion needs three dimensions. The message has the value and what was expected.
    pub fn check(&self, ndm: usize) -> Result<(), String> {
        let positive = "more than 0";
        check("number of amplitudes", self.amplitudes.len() as f64, !self.amplitudes.is_empty(), "at least 1")?;
        let ramps = matches!(self.motion, Motion::Ramps { .. });
        for &a in &self.amplitudes {
            check("amplitude", a, a > 0.0 || ramps, positive)?;
        }
        check("largest amplitude", self.largest(), self.largest() > 0.0, positive)?;
        check("number of cycles", self.cycles as f64, self.cycles > 0, "at least 1")?;
        check("number of steps of a cycle", self.steps as f64, self.steps >= 8, "at least 8")?;
        check("frequency", self.frequency, self.frequency > 0.0, positive)?;
        check("axial load", self.axial, true, "a number")?;
        check("amplitude of the axial load", self.axial_amplitude, true, "a number")?;
        check("ratio of the axial cycles", self.axial_ratio, self.axial_ratio > 0.0, positive)?;
        let plane = ndm == 2;
        match self.motion {
            Motion::Ramps { speed, hold } => {
                check("speed of the ramps", speed, speed > 0.0, positive)?;
                check("time of a hold", hold, hold >= 0.0, "not less than 0")
            }
            Motion::Axial { offset } => {
                check("offset", offset, true, "a number")?;
                let load = self.axial.abs() + self.axial_amplitude.abs();
                check("axial load", load, load == 0.0, "none, since axial displacements are imposed")
            }
            Motion::Cycles { angle } => check("angle", angle, angle == 0.0 || !plane, "0 in the plane"),
            Motion::Circles | Motion::Eights if plane => {
                Err(format!("{} need a bearing in space, not in the plane", self.motion.title()))
            }
            Motion::Recorded if plane && self.recorded.displacements.len() > 1 => {
                Err("a path of two directions needs a bearing in space, not in the plane".into())
            }
            Motion::Recorded => check("step of the path", self.recorded.dt, self.recorded.dt > 0.0, positive),
            Motion::Circles | Motion::Eights => Ok(()),
        }
    }

    /// Largest amplitude.
    fn largest(&self) -> f64 {
        self.amplitudes.iter().fold(0.0, |m, a| m.max(a.abs()))
    }

    /// Time step.
    fn time_step(&self) -> f64 {
        match self.motion {
            Motion::Ramps { speed, .. } => self.largest() / (speed * self.steps as f64),
            Motion::Recorded => self.recorded.dt,
            _ => 1.0 / (self.frequency * self.steps as f64),
        }
    }

    /// The script of the test. It writes displacements of the upper node, and the forces on it, to files in its own folder.
    /// `file` is the path of the bearing's script from there.
    pub fn script(&self, bearing: &Bearing, file: &str) -> String {
        let mut t = String::new();
        let [lower, upper] = bearing.nodes;
        let _ = writeln!(t, "# {} of the bearing of {file}, made by hysteron.", sentence(self.motion.title()));
        let _ = writeln!(t, "# Units are those of the bearing; times in the unit of 1/frequency.\n");
        let _ = writeln!(
            t,
            "# Paths are those from the folder of this script.\nset test_folder [file dirname [info script]]"
        );
        let here = |file: &str| format!("[file join $test_folder {}]", word(file));
        t += &bearing.definition_from(&here(file));
        t.push('\n');
        let plane = bearing.ndm == 2;
        let driven = self.imposed_directions(plane);
        let is_free = |d: usize| driven.contains(&d) || d == bearing.ndm && !bearing.is_held;
        let held = |d: usize| if is_free(d) { "0" } else { "1" };
        let ndf = bearing.ndf();
        let flags: Vec<&str> = (1..=ndf).map(held).collect();
        let _ = writeln!(t, "# The testing machine: the lower plate is held, the upper one moves without turning.");
        let _ = writeln!(t, "fix {lower} {}", vec!["1"; ndf].join(" "));
        let _ = writeln!(t, "fix {upper} {}\n", flags.join(" "));
        let _ = writeln!(t, "constraints Transformation\nnumberer Plain\nsystem FullGeneral");
        let _ = writeln!(t, "test NormDispIncr {:.1e} 50\nalgorithm Newton\n", 1e-9 * self.largest());
        if self.axial != 0.0 {
            self.write_axial_load(&mut t, bearing, &driven, ndf);
        }
        self.write_path(&mut t);
        self.write_motion(&mut t, bearing, &driven, ndf);
        let dofs: Vec<String> = (1..=bearing.ndm).map(|d| d.to_string()).collect();
        let dofs = dofs.join(" ");
        let forces: Vec<String> = (1..=bearing.ndm).map(|d| (ndf + d).to_string()).collect();
        let _ = writeln!(t, "# Rows from the state at rest on.");
        let file = here("displacement.out");
        let _ = writeln!(t, "recorder Node -file {file} -precision 12 -time -node {upper} -dof {dofs} disp");
        let (file, forces) = (here("force.out"), forces.join(" "));
        let _ = writeln!(t, "recorder Element -file {file} -precision 12 -time -ele 1 -dof {forces} force");
        let _ = writeln!(t, "record\n");
        if self.rates {
            t += "integrator Newmark 0.5 0.25\nanalysis Transient\nset ok [analyze [expr {[llength $xs] - 1}] $dt]\n";
        } else {
            t += "integrator LoadControl $dt\nanalysis Static\nset ok [analyze [expr {[llength $xs] - 1}]]\n";
        }
        t += "if {$ok != 0} { puts stderr \"the test ended at time [getTime]: try more steps\" }\n";
        t
    }

    /// Samples at the start of a recorded path that are the state at rest: one, or none.
    fn samples_at_rest(&self) -> usize {
        usize::from(self.recorded.displacements.iter().all(|d| d.first() == Some(&0.0)))
    }

    /// Directions of imposed displacements, from 1.
    fn imposed_directions(&self, plane: bool) -> Vec<usize> {
        let vertical = if plane { 2 } else { 3 };
        match self.motion {
            Motion::Cycles { angle } if angle != 0.0 => vec![1, 2],
            Motion::Cycles { .. } | Motion::Ramps { .. } => vec![1],
            Motion::Recorded => (1..=self.recorded.displacements.len()).collect(),
            Motion::Circles | Motion::Eights => vec![1, 2],
            Motion::Axial { .. } => vec![1, vertical],
        }
    }

    /// Write the constant axial load. A device that only resists a velocity would be a mechanism under it: with rates, the
    /// upper plate is held where it is.
    fn write_axial_load(&self, t: &mut String, bearing: &Bearing, driven: &[usize], ndf: usize) {
        let upper = bearing.nodes[1];
        let _ = writeln!(t, "# Axial load, which stays.");
        let _ = writeln!(t, "timeSeries Linear 901\npattern Plain 901 901 {{");
        let _ = writeln!(t, "    load {} {}\n}}", bearing.nodes[1], vertical_load(-self.axial, bearing.ndm, ndf));
        if self.rates {
            let held = |d: usize| if driven.contains(&d) { "1" } else { "0" };
            let flags: Vec<&str> = (1..=ndf).map(held).collect();
            let _ = writeln!(t, "fix {upper} {}", flags.join(" "));
        }
        t.push_str("integrator LoadControl 0.1\nanalysis Static\n");
        t.push_str("if {[analyze 10] != 0} { error \"the bearing does not carry the axial load\" }\n");
        t.push_str("loadConst -time 0.0\n");
        for d in driven.iter().filter(|_| self.rates) {
            let _ = writeln!(t, "remove sp {upper} {d}");
        }
        t.push('\n');
    }

    /// Write the path of the upper node as lists of coordinates, one for each step from the state at rest.
    fn write_path(&self, t: &mut String) {
        let amplitudes: Vec<String> = self.amplitudes.iter().map(f64::to_string).collect();
        let _ = writeln!(t, "# The path of the upper node: a value a step, from the state at rest on.");
        let _ = writeln!(t, "set amplitudes {{{}}}\nset cycles {}", amplitudes.join(" "), self.cycles);
        let _ =
            writeln!(t, "set steps {}\nset dt {}\nset turn [expr {{2.0*acos(-1.0)}}]", self.steps, self.time_step());
        t.push_str("set xs {0.0}; set ys {0.0}; set zs {0.0}\n");
        t.push_str("proc place {x y z} {\n    global xs ys zs\n    lappend xs $x; lappend ys $y; lappend zs $z\n}\n");
        if matches!(self.motion, Motion::Circles | Motion::Axial { .. } | Motion::Ramps { .. }) {
            t.push_str(RAMP);
        }
        let each = "foreach a $amplitudes {\n    for {set i 1} {$i <= $cycles*$steps} {incr i} {\n        \
                    set p [expr {$turn*$i/$steps}]\n";
        match self.motion {
            Motion::Cycles { angle } => {
                let _ = writeln!(t, "set angle [expr {{{angle}*$turn/360.0}}]");
                t.push_str(each);
                t.push_str(
                    "        place [expr {$a*sin($p)*cos($angle)}] [expr {$a*sin($p)*sin($angle)}] 0.0\n    }\n}\n\n",
                );
            }
            Motion::Circles => {
                let head = "foreach a $amplitudes {\n    ramp $a [expr {$steps/4}]\n";
                t.push_str(&each.replacen("foreach a $amplitudes {\n", head, 1));
                t.push_str("        place [expr {$a*cos($p)}] [expr {$a*sin($p)}] 0.0\n    }\n}\n\n");
            }
            Motion::Eights => {
                t.push_str(each);
                t.push_str("        place [expr {$a*sin($p)}] [expr {0.5*$a*sin(2.0*$p)}] 0.0\n    }\n}\n\n");
            }
            Motion::Axial { offset } => {
                let _ =
                    writeln!(t, "set offset {offset}\nif {{$offset != 0.0}} {{ ramp $offset [expr {{$steps/4}}] }}");
                t.push_str(each);
                t.push_str("        place $offset 0.0 [expr {$a*sin($p)}]\n    }\n}\n\n");
            }
            Motion::Ramps { speed, hold } => {
                let _ = writeln!(t, "set speed {speed}\nset hold {hold}");
                t.push_str("foreach a $amplitudes {\n    set way [expr {abs($a - [lindex $xs end])}]\n");
                t.push_str("    ramp $a [expr {max(1, round($way/($speed*$dt)))}]\n");
                t.push_str("    ramp $a [expr {round($hold/$dt)}]\n}\n\n");
            }
            Motion::Recorded => {
                let list = |d: usize| {
                    let values = self.recorded.displacements.get(d).map_or(&[][..], Vec::as_slice);
                    // A path that starts at rest needs no step to its first sample.
                    values.iter().skip(self.samples_at_rest()).map(|x| format!("{x:?}")).collect::<Vec<_>>().join(" ")
                };
                let _ = match self.recorded.displacements.len() {
                    1 => writeln!(t, "foreach x {{{}}} {{ place $x 0.0 0.0 }}\n", list(0)),
                    _ => writeln!(t, "foreach x {{{}}} y {{{}}} {{ place $x $y 0.0 }}\n", list(0), list(1)),
                };
            }
        }
    }

    /// Write the patterns of imposed displacements, and of the varying axial load.
    fn write_motion(&self, t: &mut String, bearing: &Bearing, driven: &[usize], ndf: usize) {
        let upper = bearing.nodes[1];
        let vertical = bearing.ndm;
        let list = |d: usize| if d == vertical { "zs" } else { ["xs", "ys"][d - 1] };
        if self.rates {
            t.push_str("# Velocities of a path, by central differences.\nproc velocities {path} {\n    global dt\n");
            t.push_str("    set v {}; set last [lindex $path 0]\n    foreach u $path next [lrange $path 1 end] {\n");
            t.push_str(
                "        if {$next eq {}} { set next $u }\n        lappend v [expr {($next - $last)/(2.0*$dt)}]\n",
            );
            t.push_str("        set last $u\n    }\n    return $v\n}\n");
        }
        for &d in driven {
            let (path, series) = (list(d), 910 + d);
            let _ = writeln!(t, "timeSeries Path {series} -dt $dt -values ${path} -useLast");
            if self.rates {
                let _ = writeln!(t, "timeSeries Path {} -dt $dt -values [velocities ${path}] -useLast", 920 + d);
                let _ = writeln!(t, "pattern MultipleSupport {series} {{");
                let _ = writeln!(t, "    groundMotion {series} Plain -disp {series} -vel {}", 920 + d);
                let _ = writeln!(t, "    imposedMotion {upper} {d} {series}\n}}");
            } else {
                let _ = writeln!(t, "pattern Plain {series} {series} {{ sp {upper} {d} 1.0 }}");
            }
        }
        if self.axial_amplitude != 0.0 {
            t.push_str("set ps {}\nfor {set i 0} {$i < [llength $xs]} {incr i} {\n");
            let _ = writeln!(t, "    lappend ps [expr {{sin({}*$turn*$i/$steps)}}]\n}}", self.axial_ratio);
            t.push_str("timeSeries Path 902 -dt $dt -values $ps -useLast\npattern Plain 902 902 {\n");
            let _ = writeln!(t, "    load {upper} {}\n}}", vertical_load(-self.axial_amplitude, bearing.ndm, ndf));
        }
        t.push('\n');
    }
}

/// Components of a nodal load with one vertical value.
fn vertical_load(value: f64, ndm: usize, ndf: usize) -> String {
    let words: Vec<String> = (1..=ndf).map(|d| if d == ndm { value.to_string() } else { "0.0".into() }).collect();
    words.join(" ")
}

/// A name quoted as one word of Tcl.
fn word(name: &str) -> String {
    if name.contains(|c: char| c.is_whitespace() || "$[]{};\"\\".contains(c)) {
        let escaped: String = name.chars().flat_map(|c| ['\\', c]).collect();
        return escaped;
    }
    name.to_owned()
}

/// A text with a capital first letter.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
