// The sky without tables: each ray summed up in even segments, optical depths by a closed form of
// Chapman's function. Schuler, An Approximation to the Chapman Grazing-Incidence Function for
// Atmospheric Scattering (GPU Pro 3): Rayleigh alone, once scattered. With Schuler's own form, or
// with the better one of lib/chapman.glsl. The air has no top for these columns. Needs lib/air.glsl,
// lib/air_shell.glsl, lib/chapman.glsl and lib/phase_function.glsl before it.

const float kLn2 = 0.693147180559945;

/// Optical length in metres from h to infinity, for a ray that does not hit the ground. Schuler's
/// form counts in heights by which the density halves, the better one in scale heights.
float chapmanColumn(Air air, float h, float mu, bool better) {
    float unit = better ? air.rayleighHeight : air.rayleighHeight * kLn2;
    float x = (air.groundRadius + h) / unit;
    float density = airDensity(h, air.rayleighHeight);
    float up = abs(mu);
    float above = density * (better ? chapmanUpward(x, up) : chapmanSchulerUpward(x, up));
    if (mu >= 0.0) {
        return air.rayleighHeight * above;
    }
    float sine = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
    float lowest = max(h - (air.groundRadius + h) * mu * mu / (1.0 + sine), 0.0);
    float level = better ? chapmanUpward(x * sine, 0.0) : chapmanSchulerUpward(x * sine, 0.0);
    return air.rayleighHeight * (2.0 * airDensity(lowest, air.rayleighHeight) * level - above);
}

/// Optical length between a ray's start and a place on it, taken towards the top, not below 0.
float chapmanBetween(Air air, float h, float mu, float hThere, float muThere, bool ground,
                     bool better) {
    float length1 = ground ? chapmanColumn(air, hThere, -muThere, better) -
                                 chapmanColumn(air, h, -mu, better)
                           : chapmanColumn(air, h, mu, better) -
                                 chapmanColumn(air, hThere, muThere, better);
    return max(length1, 0.0);
}

vec3 chapmanTransmittance(Air air, float opticalLength) {
    return airTransmittance(air, opticalLength, 0.0);
}

/// Of sunlight; black in the planet's shadow.
vec3 chapmanSunlight(Air air, float h, float muS, bool better) {
    if (hitsGround(air, h, muS)) {
        return vec3(0.0);
    }
    return chapmanTransmittance(air, chapmanColumn(air, h, muS, better));
}

/// Radiance that the first `length1` metres of a ray scatter to its start, by their middles.
vec3 chapmanLight(Air air, float h, float mu, float muS, float nu, float length1, bool ground,
                  int segments, bool better) {
    float dt = length1 / float(segments);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < segments; ++i) {
        float t = (float(i) + 0.5) * dt;
        float there = clamp(heightAlong(air, h, mu, t), 0.0, air.top);
        float muThere = cosineAlong(air, h, mu, t, there);
        float muSThere = sunCosineAlong(air, h, muS, nu, t, there);
        float way = chapmanBetween(air, h, mu, there, muThere, ground, better);
        sum += airDensity(there, air.rayleighHeight) * chapmanTransmittance(air, way) *
               chapmanSunlight(air, there, muSThere, better);
    }
    return sum * air.rayleighScattering * (dt * phaseRayleigh(nu));
}
