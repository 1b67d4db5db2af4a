//! Commands of a script that make devices, their materials or their friction, at any depth.

use hysteron_tcl::top_level;

/// A command with its words.
pub(super) struct DeviceCommand<'a> {
    /// First byte of the outermost command that contains it.
    pub(super) outermost: usize,
    /// Its words.
    pub(super) words: Vec<Word<'a>>,
}

/// A word as it is written, with its place in the script.
pub(super) struct Word<'a> {
    pub(super) text: &'a str,
    pub(super) start: usize,
    pub(super) end: usize,
}

/// Names of commands that make devices.
const COMMANDS: [&str; 3] = ["element", "uniaxialMaterial", "frictionModel"];
/// Depth of braces that is searched.
const MAX_DEPTH: usize = 8;

/// Commands in front of a byte of the script.
pub(super) fn device_commands(text: &str, end: usize) -> Vec<DeviceCommand<'_>> {
    let mut out = vec![];
    collect(text, 0, None, MAX_DEPTH, &mut out);
    out.retain(|c| c.words.last().is_some_and(|w| w.end <= end));
    out
}

/// Collects the commands of a text that begins at byte `from` of the script.
fn collect<'a>(text: &'a str, from: usize, outermost: Option<usize>, depth: usize, out: &mut Vec<DeviceCommand<'a>>) {
    for command in top_level(text) {
        let outermost = outermost.unwrap_or(command.start);
        let words = command.words.iter().filter_map(|(a, b)| Some((*a, *b, text.get(*a..*b)?)));
        if COMMANDS.contains(&command.name.as_str()) {
            let words = words.map(|(a, b, word)| Word { text: word, start: from + a, end: from + b });
            out.push(DeviceCommand { outermost, words: words.collect() });
            continue;
        }
        // A braced word may be the body of a procedure, a loop or a condition.
        for (start, _, word) in words.filter(|_| depth > 0) {
            let body = word.strip_prefix('{').and_then(|w| w.strip_suffix('}'));
            if let Some(body) = body.filter(|b| COMMANDS.iter().any(|name| b.contains(name))) {
                collect(body, from + start + 1, Some(outermost), depth - 1, out);
            }
        }
    }
}
