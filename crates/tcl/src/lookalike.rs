//! Help about text that looks right and is not: characters of word processors and web pages, copied prompts, continued
//! lines with a blank behind the backslash.

use super::number::looks_like_bad_octal;
use crate::diagnostic::{SourceMap, Span};

/// Characters that look like others: the character, its name, and what is meant.
const CHARACTERS: [(char, &str, &str); 34] = [
    ('\u{a0}', "no-break space", " "),
    ('\u{202f}', "narrow no-break space", " "),
    ('\u{2002}', "en space", " "),
    ('\u{2003}', "em space", " "),
    ('\u{2007}', "figure space", " "),
    ('\u{2009}', "thin space", " "),
    ('\u{200a}', "hair space", " "),
    ('\u{3000}', "ideographic space", " "),
    ('\u{200b}', "zero-width space", ""),
    ('\u{200c}', "zero-width non-joiner", ""),
    ('\u{200d}', "zero-width joiner", ""),
    ('\u{200e}', "left-to-right mark", ""),
    ('\u{200f}', "right-to-left mark", ""),
    ('\u{2060}', "word joiner", ""),
    ('\u{feff}', "byte order mark", ""),
    ('\u{ad}', "soft hyphen", ""),
    ('\u{201c}', "curly quote", "\""),
    ('\u{201d}', "curly quote", "\""),
    ('\u{201e}', "low quote", "\""),
    ('\u{2018}', "curly quote", "\""),
    ('\u{2019}', "curly quote", "\""),
    ('\u{2212}', "minus sign", "-"),
    ('\u{2010}', "hyphen", "-"),
    ('\u{2011}', "no-break hyphen", "-"),
    ('\u{2013}', "en dash", "-"),
    ('\u{2014}', "em dash", "-"),
    ('\u{d7}', "multiplication sign", "*"),
    ('\u{ff0d}', "full-width minus", "-"),
    ('\u{ff08}', "full-width parenthesis", "("),
    ('\u{ff09}', "full-width parenthesis", ")"),
    ('\u{ff1b}', "full-width semicolon", ";"),
    ('\u{ff0c}', "full-width comma", ","),
    ('\u{ff04}', "full-width dollar sign", "$"),
    ('\u{2028}', "line separator", "\n"),
];

/// Characters as the source of a web page writes them.
const ENTITIES: [(&str, &str); 12] = [
    ("&lt;", "<"),
    ("&gt;", ">"),
    ("&amp;", "&"),
    ("&quot;", "\""),
    ("&apos;", "'"),
    ("&nbsp;", " "),
    ("&#91;", "["),
    ("&#93;", "]"),
    ("&#123;", "{"),
    ("&#125;", "}"),
    ("&#36;", "$"),
    ("&#39;", "'"),
];

/// Prompts of interactive sessions.
const PROMPTS: [&str; 5] = ["OpenSees >", "OpenSees>", "hysteron>", ">>>", "%"];

/// What to write for a character.
fn remedy(meant: &str) -> String {
    match meant {
        "" => "it cannot be seen: remove it".into(),
        " " => "write an ordinary blank in its place".into(),
        "\n" => "end the line in its place".into(),
        _ => format!("write {meant} in its place"),
    }
}

/// Help about a word that is not what it looks like: a number with a foreign character, or one that is octal by its zero.
///
/// ```
/// let help = hysteron_tcl::lookalike("\u{2212}4.0").unwrap();
/// assert_eq!(help, "U+2212 is a minus sign, which Tcl does not know: write - in its place");
/// assert!(hysteron_tcl::lookalike("08").unwrap().contains("octal"));
/// assert_eq!(hysteron_tcl::lookalike("-4.0"), None);
/// ```
pub fn lookalike(word: &str) -> Option<String> {
    if looks_like_bad_octal(word) {
        let digits = word.trim().trim_start_matches(['-', '+']).trim_start_matches(['0', 'o', 'O']);
        return Some(format!(
            "a number that begins with 0 is octal in Tcl, without the digits 8 and 9: write {digits}"
        ));
    }
    let of = |c: char| CHARACTERS.iter().find(|known| known.0 == c);
    let (c, name, meant) = word.chars().find_map(of)?;
    let article = if name.starts_with(['a', 'e', 'i']) { "an" } else { "a" };
    Some(format!("U+{:04X} is {article} {name}, which Tcl does not know: {}", u32::from(*c), remedy(meant)))
}

/// Help about the text around the place of a message.
pub(crate) fn around(sources: &SourceMap, span: Span) -> Vec<String> {
    let text = sources.text(span.source);
    let (start, end) = (span.start as usize, span.end as usize);
    let (Some(before), Some(shown), Some(after)) = (text.get(..start), text.get(start..end), text.get(end..)) else {
        return vec![];
    };
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    let line_end = end + after.find('\n').unwrap_or(after.len());
    let mut help = vec![];
    // A body of many lines has its own messages.
    if !shown.contains('\n') {
        help.extend(lookalike(shown));
        help.extend(entity(&text[line_start..line_end]));
        help.extend(prompt(&text[start..line_end]).filter(|_| before[line_start..].trim().is_empty()));
    }
    let last = text[..line_end].rfind('\n').map_or(0, |i| i + 1);
    let above = text[..line_start.saturating_sub(1)].rsplit('\n').next().unwrap_or_default();
    let number = |at: usize| text[..at].matches('\n').count() + 1;
    if is_broken(&text[last..line_end]) {
        help.push(continuation(number(last)));
    } else if line_start > 0 && is_broken(above) {
        help.push(continuation(number(line_start) - 1));
    }
    help
}

fn entity(line: &str) -> Option<String> {
    let (code, meant) = ENTITIES.iter().find(|(code, _)| line.contains(code))?;
    Some(format!("\"{code}\" is how a web page writes \"{meant}\": write that in its place"))
}

fn prompt(line: &str) -> Option<String> {
    let prompt = PROMPTS.iter().find(|p| line.strip_prefix(**p).is_some_and(|rest| rest.starts_with(' ')))?;
    Some(format!("\"{prompt}\" is the prompt of an interactive session: remove it"))
}

/// Returns true if a line ends in a backslash with blanks behind it, which does not continue it.
fn is_broken(line: &str) -> bool {
    let trimmed = line.trim_end();
    let backslashes = trimmed.len() - trimmed.trim_end_matches('\\').len();
    trimmed.len() < line.len() && backslashes % 2 == 1 && !line.trim_start().starts_with('#')
}

fn continuation(line: usize) -> String {
    format!("a blank follows the backslash at the end of line {line}, so that the command ends there: remove the blank")
}
