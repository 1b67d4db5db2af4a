//! Laws of oscillators from the words of a command.

use hysteron_engine::analysis::Options;
use hysteron_engine::material::Slot;
use hysteron_opensees::run::{End, Run, Settings};
use hysteron_opensees::{Mode, NoFiles};
use hysteron_tcl::{Files as _, MemoryFiles, Silent};

/// Words of a `uniaxialMaterial` command in which `$tag`, `$Fy`, `$k` and `$Dy` stand for the tag, the yield force, the elastic
/// stiffness and the yield displacement of an oscillator of unit mass.
#[derive(Clone, Debug, PartialEq)]
pub struct LawText(String);

/// File of the script that makes a law.
const FILE: &str = "law.tcl";

impl LawText {
    /// The words behind `uniaxialMaterial`.
    ///
    /// # Errors
    /// They have no tag, or name neither strength nor stiffness.
    pub fn new(words: &str) -> Result<Self, String> {
        let asked = ["$tag", "$Fy", "$k"];
        if let Some(lacking) = asked.iter().find(|name| !words.contains(**name)) {
            return Err(format!(
                "the law \"{words}\" has no {lacking}: expected the words of a uniaxialMaterial with $tag, $Fy and $k, such as \
                 \"Steel01 $tag $Fy $k 0.05\""
            ));
        }
        Ok(Self(words.to_owned()))
    }

    /// Maker of its laws. It does not leave its thread.
    pub(super) fn maker(&self) -> LawMaker<'_> {
        let files = MemoryFiles::default();
        let text = format!(
            "model BasicBuilder -ndm 1 -ndf 1\nlassign $argv tag Fy k\nset Dy [expr {{$Fy/$k}}]\nuniaxialMaterial {}\n",
            self.0
        );
        files.insert(&format!("{}/{FILE}", files.current_dir().trim_end_matches('/')), text.as_str());
        LawMaker { text: self, files }
    }
}

/// Makes laws of one text.
pub(super) struct LawMaker<'a> {
    text: &'a LawText,
    files: MemoryFiles,
}

impl LawMaker<'_> {
    /// The law of a yield force and a stiffness, per unit of mass.
    ///
    /// # Errors
    /// The command does not take them.
    pub(super) fn law(&self, yield_force: f64, stiffness: f64) -> Result<Slot, String> {
        const TAG: i32 = 1;
        let settings = Settings { mode: Mode::Run, strict: false, options: Options::default() };
        let mut run = Run::new(settings, Box::new(Silent), Box::new(self.files.clone()), Box::new(NoFiles));
        let words = [TAG.to_string(), yield_force.to_string(), stiffness.to_string()];
        let wrong = |why: String| format!("the law \"{}\" with a yield force of {yield_force:.6}: {why}", self.text.0);
        match run.script(FILE, &words) {
            End::Done => {}
            End::Raised(d) | End::Rejected(d) => return Err(wrong(d.message.clone())),
            _ => return Err(wrong("it ended early".into())),
        }
        let material = run.interp.host.builder.definitions.materials.get(TAG).cloned();
        Ok(Slot::new(material.ok_or_else(|| wrong("it made no law".into()))?, TAG, 0))
    }
}
