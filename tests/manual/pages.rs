//! Links of the pages lead somewhere, and the summary of the book lists every page.

use super::prose::pages_below;
use super::root;
use std::fs;
use std::path::{Path, PathBuf};

/// Targets of the links of a page.
fn links(text: &str) -> Vec<String> {
    let mut in_code = false;
    let lines = text.lines().filter(|line| {
        in_code ^= line.trim_start().starts_with("```");
        !in_code
    });
    let of_line = |line: &str| -> Vec<String> {
        let plain: Vec<&str> = line.split('`').step_by(2).collect();
        plain.join("X").split("](").skip(1).filter_map(|rest| Some(rest.split_once(')')?.0.to_owned())).collect()
    };
    lines.flat_map(of_line).filter(|l| !l.contains("://") && !l.is_empty()).collect()
}

/// The anchor that a heading has on a page.
fn anchor(heading: &str) -> String {
    let kept = heading.trim_start_matches('#').trim().to_lowercase().replace(' ', "-");
    kept.chars().filter(|c| c.is_alphanumeric() || "-_".contains(*c)).collect()
}

/// What is wrong with a link of a page.
fn fault(page: &Path, link: &str) -> Option<String> {
    let (file, place) = link.split_once('#').unwrap_or((link, ""));
    let target = if file.is_empty() { page.to_owned() } else { page.parent()?.join(file) };
    if !target.exists() {
        return Some("no such file".into());
    }
    if place.is_empty() || target.extension().is_none_or(|e| e != "md") {
        return None;
    }
    let text = fs::read_to_string(&target).ok()?;
    let found = text.lines().any(|l| l.starts_with('#') && anchor(l) == place);
    (!found).then(|| "no such heading".into())
}

#[test]
fn links_lead_to_files_and_headings() {
    let mut pages = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"].map(|p| root().join(p)).to_vec();
    pages_below(&root().join("docs"), &mut pages);
    let of_page = |page: &PathBuf| -> Vec<String> {
        let text = fs::read_to_string(page).unwrap();
        let wrong = |link: String| Some(format!("{}: {link}: {}", page.display(), fault(page, &link)?));
        links(&text).into_iter().filter_map(wrong).collect()
    };
    let wrong: Vec<String> = pages.iter().flat_map(of_page).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_summary_lists_every_page() {
    let docs = root().join("docs");
    let summary = docs.join("SUMMARY.md");
    let listed: Vec<PathBuf> =
        links(&fs::read_to_string(&summary).unwrap()).iter().map(|l| docs.join(l)).chain([summary]).collect();
    let mut pages = vec![];
    pages_below(&docs, &mut pages);
    let missing: Vec<String> = pages.iter().filter(|p| !listed.contains(p)).map(|p| p.display().to_string()).collect();
    assert!(missing.is_empty(), "docs/SUMMARY.md lacks\n{}", missing.join("\n"));
}
