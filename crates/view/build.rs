//! Takes plotly.js out of the crate `plotly` and packs it, for the pages to carry.

use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let scripts = plotly::Plot::offline_js_sources();
    // The first script is plotly.js, the second typesets formulas, which the pages do not have.
    let script = scripts.split_once('>').and_then(|(_, rest)| rest.split_once("</script>"));
    let (library, _) = script.expect("the crate plotly begins with the script plotly.js");
    assert!(library.contains("plotly.js v"), "the first script of the crate plotly is not plotly.js");
    let packed = miniz_oxide::deflate::compress_to_vec_zlib(library.as_bytes(), 9);
    let folder = std::env::var_os("OUT_DIR").expect("cargo gives a folder");
    std::fs::write(Path::new(&folder).join("plotly.min.js.zlib"), packed).expect("the folder can be written");
}
