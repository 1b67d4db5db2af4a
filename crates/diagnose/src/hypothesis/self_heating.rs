//! Dissipated work warms the device.

use super::{Added, HYSTERETIC, Hypothesis, Proposal, STRENGTH, Sight, of_strength};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "self_heating",
    says: "dissipated work warms the device and softens it",
    refuted_by: "after a pause long enough to cool the first cycle is as soft as the last",
    like: &["cyclic_degradation", "mullins_softening"],
    needs_clock: true,
    propose,
};

/// Softening per degree: only the ratio to the heat capacity can be found without a thermometer.
const SOFTENING: f64 = 0.01;

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        // A rise by ten degrees over the longest run to start from.
        let c = m.work / 10.0;
        for (which, share, more) in Sight::shares(&m).into_iter().chain([of_strength(&m)]) {
            let mut form = |form: &str, loss: &str, added: Vec<Added>| {
                let options = format!("-softening {SOFTENING} -capacity $hy_capacity {loss} {}{share}", m.dir);
                let line = format!("{} {options}", m.amend("heating"));
                let added = added.into_iter().chain(more.clone()).collect();
                out.push(Proposal::edit("self_heating", &format!("{form} {which}"), m.at(), vec![line], added));
            };
            let cooling = vec![Added::log("capacity", 0.02 * c, 30.0 * c, c), Added::log("cooling", 1.0, 1e5, 100.0)];
            form("softening", "-cooling $hy_cooling", cooling);
            // Lead and faces of sliding lie on bodies that take up their heat; of a face alone there is hardly any heat capacity.
            if [HYSTERETIC, STRENGTH].contains(&which) {
                let capacity = Added::log("capacity", 1e-3 * c, 30.0 * c, 0.3 * c);
                let conduction = vec![capacity, Added::log("conduction", 1e-3, 1e3, 10.0)];
                form("softening, heat conducted away,", "-conduction $hy_conduction", conduction);
            }
        }
    }
    out
}
