//! A mass that is more or less than in the model.

use super::declaration::{Dimension, Measurement, Quantity};
use super::{AddedParameter, Hypothesis, Proposal, ProposalContext};
use crate::inspect::inventory::{Mass, grouped};

/// Floors that are heavier or lighter one at a time, at most.
const MAX_FLOORS: usize = 6;
/// Mass over that of the model: range, start and further starts. A choice: stored goods and water double a floor, and an empty
/// tank halves it.
const FACTORS: [f64; 3] = [0.4, 3.0, 1.2];
const FACTOR_STARTS: [f64; 2] = [0.75, 1.6];

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "changed_mass",
    statement: "a floor is heavier or lighter than in the model: stored goods, water, snow, a part that is not built",
    refuted_by: "the floor, weighed or counted from its plans, has the mass of the model",
    look_alikes: &["foundation_flexibility", "superstructure_yielding"],
    shows: "periods that are longer or shorter than the model's at every amplitude, and another shape of the modes",
    parted_by: "`foundation_flexibility` moves all floors alike above the ground; `superstructure_yielding` is right in weak parts of a motion",
    place: "masses of a shaken model: those of one height together, up to 6 heights, and all",
    forms: "a factor on the masses",
    needs_clock: false,
    memory: &[],
    materials: &[],
    measurement: Measurement::new(
        "count the loads at {place}: stored goods, water, snow, partitions",
        "weigh what stands at {place}",
    ),
    quantities: &[Quantity::new("factor", "mass over that of the model", Dimension::Ratio)],
    propose,
};

fn propose(s: &ProposalContext<'_>) -> Vec<Proposal> {
    if !s.inventory.base_excited || s.inventory.masses.is_empty() {
        return vec![];
    }
    let axis = s.inventory.vertical_axis();
    let height = |m: &Mass| s.inventory.coordinates.get(&m.node).zip(axis).map(|(x, axis)| x[axis]);
    // Without a vertical axis each mass is a floor.
    let one_floor = |a: &Mass, b: &Mass| {
        let both = height(a).zip(height(b));
        both.is_some_and(|(a, b)| s.inventory.heights.are_equal(a, b))
    };
    let floors = grouped(&s.inventory.masses, one_floor);
    let mut out: Vec<Proposal> = vec![];
    if floors.len() > 1 {
        out.extend(floors.iter().take(MAX_FLOORS).map(|floor| with_factor(floor, "mass of a floor")));
    }
    out.push(with_factor(&s.inventory.masses.iter().collect::<Vec<_>>(), "all masses"));
    out
}

/// Some masses with a common factor.
fn with_factor(masses: &[&Mass], form: &str) -> Proposal {
    let words = |m: &Mass| {
        let one = |x: &f64| if *x == 0.0 { "0.0".to_owned() } else { format!("[expr {{$hy_factor*{x:e}}}]") };
        m.mass.iter().map(one).collect::<Vec<_>>().join(" ")
    };
    let block = masses.iter().map(|m| format!("mass {} {}", m.node, words(m))).collect();
    let [least, most, start] = FACTORS;
    let factor = AddedParameter::log("factor", least, most, start);
    let factor = AddedParameter { further_starts: FACTOR_STARTS.into(), ..factor };
    let nodes: Vec<String> = masses.iter().map(|m| m.node.to_string()).collect();
    Proposal::script_edit("changed_mass", form, format!("node {}", nodes.join(" ")), block, vec![factor])
}

#[cfg(test)]
mod tests {
    use super::propose;
    use crate::inspect::response::ResponseRanges;
    use crate::test_support::{inventory_under, pad_study, proposal_context};

    /// Masses of one height are a floor. A model with one floor has no other, and one without a ground motion has none.
    #[test]
    fn masses_of_one_height_change_together() {
        let places = |floors: &str, pattern: &str| -> Vec<String> {
            let text = format!(
                "model basic -ndm 2 -ndf 3
                foreach {{n x y}} {{1 0. 0. 2 5. 0. 3 0. 3. 4 5. 3. 5 0. 6.}} {{node $n $x $y}}
                foreach n {{1 2}} {{fix $n 1 1 1}}
                foreach n {{{floors}}} {{mass $n 2. 2. 0.}}
                geomTransf Linear 1
                foreach {{e i j}} {{1 1 3 2 2 4 3 3 4 4 3 5}} {{element elasticBeamColumn $e $i $j 1. 1e3 1. 1}}"
            );
            let (inventory, study, responses) =
                (inventory_under(&text, pattern), pad_study(), ResponseRanges::default());
            let proposals = propose(&proposal_context(&inventory, &study, &responses));
            assert!(
                proposals.iter().all(|p| p.commands.iter().all(|c| c.ends_with(" 0.0") && c.contains("$hy_factor")))
            );
            proposals.into_iter().map(|p| p.location).collect()
        };
        let shaken = "UniformExcitation 2 1 -accel 2";
        assert_eq!(places("3 4 5", shaken), ["node 3 4", "node 5", "node 3 4 5"]);
        assert_eq!(places("3 4", shaken), ["node 3 4"]);
        assert!(places("3 4 5", "Plain 2 2 {load 3 1. 0. 0.}").is_empty());
    }
}
