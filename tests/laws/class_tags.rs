//! Numbers of the classes of elements.

use super::every_kind::{ELEMENTS, script};
use super::script::run;
use super::shapes::{element_words, nodes};

/// Programs that draw models ask for the number of the class. Only elements that OpenSees lacks have none.
#[test]
fn every_element_has_the_class_tag_of_opensees() {
    for &(ndm, ndf, shape, words) in ELEMENTS {
        let places = nodes(ndm, shape);
        let made = element_words(words, places.len());
        let asks = "puts [getEleClassTags 1]";
        let ran = run(&format!("{}{made}{asks}\n", script(ndm, ndf, &places))).done();
        assert!(ran.numbers()[0] > 0.0, "{words}: {}", ran.out);
    }
}
