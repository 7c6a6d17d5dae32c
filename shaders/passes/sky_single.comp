// Light scattered once, without the phase functions, Rayleigh's and Mie's apart: 50 steps of the
// trapezoid rule a texel. With SKY_EXACT_TEXELS 64 midpoints in each smooth piece of the ray, dense
// at its lower end, and transmittances as good, so that what is off in a picture is what
// interpolation loses.
#include "passes/sky_lookup.glsl"
#include "passes/sky_layers.glsl"

layout(SKY_FORMAT, binding = kSkyScatteringImage) uniform writeonly image3D scatteringImage;
layout(SKY_FORMAT, binding = kSkyMieImage) uniform writeonly image3D mieImage;
#ifdef SKY_MORE_ORDERS
layout(SKY_FORMAT, binding = kSkyOrderImage) uniform writeonly image3D orderImage;
#endif

const int kSteps = 50;
const int kExactSteps = 64;

/// Adds what `metres` of way around a place on the ray scatter to its start, of light `sun`.
void addLight(Air air, float h, float mu, float t, bool ground, float hThere, vec3 sun,
              float metres, inout vec3 rayleigh, inout vec3 mie) {
    float muThere = cosineAlong(air, h, mu, t, hThere);
    vec3 light = metres * sun * transmittanceBetween(air, h, mu, hThere, muThere, ground);
    rayleigh += light * airDensity(hThere, air.rayleighHeight);
    mie += light * airDensity(hThere, air.mieHeight);
}

float heightInAir(Air air, float h, float mu, float t) {
    return clamp(heightAlong(air, h, mu, t), 0.0, air.top);
}

void addSteps(Air air, float h, float mu, float muS, float nu, bool ground, inout vec3 rayleigh,
              inout vec3 mie) {
    float dt = distanceInAir(air, h, mu, ground) / float(kSteps);
    for (int i = 0; i <= kSteps; ++i) {
        float t = float(i) * dt;
        float hThere = heightInAir(air, h, mu, t);
        float muSThere = sunCosineAlong(air, h, muS, nu, t, hThere);
        addLight(air, h, mu, t, ground, hThere, transmittanceToSun(air, hThere, muSThere),
                 i == 0 || i == kSteps ? 0.5 * dt : dt, rayleigh, mie);
    }
}

/// Pieces end at the ray's lowest point and at the edges of the planet's shadow, out of which it is
/// lit by a sun that is a point.
void addPieces(Air air, float h, float mu, float muS, float nu, bool ground, inout vec3 rayleigh,
               inout vec3 mie) {
    float end = distanceInAir(air, h, mu, ground);
    float turn = min(distanceToLowest(air, h, mu), end);
    float entry;
    float exit;
    planetShadow(air, h, mu, muS, nu, entry, exit);
    entry = min(entry, end);
    exit = min(exit, end);
    float cuts[5] = float[5](0.0, min(turn, entry), max(min(turn, exit), entry), max(turn, exit),
                             end);
    for (int piece = 0; piece < 4; ++piece) {
        float first = cuts[piece];
        float size = cuts[piece + 1] - first;
        float middle = first + 0.5 * size;
        if (size <= 0.0 || (middle > entry && middle < exit)) {
            continue;
        }
        for (int i = 0; i < kExactSteps; ++i) {
            float u = (float(i) + 0.5) / float(kExactSteps);
            float t = middle >= turn ? first + size * u * u : first + size * (1.0 - u * u);
            float hThere = heightInAir(air, h, mu, t);
            float muSThere = sunCosineAlong(air, h, muS, nu, t, hThere);
            addLight(air, h, mu, t, ground, hThere, transmittanceToTop(air, hThere, muSThere),
                     2.0 * u * size / float(kExactSteps), rayleigh, mie);
        }
    }
}

void main() {
    ivec3 texel = layerTexel();
    if (!inLayer(texel)) {
        return;
    }
    Air air = readAir();
    float h;
    float mu;
    float muS;
    float nu;
    bool ground;
    texelRay(air, texel, h, mu, muS, nu, ground);
    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
#ifdef SKY_EXACT_TEXELS
    addPieces(air, h, mu, muS, nu, ground, rayleigh, mie);
#else
    addSteps(air, h, mu, muS, nu, ground, rayleigh, mie);
#endif
#if defined(SKY_EXACT_TEXELS) && defined(SKY_2008)
    float place = halvesPlace(float(texel.y), tables.scattering.y);
    float part = shortOfWay2008(air, h, place, ground);
    rayleigh *= part;
    mie *= part;
#endif
    rayleigh *= air.rayleighScattering;
    imageStore(scatteringImage, texel, vec4(rayleigh, 1.0));
    imageStore(mieImage, texel, vec4(mie * air.mieScattering, 1.0));
#ifdef SKY_MORE_ORDERS
    imageStore(orderImage, texel, vec4(rayleigh, 1.0));
#endif
}
