//! Which of several frames lies on top.

use super::FrameHit;
use crate::crust::{Crust, CrustKind, Frame};
use crate::plate::polarity::PolarityMemory;
use bevy::math::DVec3;

/// Whether the crust of `a` lies on top of that of `b` at `p`.
fn overrides(
    crust: &Crust,
    frames: &[Frame],
    polarity: &PolarityMemory,
    a: FrameHit,
    b: FrameHit,
    p: DVec3,
) -> bool {
    let frame_a = &frames[usize::from(a.frame)];
    let frame_b = &frames[usize::from(b.frame)];
    if frame_a.plate == frame_b.plate {
        // Of one plate: terranes over the frame that they came to, later ones over earlier ones.
        return (frame_a.terrane, a.frame) > (frame_b.terrane, b.frame);
    }
    let (i, j) = (a.sample as usize, b.sample as usize);
    // Continental crust is the lighter one, whatever the plates decided for equal kinds.
    match (crust.kind[i], crust.kind[j]) {
        (CrustKind::Continental, CrustKind::Oceanic) => return true,
        (CrustKind::Oceanic, CrustKind::Continental) => return false,
        _ => {}
    }
    if let Some(under) = polarity.under(frame_a.plate, frame_b.plate, p) {
        return under == frame_b.plate;
    }
    // These plates have not met yet: younger floor is lighter.
    let (age_a, age_b) = (crust.ocean_age[i], crust.ocean_age[j]);
    // Of one age: any order will do that is the same from both sides.
    if age_a == age_b {
        frame_a.plate < frame_b.plate
    } else {
        age_a < age_b
    }
}

/// Which of two hits at `p` lies on top.
#[inline]
pub fn upper(
    crust: &Crust,
    frames: &[Frame],
    polarity: &PolarityMemory,
    a: FrameHit,
    b: FrameHit,
    p: DVec3,
) -> FrameHit {
    if overrides(crust, frames, polarity, b, a, p) {
        b
    } else {
        a
    }
}
