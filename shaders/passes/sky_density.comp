// What the air scatters at a place into a direction, per kilometre, of the light of the order
// before and of that which the ground reflects: a sum over 16 x 32 directions.
#include "passes/sky_lookup.glsl"
#include "passes/sky_layers.glsl"
#include "passes/sky_order.glsl"
#include "lib/pi.glsl"

layout(SKY_FORMAT, binding = kSkyScatteringImage) uniform writeonly image3D densityImage;

const int kZenithAngles = 16;
const int kAzimuths = 32;

shared vec2 azimuths[kAzimuths];  // cosine and sine

void main() {
    if (gl_LocalInvocationIndex < uint(kAzimuths)) {
        float phi = (float(gl_LocalInvocationIndex) + 0.5) * 2.0 * kPi / float(kAzimuths);
        azimuths[gl_LocalInvocationIndex] = vec2(cos(phi), sin(phi));
    }
    barrier();
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
    // The zenith is z, the ray's azimuth x.
    float sine = sqrt(max(1.0 - mu * mu, 0.0));
    float sunX = sine > 0.0 ? (nu - mu * muS) / sine : 0.0;
    float sunY = sqrt(max(1.0 - sunX * sunX - muS * muS, 0.0));

    vec3 rayleigh = vec3(0.0);
    vec3 mie = vec3(0.0);
    for (int i = 0; i < kZenithAngles; ++i) {
        float theta = (float(i) + 0.5) * kPi / float(kZenithAngles);
        float cosTheta = cos(theta);
        float sinTheta = sin(theta);
        bool below = hitsGround(air, h, cosTheta);
        vec3 coordinate = scatteringCoordinate(air, h, cosTheta, muS, below);
        float toGround = 0.0;
        vec3 reflectance = vec3(0.0);
        if (below) {
            toGround = distanceToGround(air, h, cosTheta);
            float muThere = cosineAlong(air, h, cosTheta, toGround, 0.0);
            reflectance = atmosphere.albedo.rgb / kPi *
                          transmittanceBetween(air, h, cosTheta, 0.0, muThere, true);
        }
        for (int j = 0; j < kAzimuths; ++j) {
            vec2 level = sinTheta * azimuths[j];
            float nuSun = clamp(dot(level, vec2(sunX, sunY)) + cosTheta * muS, -1.0, 1.0);
            vec3 light = orderBefore(air, coordinate, nuSun);
            if (below) {
                float muSThere = sunCosineAlong(air, h, muS, nuSun, toGround, 0.0);
                light += reflectance * irradianceAt(air, 0.0, muSThere);
            }
            float nuOut = sine * level.x + mu * cosTheta;
            light *= sinTheta;
            rayleigh += light * phaseRayleigh(nuOut);
            mie += light * phaseCornetteShanks(nuOut, air.mieG);
        }
    }
    float solidAngle = kPi / float(kZenithAngles) * 2.0 * kPi / float(kAzimuths);
    vec3 density = rayleigh * air.rayleighScattering * airDensity(h, air.rayleighHeight) +
                   mie * air.mieScattering * airDensity(h, air.mieHeight);
    imageStore(densityImage, texel, vec4(density * (1000.0 * solidAngle), 1.0));
}
