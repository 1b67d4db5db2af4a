//! Backslash sequences.

/// The backslash sequence at `at`: its length in bytes and what it stands for.
pub(crate) fn backslash(text: &str, at: usize) -> (usize, char) {
    let bytes = text.as_bytes();
    let Some(next) = text.get(at + 1..).and_then(|t| t.chars().next()) else { return (1, '\\') };
    let number = |from: usize, most: usize, base: u32, limit: u32| {
        let mut value = 0;
        let mut length = 0;
        while length < most
            && let Some(digit) = bytes.get(from + length).and_then(|b| (*b as char).to_digit(base))
            && value * base + digit <= limit
        {
            value = value * base + digit;
            length += 1;
        }
        (length, char::from_u32(value).unwrap_or(char::REPLACEMENT_CHARACTER))
    };
    let hex = |most| match number(at + 2, most, 16, 0x10_ffff) {
        (0, _) => (2, next),
        (length, c) => (2 + length, c),
    };
    match next {
        'a' => (2, '\u{7}'),
        'b' => (2, '\u{8}'),
        'f' => (2, '\u{c}'),
        'n' => (2, '\n'),
        'r' => (2, '\r'),
        't' => (2, '\t'),
        'v' => (2, '\u{b}'),
        'x' => hex(2),
        'u' => hex(4),
        'U' => hex(8),
        '0'..='7' => {
            let (length, c) = number(at + 1, 3, 8, 0xff);
            (1 + length, c)
        }
        '\n' => {
            let blanks = bytes[at + 2..].iter().take_while(|b| matches!(b, b' ' | b'\t')).count();
            (2 + blanks, ' ')
        }
        c => (1 + c.len_utf8(), c),
    }
}

/// Replace every backslash sequence.
pub(crate) fn unescape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        let (length, c) = backslash(rest, at);
        out.push(c);
        rest = &rest[at + length..];
    }
    out.push_str(rest);
    out
}
