// Where in a precomputed table of the sky a ray's light stands, and the ray of each place: the
// mappings of Bruneton's 2017 description of Bruneton & Neyret 2008. No textures, no light. Those
// of the 2008 code are in sky_mapping_2008.glsl. Needs lib/air.glsl and lib/air_shell.glsl before
// it; h, mu, muS, nu as there.
//
// A place is 0..1 along each axis of a table, at the centres of its first and its last texel. A
// table of scattering has two halves along mu, for rays that hit the ground and rays that do not,
// so that nothing is interpolated across the horizon; a place along mu counts within its half.

/// The coordinate 0..1 of a texture with `texels` texels along an axis.
float textureCoordinate(float place, float texels) {
    return (0.5 + clamp(place, 0.0, 1.0) * (texels - 1.0)) / texels;
}

/// The place of a texel's centre; 0 where there is but one.
float texelPlace(float texel, float texels) {
    return texels > 1.0 ? texel / (texels - 1.0) : 0.0;
}

/// The same along mu in a table of two halves of texels / 2 each, the ground's first, upside down.
float halvesCoordinate(float place, float texels, bool ground) {
    float half1 = 0.5 * textureCoordinate(place, 0.5 * texels);
    return ground ? 0.5 - half1 : 0.5 + half1;
}

/// The place of a texel within its half; its ray hits the ground where texel < texels / 2.
float halvesPlace(float texel, float texels) {
    float size = 0.5 * texels;
    return texel < size ? texelPlace(size - 1.0 - texel, size) : texelPlace(texel - size, size);
}

/// The height at which r^2 - R^2 is `square`.
float heightOfSquare(Air air, float square) {
    float r = sqrt(air.groundRadius * air.groundRadius + square);
    return square / (r + air.groundRadius);
}

/// Metres from the top to the horizon: the longest way without crossing the air's lowest point.
float topToHorizon(Air air) {
    return sqrt(airSquare(air, air.top));
}

/// Where between the shortest and the longest way a way is; 0 where they are one.
float wayPlace(float way, float shortest, float longest) {
    return longest > shortest ? clamp((way - shortest) / (longest - shortest), 0.0, 1.0) : 0.0;
}

/// mu of a ray from height h that after `way` metres is where r^2 is greater by `difference`; `none`
/// where the way is 0.
float cosineOfWay(Air air, float h, float difference, float way, float none) {
    float r = air.groundRadius + h;
    return way > 0.0 ? clamp((difference - way * way) / (2.0 * r * way), -1.0, 1.0) : none;
}

/// x: along mu, y: along the height; for rays that do not hit the ground.
vec2 transmittancePlace(Air air, float h, float mu) {
    float rho = sqrt(airSquare(air, h));
    float horizon = topToHorizon(air);
    return vec2(wayPlace(distanceToTop(air, h, mu), air.top - h, rho + horizon), rho / horizon);
}

void transmittanceRay(Air air, vec2 place, OUT(float) h, OUT(float) mu) {
    float horizon = topToHorizon(air);
    float rho = place.y * horizon;
    h = min(heightOfSquare(air, rho * rho), air.top);
    float way = mix(air.top - h, rho + horizon, place.x);
    mu = cosineOfWay(air, h, (air.top - h) * (2.0 * air.groundRadius + air.top + h), way, 1.0);
}

/// 0 for a sun in the zenith, 1 on the horizon, more below it, by its light's way through the air.
float sunWay(Air air, float muS) {
    return max((distanceToTop(air, 0.0, muS) - air.top) / (topToHorizon(air) - air.top), 0.0);
}

/// Suns, dense around the horizon, from a cosine of muSMin < 0 on; those below it count as that.
float sunPlace(Air air, float muSMin, float muS) {
    float way = sunWay(air, muS);
    return max(1.0 - way / sunWay(air, muSMin), 0.0) / (1.0 + way);
}

float sunOfPlace(Air air, float muSMin, float place) {
    float lowest = sunWay(air, muSMin);
    float way = (lowest - place * lowest) / (1.0 + place * lowest);
    return cosineOfWay(air, 0.0, airSquare(air, air.top), mix(air.top, topToHorizon(air), way),
                       1.0);
}

/// x: along muS, y: along mu within the half of `ground`, z: along the height, w: along nu.
vec4 scatteringPlace(Air air, float muSMin, float h, float mu, float muS, float nu, bool ground) {
    float rho = sqrt(airSquare(air, h));
    float horizon = topToHorizon(air);
    float way = ground ? wayPlace(distanceToGround(air, h, mu), h, rho)
                       : wayPlace(distanceToTop(air, h, mu), air.top - h, rho + horizon);
    return vec4(sunPlace(air, muSMin, muS), way, rho / horizon, 0.5 + 0.5 * nu);
}

/// A nu that no three directions have, taken to the next that can be.
float possibleNu(float mu, float muS, float nu) {
    float sines = sqrt(max((1.0 - mu * mu) * (1.0 - muS * muS), 0.0));
    return clamp(nu, mu * muS - sines, mu * muS + sines);
}

void scatteringRay(Air air, float muSMin, vec4 place, bool ground, OUT(float) h, OUT(float) mu,
                   OUT(float) muS, OUT(float) nu) {
    float horizon = topToHorizon(air);
    float rho = place.z * horizon;
    h = min(heightOfSquare(air, rho * rho), air.top);
    if (ground) {
        mu = cosineOfWay(air, h, -rho * rho, mix(h, rho, place.y), -1.0);
    } else {
        mu = cosineOfWay(air, h, (air.top - h) * (2.0 * air.groundRadius + air.top + h),
                         mix(air.top - h, rho + horizon, place.y), 1.0);
    }
    muS = sunOfPlace(air, muSMin, place.x);
    nu = possibleNu(mu, muS, 2.0 * place.w - 1.0);
}
