//! Usages and help in Python's notation: `node $tag $x` becomes `node(tag, x)`.

/// A line of help in Python's notation.
pub fn help_in_python(help: &str) -> String {
    if let Some(usage) = help.strip_prefix("usage: ") {
        return format!("usage: {}", usage_in_python(usage));
    }
    let Some((before, after)) = help.split_once("\"hysteron commands ") else { return help.to_owned() };
    let Some((name, rest)) = after.split_once('"') else { return help.to_owned() };
    format!("{before}hysteron.commands('{name}'){rest}")
}

/// A usage of a command in Python's notation: `node $tag $x` becomes `node(tag, x)`.
pub fn usage_in_python(usage: &str) -> String {
    // What a command gives may be told behind its call, or by a call around it: `lassign [motionFile $series] dt: a series`.
    let call = usage.split_once(": ").map_or(usage, |(call, _)| call);
    let call = call.strip_prefix("lassign [").and_then(|c| c.split_once(']')).map_or(call, |(inner, _)| inner);
    call.split(" or ").map(call_in_python).collect::<Vec<_>>().join(" or ")
}

fn call_in_python(usage: &str) -> String {
    let Some((name, rest)) = usage.split_once(' ') else {
        return if usage.starts_with('$') { word_in_python(usage) } else { format!("{usage}()") };
    };
    let is_name = |w: &str| w.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    // A body in braces is made of calls of their own in Python.
    let rest = rest.split('{').next().unwrap_or_default().trim_end();
    let (head, tail) = if is_name(name) { (Some(name), rest) } else { (None, usage) };
    let (mut out, mut in_remark) = (String::new(), false);
    for word in tail.split(' ').filter(|w| !w.is_empty()) {
        in_remark |= word.starts_with('(');
        if in_remark {
            out.push(' ');
            out.push_str(word);
            in_remark = !word.contains(')');
            continue;
        }
        let glued = out.is_empty() || out.ends_with("| ") || matches!(word, "|" | "or");
        out.push_str(match (glued, out.ends_with(' ') || out.is_empty()) {
            (true, true) => "",
            (true, false) => " ",
            (false, _) => ", ",
        });
        match word {
            "|" | "or" => out.push_str("| "),
            _ => out.push_str(&word_in_python(word)),
        }
    }
    match head {
        Some(head) => format!("{head}({})", out.trim_end()),
        None => out.trim_end().to_owned(),
    }
}

fn word_in_python(word: &str) -> String {
    let core = word.trim_start_matches('<').trim_end_matches(['>', '.']);
    let Some(at) = word.find(core).filter(|_| !core.is_empty()) else { return word.to_owned() };
    let (before, after) = (&word[..at], &word[at + core.len()..]);
    let part = |p: &str| match p.strip_prefix('$') {
        Some(name) => name.to_owned(),
        None => format!("'{p}'"),
    };
    format!("{before}{}{after}", core.split('|').map(part).collect::<Vec<_>>().join("|"))
}

#[cfg(test)]
mod tests {
    use super::usage_in_python;

    #[test]
    fn usages_are_written_as_calls() {
        assert_eq!(usage_in_python("nodeDisp $node <$dof>"), "nodeDisp(node, <dof>)");
        assert_eq!(
            usage_in_python("section Fiber $tag <-GJ $GJ | -torsion $material> <-noCentroid> {fibers}"),
            "section('Fiber', tag, <'-GJ', GJ | '-torsion', material>, <'-noCentroid'>)"
        );
        assert_eq!(usage_in_python("getTime"), "getTime()");
        assert_eq!(usage_in_python("fix $node $flag (1 held, 0 free)"), "fix(node, flag (1 held, 0 free))");
        let lassign = "lassign [motionFile $series $file <-dt $dt>] dt npts: a measured file, or a series";
        assert_eq!(usage_in_python(lassign), "motionFile(series, file, <'-dt', dt>)");
    }
}
