// Phasor noise: stripes of one direction and about one wavelength, that fork and end as real faults
// do. The Rust twin keeps the packets of a cell from call to call.

// Stripes of one direction and about one wavelength.
struct StripeNoise {
    // A lattice's cell of 2^`cell` direction units holds one wave packet; 18..=26.
    cell: u32,
    // Wavelengths in a cell, Q16.
    waves: i32,
    // A packet's wavelength lies within this share of the noise's; Q16.
    spread: i32,
    // Where the random numbers begin.
    seed: u32,
}

// Phase and presence of the stripes at a point.
struct Phasor {
    // Cosine of the phase, -1..1 in Q16: 1 on crests, -1 in troughs.
    cosine: i32,
    // Sine of the phase, -1..1 in Q16: 1 on the flank a quarter wave along the axis from a crest.
    sine: i32,
    // How far the packets agree, 0..1 in Q16: 0 where stripes fork or end.
    presence: i32,
}

// A wave packet: its place, and the hash that drew it.
struct Packet {
    place: vec3<i32>,
    hash: u32,
}

// The stripes at a point. `axis` is the direction across them, components times 32767.
fn stripe_noise_at(noise: StripeNoise, point: vec3<i32>, axis: vec3<i32>) -> Phasor {
    // A packet reaches one cell far, so 27 of them matter.
    let home = point >> vec3(noise.cell);
    var sum = PacketSum();
    for (var k = 0; k < 27; k++) {
        let packet = stripe_noise_packet(noise, home, k);
        let away = point - packet.place;
        let weight = stripe_noise_weight(noise, away);
        // All terms of a packet out of reach are 0.
        if weight > 0 {
            sum = packet_sum_add(sum, stripe_noise_turn(noise, packet, away, axis), weight);
        }
    }
    return packet_sum_phasor(sum);
}

// The `k`th of the 27 packets around a cell.
fn stripe_noise_packet(noise: StripeNoise, home: vec3<i32>, k: i32) -> Packet {
    let at = home + vec3(k % 3, k / 3 % 3, k / 9) - 1;
    let hash = cell_hash(u32(at.x), u32(at.y), u32(at.z), noise.seed);
    // Ten bits of place an axis. `stripe_noise_turn` takes the phase from the top bit, and the
    // pitch from bits that the place has too.
    let drawn = (vec3(hash) >> vec3(0u, 10u, 20u)) & vec3(1023u);
    let inside = vec3<i32>(drawn << vec3(noise.cell - 10u));
    return Packet((at << vec3(noise.cell)) + inside, hash);
}

// Weight of a packet at a distance from its middle: (1 - d^2)^4 times 16; 0 a cell away.
fn stripe_noise_weight(noise: StripeNoise, away: vec3<i32>) -> i32 {
    // Fifteen bits of a cell: with eight, weights have steps that show as a grid.
    let near = unsigned_abs3(away >> vec3(noise.cell - 15u));
    if any(near > vec3(0x7fffu)) {
        return 0;
    }
    let square = i32((near.x * near.x + near.y * near.y + near.z * near.z) >> 14u);
    if square >= Q16 {
        return 0;
    }
    let fall = mul_q16(Q16 - square, Q16 - square);
    // Four bits more than a share, for where all packets are far.
    return mul_q16(fall << 4u, fall);
}

// Phase of a packet at a distance from its middle; a whole turn is 2^16.
fn stripe_noise_turn(noise: StripeNoise, packet: Packet, away: vec3<i32>, axis: vec3<i32>) -> i32 {
    let along = mul_q16(away.x, 2 * axis.x) + mul_q16(away.y, 2 * axis.y) + mul_q16(away.z, 2 * axis.z);
    let drawn = i32((packet.hash >> 7u) & 0xffffu);
    let pitch = Q16 - noise.spread + mul_q16(drawn, 2 * noise.spread);
    // A phase of 0 or 1/2 makes the noise even in its axis.
    let half_turn = i32((packet.hash >> 31u) << 15u);
    return (mul_q16(along, mul_q16(noise.waves, pitch)) >> (noise.cell - 16u)) + half_turn;
}

// Sum of the packets at a point, as complex numbers.
struct PacketSum {
    real: i32,
    imaginary: i32,
    weight: i32,
}

fn packet_sum_add(sum: PacketSum, turn: i32, weight: i32) -> PacketSum {
    // The sine is the cosine a quarter turn earlier.
    let real = mul_q16(cos_turn(turn), weight);
    let imaginary = mul_q16(cos_turn(turn - 0x4000), weight);
    return PacketSum(sum.real + real, sum.imaginary + imaginary, sum.weight + weight);
}

fn packet_sum_phasor(sum: PacketSum) -> Phasor {
    let all = unsigned_abs(sum.real) | unsigned_abs(sum.imaginary) | u32(sum.weight);
    let bits = bit_length(all);
    let x = to_phase_bits(sum.real, bits);
    let y = to_phase_bits(sum.imaginary, bits);
    let weight = max(to_phase_bits(sum.weight, bits), 1);
    let size = i32(isqrt(u32(x * x) + u32(y * y)));
    let presence = mul_q16(ratio(size, weight), ratio(sum.weight, FULL_WEIGHT));
    // All packets out of reach or cancelled: any phase serves, its presence is 0.
    if size == 0 {
        return Phasor(Q16, 0, presence);
    }
    return Phasor(signed_ratio(x, size), signed_ratio(y, size), presence);
}

// A number of at most `bits` bits brought to PHASE_BITS, so that little is lost where all packets
// are far.
fn to_phase_bits(v: i32, bits: u32) -> i32 {
    return (v >> less(bits, PHASE_BITS)) << less(PHASE_BITS, bits);
}
