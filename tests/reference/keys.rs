//! The page of all keys of an isolation study, from the declarations of its file.

use std::fs;
use std::path::{Path, PathBuf};

/// Tables of the file: heading, source in `crates/design/src`, structure.
const TABLES: [(&str, &str, &str); 12] = [
    ("Top of the file", "isolate/study_file.rs", "StudyFile"),
    ("`[[bearing]]`", "isolate/study_file.rs", "BearingEntry"),
    ("`lower` and `upper` of a bearing", "isolate/study_file.rs", "Causes"),
    ("`[[floor]]`", "isolate/study_file.rs", "FloorEntry"),
    ("`[live]`", "isolate/study_file.rs", "LiveLoad"),
    ("`[[motion]]`", "motion/entry.rs", "MotionEntry"),
    ("`[intensity]`", "performance.rs", "Intensity"),
    ("`[ida]`", "performance.rs", "Hunt"),
    ("`[stripes]`", "performance.rs", "Stripes"),
    ("`[collapse]`", "performance.rs", "Collapse"),
    ("`[[limit_state]]`", "performance.rs", "LimitState"),
    ("Values of `transition`", "isolate/study_file.rs", "Transition"),
];

/// Path of the page.
pub fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/reference/isolation-keys.md")
}

/// Word for a type of Rust.
fn word(kind: &str) -> &str {
    match kind {
        "String" => "text",
        "f64" => "number",
        "i64" | "usize" => "whole number",
        "bool" => "`true` or `false`",
        "[f64; 2]" => "two numbers",
        "[String; 2]" => "two texts",
        "Vec<String>" => "texts",
        "Vec<i64>" => "whole numbers",
        "Vec<f64>" => "numbers",
        "Vec<[f64; 2]>" => "pairs of numbers",
        "Transition" | "Structure" => "word",
        _ if kind.starts_with("Vec<") => "tables",
        _ => "table",
    }
}

/// Type inside an option or a value with its place.
fn inner(kind: &str) -> (&str, bool) {
    let optional = kind.strip_prefix("Option<").and_then(|k| k.strip_suffix('>'));
    let kind = optional.unwrap_or(kind);
    (kind.strip_prefix("Spanned<").and_then(|k| k.strip_suffix('>')).unwrap_or(kind), optional.is_some())
}

/// Rows of a structure: key, type, need and meaning. A key without a meaning is put into `blank`.
fn rows(source: &str, name: &str, blank: &mut Vec<String>) -> Vec<[String; 4]> {
    let (head, body) = ["struct", "enum"]
        .iter()
        .find_map(|what| source.split_once(&format!("{what} {name} {{\n")))
        .unwrap_or_else(|| panic!("{name} is not declared"));
    let body = body.split_once("\n}").unwrap().0;
    // A structure with a default of its own needs none of its keys.
    let attributes = head.rsplit("\n\n").next().unwrap_or_default();
    let all_optional = attributes.contains("deny_unknown_fields, default");
    let (mut out, mut meaning, mut optional) = (vec![], String::new(), all_optional);
    for line in body.lines().map(str::trim) {
        if let Some(text) = line.strip_prefix("///") {
            meaning += text;
        } else if line.starts_with("#[serde(default") {
            optional = true;
        } else if !line.starts_with("#[") && line.ends_with(',') {
            let line = line.trim_end_matches(',');
            let field = line.split(") ").last().unwrap_or(line).trim_start_matches("pub ");
            let (key, kind) = field.split_once(": ").unwrap_or((field, ""));
            let (kind, is_option) = inner(kind);
            if meaning.is_empty() {
                blank.push(format!("{name}: {key}"));
            }
            let need = if kind.is_empty() || is_option || optional { "" } else { "yes" };
            let shown = if kind.is_empty() { "word" } else { word(kind) };
            let key = if kind.is_empty() { key.to_lowercase() } else { key.to_owned() };
            out.push([key, shown.to_owned(), need.to_owned(), meaning.trim().to_owned()]);
            (meaning, optional) = (String::new(), all_optional);
        }
    }
    out
}

/// The page, and the keys that have no meaning.
pub fn text() -> (String, Vec<String>) {
    let mut blank = vec![];
    let mut out = String::from(
        "# Keys of an isolation study\n\nThis page is generated from the declarations in `crates/design/src`; `HYSTERON_WRITE=1 cargo test --test \
         reference` renews it. [Design of isolated structures](isolation.md) says how the commands use them. Lengths, forces and masses are in the units of \
         the script.\n",
    );
    for (heading, file, name) in TABLES {
        let source =
            fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/design/src").join(file)).unwrap();
        out += &format!("\n## {heading}\n\n| key | value | needed | meaning |\n| --- | --- | --- | --- |\n");
        for [key, kind, need, meaning] in rows(&source, name, &mut blank) {
            out += &format!("| `{key}` | {kind} | {need} | {} |\n", meaning.replace('|', "\\|"));
        }
    }
    (out, blank)
}
