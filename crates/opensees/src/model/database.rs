//! `database`, `save` and `restore`.

use crate::args::Args;
use crate::effect::Effect;
use crate::host::Mode;
use crate::text::Arg;
use crate::{Command, Outcome, Tcl, finish};
use hysteron_engine::analysis::SavedState;
use hysteron_tcl::{Call, Exception, OpenMode, Value};
use std::io::Write as _;

const FILE_NAME: Arg = Arg::new("name", "name of the database");
const TAG: Arg = Arg::whole("tag", "tag of the state");

pub(crate) const COMMANDS: &[Command] = &[
    Command::new("database", DATABASE, database)
        .arguments(&[FILE_NAME])
        .about("Names the files of `save` and `restore`."),
    Command::new("save", SAVE, save)
        .arguments(&[TAG])
        .about("Saves the committed state, exact to the bit. The next step begins anew, as it does after `restore`.")
        .leaving(Effect::Nothing),
    Command::new("restore", RESTORE, restore)
        .arguments(&[TAG])
        .about("Goes back to a saved state of the same model, in this run or another one.")
        .leaving(Effect::ReadsState),
];

const DATABASE: &str = "database File $name";
const SAVE: &str = "save $tag";
const RESTORE: &str = "restore $tag";

fn database(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, DATABASE);
    if a.word("kind of the database")? != "File" {
        return Err(a.unknown_name("kind of database", ["File"]));
    }
    let name = a.word(FILE_NAME.meaning)?.into_owned();
    interp.host.database = Some(name);
    finish(interp, &a)?;
    Ok(Value::EMPTY)
}

/// The path of a state in the database, and its tag.
fn path(interp: &Tcl, a: &mut Args<'_>) -> Result<String, Exception> {
    let tag = a.int(TAG.meaning)?;
    match &interp.host.database {
        Some(name) => Ok(format!("{name}.{tag}.state")),
        None => Err(a.refuse("there is no database yet", "expected \"database File NAME\" before")),
    }
}

fn save(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, SAVE);
    let name = path(interp, &mut a)?;
    finish(interp, &a)?;
    let bytes = interp.host.engine.save().to_bytes();
    let (full, part) = (interp.absolute(&name), interp.absolute(&format!("{name}.part")));
    let mode = OpenMode { write: true, create: true, truncate: true, ..OpenMode::default() };
    // Complete or absent.
    let written = interp.files.open(&part, mode).and_then(|mut file| {
        file.write_all(&bytes)?;
        file.flush()
    });
    let written = written.and_then(|()| interp.files.rename(&part, &full));
    written.map_err(|e| a.refuse(format!("cannot write {name}: {e}"), "cannot save this state"))?;
    Ok(Value::EMPTY)
}

fn restore(interp: &mut Tcl, call: &Call<'_>) -> Outcome {
    let mut a = Args::new(call, RESTORE);
    let name = path(interp, &mut a)?;
    finish(interp, &a)?;
    let full = interp.absolute(&name);
    let bytes = match interp.files.read(&full) {
        // A check saves the state of no step.
        Err(_) if interp.host.mode == Mode::Check => return Ok(Value::EMPTY),
        read => read.map_err(|e| a.refuse(format!("cannot read {name}: {e}"), "expected the tag of a saved state"))?,
    };
    let refused = |why: &str| a.refuse(format!("cannot restore {name}: {why}"), "expected a state of this model");
    let saved = SavedState::from_bytes(&bytes).ok_or_else(|| refused("it is no saved state, or damaged"))?;
    interp.host.engine.restore_saved(saved).map_err(|why| refused(&why))?;
    interp.host.builder.loads_time = None;
    Ok(Value::EMPTY)
}
