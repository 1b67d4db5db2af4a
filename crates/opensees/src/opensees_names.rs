//! Names of OpenSees that are not known here: a script that uses one is right, and its message says so.

/// Families and their names, a line each.
const NAMES: &str = include_str!("opensees_names.txt");

/// Label of a message about a name of OpenSees.
const LABEL: &str = "OpenSees has it, hysteron does not yet";

/// Returns true if OpenSees has a kind or a command of this name.
fn has(family: &str, name: &str) -> bool {
    let of = NAMES.lines().find_map(|line| line.strip_prefix(family)?.strip_prefix(':'));
    of.is_some_and(|names| names.split(' ').any(|n| n == name))
}

/// Returns true if OpenSees has a kind of a command that is not known here.
pub fn has_kind(command: &str, name: &str) -> bool {
    has(command, name)
}

/// Returns true if OpenSees, or its module for Python, has a command that is not known here.
pub fn has_command(name: &str) -> bool {
    has("command", name) || has("python", name)
}

/// The label for a kind of a family, named by its command, that OpenSees alone has.
pub(crate) fn kind_label(command: &str, name: &str) -> Option<&'static str> {
    has(command, name).then_some(LABEL)
}

/// The label for a command that OpenSees alone has.
pub(crate) fn command_label(name: &str) -> Option<&'static str> {
    has("command", name).then_some(LABEL)
}

#[cfg(test)]
mod tests {
    #[test]
    fn names_of_opensees_are_told_from_mistakes() {
        assert!(super::kind_label("uniaxialMaterial", "Masonryt").is_some());
        assert!(super::kind_label("uniaxialMaterial", "Concrete").is_none());
        assert!(super::kind_label("section", "Masonryt").is_none());
        assert!(super::has_command("findCurvatures") && !super::has_command("node"));
        assert!(super::command_label("ShallowFoundationGen").is_some() && super::command_label("analyse").is_none());
    }

    /// A row tells that OpenSees does not have it, as that of a command of an amendment and that of a law of rubber do.
    #[test]
    fn own_names_stand_in_their_rows() {
        let own = |name: &str| crate::own_commands().chain(crate::own_kinds()).any(|n| n == name);
        assert!(own("amend") && own("HDR_mat") && own("HDRRheologyBearing"));
        assert!(!own("element") && !own("Steel01") && !own("HDR"));
    }

    #[test]
    fn every_name_is_missing_here() {
        let families = super::NAMES.lines().filter_map(|line| line.split_once(": "));
        for (family, names) in families.filter(|(family, _)| !matches!(*family, "command" | "python" | "parameter")) {
            let known: Vec<&str> = crate::kinds(family).iter().flat_map(|k| k.names.iter().copied()).collect();
            let both: Vec<&str> = names.split(' ').filter(|n| known.contains(n)).collect();
            assert!(!known.is_empty() && both.is_empty(), "{both:?}");
        }
    }
}
