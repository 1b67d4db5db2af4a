//! Laws around others have the roles of the law inside, with its answers. Points together are points one by one.

use super::every_kind::MATERIALS;
use super::script::Script;
use super::wrappers::{materials, wrappers};
use hysteron::material::{
    Material, MaterialResult, Strain, Strains, Stress, Stresses, Uniaxial, UniaxialRoles, UniaxialTraits,
};
use std::collections::BTreeSet;

/// Names of the roles of a law. A role that is not here does not compile.
fn names(law: &dyn Uniaxial) -> BTreeSet<&'static str> {
    let UniaxialRoles {
        layout,
        commit,
        last_trial,
        trace,
        virgin,
        shown_strain,
        parameters,
        responses,
        columns,
        shifted,
        law,
    } = law.roles();
    let all = [
        ("layout", layout.is_some()),
        ("commit", commit.is_some()),
        ("last_trial", last_trial.is_some()),
        ("trace", trace.is_some()),
        ("virgin", virgin.is_some()),
        ("shown_strain", shown_strain.is_some()),
        ("parameters", parameters.is_some()),
        ("responses", responses.is_some()),
        ("columns", columns.is_some()),
        ("shifted", shifted.is_some()),
        ("law", law.is_some()),
    ];
    all.into_iter().filter_map(|(name, has)| has.then_some(name)).collect()
}

/// Roles that a law around others has where a law inside has them.
const FORWARDED: [&str; 2] = ["trace", "columns"];
/// Roles of every law around others.
const OF_EACH: [&str; 3] = ["shown_strain", "parameters", "responses"];
/// Roles that would go past the law around.
const OF_THE_INNER_LAW_ALONE: [&str; 4] = ["commit", "last_trial", "virgin", "law"];

/// The law around others, of which the last state variables are those of the law inside, with the name of its kind.
/// A section is not a law around others: its springs are committed.
fn around(inner: &Material) -> impl Iterator<Item = (&'static str, Material)> {
    wrappers(inner).into_iter().filter(|(kind, ..)| *kind != "Axial").map(|(kind, law, _)| (kind, law))
}

fn virgin(law: &Material) -> Vec<f64> {
    let mut state = vec![0.0; law.state_len()];
    law.init(&mut state);
    state
}

/// The committed state after a trial that has changed every state variable and is not committed.
fn traced(law: &Material, committed: &[f64]) -> Vec<f64> {
    let mut committed = committed.to_vec();
    let tried: Vec<f64> = committed.iter().map(|x| x + 0.01).collect();
    if let Some(law) = law.roles().trace {
        law.leave_trace(&tried, &mut committed);
    }
    committed
}

/// Compares roles and answers.
fn compare(kind: &str, inner: &Material, outer: &Material) -> Result<(), String> {
    let (own, has) = (names(&**inner), names(&**outer));
    let wrong = |what: &str| Err(format!("{} in {kind}: {what}", inner.name()));
    if let Some(role) = FORWARDED.iter().find(|role| own.contains(*role) != has.contains(*role)) {
        return wrong(role);
    }
    if let Some(role) = OF_EACH.iter().find(|role| !has.contains(*role)) {
        return wrong(role);
    }
    if let Some(role) = OF_THE_INNER_LAW_ALONE.iter().find(|role| has.contains(*role)) {
        return wrong(role);
    }
    if inner.depends_on_time() != outer.depends_on_time() {
        return wrong("time");
    }
    let header = outer.state_len() - inner.state_len();
    let before = virgin(outer);
    let after = traced(outer, &before);
    if after[header..] != traced(inner, &before[header..]) || after[..header] != before[..header] {
        return wrong("trace");
    }
    // Components have strains of their own.
    let has_components = ["Parallel", "Series"].contains(&kind);
    let shown = if has_components { 0.003 } else { inner.shown_strain(0.003, &virgin(inner)) };
    if outer.shown_strain(0.003, &before) != shown {
        return wrong("shown strain");
    }
    Ok(())
}

#[test]
fn laws_around_others_keep_every_role() {
    let (mut wrong, mut seen) = (vec![], BTreeSet::new());
    for host in [Script::default(), Script::compat()] {
        for (_, inner) in materials(host) {
            seen.extend(names(&*inner));
            seen.extend((traced(&inner, &virgin(&inner)) != virgin(&inner)).then_some("a trace"));
            seen.extend((inner.shown_strain(0.0, &virgin(&inner)) != 0.0).then_some("a shown strain"));
            for (kind, outer) in around(&inner) {
                wrong.extend(compare(kind, &inner, &outer).err());
                for (second, both) in around(&outer) {
                    wrong.extend(compare(second, &outer, &both).err());
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong.join("\n"));
    // The table has laws with these roles, so that the comparison has something to compare.
    for role in FORWARDED.iter().chain(&OF_EACH).chain(&OF_THE_INNER_LAW_ALONE).chain(&["a trace", "a shown strain"]) {
        assert!(seen.contains(role), "no law with {role}");
    }
}

/// Compares points that are evaluated together with points that are evaluated one by one, to the bit, on a path of strains.
fn together(law: &Material, amplitude: f64) -> Result<(), String> {
    const POINTS: usize = 5;
    let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let mut single: Vec<Vec<f64>> = vec![virgin(law); POINTS];
    let mut all = vec![0.0; POINTS * law.state_len()];
    law.init_all(POINTS, &mut all);
    for step in 1..=30 {
        let strain = |i: usize| amplitude * (0.4 * f64::from(step)).sin() * (0.2 + i as f64 / POINTS as f64);
        let strains: Vec<f64> = (0..POINTS).map(strain).collect();
        let (mut value, mut tangent, mut damping) = ([0.0; POINTS], [0.0; POINTS], [0.0; POINTS]);
        let mut next = all.clone();
        let given = Strains { value: &strains, rate: &[0.1; POINTS], dt: 0.01 };
        let mut stresses = Stresses { value: &mut value, tangent: &mut tangent, damping: &mut damping };
        let found = law.update_all(&all, &given, &mut next, &mut stresses);
        for i in 0..POINTS {
            let committed = single[i].clone();
            let s = law.update(&committed, Strain { value: strains[i], rate: 0.1, dt: 0.01 }, &mut single[i]);
            let Ok(s) = s else {
                // A law without response at a point has none for all.
                return found.err().map(|_| ()).ok_or_else(|| format!("step {step}, point {i}: a response"));
            };
            let (own, one) = ([s.value, s.tangent, s.damping], [value[i], tangent[i], damping[i]]);
            if found.is_ok() && bits(&own) != bits(&one) {
                return Err(format!("step {step}, point {i}: {one:?}, not {own:?}"));
            }
            let mut history = vec![0.0; law.state_len()];
            law.copy_history((&next, i, POINTS), (&mut history, 0, 1));
            if found.is_ok() && bits(&history) != bits(&single[i]) {
                return Err(format!("step {step}, point {i}: history {history:?}, not {:?}", single[i]));
            }
        }
        found.map_err(|e| format!("step {step}: {e}"))?;
        all = next;
    }
    Ok(())
}

#[test]
fn points_together_are_points_one_by_one() {
    let mut wrong = vec![];
    for host in [Script::default(), Script::compat()] {
        // As a fiber of a section Concrete01WithSITC is another law than as a spring.
        for (words, law) in materials(host).into_iter().filter(|(_, law)| law.name() != "Concrete01WithSITC") {
            let amplitude = MATERIALS.iter().find(|(row, _)| *row == words).map_or(0.01, |(_, amplitude)| *amplitude);
            wrong.extend(together(&law, amplitude).err().map(|e| format!("{words}: {e}")));
            for (kind, outer, _) in wrappers(&law) {
                wrong.extend(together(&outer, amplitude).err().map(|e| format!("{words} in {kind}: {e}")));
            }
        }
    }
    assert!(wrong.is_empty(), "{} wrong\n{}", wrong.len(), wrong.join("\n"));
}

/// A law around another that forwards no role.
#[derive(Debug)]
struct Forgetful(Material);

#[deny(clippy::missing_trait_methods)]
impl Uniaxial for Forgetful {
    fn name(&self) -> &'static str {
        "Forgetful"
    }
    fn state_len(&self) -> usize {
        self.0.state_len()
    }
    fn init(&self, state: &mut [f64]) {
        self.0.init(state);
    }
    fn traits(&self) -> UniaxialTraits {
        self.0.traits()
    }
    fn initial_tangent(&self) -> f64 {
        self.0.initial_tangent()
    }
    fn update(&self, committed: &[f64], strain: Strain, next: &mut [f64]) -> MaterialResult<Stress> {
        self.0.update(committed, strain, next)
    }
    fn update_all(
        &self,
        committed: &[f64],
        strains: &Strains<'_>,
        next: &mut [f64],
        stresses: &mut Stresses<'_>,
    ) -> MaterialResult {
        self.0.update_all(committed, strains, next, stresses)
    }
    fn roles(&self) -> UniaxialRoles<'_> {
        UniaxialRoles::default()
    }
}

/// The comparisons find a law around others that forgets a role, and one that forgets the layout of points.
#[test]
fn a_forgotten_role_is_found() {
    let all = materials(Script::compat());
    let of = |name: &str| all.iter().rfind(|(_, law)| law.name() == name).map(|(_, law)| law.clone()).unwrap();
    for (name, role) in [("KikuchiAikenHDR", "trace"), ("LimitState", "columns"), ("Elastic", "shown_strain")] {
        let inner = of(name);
        let found = compare("Forgetful", &inner, &Material::new(Forgetful(inner.clone())));
        assert_eq!(found, Err(format!("{name} in Forgetful: {role}")));
    }
    assert_eq!(together(&of("Steel02"), 0.1), Ok(()));
    let found = together(&Material::new(Forgetful(of("Steel02"))), 0.1);
    assert!(found.is_err_and(|e| e.starts_with("step 1, point 0: ")));
}
