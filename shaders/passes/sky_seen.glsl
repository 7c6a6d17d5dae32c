// Where directions lie in the table of what is seen from the eye's height: an upper and a lower
// half, rows dense at the horizon, columns of azimuths from the sun's. Each half has its own layers
// and its first row at the horizon, so that none takes light from beyond it.
#include "passes/sky_radiance.glsl"

/// The table holds logarithms, as light thins out by powers towards the air's edge and in twilight,
/// of the light and this little more: less than a night sky's.
const float kSkyViewFloor = 1.0e-9;
vec3 skyTexel(vec3 light) { return log(max(light, 0.0) + kSkyViewFloor); }
vec3 fromSkyTexel(vec3 texel) { return max(exp(texel) - kSkyViewFloor, 0.0); }

/// Directions are cosine and sine of their angle from the zenith: those tell angles at the horizon
/// apart that arc functions, good to 1e-5, would not, and those are what the limb is wide as seen from
/// space. The horizon at a height:
vec2 horizonPlace(Air air, float h) {
    return vec2(-sqrt(max(airSquare(air, h), 0.0)), air.groundRadius) / (air.groundRadius + h);
}

/// The other end of a half: the nadir, the zenith, or the air's edge as seen from above it.
vec2 endPlace(Air air, float h, bool ground) {
    if (ground) {
        return vec2(-1.0, 0.0);
    }
    if (h < air.top) {
        return vec2(1.0, 0.0);
    }
    float beyond = (h - air.top) * (2.0 * air.groundRadius + h + air.top);
    return vec2(-sqrt(beyond), air.groundRadius + air.top) / (air.groundRadius + h);
}

/// The direction at a distance on the unit circle from the horizon, straight through it.
vec2 placeFromHorizon(vec2 horizon, float chord, bool ground) {
    float cosine = 1.0 - 0.5 * chord * chord;
    float sine = chord * sqrt(max(1.0 - 0.25 * chord * chord, 0.0)) * (ground ? -1.0 : 1.0);
    return vec2(horizon.x * cosine + horizon.y * sine, horizon.y * cosine - horizon.x * sine);
}

/// Distances from the horizon, as parts of what the half spans, by rows 0..1: dense at the horizon,
/// and as seen from above the air at its edge too.
float partOfRow(Air air, float h, bool ground, float row) {
    if (ground) {
        return row * row * row;
    }
    float sine = h < air.top ? row : sin(0.5 * kPi * row);
    return sine * sine;
}
float rowOfPart(Air air, float h, bool ground, float part) {
    if (ground) {
        return pow(part, 1.0 / 3.0);
    }
    float sine = sqrt(part);
    return h < air.top ? sine : asin(sine) * (2.0 / kPi);
}

/// Columns are dense towards the sun's azimuth, where twilight changes fastest; azimuths as parts of
/// half a turn.
float azimuthOfColumn(float column) { return column * sqrt(column); }
float columnOfAzimuth(float azimuth) { return pow(azimuth, 2.0 / 3.0); }

/// What is seen of air and ground along a ray, but for the phase function of what Mie's air scattered
/// once; for a sun of irradiance 1.
struct SeenLight {
    vec3 rest;
    vec3 mie;
};

/// `ray`: from any height; `sine`: of its angle from the zenith; `ground`: it ends there.
SeenLight seenAlong(Air air, vec4 ray, float sine, bool ground) {
    SeenLight seen = SeenLight(vec3(0.0), vec3(0.0));
    float entry;
    if (intoAir(air, ray, sine, entry)) {
        float way = distanceInAir(air, ray.x, ray.y, ground);
        SkyLight light = marchSky(air, ray, way);
        seen.mie = light.mie;
        seen.rest = light.rayleigh * phaseRayleigh(ray.w) + light.later;
        if (ground) {
            vec2 lengths = lengthsAlong(air, ray.x, ray.y, way, true);
            seen.rest += groundLight(air, ray, way, airTransmittance(air, lengths.x, lengths.y));
        }
    }
    return seen;
}
