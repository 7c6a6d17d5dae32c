// Beams, method `adaptive`: which squares interpolation does not fill well enough, because the light
// bends between its points, by what the screen would show of it, or because something in the square
// ends the beams at another depth than at its corners. Whoever includes it says kStep, the side of a
// square in pixels, and pointMap, the points it lies between.
#include "shared/view.h"
#include "lib/tonemap.glsl"
#include "lib/view_ray.glsl"
#include "lib/beam_lattice.glsl"

layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std140, binding = kBeamSettingsSlot) uniform SettingsBlock { BeamSettings settings; };
layout(std430, binding = kExposureSlot) readonly buffer Exposure { float ev100; };
layout(binding = kDepthUnit) uniform sampler2D depthMap;
layout(binding = kColorUnit) uniform sampler2D colorMap;

ivec2 pointCount() { return (ivec2(view.picture.xy) + kStep - 1) / kStep; }

/// Relative difference of two reversed depths up to which they count as one surface.
const float kSameSurface = 0.01;

vec4 point(ivec2 at) {
    return texelFetch(pointMap, clamp(at, ivec2(0), pointCount() - 1), 0);
}

/// Second difference at b on a line of points a, b, c.
vec3 bend(vec4 a, vec4 b, vec4 c) { return abs(a.rgb - 2.0 * b.rgb + c.rgb); }

/// What a screen shows, 0..1.
vec3 shown(vec3 luminance) {
    return srgbEncode(tonemap(max(luminance, vec3(0.0)) * exposureFromEv100(ev100)));
}

bool needsSamples(ivec2 square) {
    vec4 p00 = point(square);
    vec4 p10 = point(square + ivec2(1, 0));
    vec4 p01 = point(square + ivec2(0, 1));
    vec4 p11 = point(square + ivec2(1, 1));
    vec3 across = max(max(bend(point(square + ivec2(-1, 0)), p00, p10), bend(p00, p10, point(square + ivec2(2, 0)))),
                      max(bend(point(square + ivec2(-1, 1)), p01, p11), bend(p01, p11, point(square + ivec2(2, 1)))));
    vec3 down = max(max(bend(point(square + ivec2(0, -1)), p00, p01), bend(p00, p01, point(square + ivec2(0, 2)))),
                    max(bend(point(square + ivec2(1, -1)), p10, p11), bend(p10, p11, point(square + ivec2(1, 2)))));
    // A parabola strays from its chord by an eighth of its second difference; an edge by up to half.
    vec3 astray = 0.25 * (across + down);
    vec3 mean = 0.25 * (p00.rgb + p10.rgb + p01.rgb + p11.rgb);
    ivec2 low = square * kStep;
    ivec2 high = low + kStep;
    vec3 surface = min(texelFetch(colorMap, low, 0).rgb, texelFetch(colorMap, high, 0).rgb);
    vec3 error = shown(surface + mean + astray) - shown(surface + max(mean - astray, vec3(0.0)));
    bool bent = 0.5 * max(error.r, max(error.g, error.b)) >= settings.adaptive.x;

    float d00 = texelFetch(depthMap, low, 0).r;
    float d10 = texelFetch(depthMap, ivec2(high.x, low.y), 0).r;
    float d01 = texelFetch(depthMap, ivec2(low.x, high.y), 0).r;
    float d11 = texelFetch(depthMap, high, 0).r;
    float nearest = max(max(d00, d10), max(d01, d11));
    float stray = 0.0;
    // Four texels at a time, in the order that textureGather gives them.
    for (int i = 0; i < kStep * kStep / 4; ++i) {
        ivec2 at = 2 * ivec2(i % (kStep / 2), i / (kStep / 2));
        vec4 depths = textureGather(depthMap, vec2(low + at + 1) * view.picture.zw);
        vec4 x = (float(at.x) + vec4(0.0, 1.0, 1.0, 0.0)) / float(kStep);
        vec4 y = (float(at.y) + vec4(1.0, 1.0, 0.0, 0.0)) / float(kStep);
        vec4 strays = abs(depths - mix(mix(vec4(d00), vec4(d10), x), mix(vec4(d01), vec4(d11), x), y));
        stray = max(stray, max(max(strays.x, strays.y), max(strays.z, strays.w)));
        nearest = max(nearest, max(max(depths.x, depths.y), max(depths.z, depths.w)));
    }
    // Surfaces that all lie behind the beams do not matter.
    float beamEnd = max(max(p00.a, p10.a), max(p01.a, p11.a));
    vec2 ndc = (vec2(low + high) + 1.0) * view.picture.zw - 1.0;
    float alongAxis = -viewRayDirection(ndc, view.halfExtent).z;
    float metres = viewDistance(nearest, view.depthTerms, view.halfExtent.z);
    bool behind = metres * (1.0 - 1.0e-3) > beamEnd * alongAxis;
    vec3 light = shown(surface + max(max(p00.rgb, p10.rgb), max(p01.rgb, p11.rgb))) - shown(surface);
    bool bright = max(light.r, max(light.g, light.b)) > settings.adaptive.x;
    return bent || (bright && stray > kSameSurface * nearest && !behind);
}
