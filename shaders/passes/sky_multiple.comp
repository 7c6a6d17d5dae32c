// One order of multiple scattering: the density of the order before summed up along each texel's
// ray by 50 steps of the trapezoid rule. It is kept as radiance for the next order, and added to
// the table of all orders divided by Rayleigh's phase function, by which a look-up multiplies.
#include "passes/sky_lookup.glsl"
#include "passes/sky_layers.glsl"

layout(SKY_FORMAT, binding = kSkyScatteringImage) uniform image3D sumImage;
layout(SKY_FORMAT, binding = kSkyOrderImage) uniform writeonly image3D orderImage;

const int kSteps = 50;

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
    vec3 slices = nuSlices(nu);
    float dt = distanceInAir(air, h, mu, ground) / float(kSteps);
    vec3 light = vec3(0.0);
    for (int i = 0; i <= kSteps; ++i) {
        float t = float(i) * dt;
        float hThere = clamp(heightAlong(air, h, mu, t), 0.0, air.top);
        float muThere = cosineAlong(air, h, mu, t, hThere);
        float muSThere = sunCosineAlong(air, h, muS, nu, t, hThere);
        vec3 coordinate = scatteringCoordinate(air, hThere, muThere, muSThere, ground);
        light += fourDimensional(scatteringMap, coordinate, slices) *
                 transmittanceBetween(air, h, mu, hThere, muThere, ground) *
                 (i == 0 || i == kSteps ? 0.5 : 1.0);
    }
    light *= 0.001 * dt;
    imageStore(orderImage, texel, vec4(light, 1.0));
    vec3 sum = imageLoad(sumImage, texel).rgb;
    imageStore(sumImage, texel, vec4(sum + light / phaseRayleigh(nu), 1.0));
}
