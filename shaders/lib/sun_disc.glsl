// The sun's disc: how bright it is in a direction; not what the air leaves of it. Needs lib/pi.glsl
// before it.

/// Limb darkening: the disc's radiance is that of its middle times cos^kLimb, the angle being that
/// between ray and the sun's surface (after Hestroffer & Magnan 1998 at 680, 550, 440 nm).
const vec3 kLimb = vec3(0.42, 0.52, 0.68);

/// Radiance in a direction for a sun of irradiance 1, unit vectors; radius in radians. The disc's
/// edge is as wide as a pixel of `pixelRadians` > 0.
vec3 sunDisc(vec3 direction, vec3 towardsSun, float radius, float pixelRadians) {
    float angle = 2.0 * asin(min(0.5 * length(direction - towardsSun), 1.0));
    float covered = clamp((radius - angle) / pixelRadians + 0.5, 0.0, 1.0);
    if (covered <= 0.0 || radius <= 0.0) {
        return vec3(0.0);
    }
    float across = min(angle / radius, 0.999);
    vec3 limb = pow(vec3(sqrt(1.0 - across * across)), kLimb) * (0.5 * kLimb + 1.0);
    return covered * limb / (2.0 * kPi * (1.0 - cos(radius)));
}
