// Chapman's function: how many times more air lies on a slanted ray to infinity than straight up
// through exponential air, as closed forms. x is the distance from the planet's centre in scale
// heights, cosChi the cosine between ray and zenith. With x0 = x sin(chi) the ray's lowest point,
// beyond 90 degrees: Ch(x, chi) = 2 exp(x - x0) Ch(x0, 90) - Ch(x, 180 - chi).

const float kRootOfPi = 1.77245385090552;

/// Chapman's function by a rational form of exp(y^2) erfc(y), cosChi >= 0: at most 0.34 % off for
/// x >= 795 (85 degrees), 0.03 % at 0 and 90 degrees.
float chapmanUpward(float x, float cosChi) {
    float y = cosChi * sqrt(0.5 * x);
    float e = 2.911 / (1.911 * kRootOfPi * y + sqrt(kRootOfPi * kRootOfPi * y * y + 2.911 * 2.911));
    return 0.5 * (cosChi + kRootOfPi * sqrt(0.5 * x) * e * (1.0 / x + 2.0 - cosChi * cosChi));
}

/// The same for any cosChi. Singles overflow where the ray's lowest point is 88 scale heights
/// deeper than x: ask first whether the ray hits the ground.
float chapman(float x, float cosChi) {
    if (cosChi >= 0.0) {
        return chapmanUpward(x, cosChi);
    }
    float sine = sqrt(max((1.0 - cosChi) * (1.0 + cosChi), 0.0));
    // x - x sin(chi), without the difference.
    float depth = x * cosChi * cosChi / (1.0 + sine);
    return 2.0 * exp(depth) * chapmanUpward(x * sine, 0.0) - chapmanUpward(x, -cosChi);
}

/// Schuler's form as his code has it, for cosChi >= 0: x there counts heights in which the density
/// halves. Up to 15 % off.
float chapmanSchulerUpward(float x, float cosChi) {
    float c = sqrt(x);
    return c / (c * cosChi + 1.0);
}

/// Schuler's form for any cosChi, reflected beyond 90 degrees, where the density halves with each
/// unit of x.
float chapmanSchuler(float x, float cosChi) {
    if (cosChi >= 0.0) {
        return chapmanSchulerUpward(x, cosChi);
    }
    float sine = sqrt(max((1.0 - cosChi) * (1.0 + cosChi), 0.0));
    float depth = x * cosChi * cosChi / (1.0 + sine);
    return 2.0 * exp2(depth) * chapmanSchulerUpward(x * sine, 0.0) -
           chapmanSchulerUpward(x, -cosChi);
}
