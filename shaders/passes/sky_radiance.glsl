// The sky's light along a ray, marched: light scattered once by Gauss' rule between the edges of the
// planet's shadow, light scattered before out of the tables of sources. Nothing is subtracted but
// optical lengths. Rays as in lib/air_shell.glsl. Where SOURCES is not defined there is only light
// scattered once, and no table of the rest.
#include "passes/sky_block.glsl"
#include "lib/phase_function.glsl"
#include "lib/sky_tables.glsl"

layout(binding = kOpticalLengthsUnit) uniform sampler2D opticalLengths;
#ifdef SOURCES
layout(binding = kRayleighSourcesUnit) uniform sampler2DArray rayleighSources;
layout(binding = kMieSourcesUnit) uniform sampler2DArray mieSources;
layout(binding = kSkyIrradianceUnit) uniform sampler2D groundIrradiance;
#endif

// Gauss and Legendre's nodes over 0..1 and their weights; and the integrals from 0 to each node of
// the polynomials that are 1 at one node: [to][of].
const int kSkyNodes = 8;
const float kNodes[kSkyNodes] = float[kSkyNodes](
    0.019855072, 0.101666761, 0.237233795, 0.408282679, 0.591717321, 0.762766205, 0.898333239, 0.980144928);
const float kWeights[kSkyNodes] = float[kSkyNodes](
    0.050614268, 0.111190517, 0.156853323, 0.181341892, 0.181341892, 0.156853323, 0.111190517, 0.050614268);
const float kPartial[kSkyNodes * kSkyNodes] = float[kSkyNodes * kSkyNodes](
    0.025307134, -0.009105943, 0.006280831, -0.004483016, 0.003078491, -0.001917675, 0.000972758, -0.000277508,
    0.054759322, 0.055595259, -0.013639796, 0.008149709, -0.005215352, 0.003139753, -0.001564935, 0.000442802,
    0.048587536, 0.120859525, 0.078426661, -0.015975103, 0.008371733, -0.004643466, 0.002225715, -0.000618806,
    0.051865521, 0.106193490, 0.170671134, 0.090670946, -0.016021041, 0.007241207, -0.003197814, 0.000859237,
    0.049755032, 0.114388332, 0.149612116, 0.197362933, 0.090670946, -0.013817811, 0.004997027, -0.001251253,
    0.051233074, 0.108964802, 0.161496789, 0.172970159, 0.197316995, 0.078426661, -0.009669008, 0.002026732,
    0.050171466, 0.112755452, 0.153713570, 0.186557244, 0.173192183, 0.170493119, 0.055595259, -0.004145054,
    0.050891776, 0.110217760, 0.158770998, 0.178263400, 0.185824907, 0.150572492, 0.120296461, 0.025307134);
// Parts that each smooth piece of a ray is summed up in; more than one where air is so thick that its
// light comes from a small stretch of the way.
#ifndef SKY_PARTS
#define SKY_PARTS 1
#endif

struct SkyLight {
    vec3 rayleigh;  // scattered once, without the phase function
    vec3 mie;
    vec3 later;     // scattered before
    vec2 lengths;   // optical, of the whole way
};

vec4 cubicWeights(float t) {
    return vec4(-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0,
                -t * (t - 1.0) * (t - 3.0) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0);
}

/// Optical lengths from a height 0..top to the air's end, for rays that do not hit the ground.
vec2 lengthsToTop(Air air, float h, float mu) {
    float distanceMetres = distanceToTop(air, h, mu);
    vec2 place = vec2(lengthColumn(air, h, distanceMetres), lengthRow(air, h));
    ivec2 first = clamp(ivec2(place) - 1, ivec2(0), ivec2(kLengthCosines, kLengthHeights) - 4);
    vec4 across = cubicWeights(place.x - float(first.x));
    vec4 down = cubicWeights(place.y - float(first.y));
    vec2 sum = vec2(0.0);
    for (int row = 0; row < 4; ++row) {
        vec2 line = vec2(0.0);
        for (int column = 0; column < 4; ++column) {
            line += across[column] *
                    texelFetch(opticalLengths, first + ivec2(column, row), 0).rg;
        }
        sum += down[row] * line;
    }
    return distanceMetres * exp(sum);
}

/// Over a distance within the air; `ground`: the endless ray hits it.
vec2 lengthsAlong(Air air, float h, float mu, float t, bool ground) {
    float there = clamp(heightAlong(air, h, mu, t), 0.0, air.top);
    float muThere = cosineAlong(air, h, mu, t, there);
    vec2 lengths = ground ? lengthsToTop(air, there, -muThere) - lengthsToTop(air, h, -mu)
                          : lengthsToTop(air, h, mu) - lengthsToTop(air, there, muThere);
    return max(lengths, vec2(0.0));
}

vec3 sunTransmittance(Air air, float h, float muS) {
    vec2 lengths = lengthsToTop(air, h, muS);
    return airTransmittance(air, lengths.x, lengths.y);
}

#ifdef SOURCES
void addSources(Air air, float h, float mu, float muS, float nu, vec3 rayleigh, vec3 mie,
                inout vec3 light) {
    vec2 place = vec2(sourceSun(sky.suns.xyz, muS), float(kSourceZeniths - 1) * acos(mu) * kInversePi);
    vec2 uv = (place + 0.5) / vec2(kSourceSuns, kSourceZeniths);
    float height = sourceHeight(air, h);
    float azimuth = float(kSourceAzimuths - 1) * acos(skyAzimuthCosine(mu, muS, nu)) * kInversePi;
    float lowHeight = min(floor(height), float(kSourceHeights - 2));
    float lowAzimuth = min(floor(azimuth), float(kSourceAzimuths - 2));
    vec2 part = vec2(height - lowHeight, azimuth - lowAzimuth);
    float layer = lowHeight * float(kSourceAzimuths) + lowAzimuth;
    vec3 r = mix(mix(texture(rayleighSources, vec3(uv, layer)).rgb,
                     texture(rayleighSources, vec3(uv, layer + 1.0)).rgb, part.y),
                 mix(texture(rayleighSources, vec3(uv, layer + float(kSourceAzimuths))).rgb,
                     texture(rayleighSources, vec3(uv, layer + float(kSourceAzimuths + 1))).rgb, part.y),
                 part.x);
    vec3 m = mix(mix(texture(mieSources, vec3(uv, layer)).rgb,
                     texture(mieSources, vec3(uv, layer + 1.0)).rgb, part.y),
                 mix(texture(mieSources, vec3(uv, layer + float(kSourceAzimuths))).rgb,
                     texture(mieSources, vec3(uv, layer + float(kSourceAzimuths + 1))).rgb, part.y),
                 part.x);
    light += rayleigh * exp(r) + mie * exp(m);
}
#endif

/// Adds a part of a piece of the ray on which all is smooth, and its optical lengths to those before
/// it. The part lies between two squares of the piece's way from its lower end, `from` and from + part
/// of 0..1.
void addPiece(Air air, vec4 ray, float first, float last, bool rises, bool lit, float from,
              float part, inout SkyLight light) {
    float size = last - first;
    vec2 densities[kSkyNodes];
    float heights[kSkyNodes];
    vec2 whole = vec2(0.0);
    for (int i = 0; i < kSkyNodes; ++i) {
        float u = from + part * kNodes[i];
        float way = size * u * u;
        float h = clamp(heightAlong(air, ray.x, ray.y, rises ? first + way : last - way), 0.0, air.top);
        heights[i] = h;
        densities[i] = 2.0 * u * part * size *
                       vec2(airDensity(h, air.rayleighHeight), airDensity(h, air.mieHeight));
        whole += kWeights[i] * densities[i];
    }
    for (int i = 0; i < kSkyNodes; ++i) {
        vec2 lengths = vec2(0.0);
        for (int k = 0; k < kSkyNodes; ++k) {
            lengths += kPartial[i * kSkyNodes + k] * densities[k];
        }
        lengths = light.lengths + max(rises ? lengths : whole - lengths, vec2(0.0));
        vec3 reaching = kWeights[i] * airTransmittance(air, lengths.x, lengths.y);
        vec3 rayleigh = densities[i].x * air.rayleighScattering * reaching;
        vec3 mie = densities[i].y * air.mieScattering * reaching;
        float u = from + part * kNodes[i];
        float way = size * u * u;
        float t = rises ? first + way : last - way;
        float h = heights[i];
        float muS = sunCosineAlong(air, ray.x, ray.z, ray.w, t, h);
        if (lit) {
            vec3 sun = sunTransmittance(air, h, muS);
            light.rayleigh += rayleigh * sun;
            light.mie += mie * sun;
        }
#ifdef SOURCES
        addSources(air, h, cosineAlong(air, ray.x, ray.y, t, h), muS, ray.w, rayleigh, mie, light.later);
#endif
    }
    light.lengths += whole;
}

/// Light that comes to the ray's start from `lengthMetres` of way within the air, for a sun of
/// irradiance 1. ray: height 0..top, mu, muS, nu.
SkyLight marchSky(Air air, vec4 ray, float lengthMetres) {
    float turn = min(distanceToLowest(air, ray.x, ray.y), lengthMetres);
    float entry;
    float exit;
    planetShadow(air, ray.x, ray.y, ray.z, ray.w, entry, exit);
    float cuts[5];
    cuts[0] = 0.0;
    cuts[4] = lengthMetres;
    float low = min(entry, lengthMetres);
    float high = min(exit, lengthMetres);
    cuts[1] = min(turn, low);
    cuts[2] = max(min(turn, high), low);
    cuts[3] = max(turn, high);
    SkyLight light;
    light.rayleigh = vec3(0.0);
    light.mie = vec3(0.0);
    light.later = vec3(0.0);
    light.lengths = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        if (cuts[i + 1] > cuts[i]) {
            float middle = 0.5 * (cuts[i] + cuts[i + 1]);
            bool rises = middle >= turn;
            for (int k = 0; k < SKY_PARTS; ++k) {
                float part = 1.0 / float(SKY_PARTS);
                addPiece(air, ray, cuts[i], cuts[i + 1], rises, middle <= entry || middle >= exit,
                         part * float(rises ? k : SKY_PARTS - 1 - k), part, light);
            }
        }
    }
    return light;
}

/// Irradiance of level ground by sun and sky, for a sun of irradiance 1.
vec3 skyOnGround(Air air, float muS) {
    vec3 light = muS > 0.0 ? muS * sunTransmittance(air, 0.0, muS) : vec3(0.0);
#ifdef SOURCES
    float place = (sourceSun(sky.suns.xyz, muS) + 0.5) / float(kSourceSuns);
    light += exp(texture(groundIrradiance, vec2(place, 0.5)).rgb);
#endif
    return light;
}

/// What the ground reflects into a ray that ends on it.
vec3 groundLight(Air air, vec4 ray, float lengthMetres, vec3 transmittanceThere) {
    float muS = sunCosineAlong(air, ray.x, ray.z, ray.w, lengthMetres, 0.0);
    return transmittanceThere * atmosphere.albedo.rgb * kInversePi * skyOnGround(air, muS);
}
