// Spot light: how a lamp's candela fall off over angle and distance, and where its light map lies.
// KHR_lights_punctual's formulas, and the one near-lamp rule of the program. No shadows.

/// Radius of every lamp's lens in metres. The near-lamp rule: a beam begins at the lens plane
/// (axial depth kLensMetres), and on surfaces no distance counts as less than this.
const float kLensMetres = 0.05;

/// 0..1: 1 inside the inner cone, 0 at and outside the outer one. cosAngle is between the beam's
/// axis and the direction from the lamp. As in KHR_lights_punctual's code the cosines are taken to
/// lie at least 0.001 apart: where the two cones are closer the ramp widens inwards. An outer half
/// angle under 2.56 degrees (1 - cos = 0.001) thus dims even the axis.
float coneFalloff(float cosAngle, float cosInner, float cosOuter) {
    float scale = 1.0 / max(0.001, cosInner - cosOuter);
    float ramp = clamp((cosAngle - cosOuter) * scale, 0.0, 1.0);
    return ramp * ramp;
}

/// 0..1: the end that a lamp's range puts to its light, 1 - (distance / range)^4. inverseRange in
/// 1/m, 0 for an infinite range; distance in metres, >= 0.
float rangeWindow(float distanceMetres, float inverseRange) {
    float ratio = clamp(distanceMetres * inverseRange, 0.0, 1.0);
    float square = ratio * ratio;
    return 1.0 - square * square;
}

/// 1 / distance^2 in 1/m2 under the near-lamp rule: at most 1 / kLensMetres^2 = 400.
float inverseSquare(float distanceMetres) {
    float safe = max(distanceMetres, kLensMetres);
    return 1.0 / (safe * safe);
}

/// Texture coordinates of the light map, origin at the picture's top left, u to the right, v down.
/// slope = (x / z, y / z) with z > 0 along the way the lamp shines, x to the right and y up as seen
/// from the lamp (its local +X, +Y). The picture's square encloses the cone's circle:
/// inverseTanOuter = 1 / tan(outer half angle), so slopes up to that tangent give 0..1. The
/// rotation turns the picture counter-clockwise as seen from the lamp.
vec2 lightMapUv(vec2 slope, float inverseTanOuter, float cosRotation, float sinRotation) {
    float right = inverseTanOuter * (cosRotation * slope.x + sinRotation * slope.y);
    float up = inverseTanOuter * (cosRotation * slope.y - sinRotation * slope.x);
    return vec2(0.5 + 0.5 * right, 0.5 - 0.5 * up);
}
