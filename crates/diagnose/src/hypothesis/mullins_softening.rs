//! Virgin rubber is stiffer than scragged rubber.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "mullins_softening",
    says: "virgin or recovered rubber is stiffer on its first way to a strain than on the next (Mullins, scragging)",
    refuted_by: "the second cycle at an amplitude that was never reached before is as stiff as the first",
    like: &["cyclic_degradation", "self_heating", "strain_stiffening"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved(false) {
        let k = m.stiffness();
        let part = || Added::linear("k", 0.05 * k, 1.2 * k, 0.6 * k);
        // It is the network of the rubber that softens; the rest does in its own measure.
        for (which, share, more) in [
            ("of the whole force", "", vec![]),
            ("of the hysteretic part", " -share $hy_k 0", vec![part()]),
            ("of the elastic part", " -share $hy_k 1 0", vec![part()]),
            ("of both parts", " -share $hy_k 1 $hy_rest", vec![part(), Added::linear("rest", 0.0, 1.5, 0.4)]),
        ] {
            let form = |form: &str, power: &str, added: Vec<Added>| {
                let options = format!("-virgin $hy_virgin -power {power} -onset $hy_onset {}{share}", m.dir);
                let line = format!("{} {options}", m.amend("mullins"));
                let added = added.into_iter().chain(more.clone()).collect();
                Proposal::edit("mullins_softening", &format!("{form} {which}"), m.at(), vec![line], added)
            };
            // Rubber loses half of its stiffness by it at most; more is damage.
            let virgin = Added::linear("virgin", -0.3, 1.2, 0.2);
            let onset = |start: f64| Added::log("onset", 1e-3 * m.e, 3.0 * m.e, start * m.e);
            let back = vec![virgin.clone(), Added::linear("power", 0.2, 8.0, 2.0), onset(0.1)];
            out.push(form("excess", "$hy_power", back));
            // Rubber that is back at its largest strain is as stiff as virgin rubber (Ogden and Roxburgh), or the virgin path
            // itself has lost what is gone (Simo, 1987; Govindjee and Simo, 1991).
            out.push(form("excess, lost for good,", "0", vec![virgin, onset(0.4)]));
        }
    }
    out
}
