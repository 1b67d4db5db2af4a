//! Scripts in another language than Tcl, recognised before they run.

use hysteron_tcl::ForeignScript;

/// Recognises a script in Python by its name, or by a line that imports a module.
pub(crate) fn recognize(name: &str, text: &str) -> Option<ForeignScript> {
    let mut start = 0;
    let mut lines = text.split_inclusive('\n').map(|line| {
        let at = start;
        start += line.len();
        (at, line.trim_end())
    });
    let import = lines.find(|(_, line)| imports_module(line));
    let has_its_name =
        || name.to_ascii_lowercase().ends_with(".py").then_some((0, text.lines().next().unwrap_or_default()));
    let (at, line) = import.or_else(has_its_name)?;
    let help = format!(
        "\"python {name}\" runs it, with \"import hysteron.opensees as ops\" in the place of openseespy; \"hysteron run\" takes Tcl"
    );
    Some(ForeignScript { language: "Python", place: at..at + line.len(), help })
}

/// Returns true for `import a.b as c` and `from a.b import c`. No command of Tcl or OpenSees is called so.
fn imports_module(line: &str) -> bool {
    let mut words = line.split_whitespace();
    let is_module = |w: &str| !w.is_empty() && w.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | ','));
    match [words.next(), words.next(), words.next(), words.next()] {
        [Some("from"), Some(module), Some("import"), Some(_)] => is_module(module),
        [Some("import"), Some(module), None | Some("as"), _] => is_module(module),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::recognize;

    #[test]
    fn python_is_recognized_by_its_imports_or_its_name() {
        for text in ["# frame\nimport openseespy.opensees as ops\nops.wipe()\n", "from openseespy.opensees import *\n"]
        {
            let found = recognize("frame.txt", text).expect("a script in Python");
            assert!(text[found.place].contains("openseespy"), "{text}");
        }
        assert!(recognize("frame.py", "ops.wipe()\n").is_some());
        for tcl in ["namespace import ::a::*\n", "set x {import a}\n", "# import a\nmodel basic -ndm 1\n"] {
            assert_eq!(recognize("frame.tcl", tcl), None);
        }
    }
}
