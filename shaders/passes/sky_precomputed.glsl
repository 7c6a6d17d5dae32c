// What a ray brings by a precomputed sky's tables: one look-up, or where the ray ends before the air
// does, the difference of two. Needs passes/sky_lookup.glsl.

/// Radiance that the air scatters to a ray's start, all the way to the ground or the top.
vec3 tabulatedLight(Air air, float h, float mu, float muS, float nu, bool ground) {
    vec3 coordinate = scatteringCoordinate(air, h, mu, muS, ground);
    vec3 slices = nuSlices(nu);
    return fourDimensional(scatteringMap, coordinate, slices) * phaseRayleigh(nu) +
           fourDimensional(mieMap, coordinate, slices) * phaseCornetteShanks(nu, air.mieG);
}

/// What is left of the light of the sun's disc where it is seen.
vec3 sunTransmittance(Air air, float h, float muS) {
    return transmittanceToTop(air, h, muS);
}

/// What is left of sunlight at a height 0..top, where the planet may hide some of the disc.
vec3 sunlightAt(Air air, float h, float muS) {
    return transmittanceToSun(air, h, muS);
}

/// Irradiance of level planes by the sky alone, of which the simplified variant knows nothing.
vec3 skylightAt(Air air, float h, float muS) {
#ifdef SKY_2008
    return vec3(0.0);
#else
    return irradianceAt(air, h, muS);
#endif
}

/// Irradiance of the ground.
vec3 groundIrradiance(Air air, float muS) {
    return sunIrradiance(air, 0.0, muS) + skylightAt(air, 0.0, muS);
}

/// `start`: height, mu, muS, nu; `cut`: the ray ends before the air does.
void skyAlong(Air air, vec4 start, float length1, bool ground, bool cut, OUT(vec3) transmittance,
              OUT(vec3) light) {
    float h = start.x;
    float mu = start.y;
    light = tabulatedLight(air, h, mu, start.z, start.w, ground);
    if (!ground && !cut) {
        transmittance = transmittanceToTop(air, h, mu);
        return;
    }
    float hThere = clamp(heightAlong(air, h, mu, length1), 0.0, air.top);
    float muThere = cosineAlong(air, h, mu, length1, hThere);
    transmittance = transmittanceBetween(air, h, mu, hThere, muThere, ground);
    if (cut) {
        float muSThere = sunCosineAlong(air, h, start.z, start.w, length1, hThere);
        light -= transmittance * tabulatedLight(air, hThere, muThere, muSThere, start.w, ground);
#ifdef SKY_2008
        light = max(light, vec3(0.0));
#endif
    }
}
