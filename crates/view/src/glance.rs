//! A glance at a run in a terminal: the largest displacement so far, and the loop of a bearing.

use crate::devices::{Device, Role};
use crate::scene::{Scene, translations};
use hysteron_engine::analysis::Engine;
use hysteron_engine::number_format::Style;
use std::fmt::Write as _;

/// Points of a loop that are kept, at most.
const MAX_POINTS: usize = 4000;
/// Columns and rows of a loop in letters, each of two by four dots.
const SIZE: (usize, usize) = (36, 9);

/// A look at a run while it works.
#[derive(Debug, Default)]
pub struct Glance {
    model: Option<Watched>,
}

/// The model that is analysed.
#[derive(Debug)]
struct Watched {
    scene: Scene,
    /// Revision of the model that was seen last.
    revision: u64,
    device: Option<(Device, usize)>,
    /// Deformations and forces of the device.
    points: Vec<(f64, f64)>,
    /// Every so many steps are kept.
    every: usize,
    steps: usize,
    /// Largest absolute displacement, its place among the degrees of freedom, and its time.
    largest: (f64, usize, f64),
    buffers: (Vec<f64>, Vec<f64>),
}

impl Watched {
    fn new(engine: &Engine) -> Self {
        let scene = Scene::new(engine);
        let devices = Device::all(engine, &scene, 50);
        let with_role =
            |role: Role| devices.iter().find_map(|d| Some((d, d.directions.iter().position(|(_, own)| *own == role)?)));
        let chosen = with_role(Role::Shear).or_else(|| with_role(Role::Axial)).map(|(d, k)| (d.element, k));
        let device = chosen.and_then(|(at, k)| Some((devices.into_iter().find(|d| d.element == at)?, k)));
        let revision = engine.model().revision();
        Self {
            scene,
            revision,
            device,
            points: vec![],
            every: 1,
            steps: 0,
            largest: (0.0, 0, 0.0),
            buffers: (vec![], vec![]),
        }
    }

    fn step(&mut self, engine: &Engine) {
        let state = engine.state();
        for (at, x) in state.disp.iter().enumerate() {
            // Rotations are angles, and no lengths.
            if x.abs() > self.largest.0 && self.direction(at).is_some() {
                self.largest = (x.abs(), at, state.time);
            }
        }
        self.steps += 1;
        let Some((device, direction)) = self.device.as_ref().filter(|_| self.steps.is_multiple_of(self.every)) else {
            return;
        };
        device.read(engine, &mut self.buffers);
        let row = &self.buffers.1;
        self.points.push((row[*direction], row[device.directions.len() + direction]));
        if self.points.len() > MAX_POINTS {
            let mut n = 0;
            self.points.retain(|_| {
                n += 1;
                n % 2 == 0
            });
            self.every *= 2;
        }
    }

    /// Place of the node and direction of a degree of freedom; none of a rotation.
    fn direction(&self, dof: usize) -> Option<(usize, usize)> {
        let node = self.scene.nodes.partition_point(|n| n.offset <= dof).checked_sub(1)?;
        let n = &self.scene.nodes[node];
        let k = dof - n.offset;
        (k < translations(n.ndf, self.scene.ndm)).then_some((node, k))
    }

    fn text(&self) -> String {
        let mut out = String::new();
        let (size, dof, time) = self.largest;
        if let Some((node, k)) = self.direction(dof).filter(|_| size > 0.0) {
            let (tag, axis) = (self.scene.nodes[node].tag, ["x", "y", "z"][k]);
            let _ = writeln!(out, "largest displacement {} of node {tag} in {axis}, at {}", short(size), short(time));
        }
        let Some((device, direction)) = &self.device else { return out };
        let ends = |of: fn(&(f64, f64)) -> f64| {
            let all = self.points.iter().map(of).filter(|x| x.is_finite());
            all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)))
        };
        let (u, q) = (ends(|p| p.0), ends(|p| p.1));
        if u.0 >= u.1 || q.0 >= q.1 {
            return out;
        }
        let e = &self.scene.elements[device.element];
        let name = &device.directions[*direction].0;
        let _ = writeln!(
            out,
            "element {}, {name}: deformation {} to {}, force {} to {}",
            e.tag,
            short(u.0),
            short(u.1),
            short(q.0),
            short(q.1)
        );
        out + &canvas(&self.points, u, q)
    }
}

/// A number with four digits.
fn short(x: f64) -> String {
    let mut out = String::new();
    Style { precision: 4, scientific: false }.push(x, &mut out);
    out
}

/// Points joined by lines, as letters of Braille.
fn canvas(points: &[(f64, f64)], x: (f64, f64), y: (f64, f64)) -> String {
    /// Bits of the dots of a letter by row and column.
    const DOTS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    let (columns, rows) = SIZE;
    let (width, height) = ((2 * columns - 1) as f64, (4 * rows - 1) as f64);
    let mut letters = vec![vec![0u8; columns]; rows];
    let place = |p: &(f64, f64)| ((p.0 - x.0) / (x.1 - x.0) * width, (y.1 - p.1) / (y.1 - y.0) * height);
    let finite = |p: &&(f64, f64)| p.0.is_finite() && p.1.is_finite();
    let places: Vec<(f64, f64)> = points.iter().filter(finite).map(place).collect();
    for w in places.windows(2) {
        let (dx, dy) = (w[1].0 - w[0].0, w[1].1 - w[0].1);
        let n = dx.abs().max(dy.abs()).ceil().max(1.0);
        for i in 0..=n as usize {
            let part = i as f64 / n;
            let (a, b) = ((w[0].0 + part * dx).round() as usize, (w[0].1 + part * dy).round() as usize);
            letters[b / 4][a / 2] |= DOTS[b % 4][a % 2];
        }
    }
    let letter = |bits: &u8| char::from_u32(0x2800 + u32::from(*bits)).unwrap_or(' ');
    letters.iter().map(|row| row.iter().map(letter).collect::<String>() + "\n").collect()
}

impl Glance {
    /// Look at a step that has been committed.
    pub fn step(&mut self, engine: &Engine) {
        let revision = engine.model().revision();
        let is_same = |m: &mut Watched| {
            let known = m.revision == revision || m.scene.has_parts_of(engine.model());
            m.revision = revision;
            known
        };
        if !self.model.as_mut().is_some_and(is_same) {
            self.model = Some(Watched::new(engine));
        }
        self.model.iter_mut().for_each(|m| m.step(engine));
    }

    /// Lines for a terminal; empty before the first step.
    pub fn text(&self) -> String {
        self.model.as_ref().map_or_else(String::new, Watched::text)
    }
}

#[cfg(test)]
mod tests {
    use super::{SIZE, canvas};

    #[test]
    fn a_square_is_drawn_along_the_edges() {
        let square = [(-1.0, -5.0), (1.0, -5.0), (1.0, 5.0), (-1.0, 5.0), (-1.0, -5.0)];
        let drawn = canvas(&square, (-1.0, 1.0), (-5.0, 5.0));
        let rows: Vec<Vec<char>> = drawn.lines().map(|l| l.chars().collect()).collect();
        assert_eq!((rows[0].len(), rows.len()), SIZE);
        assert_eq!((rows[0][0], rows[0][1], rows[4][0], rows[4][5]), ('\u{284F}', '\u{2809}', '\u{2847}', '\u{2800}'));
        assert_eq!(rows[SIZE.1 - 1][1], '\u{28C0}');
    }
}
