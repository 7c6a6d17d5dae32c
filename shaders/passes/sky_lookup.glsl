// What the tables of a precomputed sky hold for a ray: Bruneton & Neyret's, or with SKY_2008 those
// of the simplified variant, which with SKY_EXACT_TEXELS looks transmittance up as the former
// does. Light is for a sun of irradiance 1.
#include "passes/sky_air.glsl"
#include "lib/phase_function.glsl"
#include "lib/sky_mapping.glsl"
#ifdef SKY_2008
#include "lib/sky_mapping_2008.glsl"
#endif
#include "shared/sky_precomputed.h"
#if defined(SKY_2008) && !defined(SKY_EXACT_TEXELS)
#define SKY_2008_TRANSMITTANCE
#endif

layout(std140, binding = kPrecomputedSkySlot) uniform PrecomputedSkyBlock { PrecomputedSky tables; };
layout(binding = kSkyTransmittanceUnit) uniform sampler2D transmittanceMap;
layout(binding = kSkyPlaneUnit) uniform sampler2D irradianceMap;
layout(binding = kSkyScatteringUnit) uniform sampler3D scatteringMap;
layout(binding = kSkyMieUnit) uniform sampler3D mieMap;

/// From h to the top, for a ray that does not hit the ground.
vec3 transmittanceToTop(Air air, float h, float mu) {
#ifdef SKY_2008_TRANSMITTANCE
    return textureLod(transmittanceMap, transmittancePlace2008(air, h, mu), 0.0).rgb;
#else
    vec2 place = transmittancePlace(air, h, mu);
    vec2 size = vec2(textureSize(transmittanceMap, 0));
    return textureLod(transmittanceMap,
                      vec2(textureCoordinate(place.x, size.x),
                           textureCoordinate(place.y, size.y)),
                      0.0).rgb;
#endif
}

vec3 cappedQuotient(vec3 a, vec3 b) {
    return mix(vec3(0.0), min(a / b, vec3(1.0)), greaterThan(b, vec3(0.0)));
}

/// Between a ray's start and a place on it: a quotient of two look-ups towards the top.
vec3 transmittanceBetween(Air air, float h, float mu, float hThere, float muThere, bool ground) {
#ifdef SKY_2008_TRANSMITTANCE
    bool down = mu <= 0.0;
#else
    bool down = ground;
#endif
    return down ? cappedQuotient(transmittanceToTop(air, hThere, -muThere),
                                 transmittanceToTop(air, h, -mu))
                : cappedQuotient(transmittanceToTop(air, h, mu),
                                 transmittanceToTop(air, hThere, muThere));
}

/// Of sunlight; the planet's shadow has the half-shade of the sun's disc, or with SKY_2008 none.
vec3 transmittanceToSun(Air air, float h, float muS) {
    float r = air.groundRadius + h;
    float above = muS + sqrt(airSquare(air, h)) / r;
#ifdef SKY_2008
    float seen = above >= 0.0 ? 1.0 : 0.0;
#else
    float edge = max(atmosphere.sun.w, 1e-6) * air.groundRadius / r;
    float seen = smoothstep(-edge, edge, above);
#endif
    return seen > 0.0 ? seen * transmittanceToTop(air, h, muS) : vec3(0.0);
}

/// Where to look for all nu of a ray: x, y, z in the texture, for nu's first slice.
vec3 scatteringCoordinate(Air air, float h, float mu, float muS, bool ground) {
#ifdef SKY_2008
    vec4 place = scatteringPlace2008(air, h, mu, muS, 0.0, ground);
#else
    vec4 place = scatteringPlace(air, tables.suns.x, h, mu, muS, 0.0, ground);
#endif
    return vec3(textureCoordinate(place.x, tables.scattering.x) / tables.scattering.w,
                halvesCoordinate(place.y, tables.scattering.y, ground),
                textureCoordinate(place.z, tables.scattering.z));
}

/// Which two slices hold nu, as shifts of x, and (z) how much the second counts.
vec3 nuSlices(float nu) {
    float slice = clamp(0.5 + 0.5 * nu, 0.0, 1.0) * (tables.scattering.w - 1.0);
    float first = floor(slice);
    float second = min(first + 1.0, tables.scattering.w - 1.0);
    return vec3(first, second, 0.0) / tables.scattering.w + vec3(0.0, 0.0, slice - first);
}

vec3 fourDimensional(sampler3D map, vec3 coordinate, vec3 slices) {
    return mix(textureLod(map, coordinate + vec3(slices.x, 0.0, 0.0), 0.0).rgb,
               textureLod(map, coordinate + vec3(slices.y, 0.0, 0.0), 0.0).rgb, slices.z);
}

/// The texel's ray; `ground` as its half of the table says.
void texelRay(Air air, ivec3 texel, OUT(float) h, OUT(float) mu, OUT(float) muS, OUT(float) nu,
              OUT(bool) ground) {
    int suns = int(tables.scattering.x);
    ground = float(texel.y) < 0.5 * tables.scattering.y;
    vec4 place = vec4(texelPlace(float(texel.x % suns), tables.scattering.x),
                      halvesPlace(float(texel.y), tables.scattering.y),
                      texelPlace(float(texel.z), tables.scattering.z),
                      tables.scattering.w > 1.0
                          ? texelPlace(float(texel.x / suns), tables.scattering.w)
                          : 0.5);
#ifdef SKY_2008
    scatteringRay2008(air, place, ground, h, mu, muS, nu);
#else
    scatteringRay(air, tables.suns.x, place, ground, h, mu, muS, nu);
#endif
}

/// Of a level plane at height h under a sun of cosine muS, by the table, which lies evenly in both.
vec3 irradianceAt(Air air, float h, float muS) {
    vec2 size = vec2(textureSize(irradianceMap, 0));
    return textureLod(irradianceMap,
                      vec2(textureCoordinate(0.5 + 0.5 * muS, size.x),
                           textureCoordinate(h / air.top, size.y)),
                      0.0).rgb;
}

/// By the sun itself: its transmittance times the mean cosine of its disc, or with SKY_2008 the dot
/// product of sun and ground.
vec3 sunIrradiance(Air air, float h, float muS) {
#ifdef SKY_2008
    return transmittanceToSun(air, h, muS) * max(muS, 0.0);
#else
    float edge = max(atmosphere.sun.w, 1e-6);
    float cosine = muS < -edge  ? 0.0
                   : muS > edge ? muS
                                : (muS + edge) * (muS + edge) / (4.0 * edge);
    return cosine > 0.0 ? cosine * transmittanceToTop(air, h, muS) : vec3(0.0);
#endif
}
