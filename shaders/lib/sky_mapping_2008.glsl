// Where in a precomputed table of the sky a ray's light stands, as the code of Bruneton & Neyret
// 2008 has it and the simplified variant after it; with that mapping's own faults: the table of
// transmittance runs across the horizon, and suns lie by a tangent. Needs lib/sky_mapping.glsl
// before it; places as there.

const float kLowestView2008 = -0.15;
const float kLowestSun2008 = -0.1975;

/// x: along mu, y: along the height. There is no inset: 0 and 1 are the edges of the texture.
vec2 transmittancePlace2008(Air air, float h, float mu) {
    float up = max((mu - kLowestView2008) / (1.0 - kLowestView2008), 0.0);
    return vec2(atan(up * tan(1.5)) / 1.5, sqrt(h / air.top));
}

void transmittanceRay2008(Air air, vec2 place, OUT(float) h, OUT(float) mu) {
    h = place.y * place.y * air.top;
    mu = kLowestView2008 + (1.0 - kLowestView2008) * tan(1.5 * place.x) / tan(1.5);
}

float sunPlace2008(float muS) {
    return 0.5 * (atan(max(muS, kLowestSun2008) * tan(1.26 * 1.1)) / 1.1 + (1.0 - 0.26));
}

float sunOfPlace2008(float place) {
    return clamp(tan((2.0 * place - 1.0 + 0.26) * 1.1) / tan(1.26 * 1.1), -1.0, 1.0);
}

/// Axes as in scatteringPlace.
vec4 scatteringPlace2008(Air air, float h, float mu, float muS, float nu, bool ground) {
    float rho = sqrt(airSquare(air, h));
    float horizon = topToHorizon(air);
    float way = ground ? wayPlace(distanceToGround(air, h, mu), 0.0, rho)
                       : wayPlace(distanceToTop(air, h, mu), 0.0, rho + horizon);
    return vec4(sunPlace2008(muS), way, rho / horizon, 0.5 + 0.5 * nu);
}

/// Places that stand for shorter ways than there are have the shortest one's ray.
void scatteringRay2008(Air air, vec4 place, bool ground, OUT(float) h, OUT(float) mu,
                       OUT(float) muS, OUT(float) nu) {
    float horizon = topToHorizon(air);
    float rho = place.z * horizon;
    h = min(heightOfSquare(air, rho * rho), air.top);
    if (ground) {
        mu = cosineOfWay(air, h, -rho * rho, max(place.y * rho, h), -1.0);
    } else {
        mu = cosineOfWay(air, h, (air.top - h) * (2.0 * air.groundRadius + air.top + h),
                         max(place.y * (rho + horizon), air.top - h), 1.0);
    }
    muS = sunOfPlace2008(place.x);
    nu = possibleNu(mu, muS, 2.0 * place.w - 1.0);
}

/// What light from the shortest way counts in such places, if they are to lie on a straight line
/// that is 0 at no way: 0..1, and 1 in all others. The 2008 code has 1 in all.
float shortOfWay2008(Air air, float h, float place, bool ground) {
    float rho = sqrt(airSquare(air, h));
    float way = place * (ground ? rho : rho + topToHorizon(air));
    float shortest = ground ? h : air.top - h;
    return way < shortest ? way / shortest : 1.0;
}
