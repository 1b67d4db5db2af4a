//! Coulomb friction in parallel.

use super::{Added, Hypothesis, Proposal, Sight};

pub(super) const HYPOTHESIS: Hypothesis = Hypothesis {
    cause: "friction",
    says: "a Coulomb friction force acts in parallel (a slider, a guide, the rig)",
    refuted_by: "the loop of a tiny cycle is as thin as the material alone would have it",
    like: &["rate_dependence", "damping", "sensor_gain"],
    needs_clock: false,
    propose,
};

fn propose(s: &Sight<'_>) -> Vec<Proposal> {
    let mut out = vec![];
    for m in s.moved_or_grounded() {
        let force = || Added::log("force", 1e-3 * m.q, 0.9 * m.q, 0.05 * m.q);
        // What bends farther before it slips is a hysteretic spring and no friction.
        let way = || Added::log("way", 1e-4 * m.e, 0.05 * m.e, 0.01 * m.e);
        let mut form = |form: &str, law: &str, added: Vec<Added>| {
            out.push(Proposal::edit("friction", form, m.at(), vec![format!("{law} {}", m.dir)], added));
        };
        let slips = |kind: &str| format!("{} -force $hy_force -stiffness [expr $hy_force/$hy_way]", m.amend(kind));
        form("constant friction force", &slips("friction"), vec![force(), way()]);
        form("friction force of bristles", &slips("bristles"), vec![force(), way()]);
        if s.clock {
            let more = [
                Added::log("breakaway", 1e-3 * m.q, 0.9 * m.q, 0.05 * m.q),
                Added::log("speed", 1e-3 * m.v, m.v, 0.1 * m.v),
            ];
            let law = format!("{} -breakaway $hy_breakaway -speed $hy_speed", slips("bristles"));
            form("friction force that falls with speed", &law, [force(), way()].into_iter().chain(more).collect());
            let law = format!("{} -force $hy_force -speed $hy_speed", m.amend("sliding"));
            let speed = Added::log("speed", 1e-4 * m.v, 0.1 * m.v, 0.01 * m.v);
            form("friction force smoothed over speed", &law, vec![force(), speed]);
        }
    }
    out
}
