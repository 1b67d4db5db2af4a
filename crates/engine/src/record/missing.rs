//! What recorders ask for and the model has not.

use crate::model::Tag;

/// Something that a recorder asks for and the model has not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// A node.
    Node(Tag),
    /// An element.
    Element(Tag),
    /// A response of an element.
    Response {
        /// The words that name it.
        words: String,
        /// The element.
        element: Tag,
        /// Its class.
        class: &'static str,
    },
    /// A degree of freedom, from 1, which no node of the recorder has.
    Dof {
        /// The degree of freedom.
        dof: usize,
        /// The first of the nodes.
        node: Tag,
        /// Number of degrees of freedom that it has.
        ndf: usize,
    },
    /// A column, from 1, which no response of the recorder has.
    Column {
        /// The column.
        column: usize,
        /// The words that name the response.
        words: String,
        /// Largest number of columns of one response.
        width: usize,
    },
    /// A drift of two nodes that have no distance in a direction, from 1.
    Drift {
        /// The nodes.
        nodes: (Tag, Tag),
        /// The direction.
        direction: usize,
    },
}

/// Tags that a message lists.
const MAX_LISTED: usize = 5;

impl Missing {
    /// Returns true if the record has a column of zeros in its place.
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Dof { .. })
    }

    /// Words before the tag, the tag, and words behind it. Those with the same words are listed together.
    fn parts(&self) -> (String, String, String) {
        match self {
            Self::Node(tag) => ("node ".into(), tag.to_string(), String::new()),
            Self::Element(tag) => ("element ".into(), tag.to_string(), String::new()),
            Self::Response { words, element, class } => {
                (format!("response \"{words}\" of element "), element.to_string(), format!(" ({class})"))
            }
            Self::Dof { dof, node, ndf } => {
                ("degree of freedom ".into(), dof.to_string(), format!(" at node {node}: it has {ndf}"))
            }
            Self::Column { column, words, width } => {
                ("column ".into(), column.to_string(), format!(" of response \"{words}\": it has {width}"))
            }
            Self::Drift { nodes: (i, j), direction } => (
                "a drift between nodes ".into(),
                format!("{i} and {j}"),
                format!(", which are level in direction {direction}"),
            ),
        }
    }

    /// What is missing, in words that follow "no": tags of a kind are listed together, and only the first of many.
    ///
    /// ```
    /// use hysteron_engine::record::Missing;
    /// let missing: Vec<Missing> = (1..=9).map(Missing::Node).chain([Missing::Element(4)]).collect();
    /// assert_eq!(Missing::list(missing.iter()), "node 1, 2, 3, 4, 5 and 4 more, no element 4");
    /// ```
    pub fn list<'a>(all: impl IntoIterator<Item = &'a Self>) -> String {
        let mut groups: Vec<(String, Vec<String>, String)> = vec![];
        for (before, tag, behind) in all.into_iter().map(Self::parts) {
            match groups.iter_mut().find(|g| g.0 == before && g.2 == behind) {
                Some(group) => group.1.push(tag),
                None => groups.push((before, vec![tag], behind)),
            }
        }
        let group = |(before, tags, behind): &(String, Vec<String>, String)| {
            let listed = tags.iter().take(MAX_LISTED).map(String::as_str).collect::<Vec<_>>().join(", ");
            let more = tags.len().saturating_sub(MAX_LISTED);
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            format!("{before}{listed}{more}{behind}")
        };
        groups.iter().map(group).collect::<Vec<_>>().join(", no ")
    }
}
