//! Fiber sections by the dimensions of their shape.

use super::{Kind, Make, warn_of_torsion};
use crate::Tcl;
use crate::args::Args;
use crate::text::{Arg, Domain, Text};
use crate::things;
use hysteron_engine::material::{Elastic, Material};
use hysteron_engine::section::{Fiber, FiberBending, FiberSection, SharedSection};
use hysteron_engine::shared::Shared;
use hysteron_tcl::Exception;
use std::f64::consts::PI;

const RECTANGULAR_BARS: [Arg; 3] = [
    Arg::not_negative("Atop", "area of a top bar Atop"),
    Arg::not_negative("Abottom", "area of a bottom bar Abottom"),
    Arg::not_negative("Aside", "area of a side bar Aside"),
];
const AS: Arg = Arg::not_negative("As", "area of a bar As");
const NFTW: Arg = Arg::count("nftw", "fibers across the web nftw");
const NFDW: Arg = Arg::count("nfdw", "fibers of the web nfdw");
const NFTF: Arg = Arg::count("nftf", "fibers of a flange nftf");
const NFBF: Arg = Arg::count("nfbf", "fibers across a flange nfbf");
const RECTANGULAR_PARTS: [Arg; 3] = [
    Arg::count("nfcore", "fibers of the core nfcore"),
    Arg::count("nfcover", "fibers of the cover nfcover"),
    Arg::count("nfs", "bars of a layer nfs"),
];
const CIRCULAR_PARTS: [Arg; 3] = [
    Arg::count("nRingsCore", "rings of the core"),
    Arg::count("nRingsCover", "rings of the cover"),
    Arg::count("nWedges", "number of wedges"),
];
const BARS: Arg = Arg::count("nSteel", "number of bars");
const GJ: Arg = Arg::of("-GJ", "GJ", "torsional rigidity GJ").within(Domain::NotNegative);

const FLANGED: [Arg; 4] = [
    Arg::positive("d", "depth d"),
    Arg::positive("tw", "thickness of the web tw"),
    Arg::positive("bf", "width of the flanges bf"),
    Arg::positive("tf", "thickness of the flanges tf"),
];
const COVER_DEPTH: Arg = Arg::positive("coverDepth", "depth of the cover");
const RECTANGLE: [Arg; 3] = [FLANGED[0], Arg::positive("b", "width b"), COVER_DEPTH];
const RCCIRCULAR_SECTION_D: Arg = Arg::positive("d", "diameter d");

pub(super) const WIDE_FLANGE: Kind = Kind {
    names: &["WFSection2d", "WSection2d"],
    usage: "section WFSection2d $tag $material $d $tw $bf $tf $nfdw $nftf <$nfbf $nftw> <-GJ $GJ>",
    text: Text::new("A wide flange of fibres.")
        .example("section WFSection2d 77 1 10. 0.5 6. 0.8 20 4")
        .arguments(&[Arg::thing("material", things::MATERIAL), NFDW, NFTF, NFBF, NFTW, GJ])
        .groups(&[&FLANGED]),
    make: Make::Beam(wide_flange),
};

pub(super) const RECTANGULAR_CONCRETE: Kind = Kind {
    names: &["RCSection2d"],
    usage: "section RCSection2d $tag $core $cover $steel $d $b $coverDepth $Atop $Abottom $Aside $nfcore $nfcover $nfs",
    text: Text::new("A rectangle of concrete with bars, bent about one axis.")
        .example("section RCSection2d 77 1 2 3 20. 12. 2. 0.5 0.5 0.3 16 4 3")
        .arguments(&[
            Arg::thing("core", things::MATERIAL),
            Arg::thing("cover", things::MATERIAL),
            Arg::thing("steel", things::MATERIAL),
        ])
        .groups(&[&RECTANGLE, &RECTANGULAR_BARS, &RECTANGULAR_PARTS]),
    make: Make::Beam(rectangular_concrete),
};

pub(super) const CIRCULAR_CONCRETE: Kind = Kind {
    names: &["RCCircularSection"],
    usage: "section RCCircularSection $tag $core $cover $steel $d $coverDepth $As $nRingsCore $nRingsCover $nWedges $nSteel \
            <-GJ $GJ | -torsion $material>",
    text: Text::new("A circle of concrete with bars.")
        .example("section RCCircularSection 77 1 2 3 20. 2. 0.5 4 2 8 8 -GJ 1.")
        .arguments(&[
            Arg::thing("core", things::MATERIAL),
            Arg::thing("cover", things::MATERIAL),
            Arg::thing("steel", things::MATERIAL),
            RCCIRCULAR_SECTION_D,
            COVER_DEPTH,
            AS,
            BARS,
            GJ,
            Arg::of("-torsion", "material", "law of torsion, in space"),
        ])
        .groups(&[&CIRCULAR_PARTS]),
    make: Make::Beam(circular_concrete),
};

/// A uniaxial material with its tag.
type Tagged = (Material, i32);

fn material(interp: &Tcl, a: &mut Args<'_>) -> Result<Tagged, Exception> {
    a.of(&interp.host.builder.definitions.materials)
}

/// Middles of strips of equal depth from the top of a part of height `whole` about the origin down to `depth` below it.
/// Order and round-off of fibers are those of OpenSees: both decide which fiber a recorder shows.
fn strips(whole: f64, depth: f64, count: usize) -> impl Iterator<Item = f64> {
    let strip = depth / count as f64;
    let first = 0.5 * (whole - strip);
    (0..count).map(move |i| first - strip * i as f64)
}

/// The section of fibers, with what is left of the words.
fn finished(interp: &mut Tcl, a: &mut Args<'_>, fibers: Vec<Fiber>) -> Result<SharedSection, Exception> {
    let mut torsion = None;
    if a.flag("-GJ") {
        let law: Material = Elastic::new(a.number(&GJ)?).shared();
        torsion = Some((law, 0));
    } else if a.flag("-torsion") {
        torsion = Some(material(interp, a)?);
    }
    let space = interp.host.builder.ndm == 3;
    if space && torsion.is_none() {
        warn_of_torsion(interp, a.last_span())?;
    }
    let bending = if space { FiberBending::Space(torsion) } else { FiberBending::Plane };
    Ok(FiberSection::new(fibers, bending, false).shared())
}

fn wide_flange(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let steel = material(interp, a)?;
    let [d, tw, bf, tf] = a.numbers(&FLANGED)?;
    let dw = d - 2.0 * tf;
    if dw <= 0.0 {
        return Err(a.refuse(format!("the flanges are {tf} thick and the section is {d} deep"), "expected less"));
    }
    let [in_web, in_flange] = a.parts([&NFDW, &NFTF])?;
    let mut across = 1;
    if a.at_number() {
        across = a.parts_of(in_flange, &NFBF)?;
        a.count(&NFTW)?;
    }
    let fiber = |y, z, area| Fiber { y, z, area, material: steel.clone() };
    let area = bf * tf / (in_flange * across) as f64;
    // The lower flange mirrors the upper one, and its fibers follow from the last one back.
    let flange = |z| strips(d, tf, in_flange).map(move |y| (y, z));
    let upper: Vec<(f64, f64)> = strips(bf, bf, across).flat_map(flange).collect();
    let mut fibers: Vec<Fiber> = upper.iter().map(|(y, z)| fiber(*y, *z, area)).collect();
    fibers.extend(strips(dw, dw, in_web).map(|y| fiber(y, 0.0, dw * tw / in_web as f64)));
    fibers.extend(upper.iter().rev().map(|(y, z)| fiber(-y, *z, area)));
    finished(interp, a, fibers)
}

/// Materials of core, cover and bars.
fn concrete(interp: &Tcl, a: &mut Args<'_>) -> Result<[Tagged; 3], Exception> {
    Ok([material(interp, a)?, material(interp, a)?, material(interp, a)?])
}

fn rectangular_concrete(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let [core, cover, steel] = concrete(interp, a)?;
    let [d, b, depth] = a.numbers(&RECTANGLE)?;
    let (inner, width) = (d - 2.0 * depth, b - 2.0 * depth);
    if inner <= 0.0 || width <= 0.0 {
        return Err(a.refuse(format!("the cover of {depth} leaves no core"), "expected less"));
    }
    let [top, bottom, side] = a.numbers(&RECTANGULAR_BARS)?;
    let [in_core, in_cover, bars] = a.parts(RECTANGULAR_PARTS.each_ref())?;
    let mut fibers = vec![];
    let mut add = |y, area, material: &Tagged| fibers.push(Fiber { y, z: 0.0, area, material: material.clone() });
    for (of, wide) in [(&core, width), (&cover, 2.0 * depth)] {
        strips(inner, inner, in_core).for_each(|y| add(y, wide * inner / in_core as f64, of));
    }
    for sign in [1.0, -1.0] {
        strips(d, depth, in_cover).for_each(|y| add(sign * y, b * depth / in_cover as f64, &cover));
    }
    let bar = 0.5 * d - depth;
    add(bar, bars as f64 * top, &steel);
    add(-bar, bars as f64 * bottom, &steel);
    for i in 1..bars.saturating_sub(1) {
        add(-bar + inner / (bars - 1) as f64 * i as f64, 2.0 * side, &steel);
    }
    finished(interp, a, fibers)
}

fn circular_concrete(interp: &mut Tcl, a: &mut Args<'_>) -> Result<SharedSection, Exception> {
    let [core, cover, steel] = concrete(interp, a)?;
    let (d, depth) = (a.number(&RCCIRCULAR_SECTION_D)?, a.number(&COVER_DEPTH)?);
    let radius = 0.5 * d - depth;
    if radius <= 0.0 {
        return Err(a.refuse(format!("the cover of {depth} leaves no core"), "expected less"));
    }
    let bar = a.number(&AS)?;
    let [rings_core, rings_cover, wedges] = a.parts(CIRCULAR_PARTS.each_ref())?;
    let [bars] = a.parts([&BARS])?;
    let mut fibers = vec![];
    let mut ring = |at: f64, area: f64, count: usize, material: &Tagged| {
        let half = PI / count as f64;
        let mut angle = half;
        for _ in 0..count {
            fibers.push(Fiber { y: at * angle.cos(), z: at * angle.sin(), area, material: material.clone() });
            angle += 2.0 * half;
        }
    };
    // Area and centroid of a sector.
    let half = PI / wedges as f64;
    let sector = |r: f64| (r * r * half, 2.0 / 3.0 * r * half.sin() / half);
    for (from, to, rings, of) in [(0.0, radius, rings_core, &core), (radius, 0.5 * d, rings_cover, &cover)] {
        let step = (to - from) / rings as f64;
        for i in 0..rings {
            let ((hole, hole_at), (whole, whole_at)) =
                (sector(from + step * i as f64), sector(from + step * (i + 1) as f64));
            let area = whole - hole;
            ring((whole_at * whole - hole_at * hole) / area, area, wedges, of);
        }
    }
    ring(radius, bar, bars, &steel);
    finished(interp, a, fibers)
}
