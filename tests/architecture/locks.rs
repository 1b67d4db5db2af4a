//! The workspaces beside this one have locks of their own, which their builds hold to: they follow the crates here.

use std::fs;
use std::path::Path;

/// Names in the part of a Cargo.toml that a build of the crate needs.
fn needed(manifest: &str) -> Vec<&str> {
    let part = manifest.split("\n[").find_map(|part| part.strip_prefix("dependencies]\n"));
    part.into_iter()
        .flat_map(str::lines)
        .filter_map(|l| l.split(['.', ' ', '=']).next())
        .filter(|n| !n.is_empty())
        .collect()
}

#[test]
fn locks_of_the_other_workspaces_follow_the_crates() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut crates, mut wrong) = (0, vec![]);
    for lock in ["bindings/python/Cargo.lock", "fuzz/Cargo.lock"] {
        let text = fs::read_to_string(root.join(lock)).unwrap_or_default().replace("\r\n", "\n");
        for package in text.split("[[package]]\n").filter(|p| !p.contains("\nsource = ")) {
            let name = package.split('"').nth(1).unwrap_or_default();
            let Some(short) = name.strip_prefix("hysteron-") else { continue };
            let Ok(manifest) = fs::read_to_string(root.join("crates").join(short).join("Cargo.toml")) else { continue };
            crates += 1;
            let has = |n: &str| package.contains(&format!("\n \"{n}\"")) || package.contains(&format!("\n \"{n} "));
            let missing = needed(&manifest).into_iter().filter(|n| !n.starts_with('#') && !has(n));
            wrong.extend(missing.map(|n| format!("{lock}: {name} has no {n}")));
        }
    }
    assert!(crates > 10, "the locks name {crates} crates");
    assert!(wrong.is_empty(), "cargo update --workspace in that folder: {wrong:?}");
}

#[test]
fn a_dependency_is_read_from_a_manifest() {
    let manifest = "[package]\nname = \"a\"\n\n[dependencies]\nb.workspace = true\nc = { version = \"1\" }\n\n[dev-dependencies]\nd = \"1\"\n";
    assert_eq!(needed(manifest), ["b", "c"]);
}
