// Irradiance of level planes by one order of the sky's light (16 x 64 directions a texel), added to
// the sum of all orders; or with SKY_DIRECT by the sun, which is not.
#include "passes/sky_lookup.glsl"
#include "passes/sky_order.glsl"
#include "lib/pi.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = kSkyPlaneImage) uniform writeonly image2D orderImage;
layout(rgba32f, binding = kSkyIrradianceImage) uniform image2D sumImage;

const int kZenithAngles = 16;
const int kAzimuths = 64;

vec3 skyIrradiance(Air air, float h, float muS) {
    float step1 = 0.5 * kPi / float(kZenithAngles);
    float sunX = sqrt(max(1.0 - muS * muS, 0.0));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kZenithAngles; ++i) {
        float theta = (float(i) + 0.5) * step1;
        float cosTheta = cos(theta);
        float sinTheta = sin(theta);
        vec3 coordinate = scatteringCoordinate(air, h, cosTheta, muS, false);
        for (int j = 0; j < kAzimuths; ++j) {
            float phi = (float(j) + 0.5) * 2.0 * kPi / float(kAzimuths);
            float nu = clamp(sinTheta * cos(phi) * sunX + cosTheta * muS, -1.0, 1.0);
            sum += orderBefore(air, coordinate, nu) * (cosTheta * sinTheta);
        }
    }
    return sum * (step1 * 2.0 * kPi / float(kAzimuths));
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    vec2 size = vec2(imageSize(orderImage));
    if (any(greaterThanEqual(texel, ivec2(size)))) {
        return;
    }
    Air air = readAir();
    float muS = 2.0 * texelPlace(float(texel.x), size.x) - 1.0;
    float h = air.top * texelPlace(float(texel.y), size.y);
#ifdef SKY_DIRECT
    imageStore(orderImage, texel, vec4(sunIrradiance(air, h, muS), 1.0));
    imageStore(sumImage, texel, vec4(0.0));
#else
    vec3 light = skyIrradiance(air, h, muS);
    imageStore(orderImage, texel, vec4(light, 1.0));
    imageStore(sumImage, texel, vec4(imageLoad(sumImage, texel).rgb + light, 1.0));
#endif
}
