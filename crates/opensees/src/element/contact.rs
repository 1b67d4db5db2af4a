//! `element zeroLengthImpact3D`, `zeroLengthContact2D` and `zeroLengthContact3D`.

use super::{Ends, Kind, Make};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use hysteron_engine::element::{
    Contact, ContactDirection, ContactFriction, ContactSurface, Element, Impact, ImpactOptions,
};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::sync::Arc;

const ORIGIN: [Arg; 2] = [
    Arg::number("originX", "origin x of the axis of the circle"),
    Arg::number("originY", "origin y of the axis of the circle"),
];

const NORMAL: [Arg; 2] = [
    Arg::of("-normal", "Nx", "component Nx of the normal").within(Domain::Number),
    Arg::of("-normal", "Ny", "component Ny of the normal").within(Domain::Number),
];

const DIRECTION: Arg = Arg::whole("direction", "direction of the contact");
const FRICTION: Arg = Arg::not_negative("friction", "coefficient of friction");
const KT: Arg = Arg::not_negative("Kt", "tangential stiffness Kt");
const KN: Arg = Arg::positive("Kn", "normal stiffness Kn");
const COHESION: Arg = Arg::not_negative("cohesion", "cohesion");

const IMPACT_NUMBERS: [Arg; 7] = [
    Arg::number("gap", "gap"),
    FRICTION,
    KT,
    KN,
    Arg::not_negative("Kn2", "normal stiffness Kn2 after yielding"),
    Arg::not_negative("yield", "yield penetration"),
    COHESION,
];

const NODES: &[Arg] = &[
    Arg::whole("secondary", "node that must not enter the surface of the other one"),
    Arg::whole("primary", "node on the surface"),
];

pub(super) const IMPACT: Kind = Kind {
    names: &["zeroLengthImpact3D"],
    usage: "element zeroLengthImpact3D $tag $secondary $primary $direction $gap $friction $Kt $Kn $Kn2 $yield $cohesion",
    text: Text::new("Contact of two nodes with friction and a bilinear hysteretic stiffness.")
        .example("element zeroLengthImpact3D 2 1 2 1 1 1 1 1 1 1 1")
        .arguments(&[Arg::whole("secondary", "tag of node i"), Arg::whole("primary", "tag of node j"), DIRECTION])
        .groups(&[&IMPACT_NUMBERS]),
    make: Make::TwoNodes(make),
};

pub(super) const CONTACT_2D: Kind = Kind {
    names: &["zeroLengthContact2D", "ZeroLengthContact2D"],
    usage: "element zeroLengthContact2D $tag $secondary $primary $Kn $Kt $friction -normal $Nx $Ny",
    text: Text::new("Contact of two nodes in the plane with Coulomb friction, by penalties.")
        .example("element zeroLengthContact2D 77 1 2 1. 1. 0.3 -normal 0. 1.")
        .groups(&[&[KN, KT, FRICTION], &NORMAL, NODES]),
    make: Make::TwoNodes(make_in_plane),
};

pub(super) const CONTACT_3D: Kind = Kind {
    names: &["zeroLengthContact3D", "ZeroLengthContact3D"],
    usage: "element zeroLengthContact3D $tag $secondary $primary $Kn $Kt $friction $cohesion $direction <$originX $originY>",
    text: Text::new("Contact of two nodes in space with Coulomb friction, by penalties.")
        .example("element zeroLengthContact3D 77 1 2 1. 1. 0.3 0. 3")
        .arguments(&[
            KN,
            KT,
            FRICTION,
            COHESION,
            Arg::new(
                "direction",
                "1, 2 or 3: the primary surface faces along x, y or z; 0: a circle around an axis \
                 along z",
            )
            .within(Domain::Whole),
        ])
        .groups(&[&ORIGIN, NODES]),
    make: Make::TwoNodes(make_in_space),
};

fn direction(a: &mut Args<'_>) -> Result<ContactDirection, Exception> {
    match a.int(DIRECTION.meaning)? {
        0 => Ok(ContactDirection::Circular),
        axis @ 1..=3 => Ok(ContactDirection::Axis(axis as usize - 1)),
        other => Err(a.refuse(format!("direction of the contact is {other}"), "expected 0, 1, 2 or 3")),
    }
}

/// Normal stiffness, then the law of the friction without cohesion.
fn stiffnesses(a: &mut Args<'_>) -> Result<(f64, ContactFriction), Exception> {
    let normal = a.number(&KN)?;
    let tangential = a.number(&KT)?;
    Ok((normal, ContactFriction { tangential, friction: a.number(&FRICTION)?, cohesion: 0.0 }))
}

fn make_in_plane(_: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    if ends.ndm != 2 || !matches!(ends.ndf, 2 | 3) {
        return Err(ends.wrong(a, "2 or 3 degrees of freedom in 2 dimensions"));
    }
    let (normal, friction) = stiffnesses(a)?;
    if a.word("option -normal")? != "-normal" {
        return Err(a.unknown_name("option in this place", ["-normal"]));
    }
    let [x, y] = a.numbers(&NORMAL)?;
    let length = x.hypot(y);
    if length == 0.0 {
        return Err(a.refuse("the normal has no length", "expected a vector out of the primary surface"));
    }
    let surface = ContactSurface::Line { normal: [x / length, y / length], per_node: ends.ndf };
    Ok(Contact::new(surface, normal, friction, [ends.place.0, ends.place.1]).shared())
}

fn make_in_space(_: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 3))?;
    let (normal, mut friction) = stiffnesses(a)?;
    friction.cohesion = a.number(&COHESION)?;
    let direction = direction(a)?;
    let place = a.last_span();
    let mut origin = [0.0; 2];
    if direction == ContactDirection::Circular {
        if a.left() > 0 {
            origin = a.numbers(&ORIGIN)?;
        }
        if (ends.place.1.x - origin[0]).hypot(ends.place.1.y - origin[1]) == 0.0 {
            let label = "expected a primary node apart from the axis of the cylinder";
            return Err(a.refuse_at(place, "the primary node is on the axis of the contact", label));
        }
    }
    let surface = ContactSurface::Space { direction, origin };
    Ok(Contact::new(surface, normal, friction, [ends.place.0, ends.place.1]).shared())
}

fn make(_: &mut Tcl, a: &mut Args<'_>, ends: &Ends) -> Result<Arc<dyn Element>, Exception> {
    ends.need(a, (3, 3))?;
    let direction = direction(a)?;
    let [gap, friction, tangential, kn, kn2, yield_penetration, cohesion] = a.numbers(&IMPACT_NUMBERS)?;
    let options =
        ImpactOptions { direction, gap, friction, tangential, normal: [kn, kn2], yield_penetration, cohesion };
    Ok(Impact::new(options, [ends.place.0, ends.place.1]).shared())
}
