use super::*;

/// Shares of a square tile of heights `z(east, south)` in m at cells counted from the middle.
fn shares_of(side: usize, z: impl Fn(f64, f64) -> f64) -> GeomorphonShares {
    GeomorphonShares::of(&square(side, z)).unwrap()
}

fn square(side: usize, z: impl Fn(f64, f64) -> f64) -> HeightGrid {
    let middle = (side / 2) as f64;
    let height = |i: usize| z((i % side) as f64 - middle, (i / side) as f64 - middle) as f32;
    HeightGrid {
        width: side,
        height: side,
        values: (0..side * side).map(height).collect(),
        pixel_m: [92.6; 2],
    }
}

/// The form in the middle of the smallest tile: it has one cell with a form.
fn form_of(z: impl Fn(f64, f64) -> f64) -> Geomorphon {
    let shares = shares_of(41, z);
    let mut forms = Geomorphon::ALL.into_iter();
    forms.find(|&form| shares.share(form) == 1.0).unwrap()
}

/// A plane that rises to the east by so many degrees.
fn plane(degrees: f64) -> impl Fn(f64, f64) -> f64 {
    let (sin, cos) = math::sin_cos(degrees.to_radians());
    move |east, _| 1000.0 + east * 92.6 * sin / cos
}

#[test]
fn simple_ground_has_the_form_that_it_is_called_by() {
    let away = |east: f64, south: f64| (east * east + south * south).sqrt();
    assert_eq!(
        form_of(|east, south| -30.0 * away(east, south)),
        Geomorphon::Peak
    );
    assert_eq!(
        form_of(|east, south| 30.0 * away(east, south)),
        Geomorphon::Depression
    );
    assert_eq!(form_of(|east, _| 30.0 * east.abs()), Geomorphon::Valley);
    assert_eq!(form_of(|_, south| -30.0 * south.abs()), Geomorphon::Ridge);
    assert_eq!(
        form_of(|east, _| 30.0 * east.max(0.0)),
        Geomorphon::Footslope
    );
    assert_eq!(
        form_of(|east, _| 30.0 * east.min(0.0)),
        Geomorphon::Shoulder
    );
    let spur = |east: f64, south: f64| 20.0 * east - 10.0 * south.abs();
    assert_eq!(form_of(spur), Geomorphon::Spur);
    assert_eq!(
        form_of(|east, south| -spur(east, south)),
        Geomorphon::Hollow
    );
}

/// Up and down a plane highest and lowest line of sight are the plane's: it counts twice.
#[test]
fn planes_are_flat_below_half_a_degree() {
    assert_eq!(form_of(plane(0.0)), Geomorphon::Flat);
    assert_eq!(form_of(plane(0.45)), Geomorphon::Flat);
    // Diagonals rise by 1 / √2 of it: 0.53°.
    assert_eq!(form_of(plane(0.75)), Geomorphon::Slope);
    assert_eq!(form_of(plane(60.0)), Geomorphon::Slope);
}

/// Walls around the middle, so many cells away, on level ground.
fn walls(at: f64) -> impl Fn(f64, f64) -> f64 {
    move |east, south| 500.0 * f64::from(u8::from(east.abs() == at || south.abs() == at))
}

/// Walls are seen 20 cells away, along diagonals 14.
#[test]
fn forms_far_away_are_not_seen() {
    assert_eq!(form_of(walls(14.0)), Geomorphon::Depression);
    assert_eq!(form_of(walls(15.0)), Geomorphon::Footslope);
    assert_eq!(form_of(walls(20.0)), Geomorphon::Footslope);
    assert_eq!(shares_of(43, walls(21.0)).share(Geomorphon::Flat), 1.0);
}

/// The forms by angles and whole profiles, cell by cell.
fn reference(tile: &HeightGrid) -> [usize; Geomorphon::COUNT] {
    let mut counts = [0; Geomorphon::COUNT];
    for y in 20..tile.height - 20 {
        for x in 20..tile.width - 20 {
            let sums = NEIGHBOURS.map(|step| angle_sum(tile, [x, y], step));
            let higher = sums.iter().filter(|&&sum| sum > 1.0).count();
            let lower = sums.iter().filter(|&&sum| sum < -1.0).count();
            counts[FORMS[lower][higher] as usize] += 1;
        }
    }
    counts
}

/// Sum of the highest and the lowest elevation angle in degrees.
fn angle_sum(tile: &HeightGrid, [x, y]: [usize; 2], step: CellStep) -> f64 {
    let mut extremes = [-90.0_f64, 90.0];
    for k in 1..=20 {
        let [east, south] = [step.east * k, step.south * k];
        let metres = 92.6 * ((east * east + south * south) as f64).sqrt();
        if metres > 20.0 * 92.6 {
            break;
        }
        let [column, row] = [x as isize + east, y as isize + south];
        let rise = tile.row(row as usize)[column as usize] - tile.row(y)[x];
        let angle = math::atan2(f64::from(rise), metres).to_degrees();
        extremes = [extremes[0].max(angle), extremes[1].min(angle)];
    }
    extremes[0] + extremes[1]
}

/// Hills so many m high, with dents.
fn hills(metres: f64) -> impl Fn(f64, f64) -> f64 {
    move |east, south| {
        let dents = ((east * 37.0 + south * 101.0) as i64 as u64).wrapping_mul(0x9E37_79B9_7F4A);
        let dent = (dents >> 40 & 0xFF) as f64 / 1024.0;
        metres * (1.0 + math::sin(east / 7.0) + math::sin(south / 11.0) + dent)
    }
}

#[test]
fn tangents_decide_as_angles_do() {
    for metres in [3.0, 40.0, 4000.0] {
        let tile = square(70, hills(metres));
        let found = GeomorphonShares::of(&tile).unwrap();
        let expected = reference(&tile).map(|count| count as f64 / 900.0);
        assert_eq!(found.0, expected, "{metres}");
    }
}

#[test]
fn forms_are_a_triangle_of_counts() {
    for (lower, row) in FORMS.iter().enumerate() {
        assert_eq!(row.len(), 9 - lower);
    }
    assert_eq!(Geomorphon::of_profiles(0, 8), Some(Geomorphon::Depression));
    assert_eq!(Geomorphon::of_profiles(9, 0), None);
}

fn shares(of: &[(Geomorphon, f64)]) -> GeomorphonShares {
    let mut shares = GeomorphonShares([0.0; Geomorphon::COUNT]);
    for &(form, share) in of {
        shares.0[form as usize] = share;
    }
    shares
}

/// D of (1, 0) and (1/2, 1/2) is 3/2 - 3/4 log₂ 3.
#[test]
fn distances_are_roots_of_divergences() {
    let slopes = shares(&[(Geomorphon::Slope, 1.0)]);
    let valleys = shares(&[(Geomorphon::Valley, 1.0)]);
    let both = shares(&[(Geomorphon::Slope, 0.5), (Geomorphon::Valley, 0.5)]);
    assert_eq!(slopes.distance(&slopes), 0.0);
    assert!((slopes.distance(&valleys) - 1.0).abs() < 1e-12);
    let expected = (1.5 - 0.75 * math::ln(3.0) / math::ln(2.0)).sqrt();
    assert!((slopes.distance(&both) - expected).abs() < 1e-12);
    assert_eq!(slopes.distance(&both), both.distance(&slopes));
    assert_eq!(GeomorphonShares::mean(&[slopes, valleys]), Some(both));
    assert_eq!(GeomorphonShares::mean(&[]), None);
}

#[test]
fn small_tiles_have_no_forms() {
    assert_eq!(GeomorphonShares::of(&square(40, |_, _| 0.0)), None);
}
