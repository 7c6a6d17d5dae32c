// Light scattered once, without the phase functions, Rayleigh's and Mie's apart: 50 steps of the
// trapezoid rule a texel. With SKY_EXACT_TEXELS 400, and transmittances as good, so that what is off
// in a picture is what interpolation loses.
#include "passes/sky_lookup.glsl"
#include "passes/sky_layers.glsl"

layout(SKY_FORMAT, binding = kSkyScatteringImage) uniform writeonly image3D scatteringImage;
layout(SKY_FORMAT, binding = kSkyMieImage) uniform writeonly image3D mieImage;
#ifdef SKY_MORE_ORDERS
layout(SKY_FORMAT, binding = kSkyOrderImage) uniform writeonly image3D orderImage;
#endif

#ifdef SKY_EXACT_TEXELS
const int kSteps = 400;
#else
const int kSteps = 50;
#endif

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
    float dt = distanceInAir(air, h, mu, ground) / float(kSteps);
    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
    for (int i = 0; i <= kSteps; ++i) {
        float t = float(i) * dt;
        float hThere = clamp(heightAlong(air, h, mu, t), 0.0, air.top);
        float muThere = cosineAlong(air, h, mu, t, hThere);
        float muSThere = sunCosineAlong(air, h, muS, nu, t, hThere);
        vec3 light = transmittanceToSun(air, hThere, muSThere);
        light *= transmittanceBetween(air, h, mu, hThere, muThere, ground);
        light *= i == 0 || i == kSteps ? 0.5 * dt : dt;
        rayleigh += light * airDensity(hThere, air.rayleighHeight);
        mie += light * airDensity(hThere, air.mieHeight);
    }
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
