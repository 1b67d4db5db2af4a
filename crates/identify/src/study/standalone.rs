//! A script of a study that runs by itself: it finds its files from any folder, and has values for its variables.

use super::run::Role;
use super::script_simulator::{ScriptSimulator, tcl_value};
use hysteron_tcl::Value;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Component, Path, PathBuf};

/// First and last line of a head.
const OPEN: &str = "# ---- added by hysteron: the script runs by itself ----";
const CLOSE: &str = "# ---- end of what was added ----";

/// Procedures that find a file by its name, and replace names among the words of a command.
const FIND: &str = r"    proc hysteron_found {name} {
        set there [file join $::hysteron_folder $name]
        expr {![file exists $name] && [file exists $there] ? $there : $name}
    }
";

/// A command that reads files: its name, and the Tcl commands that make it look in the folder of the study.
struct Reader {
    name: &'static str,
    wrapper: &'static str,
}

/// Commands of scripts that read files. Only those that a script contains are wrapped.
const READERS: [Reader; 7] = [
    Reader {
        name: "source",
        wrapper: "    proc source {args} {
        uplevel 1 [concat [list hysteron_source] [lrange $args 0 end-1] [list [hysteron_found [lindex $args end]]]]
    }\n",
    },
    Reader {
        name: "open",
        // A file that is written belongs to the current folder.
        wrapper: "    proc open {name {mode r} args} {
        if {[string match r* $mode] || [lindex $mode 0] eq {RDONLY}} {set name [hysteron_found $name]}
        uplevel 1 [list hysteron_open $name $mode] $args
    }\n",
    },
    Reader {
        name: "file",
        wrapper: "    proc file {question args} {
        if {$question in {exists readable isfile size}} {set args [list [hysteron_found [lindex $args 0]]]}
        uplevel 1 [concat [list hysteron_file $question] $args]
    }\n",
    },
    Reader {
        name: "motionFile",
        wrapper: "    proc motionFile {args} {
        uplevel 1 [linsert [lreplace $args 1 1 [hysteron_found [lindex $args 1]]] 0 hysteron_motionFile]
    }\n",
    },
    Reader { name: "timeSeries", wrapper: "" },
    Reader { name: "pattern", wrapper: "" },
    Reader { name: "groundMotion", wrapper: "" },
];

/// Procedure for commands whose words include those of a time series, which may be one word.
const FIND_IN_WORDS: &str = r#"    proc hysteron_words {words} {
        set found {}
        foreach word $words {
            if {[lindex $found end] in {-filePath -fileTime}} {
                set word [hysteron_found $word]
            } elseif {[regexp {^(Series|Path) .*-file} $word]} {
                set word [hysteron_words $word]
            }
            lappend found $word
        }
        return $found
    }
"#;

/// A script of a study with a marked head by which it runs from any folder.
///
/// Relative names of files that it reads are looked up in the current folder, then in that of the study. Where no
/// variable of the study's `set` tables is set, those of the first fitted run are. `folder` is that of the written
/// script; both folders must exist.
pub fn standalone_script(simulator: &ScriptSimulator, folder: &Path, text: &str) -> String {
    let head = file_head(simulator, folder, text) + &variable_head(simulator);
    if head.is_empty() { text.to_owned() } else { format!("{OPEN}\n{head}{CLOSE}\n{text}") }
}

/// Commands that find files; empty if the script reads none, or lies in the folder of the study.
fn file_head(simulator: &ScriptSimulator, folder: &Path, text: &str) -> String {
    let study = simulator.study();
    let model = study.absolute(&study.model);
    let read: Vec<(String, String)> = simulator.files_read().into_iter().filter(|(path, _)| *path != model).collect();
    let (Ok(from), Ok(to)) = (folder.canonicalize(), study.folder.canonicalize()) else { return String::new() };
    if read.is_empty() || from == to {
        return String::new();
    }
    let scripts = read.iter().filter(|(path, _)| path.ends_with(".tcl")).map(|(_, text)| text.as_str());
    let texts: Vec<&str> = std::iter::once(text).chain(scripts).collect();
    let readers: Vec<&Reader> = READERS.iter().filter(|r| texts.iter().any(|text| mentions(text, r.name))).collect();
    // Its own wrapper would call the procedure that it is called by.
    let find =
        if readers.iter().any(|r| r.name == "file") { FIND.replace("[file ", "[hysteron_file ") } else { FIND.into() };
    let way = Value::from(way(&from, &to).to_string_lossy().replace('\\', "/").as_str());
    let mut head = format!(
        "# A relative name of a file that is not in the current folder is looked up in the folder of the study.\n\
         if {{[info procs hysteron_found] eq {{}}}} {{\n    \
         set hysteron_folder [file normalize [file join [file dirname [info script]] {}]]\n{find}",
        Value::list([way]).as_str()
    );
    if readers.iter().any(|r| r.wrapper.is_empty()) {
        head += FIND_IN_WORDS;
    }
    for Reader { name, wrapper } in readers {
        let _ = writeln!(head, "    rename {name} hysteron_{name}");
        if wrapper.is_empty() {
            let _ = writeln!(
                head,
                "    proc {name} {{args}} {{\n        uplevel 1 [linsert [hysteron_words $args] 0 hysteron_{name}]\n    }}"
            );
        }
        head += wrapper;
    }
    head + "}\n"
}

/// Commands that set the variables of the first fitted run where none of any run is set.
fn variable_head(simulator: &ScriptSimulator) -> String {
    let study = simulator.study();
    let Some((_, first)) = study.runs_of(Role::Fit).next().filter(|(_, run)| !run.set.is_empty()) else {
        return String::new();
    };
    let names: BTreeSet<&str> = study.runs.iter().flat_map(|r| &r.set).map(|(name, _)| name.as_str()).collect();
    let quoted = |word: &str| Value::list([Value::from(word)]).as_str().into_owned();
    let known: Vec<String> = names.iter().map(|name| format!("[info exists {}]", quoted(name))).collect();
    let mut head =
        format!("# Variables of the run {}, where none is set.\nif {{!({})}} {{\n", first.name, known.join(" || "));
    for (name, value) in &first.set {
        let command = Value::list([Value::from("set"), Value::from(name.as_str()), tcl_value(value)]);
        let _ = writeln!(head, "    {}", command.as_str());
    }
    head + "}\n"
}

/// Returns true if a text contains a word where a command may begin.
fn mentions(text: &str, word: &str) -> bool {
    text.match_indices(word).any(|(at, _)| {
        let (before, after) = (text[..at].trim_end_matches([' ', '\t']), &text[at + word.len()..]);
        (before.is_empty() || before.ends_with(['\n', '[', '{', ';', '"'])) && after.starts_with([' ', '\t'])
    })
}

/// Relative path between two absolute folders; the second itself where they share no root.
fn way(from: &Path, to: &Path) -> PathBuf {
    let (from, to_parts): (Vec<Component<'_>>, Vec<Component<'_>>) =
        (from.components().collect(), to.components().collect());
    let shared = from.iter().zip(&to_parts).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return to.to_owned();
    }
    let up = from[shared..].iter().map(|_| Component::ParentDir);
    let way: PathBuf = up.chain(to_parts[shared..].iter().copied()).collect();
    if way.as_os_str().is_empty() { PathBuf::from(".") } else { way }
}

#[cfg(test)]
mod tests {
    use super::{mentions, way};
    use std::path::Path;

    #[test]
    fn the_way_between_folders_is_relative() {
        let between = |a: &str, b: &str| way(Path::new(a), Path::new(b)).display().to_string();
        assert_eq!(between("/study/results", "/study"), "..");
        assert_eq!(between("/out/pad", "/study"), "../../study");
        assert_eq!(between("/study", "/study/model"), "model");
    }

    #[test]
    fn a_command_begins_a_line_or_a_bracket() {
        assert!(mentions("set f [open $name r]", "open") && mentions("open x", "open"));
        assert!(!mentions("set open 1; reopen x; # to open it", "open") && !mentions("recorder -file x", "file"));
    }
}
