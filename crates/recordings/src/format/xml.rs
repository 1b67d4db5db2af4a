//! Tags and texts of XML, as far as workbooks have them.

/// A piece of XML.
#[derive(Debug, PartialEq)]
pub(super) enum Piece<'a> {
    /// A tag that opens: its name without prefix, its attributes, and whether it closes itself.
    Open(&'a str, &'a str, bool),
    /// A tag that closes.
    Close(&'a str),
    /// Text between tags, not yet unescaped.
    Text(&'a str),
}

/// The pieces of a text.
pub(super) struct Pieces<'a>(pub(super) &'a str);

fn local(name: &str) -> &str {
    name.rsplit_once(':').map_or(name, |(_, n)| n)
}

impl<'a> Iterator for Pieces<'a> {
    type Item = Piece<'a>;

    fn next(&mut self) -> Option<Piece<'a>> {
        loop {
            let text = self.0;
            if text.is_empty() {
                return None;
            }
            let Some(rest) = text.strip_prefix('<') else {
                let end = text.find('<').unwrap_or(text.len());
                self.0 = &text[end..];
                return Some(Piece::Text(&text[..end]));
            };
            if rest.starts_with(['?', '!']) {
                let end = if rest.starts_with("!--") {
                    rest.find("-->").map(|i| i + 3)
                } else {
                    rest.find('>').map(|i| i + 1)
                };
                self.0 = &rest[end.unwrap_or(rest.len())..];
                continue;
            }
            let end = rest.find('>')?;
            let tag = &rest[..end];
            self.0 = &rest[end + 1..];
            if let Some(name) = tag.strip_prefix('/') {
                return Some(Piece::Close(local(name.trim())));
            }
            let (tag, closed) = tag.strip_suffix('/').map_or((tag, false), |t| (t, true));
            let (name, attributes) = tag.split_once(char::is_whitespace).unwrap_or((tag, ""));
            return Some(Piece::Open(local(name), attributes, closed));
        }
    }
}

/// The value of an attribute by its name without prefix.
pub(super) fn attribute<'a>(attributes: &'a str, name: &str) -> Option<&'a str> {
    let mut rest = attributes;
    while let Some((key, after)) = rest.split_once('=') {
        let quote = after.trim_start().chars().next().filter(|c| matches!(c, '"' | '\''))?;
        let (value, more) = after.trim_start()[1..].split_once(quote)?;
        if local(key.trim()) == name {
            return Some(value);
        }
        rest = more;
    }
    None
}

/// A text with its entities replaced.
pub(super) fn unescaped(text: &str) -> String {
    if !text.contains('&') {
        return text.to_owned();
    }
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('&') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let end = rest.find(';').filter(|e| *e < 12);
        let entity = end.map(|e| &rest[1..e]);
        let code = |digits: &str, radix| u32::from_str_radix(digits, radix).ok().and_then(char::from_u32);
        let c = match entity {
            Some("amp") => Some('&'),
            Some("lt") => Some('<'),
            Some("gt") => Some('>'),
            Some("quot") => Some('"'),
            Some("apos") => Some('\''),
            Some(e) => {
                e.strip_prefix("#x").and_then(|d| code(d, 16)).or_else(|| e.strip_prefix('#').and_then(|d| code(d, 10)))
            }
            None => None,
        };
        match (c, end) {
            (Some(c), Some(end)) => {
                out.push(c);
                rest = &rest[end + 1..];
            }
            _ => {
                out.push('&');
                rest = &rest[1..];
            }
        }
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::{Piece, Pieces, attribute, unescaped};

    #[test]
    fn tags_and_texts() {
        let pieces: Vec<Piece<'_>> = Pieces("<?xml?><x:a r='1' t=\"s\">5 &lt; 6<b/></x:a>").collect();
        let expected = [
            Piece::Open("a", "r='1' t=\"s\"", false),
            Piece::Text("5 &lt; 6"),
            Piece::Open("b", "", true),
            Piece::Close("a"),
        ];
        assert_eq!(pieces, expected);
        assert_eq!((attribute("r='1' t=\"s\"", "t"), attribute("r='1'", "t")), (Some("s"), None));
        assert_eq!(unescaped("a &amp; &#x41;&#66; & b"), "a & AB & b");
    }
}
