use super::*;
use crate::amplify::count::LevelCounts;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, EdgeSplit, Face, FaceSplit, Inner, NONE, SplitMark};

#[test]
fn rows_have_no_holes_and_no_borders_within() {
    let layouts = [
        EdgeJoins::LAYOUT,
        EdgeState::LAYOUT,
        FaceSides::LAYOUT,
        FaceCorners::LAYOUT,
        VertexCore::LAYOUT,
        LevelCounts::LAYOUT,
        BlockCounts::LAYOUT,
        LevelSizes::LAYOUT,
        LevelArgs::LAYOUT,
    ];
    for RowLayout {
        name,
        size,
        members,
    } in layouts
    {
        assert!(size.is_power_of_two() && size >= 16, "{name}: {size}");
        let mut end = 0;
        for &(member, offset, bytes) in members {
            assert_eq!(offset, end, "{name}.{member}");
            end += bytes;
        }
        assert_eq!(end, size, "{name}");
    }
}

#[test]
fn edges_come_back_from_their_rows() {
    for kind in [EdgeKind::Terrain, EdgeKind::River, EdgeKind::Gully] {
        for mark in [SplitMark::Leaf, SplitMark::Halo, SplitMark::Split] {
            let edge = Edge {
                arriving: 77,
                birth: 17,
                ..Edge::new(kind, [3, 5], [8, NONE])
            };
            let split = EdgeSplit {
                mid: if mark == SplitMark::Leaf { 0 } else { 9 },
                child: if mark == SplitMark::Split { 12 } else { 0 },
                mark,
            };
            let rows = (EdgeJoins::from(&edge), EdgeState::from((&edge, &split)));
            assert_eq!(Edge::from(rows), edge);
            assert_eq!(EdgeSplit::from(rows.1), split);
        }
    }
}

#[test]
fn faces_come_back_from_their_rows() {
    let inners = [
        [Inner::Terrain, Inner::RiverToFirst, Inner::RiverToSecond],
        [Inner::GullyToFirst, Inner::GullyToSecond, Inner::Terrain],
    ];
    for inner in inners {
        for mark in [SplitMark::Leaf, SplitMark::Halo, SplitMark::Split] {
            let face = Face {
                vertices: [3, 5, 7],
                edges: [2, 4, 6],
            };
            let child = if mark == SplitMark::Split { 16 } else { 0 };
            let split = FaceSplit { child, inner, mark };
            let sides = FaceSides::from((&face, &split, 2));
            let rows = (sides, FaceCorners::from((&face, &split)));
            assert_eq!(Face::from(rows), face);
            assert_eq!(FaceSplit::from(rows), split);
        }
    }
}

/// Numbers of kinds that there are not, as of a broken buffer.
#[test]
fn any_words_are_rows() {
    let words = [u32::MAX; 12];
    assert_eq!(from_words::<EdgeState>(&words).len(), 3);
    for state in from_words::<EdgeState>(&words) {
        let edge = Edge::from((EdgeJoins::default(), state));
        assert_eq!((edge.kind, edge.birth), (EdgeKind::Terrain, 255));
        assert_eq!(EdgeSplit::from(state), EdgeSplit::default());
    }
    let sides = from_words::<FaceSides>(&words)[0];
    let corners = from_words::<FaceCorners>(&words[..5])[1];
    assert_eq!(corners.vertices, [u32::MAX, 0, 0]);
    assert_eq!(FaceSplit::from((sides, corners)).inner, [Inner::Terrain; 3]);
}
