//! The command that is being written before the cursor, which need not be complete.

/// The words of a command up to the cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct LineBefore<'a> {
    /// Whole words.
    pub(crate) words: Vec<&'a str>,
    /// The word at the cursor up to there; empty after a blank.
    pub(crate) partial: &'a str,
    /// First byte of that word.
    pub(crate) start: usize,
    /// The word stands in quotes, which are not part of it.
    pub(crate) is_quoted: bool,
}

/// Bytes before the cursor that are looked at.
const MAX_LOOK: usize = 4000;

/// The command before a byte of a text.
pub(crate) fn before(text: &str, at: usize) -> LineBefore<'_> {
    let mut from = at.saturating_sub(MAX_LOOK);
    while !text.is_char_boundary(from) {
        from += 1;
    }
    let within = text.get(from..at).unwrap_or_default();
    // Lines that end with a backslash go on.
    let mut begin = within.len();
    for (i, line) in within.rsplit('\n').enumerate() {
        if i > 0 && !line.ends_with('\\') {
            break;
        }
        begin -= line.len() + usize::from(i > 0);
    }
    let line = &within[begin..];
    // Brackets and braces begin commands of their own; what is closed again belongs to the command around it.
    let (mut starts, mut quoted) = (vec![0_usize], false);
    let mut bytes = line.bytes().enumerate();
    while let Some((i, b)) = bytes.next() {
        match b {
            b'\\' => drop(bytes.next()),
            b'"' => quoted = !quoted,
            b'[' | b'{' if !quoted || b == b'[' => starts.push(i + 1),
            b']' | b'}' if starts.len() > 1 => drop(starts.pop()),
            b';' if !quoted => {
                if let Some(last) = starts.last_mut() {
                    *last = i + 1;
                }
            }
            _ => {}
        }
    }
    let command = starts.last().map_or("", |s| line.get(*s..).unwrap_or_default());
    let mut words: Vec<&str> = command.split_whitespace().filter(|w| *w != "\\").collect();
    let is_open = command.chars().next_back().is_some_and(|c| !c.is_whitespace());
    let partial = if is_open { words.pop().unwrap_or_default() } else { "" };
    LineBefore { words, partial, start: at - partial.len(), is_quoted: false }
}

#[cfg(test)]
mod tests {
    use super::before;

    fn parts(text: &str) -> (Vec<&str>, &str) {
        let line = before(text, text.len());
        (line.words, line.partial)
    }

    #[test]
    fn the_innermost_command_is_found() {
        assert_eq!(parts("node 1 0\nelement tru"), (vec!["element"], "tru"));
        assert_eq!(parts("pattern Plain 1 1 { load 2 "), (vec!["load", "2"], ""));
        assert_eq!(parts("set a [expr 1]; fix $"), (vec!["fix"], "$"));
        assert_eq!(parts("set x [nodeDisp 3"), (vec!["nodeDisp"], "3"));
        assert_eq!(parts("element truss 1 \\\n  2 3 "), (vec!["element", "truss", "1", "2", "3"], ""));
        assert_eq!(parts("a b\n"), (vec![], ""));
        assert_eq!(parts(""), (vec![], ""));
    }
}
