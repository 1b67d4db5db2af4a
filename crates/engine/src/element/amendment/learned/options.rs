//! A learned law as options with words, for scripts and files.

use super::history::Scales;
use super::law::{Channel, ChannelForce, Factor, LearnedLaw, Piece, Shape, Target};
use super::passive::Refusal;
use super::variable::Variable;
use std::collections::BTreeMap;

/// An option of a law with its words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LawOption {
    /// Its name, such as `-factor`.
    pub name: String,
    /// Words after it.
    pub words: Vec<String>,
}

/// Names of the options with what follows them; those that may be repeated are marked.
pub const OPTIONS: &[(&str, &str, bool)] = &[
    ("-range", "$U $V $T", false),
    ("-work", "$D", false),
    ("-spring", "$k", false),
    ("-piece", "$side $at $k", true),
    ("-moving", "$k", false),
    ("-hysteresis", "bilinear|boucWen|curve|own $level $strength", false),
    ("-curve", "$slope ...", false),
    ("-unequal", "$strength", false),
    ("-stop", "$level $strength", true),
    ("-maxwell", "$time $k", true),
    ("-dashpot", "$power $c", true),
    ("-viscous", "$width $force", true),
    ("-channel", "$name $mean $deviation", true),
    ("-factor", "elastic|hysteretic|viscous|whole|strength $variable <$parameter ...> $a $low $high", true),
    ("-force", "$channel $a $low $high", true),
    ("-beyond", "clamp|continue", false),
];

/// Number of the option in [`OPTIONS`], and of the word after it where one is to blame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OptionError {
    /// Index among the given options; none where one is missing.
    pub option: Option<usize>,
    /// Index of the word; none for the whole option.
    pub word: Option<usize>,
    /// Reason.
    pub message: String,
}

/// Names of the variables, and the names of their parameters.
pub const VARIABLES: &[(&str, &[&str])] = &[
    ("deformation", &["power"]),
    ("side", &[]),
    ("sideOver", &["time"]),
    ("place", &["place", "width"]),
    ("time", &[]),
    ("timeSaturating", &["constant"]),
    ("timeStep", &["at"]),
    ("work", &[]),
    ("workSaturating", &["constant"]),
    ("recentWork", &["time"]),
    ("recentWorkSoftening", &["time"]),
    ("largest", &[]),
    ("largestOfSide", &[]),
    ("largestDecay", &["constant"]),
    ("largestDecayOfSide", &["constant"]),
    ("virgin", &["power"]),
    ("pinching", &["width"]),
    ("rate", &["reference"]),
    ("rateOver", &["reference", "time"]),
    ("rest", &["length", "time"]),
    ("still", &["length", "time"]),
    ("channel", &["name"]),
    ("channelSquare", &["name"]),
    ("channelLate", &["name", "time"]),
];

impl Variable {
    /// The variable by its name, numbers and channel.
    pub fn of(name: &str, p: &[f64], channel: usize) -> Option<Self> {
        let n = |i: usize| p.get(i).copied().unwrap_or(f64::NAN);
        Some(match name {
            "deformation" => Self::Deformation { power: n(0) },
            "side" => Self::Side,
            "sideOver" => Self::SideOver { constant: n(0) },
            "place" => Self::Place { place: n(0), width: n(1) },
            "time" => Self::Time,
            "timeSaturating" => Self::TimeSaturating { constant: n(0) },
            "timeStep" => Self::TimeStep { at: n(0) },
            "work" => Self::Work,
            "workSaturating" => Self::WorkSaturating { constant: n(0) },
            "recentWork" => Self::RecentWork { constant: n(0) },
            "recentWorkSoftening" => Self::RecentWorkSoftening { constant: n(0) },
            "largest" => Self::Largest,
            "largestOfSide" => Self::LargestOfSide,
            "largestDecay" => Self::LargestDecay { constant: n(0) },
            "largestDecayOfSide" => Self::LargestDecayOfSide { constant: n(0) },
            "virgin" => Self::Virgin { power: n(0) },
            "pinching" => Self::Pinching { width: n(0) },
            "rate" => Self::Rate { reference: n(0) },
            "rateOver" => Self::RateOver { reference: n(0), constant: n(1) },
            "rest" => Self::Rest { length: n(0), time: n(1) },
            "still" => Self::Still { length: n(0), time: n(1) },
            "channel" => Self::Channel { channel },
            "channelSquare" => Self::ChannelSquare { channel },
            "channelLate" => Self::ChannelLate { channel, constant: n(0) },
            _ => return None,
        })
    }

    /// Name in a script, and its numbers.
    pub fn words(self) -> (&'static str, Vec<f64>) {
        match self {
            Self::Deformation { power } => ("deformation", vec![power]),
            Self::Side => ("side", vec![]),
            Self::SideOver { constant } => ("sideOver", vec![constant]),
            Self::Place { place, width } => ("place", vec![place, width]),
            Self::Time => ("time", vec![]),
            Self::TimeSaturating { constant } => ("timeSaturating", vec![constant]),
            Self::TimeStep { at } => ("timeStep", vec![at]),
            Self::Work => ("work", vec![]),
            Self::WorkSaturating { constant } => ("workSaturating", vec![constant]),
            Self::RecentWork { constant } => ("recentWork", vec![constant]),
            Self::RecentWorkSoftening { constant } => ("recentWorkSoftening", vec![constant]),
            Self::Largest => ("largest", vec![]),
            Self::LargestOfSide => ("largestOfSide", vec![]),
            Self::LargestDecay { constant } => ("largestDecay", vec![constant]),
            Self::LargestDecayOfSide { constant } => ("largestDecayOfSide", vec![constant]),
            Self::Virgin { power } => ("virgin", vec![power]),
            Self::Pinching { width } => ("pinching", vec![width]),
            Self::Rate { reference } => ("rate", vec![reference]),
            Self::RateOver { reference, constant } => ("rateOver", vec![reference, constant]),
            Self::Rest { length, time } => ("rest", vec![length, time]),
            Self::Still { length, time } => ("still", vec![length, time]),
            Self::Channel { .. } => ("channel", vec![]),
            Self::ChannelSquare { .. } => ("channelSquare", vec![]),
            Self::ChannelLate { constant, .. } => ("channelLate", vec![constant]),
        }
    }
}

const TARGETS: [(&str, Target); 5] = [
    ("elastic", Target::Elastic),
    ("hysteretic", Target::Hysteretic),
    ("viscous", Target::Viscous),
    ("whole", Target::Whole),
    ("strength", Target::Strength),
];

impl Target {
    /// Name in a script.
    pub fn word(self) -> &'static str {
        TARGETS.iter().find(|(_, t)| *t == self).map_or("", |(name, _)| name)
    }

    /// Name in a sentence.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::Elastic => "elastic stiffness",
            Self::Hysteretic => "hysteretic force",
            Self::Viscous => "viscous force",
            Self::Whole => "whole force",
            Self::Strength => "strength",
        }
    }
}

/// Reader of options into a law.
struct Reader<'a> {
    options: &'a [LawOption],
    /// Indices of the options by name.
    by_name: BTreeMap<&'a str, Vec<usize>>,
}

impl<'a> Reader<'a> {
    fn new(options: &'a [LawOption]) -> Result<Self, OptionError> {
        let mut by_name: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (i, o) in options.iter().enumerate() {
            let fail = |message: String| OptionError { option: Some(i), word: None, message };
            let Some((.., repeats)) = OPTIONS.iter().find(|(name, ..)| *name == o.name) else {
                return Err(fail(format!("a learned law has no option {}", o.name)));
            };
            let places = by_name.entry(&o.name).or_default();
            places.push(i);
            if places.len() > 1 && !repeats {
                return Err(fail(format!("{} stands twice", o.name)));
            }
        }
        Ok(Self { options, by_name })
    }

    fn all(&self, name: &str) -> &[usize] {
        self.by_name.get(name).map_or(&[], Vec::as_slice)
    }

    fn number(&self, option: usize, word: usize) -> Result<f64, OptionError> {
        let o = &self.options[option];
        let fail = |message: String| OptionError { option: Some(option), word: Some(word), message };
        let Some(text) = o.words.get(word) else {
            let usage = OPTIONS.iter().find(|(name, ..)| *name == o.name).map_or("", |(_, usage, _)| usage);
            return Err(OptionError {
                option: Some(option),
                word: None,
                message: format!("expected {} {usage}", o.name),
            });
        };
        let x: Option<f64> = text.parse().ok().filter(|x: &f64| x.is_finite());
        x.ok_or_else(|| fail(format!("\"{text}\" is no finite number")))
    }

    /// Numbers of an option that has exactly so many.
    fn numbers<const N: usize>(&self, option: usize) -> Result<[f64; N], OptionError> {
        let mut out = [0.0; N];
        for (i, x) in out.iter_mut().enumerate() {
            *x = self.number(option, i)?;
        }
        self.ends(option, N)?;
        Ok(out)
    }

    fn ends(&self, option: usize, count: usize) -> Result<(), OptionError> {
        let o = &self.options[option];
        let message = || format!("one word too many for {}", o.name);
        let error = || OptionError { option: Some(option), word: Some(count), message: message() };
        if o.words.len() > count { Err(error()) } else { Ok(()) }
    }

    fn one<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, OptionError> {
        self.all(name).first().map(|i| self.numbers(*i)).transpose()
    }

    fn each<const N: usize>(&self, name: &str) -> Result<Vec<[f64; N]>, OptionError> {
        self.all(name).iter().map(|i| self.numbers(*i)).collect()
    }

    fn needed<const N: usize>(&self, name: &str) -> Result<[f64; N], OptionError> {
        let missing = || OptionError { option: None, word: None, message: format!("{name} is missing") };
        self.one(name)?.ok_or_else(missing)
    }

    fn word(&self, option: usize, word: usize, what: &str) -> Result<&'a str, OptionError> {
        let fail = || OptionError { option: Some(option), word: None, message: format!("the {what} is missing") };
        self.options[option].words.get(word).map(String::as_str).ok_or_else(fail)
    }

    fn unknown(option: usize, word: usize, what: &str, known: &[&str]) -> OptionError {
        let message = format!("unknown {what}; expected one of {}", known.join(", "));
        OptionError { option: Some(option), word: Some(word), message }
    }

    fn channel(&self, option: usize, word: usize, channels: &[Channel]) -> Result<usize, OptionError> {
        let name = self.word(option, word, "name of the channel")?;
        let known: Vec<&str> = channels.iter().map(|c| c.name.as_str()).collect();
        let found = channels.iter().position(|c| c.name == name);
        found.ok_or_else(|| Self::unknown(option, word, "channel", &known))
    }

    fn shape(&self) -> Result<(Shape, f64, f64), OptionError> {
        let missing = || OptionError { option: None, word: None, message: "-hysteresis is missing".into() };
        let i = *self.all("-hysteresis").first().ok_or_else(missing)?;
        let curve = self.all("-curve").first();
        let shape = match self.word(i, 0, "form")? {
            "bilinear" => Shape::Bilinear,
            "boucWen" => Shape::BoucWen,
            "own" => Shape::Own,
            "curve" => {
                let missing = || OptionError { option: Some(i), word: Some(0), message: "-curve is missing".into() };
                let at = *curve.ok_or_else(missing)?;
                let count = self.options[at].words.len();
                Shape::Curve((0..count).map(|k| self.number(at, k)).collect::<Result<_, _>>()?)
            }
            _ => return Err(Self::unknown(i, 0, "form", &["bilinear", "boucWen", "curve", "own"])),
        };
        if let Some(at) = curve.filter(|_| !matches!(shape, Shape::Curve(_))) {
            let message = "-curve belongs to -hysteresis curve".into();
            return Err(OptionError { option: Some(*at), word: None, message });
        }
        let (level, strength) = (self.number(i, 1)?, self.number(i, 2)?);
        self.ends(i, 3)?;
        if level <= 0.0 {
            return Err(OptionError { option: Some(i), word: Some(1), message: "the level is not above 0".into() });
        }
        Ok((shape, level, strength))
    }

    fn factor(&self, option: usize, channels: &[Channel]) -> Result<Factor, OptionError> {
        let target = self.word(option, 0, "part")?;
        let targets = TARGETS.map(|(name, _)| name);
        let target = TARGETS.iter().find(|(name, _)| *name == target).map(|(_, t)| *t);
        let target = target.ok_or_else(|| Self::unknown(option, 0, "part", &targets))?;
        let name = self.word(option, 1, "variable")?;
        let names: Vec<&str> = VARIABLES.iter().map(|(name, _)| *name).collect();
        let (_, parameters) = VARIABLES
            .iter()
            .find(|(known, _)| *known == name)
            .ok_or_else(|| Self::unknown(option, 1, "variable", &names))?;
        let (mut at, mut channel, mut numbers) = (2, 0, vec![]);
        for parameter in *parameters {
            if *parameter == "name" {
                channel = self.channel(option, at, channels)?;
            } else {
                let x = self.number(option, at)?;
                let least = if *parameter == "power" { 1.0 } else { 0.0 };
                let is_place = *parameter == "place";
                if !is_place && (x < least || (x == 0.0 && *parameter != "at")) {
                    let message = format!("the {parameter} is {x}; expected at least {least}, and not 0");
                    return Err(OptionError { option: Some(option), word: Some(at), message });
                }
                numbers.push(x);
            }
            at += 1;
        }
        let [coefficient, low, high] =
            [self.number(option, at)?, self.number(option, at + 1)?, self.number(option, at + 2)?];
        self.ends(option, at + 3)?;
        if low > high {
            let message = "the least value is above the largest".into();
            return Err(OptionError { option: Some(option), word: Some(at + 1), message });
        }
        let unknown = || Self::unknown(option, 1, "variable", &names);
        let variable = Variable::of(name, &numbers, channel).ok_or_else(unknown)?;
        Ok(Factor { target, variable, coefficient, range: [low, high] })
    }

    fn law(&self) -> Result<LearnedLaw, OptionError> {
        let [deformation, speed, duration] = self.needed("-range")?;
        if [deformation, speed, duration].iter().any(|x| *x <= 0.0) {
            let option = self.all("-range").first().copied();
            return Err(OptionError { option, word: None, message: "expected numbers above 0".into() });
        }
        let (shape, level, strength) = self.shape()?;
        let work = self.one("-work")?.map_or(deformation * deformation, |[w]: [f64; 1]| w);
        if work <= 0.0 {
            let option = self.all("-work").first().copied();
            return Err(OptionError { option, word: Some(0), message: "expected work above 0".into() });
        }
        let mut channels: Vec<Channel> = vec![];
        for i in self.all("-channel") {
            let name = self.word(*i, 0, "name of the channel")?.to_owned();
            let (mean, deviation) = (self.number(*i, 1)?, self.number(*i, 2)?);
            self.ends(*i, 3)?;
            if deviation <= 0.0 || channels.iter().any(|c| c.name == name) {
                let message = "expected another name, and a deviation above 0".into();
                return Err(OptionError { option: Some(*i), word: None, message });
            }
            channels.push(Channel { name, mean, deviation });
        }
        let force = |i: &usize| -> Result<ChannelForce, OptionError> {
            let channel = self.channel(*i, 0, &channels)?;
            let [coefficient, low, high] = [self.number(*i, 1)?, self.number(*i, 2)?, self.number(*i, 3)?];
            self.ends(*i, 4)?;
            Ok(ChannelForce { channel, coefficient, range: [low.min(high), high.max(low)] })
        };
        let goes_on = match self.all("-beyond").first() {
            None => false,
            Some(i) => match self.word(*i, 0, "word")? {
                "clamp" => false,
                "continue" => true,
                _ => return Err(Self::unknown(*i, 0, "word", &["clamp", "continue"])),
            },
        };
        let pieces = self.each("-piece")?.into_iter();
        Ok(LearnedLaw {
            scales: Scales { deformation, speed, duration, work, level },
            spring: self.one("-spring")?.map_or(0.0, |[k]: [f64; 1]| k),
            pieces: pieces.map(|[side, at, stiffness]| Piece { side, at, stiffness }).collect(),
            moving: self.one("-moving")?.map_or(0.0, |[k]: [f64; 1]| k),
            shape,
            strength,
            unequal: self.one("-unequal")?.map_or(0.0, |[k]: [f64; 1]| k),
            stops: self.each("-stop")?,
            maxwell: self.each("-maxwell")?,
            dashpots: self.each("-dashpot")?,
            viscous: self.each("-viscous")?,
            factors: self.all("-factor").iter().map(|i| self.factor(*i, &channels)).collect::<Result<_, _>>()?,
            forces: self.all("-force").iter().map(force).collect::<Result<_, _>>()?,
            channels,
            goes_on,
        })
    }
}

impl LearnedLaw {
    /// The law of some options.
    ///
    /// # Errors
    /// An option that is unknown, incomplete or missing; a law that makes energy.
    pub fn of_options(options: &[LawOption]) -> Result<Self, OptionError> {
        let reader = Reader::new(options)?;
        let law = reader.law()?;
        match law.refusal() {
            None => Ok(law),
            Some(Refusal { option, place, message }) => {
                Err(OptionError { option: reader.all(option).get(place).copied(), word: None, message })
            }
        }
    }

    /// Options that make the law again. Numbers are those of the law, to the last bit.
    pub fn options(&self) -> Vec<LawOption> {
        let mut out: Vec<LawOption> = vec![];
        let mut add = |name: &str, words: Vec<String>| out.push(LawOption { name: name.into(), words });
        let numbers = |x: &[f64]| x.iter().map(f64::to_string).collect::<Vec<_>>();
        let s = &self.scales;
        add("-range", numbers(&[s.deformation, s.speed, s.duration]));
        add("-work", numbers(&[s.work]));
        let lone = [("-spring", self.spring), ("-moving", self.moving), ("-unequal", self.unequal)];
        lone.into_iter().filter(|(_, x)| *x != 0.0).for_each(|(name, x)| add(name, numbers(&[x])));
        self.pieces.iter().for_each(|p| add("-piece", numbers(&[p.side, p.at, p.stiffness])));
        let form = match &self.shape {
            Shape::Bilinear => "bilinear",
            Shape::BoucWen => "boucWen",
            Shape::Own => "own",
            Shape::Curve(knots) => {
                add("-curve", numbers(knots));
                "curve"
            }
        };
        add("-hysteresis", [vec![form.to_owned()], numbers(&[s.level, self.strength])].concat());
        let lists = [
            ("-stop", &self.stops),
            ("-maxwell", &self.maxwell),
            ("-dashpot", &self.dashpots),
            ("-viscous", &self.viscous),
        ];
        for (name, list) in lists {
            list.iter().for_each(|x| add(name, numbers(x)));
        }
        for c in &self.channels {
            add("-channel", [vec![c.name.clone()], numbers(&[c.mean, c.deviation])].concat());
        }
        let channel = |i: usize| self.channels.get(i).map(|c| c.name.clone());
        for f in &self.factors {
            let (name, parameters) = f.variable.words();
            let mut words = vec![f.target.word().to_owned(), name.to_owned()];
            words.extend(f.variable.channel().and_then(channel));
            words.extend(numbers(&parameters));
            words.extend(numbers(&[f.coefficient, f.range[0], f.range[1]]));
            add("-factor", words);
        }
        for f in &self.forces {
            let words = channel(f.channel).into_iter().chain(numbers(&[f.coefficient, f.range[0], f.range[1]]));
            add("-force", words.collect());
        }
        if self.goes_on {
            add("-beyond", vec!["continue".into()]);
        }
        out
    }
}
