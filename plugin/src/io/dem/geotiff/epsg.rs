//! EPSG's projected systems that the crate `crs-definitions` does not have: its table is that of an
//! older version of the dataset, and lacks methods that PROJ's texts have no name for.
//!
//! Those whose scale is another than that of the ground, by more than 0.2 % somewhere in the region
//! that they are made for, have their definitions here (EPSG dataset, version 12); of all others it
//! is enough to know that they are true to scale.

/// Code, and text for PROJ.
const DEFINITIONS: [(u16, &str); 26] = [
    // ISN2016 / LAEA Europe.
    (
        9039,
        "+proj=laea +lat_0=52 +lon_0=10 +x_0=4321000 +y_0=3210000 +ellps=GRS80",
    ),
    // ISN2016 / LCC Europe.
    (
        9040,
        "+proj=lcc +lat_0=52 +lon_0=10 +lat_1=35 +lat_2=65 +x_0=4000000 +y_0=2800000 +ellps=GRS80",
    ),
    // WGS 84 / NIWA Albers.
    (
        9191,
        "+proj=aea +lat_0=-40 +lon_0=175 +lat_1=-30 +lat_2=-50 +datum=WGS84",
    ),
    // Hartebeesthoek94 / ZAF BSU Albers 25E.
    (
        9221,
        "+proj=aea +lat_0=-30 +lon_0=25 +lat_1=-22 +lat_2=-38 +x_0=1.4e6 +y_0=1.3e6 +ellps=WGS84",
    ),
    // Hartebeesthoek94 / ZAF BSU Albers 44E.
    (
        9222,
        "+proj=aea +lat_0=-42 +lon_0=44 +lat_1=-34 +lat_2=-50 +x_0=1.2e6 +y_0=1.3e6 +ellps=WGS84",
    ),
    // NAD27 / US National Atlas Equal Area.
    (9311, "+proj=laea +R_A +lat_0=45 +lon_0=-100 +ellps=clrk66"),
    // WGS 84 / IBCSO Polar Stereographic.
    (
        9354,
        "+proj=stere +lat_0=-90 +lat_ts=-65 +lon_0=0 +datum=WGS84",
    ),
    // MAGNA-SIRGAS 2018 / Origen-Nacional.
    (
        9377,
        "+proj=tmerc +lat_0=4 +lon_0=-73 +k=0.9992 +x_0=5000000 +y_0=2000000 +ellps=GRS80",
    ),
    // GDA2020 / Australian Albers.
    (
        9473,
        "+proj=aea +lat_0=0 +lon_0=132 +lat_1=-18 +lat_2=-36 +ellps=GRS80",
    ),
    // RGF93 v2 / Lambert-93.
    (
        9793,
        "+proj=lcc +lat_0=46.5 +lon_0=3 +lat_1=49 +lat_2=44 +x_0=700000 +y_0=6600000 +ellps=GRS80",
    ),
    // RGF93 v2b / Lambert-93.
    (
        9794,
        "+proj=lcc +lat_0=46.5 +lon_0=3 +lat_1=49 +lat_2=44 +x_0=700000 +y_0=6600000 +ellps=GRS80",
    ),
    // NAD83 / TWDB GM.
    (
        10_480,
        "+proj=aea +lat_0=31.25 +lon_0=-100 +lat_1=27.5 +lat_2=35 +x_0=1.5e6 +y_0=6e6 +datum=NAD83",
    ),
    // The same in US survey feet.
    (
        10_481,
        "+proj=aea +lat_0=31.25 +lon_0=-100 +lat_1=27.5 +lat_2=35 +x_0=1.5e6 +y_0=6e6 \
         +datum=NAD83 +units=us-ft",
    ),
    // WGS 84 / GLANCE Africa.
    (10_592, "+proj=laea +lat_0=5 +lon_0=20 +datum=WGS84"),
    // WGS 84 / GLANCE Asia.
    (10_594, "+proj=laea +lat_0=45 +lon_0=100 +datum=WGS84"),
    // WGS 84 / GLANCE Europe.
    (10_596, "+proj=laea +lat_0=55 +lon_0=20 +datum=WGS84"),
    // WGS 84 / GLANCE North America.
    (10_598, "+proj=laea +lat_0=50 +lon_0=-100 +datum=WGS84"),
    // WGS 84 / GLANCE Oceania.
    (10_601, "+proj=laea +lat_0=-15 +lon_0=135 +datum=WGS84"),
    // WGS 84 / GLANCE South America.
    (10_603, "+proj=laea +lat_0=-15 +lon_0=-60 +datum=WGS84"),
    // WGS 84 / Equi7 Africa.
    (
        27_701,
        "+proj=aeqd +lat_0=8.5 +lon_0=21.5 +x_0=5621452.02 +y_0=5990638.423 +datum=WGS84",
    ),
    // WGS 84 / Equi7 Antarctica.
    (
        27_702,
        "+proj=aeqd +lat_0=-90 +lon_0=0 +x_0=3714266.977 +y_0=3402016.506 +datum=WGS84",
    ),
    // WGS 84 / Equi7 Asia.
    (
        27_703,
        "+proj=aeqd +lat_0=47 +lon_0=94 +x_0=4340913.848 +y_0=4812712.923 +datum=WGS84",
    ),
    // WGS 84 / Equi7 Europe.
    (
        27_704,
        "+proj=aeqd +lat_0=53 +lon_0=24 +x_0=5837287.82 +y_0=2121415.696 +datum=WGS84",
    ),
    // WGS 84 / Equi7 North America.
    (
        27_705,
        "+proj=aeqd +lat_0=52 +lon_0=-97.5 +x_0=8264722.177 +y_0=4867518.353 +datum=WGS84",
    ),
    // WGS 84 / Equi7 Oceania.
    (
        27_706,
        "+proj=aeqd +lat_0=-19.5 +lon_0=131.5 +x_0=6988408.536 +y_0=7654884.537 +datum=WGS84",
    ),
    // WGS 84 / Equi7 South America.
    (
        27_707,
        "+proj=aeqd +lat_0=-14 +lon_0=-60.5 +x_0=7257179.236 +y_0=5592024.446 +datum=WGS84",
    ),
];

/// First and last codes of systems that are true to scale, one after the other. Codes between them
/// that `crs-definitions` has are looked up there.
const TRUE_TO_SCALE: [u16; 244] = [
    2218, 2221, 2296, 2963, 2985, 3173, 5017, 5017, 5224, 5225, 5515, 5516, 6244, 6275, 8441, 8441,
    8950, 8951, 9141, 9141, 9149, 9150, 9154, 9159, 9205, 9218, 9249, 9250, 9252, 9252, 9254, 9254,
    9265, 9265, 9271, 9273, 9284, 9285, 9295, 9297, 9300, 9300, 9356, 9360, 9367, 9367, 9373, 9373,
    9387, 9387, 9391, 9391, 9404, 9407, 9456, 9456, 9476, 9482, 9487, 9494, 9498, 9498, 9549, 9549,
    9674, 9674, 9678, 9678, 9680, 9680, 9697, 9699, 9709, 9709, 9712, 9713, 9716, 9716, 9741, 9741,
    9748, 9749, 9761, 9761, 9766, 9766, 9821, 9865, 9869, 9869, 9874, 9875, 9880, 9880, 9895, 9895,
    9943, 9943, 9945, 9945, 9947, 9947, 9967, 9967, 9972, 9972, 9977, 9977, 10_160, 10_160, 10_183,
    10_183, 10_188, 10_188, 10_194, 10_194, 10_199, 10_199, 10_207, 10_207, 10_212, 10_212, 10_217,
    10_217, 10_222, 10_222, 10_227, 10_227, 10_235, 10_235, 10_240, 10_240, 10_250, 10_250, 10_254,
    10_254, 10_258, 10_258, 10_262, 10_262, 10_266, 10_266, 10_270, 10_270, 10_275, 10_275, 10_280,
    10_280, 10_285, 10_291, 10_306, 10_306, 10_314, 10_317, 10_329, 10_329, 10_448, 10_465, 10_471,
    10_471, 10_477, 10_477, 10_516, 10_516, 10_622, 10_622, 10_626, 10_626, 10_632, 10_632, 10_665,
    10_665, 10_674, 10_674, 10_731, 10_733, 11_114, 11_118, 20_002, 20_002, 20_042, 20_042, 20_047,
    20_050, 20_904, 20_932, 21_004, 21_032, 21_207, 21_264, 21_307, 21_364, 22_207, 22_222, 22_229,
    22_232, 22_239, 22_240, 22_243, 22_250, 22_262, 22_265, 22_300, 22_300, 22_307, 22_322, 22_337,
    22_338, 22_348, 22_357, 22_407, 22_422, 22_462, 22_465, 22_607, 22_622, 22_639, 22_639, 22_641,
    22_646, 22_648, 22_657, 22_707, 22_722, 22_739, 22_739, 22_762, 22_765, 22_807, 22_822, 23_301,
    23_333, 27_200, 27_200, 29_701, 29_701, 29_874, 29_874, 32_159, 32_159, 32_600, 32_600, 32_700,
    32_700,
];

/// The text for PROJ of a system, if it has one here.
pub(super) fn definition(code: u16) -> Option<&'static str> {
    let found = DEFINITIONS.iter().find(|(known, _)| *known == code);
    found.map(|(_, text)| *text)
}

/// Is it a grid that land is measured on?
pub(super) fn is_true_to_scale(code: u16) -> bool {
    let (ranges, _) = TRUE_TO_SCALE.as_chunks::<2>();
    ranges
        .iter()
        .any(|[first, last]| (*first..=*last).contains(&code))
}
