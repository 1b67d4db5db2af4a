//! Advice on channels that no edit of the script changes.

use super::result_file::UnmovedChannel;
use hysteron_identify::study::ObservedChannel;

impl UnmovedChannel {
    /// The advice in words.
    pub(super) fn advice(&self) -> String {
        format!("no effect of the library changes the channel {}: {}", self.channel, self.record_instead)
    }
}

/// Channels with a recorder that would show the effects.
pub(super) fn unmoved_in_words(channels: &[ObservedChannel], script: &str) -> Vec<UnmovedChannel> {
    let element = |o: &ObservedChannel| {
        let line = script.lines().find(|line| line.contains(&o.output))?;
        let words: Vec<&str> = line.split_whitespace().collect();
        let is_element = words.windows(2).any(|w| w[0] == "recorder" && w[1].starts_with("Element"));
        let tag = words.iter().position(|w| *w == "-ele").and_then(|i| words.get(i + 1)).copied().unwrap_or("$tag");
        is_element.then(|| tag.to_owned())
    };
    let one = |o: &ObservedChannel| UnmovedChannel {
        channel: o.channel.clone(),
        record_instead: match element(o) {
            Some(tag) => {
                format!("record the force of its element (recorder Element -ele {tag} force) or a displacement")
            }
            None => {
                "it is imposed, or nothing that can be added acts there; observe a force or a free displacement".into()
            }
        },
    };
    channels.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::unmoved_in_words;
    use hysteron_identify::study::ObservedChannel;

    #[test]
    fn the_element_of_a_recorder_is_named() {
        let script = "recorder Element -file inner.out -time -ele 7 material 1 tangent\nrecorder Node -file u.out -node 2 -dof 1 disp\n";
        let channel = |output: &str| ObservedChannel {
            channel: output.into(),
            unit: String::new(),
            output: output.into(),
            column: 1,
            measure: None,
            at: String::new(),
            weight: 1.0,
            shift: 0.0,
            values: vec![],
            variance: 1.0,
        };
        let told = unmoved_in_words(&[channel("inner.out"), channel("u.out")], script);
        assert!(told[0].record_instead.contains("-ele 7 force"), "{told:?}");
        assert!(told[1].record_instead.starts_with("it is imposed"), "{told:?}");
    }
}
