//! The passes that know the rules of the ground, as their Rust twins do them.

use super::columns::{edge_joins, edge_states, face_corners, face_sides, stale};
use super::level::MarkedLevel;
use super::pass::PassCase;
use pangaea_shaders::amplify::carve::{Carved, carve_all};
use pangaea_shaders::amplify::edge_split::edge_split;
use pangaea_shaders::amplify::face_decide::face_decide;
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::rows::{
    EdgeState, Row, VertexCore, VertexCourse, VertexLand, VertexRiver, words,
};
use pangaea_shaders::amplify::rules::ocean::{OceanCache, swell};
use pangaea_shaders::amplify::show::show_all;
use pangaea_shaders::amplify::topology::{Edge, Level};
use pangaea_shaders::amplify::uniform::LevelUniform;
use pangaea_shaders::amplify::vertex::Vertex;
use pangaea_shaders::amplify::vertex_resolve::vertex_resolve;
use pangaea_shaders::amplify::vertices::Vertices;

/// Words of the columns of all vertices.
#[derive(Clone, Default)]
pub(super) struct VertexWords {
    pub(super) cores: Vec<u32>,
    pub(super) courses: Vec<u32>,
    pub(super) lands: Vec<u32>,
    pub(super) rivers: Vec<u32>,
}

impl VertexWords {
    /// Adds vertices, whose kind is that before any face settled them.
    pub(super) fn add<'v>(&mut self, vertices: impl IntoIterator<Item = &'v Vertex>) {
        let mut cache = OceanCache::default();
        for vertex in vertices {
            let land = VertexLand::from((vertex, swell(&mut cache, vertex)));
            self.cores.extend(words([VertexCore::from(vertex)]));
            self.courses
                .extend(words([VertexCourse::from((vertex, vertex.kind))]));
            self.lands.extend(words([land]));
            self.rivers.extend(words([VertexRiver::from(vertex)]));
        }
    }

    /// Takes the rivers of the last vertices anew.
    fn settle<'v>(&mut self, first: u32, vertices: impl IntoIterator<Item = &'v Vertex>) {
        self.rivers.truncate(first as usize * size::<VertexRiver>());
        let rows = vertices.into_iter().map(VertexRiver::from);
        self.rivers.extend(words(rows));
    }

    /// The same with stale rows for so many vertices more.
    fn longer(&self, count: usize) -> Self {
        let mut longer = self.clone();
        longer.cores.extend(stale(count * size::<VertexCore>()));
        longer.courses.extend(stale(count * size::<VertexCourse>()));
        longer.lands.extend(stale(count * size::<VertexLand>()));
        longer.rivers.extend(stale(count * size::<VertexRiver>()));
        longer
    }

    fn named(self) -> [(&'static str, Vec<u32>); 4] {
        [
            ("vertex_cores", self.cores),
            ("vertex_courses", self.courses),
            ("vertex_lands", self.lands),
            ("vertex_rivers", self.rivers),
        ]
    }
}

/// Words of a row.
const fn size<R: Row>() -> usize {
    R::LAYOUT.size / 4
}

/// Makes the vertices of a level and settles them and the faces beside them; `check` is given each
/// pass. `rows` are those of all vertices.
pub(super) fn make_vertices<'a>(
    uniform: LevelUniform,
    view: &View,
    marked: &mut MarkedLevel<'a>,
    [halved, decided]: [&[u32]; 2],
    vertices: &mut Vertices,
    rows: &mut VertexWords,
    check: &mut impl FnMut(&PassCase),
) {
    let first = vertices.len() as u32;
    check(&split_edges(uniform, marked, halved, vertices, rows));
    check(&decide_faces(uniform, marked, decided, vertices, rows));
    let before = rows.clone();
    vertex_resolve(uniform, marked.level, halved, vertices);
    let made = || vertices.iter().skip(first as usize);
    rows.settle(first, made());
    check(&resolved(marked, halved, before, rows));
    let carved = carve_all(uniform.scale, uniform.rules, made());
    let shown = show_all(uniform.scale, uniform.rules, view, made(), &carved);
    let [carved, shown] = [carved, shown].map(|column| Finished::new(first, column));
    let [cores, courses, lands, rivers] = rows.clone().named();
    let (before, after) = (("carved", carved.before), ("carved", carved.after));
    let reads = [cores, courses, lands, rivers];
    let [a, b, c, d] = reads.clone();
    check(&marked.case(
        "carve_all",
        marked.args().halved,
        [a, b, c, d, before],
        [after.clone()],
    ));
    let [a, b, c, d] = reads;
    check(&marked.case(
        "show_all",
        marked.args().halved,
        [a, b, c, d, after, ("shown", shown.before)],
        [("shown", shown.after)],
    ));
}

/// Ground and water of all vertices, of which a pass writes the last.
struct Finished {
    before: Vec<u32>,
    after: Vec<u32>,
}

impl Finished {
    /// Those from number `first` on are given.
    fn new(first: u32, made: Vec<Carved>) -> Self {
        let older = stale(size::<Carved>() * first as usize);
        let made = words(made);
        Self {
            before: [older.clone(), stale(made.len())].concat(),
            after: [older, made].concat(),
        }
    }
}

fn split_edges<'a>(
    uniform: LevelUniform,
    marked: &MarkedLevel<'a>,
    halved: &[u32],
    vertices: &mut Vertices,
    rows: &mut VertexWords,
) -> PassCase<'a> {
    let mesh = marked.level.mesh.clone();
    let before = rows.longer(halved.len());
    let (coarser, new) = vertices.append(halved.len());
    edge_split(uniform, &mesh, coarser, halved, new);
    rows.add(&*new);
    let level = &*marked.level;
    let [cores, courses, lands, rivers] = before.named();
    marked.case(
        "edge_split",
        marked.args().halved,
        [
            ("edge_joins", edge_joins(&mesh.edges)),
            ("edge_states", words(edge_states(level))),
            ("face_corners", words(face_corners(level))),
            ("halved", halved.to_vec()),
            cores,
            courses,
            lands,
            rivers,
        ],
        rows.clone().named(),
    )
}

fn decide_faces<'a>(
    uniform: LevelUniform,
    marked: &mut MarkedLevel<'a>,
    decided: &[u32],
    vertices: &Vertices,
    rows: &VertexWords,
) -> PassCase<'a> {
    let before = face_sides(marked.level);
    let Level {
        mesh, edges, faces, ..
    } = &mut *marked.level;
    face_decide(uniform, mesh, edges, vertices.view(), decided, faces);
    let level = &*marked.level;
    marked.case(
        "face_decide",
        marked.args().decided,
        [
            ("vertex_cores", rows.cores.clone()),
            ("vertex_courses", rows.courses.clone()),
            ("edge_joins", edge_joins(&level.mesh.edges)),
            ("edge_states", words(edge_states(level))),
            ("face_corners", words(face_corners(level))),
            ("decided", decided.to_vec()),
            ("face_sides", words(before)),
        ],
        [("face_sides", words(face_sides(level)))],
    )
}

fn resolved<'a>(
    marked: &MarkedLevel<'a>,
    halved: &[u32],
    before: VertexWords,
    after: &VertexWords,
) -> PassCase<'a> {
    let level = &*marked.level;
    marked.case(
        "vertex_resolve",
        marked.args().halved,
        [
            ("vertex_cores", before.cores),
            ("vertex_courses", before.courses),
            ("edge_joins", edge_joins(&level.mesh.edges)),
            ("edge_states", words(edge_states(level))),
            ("face_sides", words(face_sides(level))),
            ("face_corners", words(face_corners(level))),
            ("halved", halved.to_vec()),
            ("vertex_rivers", before.rivers),
        ],
        [("vertex_rivers", after.rivers.clone())],
    )
}

impl<'a> MarkedLevel<'a> {
    /// The halves of its split edges.
    pub(super) fn halves(
        &self,
        rows: &VertexWords,
        halved: &[u32],
        halves: &[Edge],
    ) -> PassCase<'a> {
        let level = &*self.level;
        let states = halves
            .iter()
            .map(|edge| EdgeState::from((edge, &Default::default())));
        let before = stale(4 * halves.len());
        self.case(
            "grow_halves",
            self.args().halved,
            [
                ("vertex_cores", rows.cores.clone()),
                ("vertex_rivers", rows.rivers.clone()),
                ("edge_joins", edge_joins(&level.mesh.edges)),
                ("edge_states", words(edge_states(level))),
                ("face_corners", words(face_corners(level))),
                ("halved", halved.to_vec()),
                ("finer_edge_joins", before.clone()),
                ("finer_edge_states", before),
            ],
            [
                ("finer_edge_joins", edge_joins(halves)),
                ("finer_edge_states", words(states)),
            ],
        )
    }
}
