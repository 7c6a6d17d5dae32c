// Where directions lie in the table of what is seen from the eye's height: an upper and a lower
// half, rows dense at the horizon, columns of azimuths from the sun's. Each half has its own layers
// and its first row at the horizon, so that none takes light from beyond it.
#include "passes/sky_radiance.glsl"

/// Angle from the zenith to the horizon at a height.
float horizonAngle(Air air, float h) {
    return 0.5 * kSkyPi + atan(sqrt(max(airSquare(air, h), 0.0)), air.groundRadius);
}

/// How far the upper half reaches up from the horizon: to the zenith, or to the air's edge as seen
/// from above it.
float upperSpan(Air air, float h) {
    float horizon = horizonAngle(air, h);
    if (h <= air.top) {
        return horizon;
    }
    float beyond = (h - air.top) * (2.0 * air.groundRadius + h + air.top);
    return horizon - (0.5 * kSkyPi + atan(sqrt(beyond), air.groundRadius + air.top));
}
