//! Circles of imports.

use super::imports::Import;
use std::collections::{BTreeMap, BTreeSet};

/// The groups of rooms that reach each other, as the imports among them: the first of one file by
/// another. `room` is the room that a file lies in.
pub fn circles(imports: &[Import], room: impl Fn(&str) -> String) -> Vec<Vec<Import>> {
    let rooms = |import: &Import| (room(&import.from), room(&import.to));
    let reach = Reach::new(imports.iter().map(rooms));
    let mut pairs = BTreeSet::new();
    let mut found: Vec<Vec<Import>> = Vec::new();
    for import in imports {
        let (from, to) = rooms(import);
        let is_first = pairs.insert((&import.from, &import.to));
        if !is_first || from == to || !reach.meet(&from, &to) {
            continue;
        }
        let circle = found
            .iter_mut()
            .find(|circle| reach.meet(&rooms(&circle[0]).0, &from));
        match circle {
            Some(circle) => circle.push(import.clone()),
            None => found.push(vec![import.clone()]),
        }
    }
    found
}

/// All rooms that can be reached from each in one step or more.
struct Reach(BTreeMap<String, BTreeSet<String>>);

impl Reach {
    fn new(arrows: impl Iterator<Item = (String, String)>) -> Self {
        let mut next: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (from, to) in arrows.filter(|(from, to)| from != to) {
            next.entry(from).or_default().insert(to);
        }
        let reach = next
            .keys()
            .map(|start| (start.clone(), reachable(&next, start)));
        Self(reach.collect())
    }

    fn leads(&self, from: &str, to: &str) -> bool {
        self.0.get(from).is_some_and(|reached| reached.contains(to))
    }

    fn meet(&self, a: &str, b: &str) -> bool {
        self.leads(a, b) && self.leads(b, a)
    }
}

fn reachable(next: &BTreeMap<String, BTreeSet<String>>, start: &str) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut open: Vec<&String> = next[start].iter().collect();
    while let Some(place) = open.pop() {
        if reached.insert(place.clone()) {
            open.extend(next.get(place).into_iter().flatten());
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;

    fn import((from, to): (&str, &str)) -> Import {
        Import {
            from: from.into(),
            line: 1,
            text: String::new(),
            to: to.into(),
        }
    }

    #[test]
    fn each_group_of_rooms_that_reach_each_other_is_one_circle() {
        let arrows = [
            ("a/x", "b/x"),
            ("b/x", "c/x"),
            ("c/x", "a/y"),
            ("c/x", "d/x"),
            ("d/x", "e/x"),
            ("e/x", "d/y"),
            ("a/x", "a/y"),
        ];
        let imports = arrows.map(import);
        let found = circles(&imports, |file| file[..1].into());
        assert_eq!(found, [imports[..3].to_vec(), imports[4..6].to_vec()]);
        // Files are smaller rooms: no file leads back to itself.
        assert!(circles(&imports, |file| file.into()).is_empty());
    }
}
