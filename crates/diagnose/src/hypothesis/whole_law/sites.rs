//! Commands of the devices whose law is replaced, and their edits.

use super::super::context::MovingGroup;
use super::super::device_commands::{DeviceCommand, Word};
use super::{Replaces, WholeLaw};
use crate::candidate::proposal::TextEdit;

/// Edits that put a law in the place of another.
pub(super) struct Site {
    /// First byte of the first outermost command that contains one of them.
    pub(super) first: usize,
    /// The edits.
    pub(super) edits: Vec<TextEdit>,
}

/// Elements that list materials with their directions.
const LISTED: [&str; 2] = ["zeroLength", "twoNodeLink"];
/// Bearings with one law of shear, which a `twoNodeLink` between the same nodes can have too. Its moments by the axial force
/// over a shear deformation are left out.
pub(super) const BEARINGS: [&str; 5] = [
    "elastomericBearingPlasticity",
    "ElastomericBearingPlasticity",
    "elastomericBearing",
    "elastomericBearingBoucWen",
    "ElastomericBearingBoucWen",
];
/// Options of these bearings that a `twoNodeLink` takes as they are.
const COMMON_OPTIONS: [&str; 4] = ["-orient", "-shearDist", "-doRayleigh", "-mass"];

/// Edits for a law at the devices of a group; `None` if their commands are not found or do not suit it.
pub(super) fn find(
    law: &WholeLaw,
    group: &MovingGroup<'_>,
    commands: &[DeviceCommand<'_>],
    first_tag: i32,
) -> Option<Site> {
    let found: Vec<(usize, TextEdit)> = match &law.replaces {
        Replaces::Shear { kinds, bearings } => {
            let of_materials = materials(law, kinds, group, commands);
            of_materials.or_else(|| bearings.then(|| links(law, group, commands, first_tag))?)?
        }
        Replaces::Friction(kinds) => frictions(law, kinds, group, commands)?,
    };
    let first = found.iter().map(|(outermost, _)| *outermost).min()?;
    Some(Site { first, edits: found.into_iter().map(|(_, edit)| edit).collect() })
}

fn is_option(word: &str) -> bool {
    word.strip_prefix('-').is_some_and(|rest| rest.starts_with(char::is_alphabetic))
}

/// Words of an option, up to the next one.
fn option_words<'a, 'b>(command: &'b DeviceCommand<'a>, option: &str) -> Option<&'b [Word<'a>]> {
    let from = command.words.iter().position(|w| w.text == option)? + 1;
    let length = command.words[from..].iter().position(|w| is_option(w.text));
    Some(&command.words[from..length.map_or(command.words.len(), |n| from + n)])
}

/// Returns true for an `element` command of these kinds that makes, or may make, devices of the group.
fn makes(command: &DeviceCommand<'_>, kinds: &[&str], group: &MovingGroup<'_>) -> bool {
    let word = |i: usize| command.words.get(i).map_or("", |w| w.text);
    let of_group = |tag: i32| group.devices.iter().any(|d| d.tag == tag);
    // A tag that is no number is that of a loop or a procedure.
    word(0) == "element" && kinds.contains(&word(1)) && word(2).parse().map_or(true, of_group)
}

/// A definition by its command, kind and tag.
fn definition<'a, 'b>(commands: &'b [DeviceCommand<'a>], name: &str, tag: &str) -> Option<&'b DeviceCommand<'a>> {
    let word = |c: &DeviceCommand<'a>, i: usize| c.words.get(i).map(|w| w.text);
    let mut of_tag = commands.iter().filter(|c| word(c, 0) == Some(name) && word(c, 2) == Some(tag));
    // Of two with one tag it is not known which of them is meant.
    of_tag.next().filter(|_| of_tag.next().is_none())
}

/// Returns true if a material is of the given kinds, or a plain sum of such.
fn is_of(kinds: &[&str], material: &DeviceCommand<'_>, commands: &[DeviceCommand<'_>]) -> bool {
    match material.words[1].text {
        "Parallel" => {
            let parts = &material.words[3..];
            let known = |w: &Word<'_>| {
                let part = definition(commands, "uniaxialMaterial", w.text);
                part.is_some_and(|c| kinds.contains(&c.words[1].text))
            };
            !parts.is_empty() && parts.iter().all(known)
        }
        kind => kinds.contains(&kind),
    }
}

/// The law in place of the words of a definition from its kind on.
fn replaced(law: &WholeLaw, command: &DeviceCommand<'_>) -> Option<(usize, TextEdit)> {
    let (kind, tag, last) = (command.words.get(1)?, command.words.get(2)?, command.words.last()?);
    let text = law.command.replace("{tag}", tag.text).replace("{old}", last.text);
    Some((command.outermost, TextEdit { start: kind.start, end: last.end, text }))
}

/// Edits of the materials in which the devices move. `None` if one of them stays, or also acts elsewhere.
fn materials(
    law: &WholeLaw,
    kinds: &[&str],
    group: &MovingGroup<'_>,
    commands: &[DeviceCommand<'_>],
) -> Option<Vec<(usize, TextEdit)>> {
    let mut tags: Vec<&str> = vec![];
    let mut kept: Vec<&str> = vec![];
    for element in commands.iter().filter(|c| c.words.get(1).is_some_and(|w| LISTED.contains(&w.text))) {
        let (list, directions) = (option_words(element, "-mat")?, option_words(element, "-dir")?);
        if list.len() != directions.len() {
            return None;
        }
        let moves =
            |d: &Word<'_>| d.text.parse().map_or(directions.len() == 1, |number| group.directions.contains(&number));
        for (material, direction) in list.iter().zip(directions) {
            let of_group = makes(element, &LISTED, group) && moves(direction);
            let known = if of_group { &mut tags } else { &mut kept };
            if !known.contains(&material.text) {
                known.push(material.text);
            }
        }
    }
    let suits = |tag: &&str| {
        let material = definition(commands, "uniaxialMaterial", tag);
        material.filter(|c| c.words.len() > 3 && is_of(kinds, c, commands))
    };
    let mut found: Vec<&DeviceCommand<'_>> = tags.iter().filter(|t| !kept.contains(*t)).filter_map(suits).collect();
    // A spring beside a hysteretic material stays; alone it is the device's law.
    if found.iter().any(|c| c.words[1].text != "Elastic") {
        found.retain(|c| c.words[1].text != "Elastic");
    }
    (!found.is_empty()).then(|| found.into_iter().map(|c| replaced(law, c)).collect())?
}

/// Edits of bearings: a link with the law in the directions of shear and the bearing's materials in the others.
fn links(
    law: &WholeLaw,
    group: &MovingGroup<'_>,
    commands: &[DeviceCommand<'_>],
    first_tag: i32,
) -> Option<Vec<(usize, TextEdit)>> {
    // Springs in two directions are not coupled.
    let [_] = group.directions[..] else { return None };
    let bearings = commands.iter().filter(|c| makes(c, &BEARINGS, group));
    let link = |(number, bearing): (i32, &DeviceCommand<'_>)| {
        let [first, .., last] = &bearing.words[..] else { return None };
        let tag = bearing.words.get(2)?.text;
        let law_tag = match tag.parse::<i32>() {
            Ok(_) => (first_tag + number).to_string(),
            Err(_) => format!("[expr {{{first_tag}+{tag}}}]"),
        };
        let material = |option: &str| Some(option_words(bearing, option)?.first()?.text);
        let axial = material("-P")?;
        let (materials, directions) = match (material("-T"), material("-My"), material("-Mz")) {
            (Some(t), Some(my), Some(mz)) => {
                (format!("{axial} {law_tag} {law_tag} {t} {my} {mz}"), "1 2 3 4 5 6".to_owned())
            }
            (None, None, Some(mz)) => (format!("{axial} {law_tag} {mz}"), "1 2 3".to_owned()),
            _ => return None,
        };
        let nodes = [bearing.words.get(3)?.text, bearing.words.get(4)?.text].join(" ");
        let mut text = format!(
            "uniaxialMaterial {}\nelement twoNodeLink {tag} {nodes} -mat {materials} -dir {directions}",
            law.command.replace("{tag}", &law_tag)
        );
        for option in COMMON_OPTIONS {
            let Some(words) = option_words(bearing, option) else { continue };
            let words: Vec<&str> = std::iter::once(option).chain(words.iter().map(|w| w.text)).collect();
            text += &format!(" {}", words.join(" "));
        }
        Some((bearing.outermost, TextEdit { start: first.start, end: last.end, text }))
    };
    let found: Vec<_> = (0..).zip(bearings).map(link).collect::<Option<_>>()?;
    (!found.is_empty()).then_some(found)
}

/// Edits of the friction of sliders: the fourth word behind the kind of the element names it.
fn frictions(
    law: &WholeLaw,
    kinds: &[&str],
    group: &MovingGroup<'_>,
    commands: &[DeviceCommand<'_>],
) -> Option<Vec<(usize, TextEdit)>> {
    const SLIDERS: [&str; 2] = ["flatSliderBearing", "singleFPBearing"];
    let mut tags: Vec<&str> = vec![];
    for slider in commands.iter().filter(|c| makes(c, &SLIDERS, group)) {
        let tag = slider.words.get(5)?.text;
        if !tags.contains(&tag) {
            tags.push(tag);
        }
    }
    let suits = |tag: &&str| {
        let model = definition(commands, "frictionModel", tag)?;
        (kinds.contains(&model.words[1].text) && model.words.len() == 4).then(|| replaced(law, model))?
    };
    let found: Vec<_> = tags.iter().map(suits).collect::<Option<_>>()?;
    (!found.is_empty()).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::super::{LAWS, WholeLaw};
    use super::find;
    use crate::hypothesis::context::MovingGroup;
    use crate::hypothesis::device_commands::device_commands;
    use crate::inspect::inventory::Device;

    /// The script after a law has taken the place of that of element 1, which moves in some directions.
    fn edited(law: &WholeLaw, text: &str, directions: &[usize]) -> Option<String> {
        let device = Device {
            tag: 1,
            class: "",
            nodes: [1, 2],
            directions: vec![],
            linear: false,
            viscous: false,
            slides: false,
        };
        let group = MovingGroup {
            devices: vec![&device],
            dir_option: String::new(),
            directions: directions.into(),
            axial: None,
            deformation: 1.0,
            force: 1.0,
            speed: 1.0,
            work: 1.0,
        };
        let mut edits = find(law, &group, &device_commands(text, text.len()), 900)?.edits;
        edits.sort_by_key(|e| std::cmp::Reverse(e.start));
        let mut out = text.to_owned();
        edits.iter().for_each(|e| out.replace_range(e.start..e.end, &e.text));
        Some(out)
    }

    fn law(start: &str) -> &'static WholeLaw {
        LAWS.iter().find(|law| law.command.starts_with(start)).expect("a law")
    }

    fn command(start: &str, tag: &str) -> String {
        law(start).command.replace("{tag}", tag)
    }

    #[test]
    fn materials_of_the_shear_direction_are_replaced() {
        let springs = "uniaxialMaterial Steel01 1 $Fy $k 0.1\nuniaxialMaterial Elastic 2 5.0\n";
        let sum =
            format!("{springs}uniaxialMaterial Parallel 3 1 2 ;# rubber\nelement zeroLength 1 1 2 -mat 3 -dir 1\n");
        let rubber = sum.replace("Parallel 3 1 2", &command("HDRRheology", "3"));
        assert_eq!(edited(law("HDRRheology"), &sum, &[1]), Some(rubber));
        // A spring or a dashpot beside the hysteretic material stays.
        let beside = format!("{springs}element twoNodeLink 1 1 2 -mat 2 1 2 -dir 1 2 2 -orient 0 1 0\n");
        let kept = beside.replace("Steel01 1 $Fy $k 0.1", &command("Hysteretic", "1"));
        assert_eq!(edited(law("Hysteretic"), &beside, &[2]), Some(kept));
        // Another element has the material, or the kind is none of the law's.
        let shared =
            format!("{springs}element zeroLength 1 1 2 -mat 1 -dir 1\nelement zeroLength 2 2 3 -mat 1 -dir 1\n");
        assert_eq!(edited(law("HDRRheology"), &shared, &[1]), None);
        let steel = "uniaxialMaterial Steel02 1 1 2 0.1 18 0.9 0.1\nelement zeroLength 1 1 2 -mat 1 -dir 1\n";
        assert_eq!(edited(law("HDRRheology"), steel, &[1]), None);
    }

    #[test]
    fn bearings_become_links_with_their_other_materials() {
        let bearing = |rest: &str| format!("element elastomericBearingBoucWen {rest}\n");
        let plane = bearing("1 1 2 $k $q 0.1 0.0 2.0 1.0 0.5 0.5 -P 7 -Mz 8 -orient 0 1 0 -1 0 0");
        let link = format!(
            "uniaxialMaterial {}\nelement twoNodeLink 1 1 2 -mat 7 900 8 -dir 1 2 3 -orient 0 1 0 -1 0 0\n",
            command("HDRRheology", "900")
        );
        assert_eq!(edited(law("HDRRheology"), &plane, &[2]), Some(link));
        let space = bearing("$e 1 2 $k $q 0.1 0.0 2.0 1.0 0.5 0.5 -P 7 -T 6 -My 8 -Mz 9");
        let tag = "[expr {900+$e}]";
        let link = format!(
            "uniaxialMaterial {}\nelement twoNodeLink $e 1 2 -mat 7 {tag} {tag} 6 8 9 -dir 1 2 3 4 5 6\n",
            command("HDRRheology", tag)
        );
        assert_eq!(edited(law("HDRRheology"), &space, &[2]), Some(link));
        // Two directions would need a coupled law.
        assert_eq!(edited(law("HDRRheology"), &space, &[2, 3]), None);
    }

    #[test]
    fn friction_keeps_its_coefficient() {
        let text = "frictionModel Coulomb 4 $mu\nelement flatSliderBearing 1 1 2 4 1e6 -P 1 -Mz 2\n";
        let fast = text.replace("Coulomb 4 $mu", "VelDependent 4 [expr {$::hy_slow*($mu)}] $mu $::hy_rate");
        assert_eq!(edited(law("VelDependent"), text, &[2]), Some(fast));
        assert_eq!(edited(law("VelDependent"), &text.replace("Coulomb", "VelNormalFrcDep"), &[2]), None);
    }
}
