//! Words with brackets: the form of WKT.

/// Words of the same meaning in both versions of WKT.
const UNIT: [&str; 4] = ["UNIT", "LENGTHUNIT", "ANGLEUNIT", "SCALEUNIT"];

/// A word with what stands in its brackets.
#[derive(Debug, Default, PartialEq)]
pub(super) struct WktNode {
    pub(super) name: String,
    pub(super) texts: Vec<String>,
    pub(super) numbers: Vec<f64>,
    pub(super) nodes: Vec<WktNode>,
}

/// Deepest brackets.
const MOST_LEVELS: usize = 16;

impl WktNode {
    /// The nodes that are the whole text, with commas between them.
    pub(super) fn parse(text: &str) -> Option<Vec<Self>> {
        let mut rest = text.trim();
        let mut nodes = vec![Self::read(&mut rest, 0)?];
        while let Some(more) = rest.trim_start().strip_prefix(',') {
            rest = more;
            nodes.push(Self::read(&mut rest, 0)?);
        }
        rest.trim().is_empty().then_some(nodes)
    }

    /// The node that a text begins with, which is taken off it.
    fn read(rest: &mut &str, level: usize) -> Option<Self> {
        let open = rest.find(['[', '('])?;
        let mut node = Self {
            name: rest[..open].trim().to_ascii_uppercase(),
            ..Self::default()
        };
        *rest = &rest[open + 1..];
        loop {
            *rest = rest.trim_start();
            node.take_argument(rest, level)?;
            *rest = rest.trim_start();
            let end = rest.chars().next()?;
            *rest = &rest[end.len_utf8()..];
            match end {
                ']' | ')' => return Some(node),
                ',' => {}
                _ => return None,
            }
        }
    }

    /// Takes a text, a number, a word or a node off the rest.
    fn take_argument(&mut self, rest: &mut &str, level: usize) -> Option<()> {
        if let Some(quoted) = rest.strip_prefix('"') {
            let end = quoted.find('"')?;
            self.texts.push(quoted[..end].to_string());
            *rest = &quoted[end + 1..];
            return Some(());
        }
        let end = rest.find([',', '[', '(', ']', ')'])?;
        if rest[end..].starts_with(['[', '(']) {
            let level = (level < MOST_LEVELS).then_some(level + 1)?;
            self.nodes.push(Self::read(rest, level)?);
            return Some(());
        }
        // Words, such as those of directions, are passed over.
        self.numbers.extend(rest[..end].trim().parse::<f64>());
        *rest = &rest[end..];
        Some(())
    }

    pub(super) fn child(&self, names: &[&str]) -> Option<&Self> {
        let is_named = |node: &&Self| names.contains(&node.name.as_str());
        self.nodes.iter().find(is_named)
    }

    /// A node however deep.
    pub(super) fn find(&self, names: &[&str]) -> Option<&Self> {
        let below = || self.nodes.iter().find_map(|node| node.find(names));
        self.child(names).or_else(below)
    }

    pub(super) fn title(&self) -> &str {
        self.texts.first().map_or("", String::as_str)
    }

    /// The size of its own unit, or of that of its axes.
    pub(super) fn unit(&self) -> Option<f64> {
        let of_axes = || self.child(&["AXIS"])?.child(&UNIT);
        let node = self.child(&UNIT).or_else(of_axes)?;
        let unit = *node.numbers.first()?;
        (unit.is_finite() && unit > 0.0).then_some(unit)
    }
}
