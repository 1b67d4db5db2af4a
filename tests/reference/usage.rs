//! The usage string of a command, taken apart: `name $a <$b> <-option $c> | $d ...`.

/// A part of a usage string.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MatrixMask {
    /// A word that stands as it is: `-mat`, `beam|bar`, `{fibers}`.
    Word(String),
    /// An argument, without its dollar.
    Argument(String),
    /// `<...>`: parts that may be left out.
    Optional(Vec<MatrixMask>),
    /// `...`: what comes before may be repeated.
    Repeated,
    /// `|` or `or`: what follows is another form.
    Either,
}

/// The command within a usage string such as `lassign [motionFile ...] dt npts`.
pub fn command(usage: &str) -> &str {
    usage.split_once('[').map_or(usage, |(_, inner)| inner.split(']').next().unwrap_or(inner))
}

/// Parts of a usage string, without the name of the command. Notes in parentheses and after a colon are left out.
pub fn parse(usage: &str) -> Vec<MatrixMask> {
    let usage = command(usage.split(": ").next().unwrap_or(usage));
    let mut words = tokens(usage).into_iter().skip(1);
    group(&mut words)
}

/// Words of a usage string; `<` and `>` are words of their own.
fn tokens(usage: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    let (mut depth, mut note) = (0, false);
    for c in usage.chars() {
        match c {
            '(' => note = true,
            ')' => note = false,
            _ if note => {}
            '{' => {
                depth += 1;
                push(&mut out, c);
            }
            '}' => {
                depth -= 1;
                push(&mut out, c);
            }
            _ if depth > 0 => push(&mut out, c),
            '<' | '>' => out.extend([c.to_string(), String::new()]),
            ',' => {}
            c if c.is_whitespace() => out.push(String::new()),
            c => push(&mut out, c),
        }
    }
    out.retain(|w| !w.is_empty());
    out
}

fn push(out: &mut [String], c: char) {
    if let Some(last) = out.last_mut() {
        last.push(c);
    }
}

fn group(words: &mut impl Iterator<Item = String>) -> Vec<MatrixMask> {
    let mut out = vec![];
    while let Some(word) = words.next() {
        match word.as_str() {
            ">" => break,
            "<" => out.push(MatrixMask::Optional(group(words))),
            "|" | "or" => out.push(MatrixMask::Either),
            "..." => out.push(MatrixMask::Repeated),
            _ => match word.strip_prefix('$') {
                Some(name) => alternatives(name, &mut out),
                None => out.push(MatrixMask::Word(word)),
            },
        }
    }
    out
}

/// `$a|$b` and `$section|-sections` are two forms each.
fn alternatives(word: &str, out: &mut Vec<MatrixMask>) {
    for (i, part) in word.split('|').enumerate() {
        if i > 0 {
            out.push(MatrixMask::Either);
        }
        let name = part.trim_start_matches('$').to_owned();
        out.push(if part.starts_with('-') { MatrixMask::Word(name) } else { MatrixMask::Argument(name) });
    }
}

/// An argument or option as a row of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// As the usage has it: `$E`, `-mass $m`, `-cMass`.
    pub shown: String,
    /// The option that it follows, or that it is; empty for arguments by position.
    pub option: String,
    /// Names of its arguments; none for an option without.
    pub arguments: Vec<String>,
    /// True if it may be left out.
    pub optional: bool,
}

/// The arguments and options of a usage, each once, in their order.
pub fn rows(parts: &[MatrixMask]) -> Vec<Row> {
    let mut out = vec![];
    collect(parts, false, &mut out);
    let mut seen: Vec<(String, Vec<String>)> = vec![];
    out.retain(|r| {
        let key = (r.option.clone(), r.arguments.clone());
        let new = !seen.contains(&key);
        seen.push(key);
        new
    });
    out
}

fn collect(parts: &[MatrixMask], optional: bool, out: &mut Vec<Row>) {
    // The option whose arguments are being taken: they are part of its row.
    let mut option: Option<usize> = None;
    for part in parts {
        match part {
            MatrixMask::Word(word) if word.starts_with('-') => {
                for name in word.split('|') {
                    let row = Row { shown: name.into(), option: name.into(), arguments: vec![], optional };
                    option = Some(out.len());
                    out.push(row);
                }
            }
            MatrixMask::Word(word) => {
                if let Some(row) = option.take().map(|i| &mut out[i])
                    && row.arguments.is_empty()
                {
                    row.shown += &format!(" {word}");
                }
            }
            MatrixMask::Argument(name) => match option {
                Some(i) => {
                    out[i].shown += &format!(" ${name}");
                    out[i].arguments.push(name.clone());
                }
                None => out.push(Row {
                    shown: format!("${name}"),
                    option: String::new(),
                    arguments: vec![name.clone()],
                    optional,
                }),
            },
            MatrixMask::Optional(inner) => {
                let opens = inner.iter().any(|p| matches!(p, MatrixMask::Word(w) if w.starts_with('-')));
                match option {
                    Some(i) if !opens => {
                        let mut more = vec![];
                        collect(inner, true, &mut more);
                        for row in more {
                            out[i].shown += &format!(" <{}>", row.shown);
                            out[i].arguments.extend(row.arguments);
                        }
                    }
                    _ => collect(inner, true, out),
                }
            }
            MatrixMask::Repeated => {
                if let Some(row) = out.last_mut() {
                    row.shown += " ...";
                }
            }
            MatrixMask::Either => option = None,
        }
    }
}
