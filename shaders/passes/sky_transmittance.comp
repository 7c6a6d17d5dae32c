// The table of transmittance to the top: 500 steps of the trapezoid rule a texel.
#include "passes/sky_lookup.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = kSkyPlaneImage) uniform writeonly image2D transmittanceImage;

const int kSteps = 500;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(imageSize(transmittanceImage));
    if (any(greaterThanEqual(texel, ivec2(size)))) {
        return;
    }
    Air air = readAir();
    float h;
    float mu;
#ifdef SKY_2008_TRANSMITTANCE
    transmittanceRay2008(air, (vec2(texel) + 0.5) / size, h, mu);
    if (hitsGround(air, h, mu)) {
        imageStore(transmittanceImage, texel, vec4(0.0));
        return;
    }
#else
    transmittanceRay(air, vec2(texelPlace(float(texel.x), size.x), texelPlace(float(texel.y), size.y)),
                     h, mu);
#endif
    float dt = distanceToTop(air, h, mu) / float(kSteps);
    vec2 sum = vec2(0.0);
    for (int i = 0; i <= kSteps; ++i) {
        float there = heightAlong(air, h, mu, float(i) * dt);
        float weight = i == 0 || i == kSteps ? 0.5 * dt : dt;
        sum += weight * vec2(airDensity(there, air.rayleighHeight), airDensity(there, air.mieHeight));
    }
    imageStore(transmittanceImage, texel, vec4(airTransmittance(air, sum.x, sum.y), 1.0));
}
