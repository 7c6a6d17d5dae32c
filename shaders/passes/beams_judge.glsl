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
layout(std430, binding = kExposureSlot) readonly buffer Exposure { float ev100; int toneCurve; };
layout(binding = kDepthUnit) uniform sampler2D depthMap;
layout(binding = kColorUnit) uniform sampler2D colorMap;

ivec2 pointCount() { return (ivec2(view.picture.xy) + kStep - 1) / kStep; }

/// Relative difference of two reversed depths up to which they count as one surface.
const float kSameSurface = 0.01;

vec4 point(ivec2 at) {
    return texelFetch(pointMap, clamp(at, ivec2(0), pointCount() - 1), 0);
}

/// Second difference at b on a line of points a, b, c.
vec3 bend(vec4 a, vec4 b, vec4 c) { return a.rgb - 2.0 * b.rgb + c.rgb; }

/// How far the light between two points may stray from the chord, given the bends at both.
// Where they are of one sign the light is a curve: a parabola strays by an eighth of its bend, a kink by
// half of it. Where the signs differ an edge stands between the points, and a pixel next to it strays by
// nearly all of the step.
vec3 strayOfChord(vec3 first, vec3 second) {
    vec3 least = min(abs(first), abs(second));
    vec3 most = max(abs(first), abs(second));
    vec3 edge = mix(vec3(0.0), least, lessThan(first * second, vec3(0.0)));
    return 0.5 * (most + edge);
}

/// What a screen shows, 0..1.
vec3 shown(vec3 luminance) {
    return srgbEncode(tonemap(toneCurve, max(luminance, vec3(0.0)) * exposureFromEv100(ev100)));
}

/// Whether the screen would show light bent more than tolerated.
bool isBent(ivec2 square, vec3 surface, vec4 p00, vec4 p10, vec4 p01, vec4 p11) {
    vec3 across =
        max(strayOfChord(bend(point(square + ivec2(-1, 0)), p00, p10), bend(p00, p10, point(square + ivec2(2, 0)))),
            strayOfChord(bend(point(square + ivec2(-1, 1)), p01, p11), bend(p01, p11, point(square + ivec2(2, 1)))));
    vec3 down =
        max(strayOfChord(bend(point(square + ivec2(0, -1)), p00, p01), bend(p00, p01, point(square + ivec2(0, 2)))),
            strayOfChord(bend(point(square + ivec2(1, -1)), p10, p11), bend(p10, p11, point(square + ivec2(1, 2)))));
    vec3 stray = max(across, down);
    vec3 mean = 0.25 * (p00.rgb + p10.rgb + p01.rgb + p11.rgb);
    // More of it downwards, where the screen shows it more: for an edge between light and dark all of
    // what a dark pixel may be given wrongly.
    vec3 error = shown(surface + mean + stray / 3.0) - shown(surface + max(mean - stray * (2.0 / 3.0), vec3(0.0)));
    return max(error.r, max(error.g, error.b)) >= settings.adaptive.x;
}

/// Whether a surface in the square ends the beams elsewhere than the surfaces at its corners tell.
bool isCut(ivec2 low, vec3 surface, vec4 p00, vec4 p10, vec4 p01, vec4 p11) {
    ivec2 high = low + kStep;
    float d00 = texelFetch(depthMap, low, 0).r;
    float d10 = texelFetch(depthMap, ivec2(high.x, low.y), 0).r;
    float d01 = texelFetch(depthMap, ivec2(low.x, high.y), 0).r;
    float d11 = texelFetch(depthMap, high, 0).r;
    float nearest = max(max(d00, d10), max(d01, d11));
    float farthestCorner = min(min(d00, d10), min(d01, d11));
    float farthest = farthestCorner;
    float stray = 0.0;
    // Four texels at a time, in the order that textureGather gives them.
    for (int i = 0; i < kStep * kStep / 4; ++i) {
        ivec2 at = 2 * ivec2(i % (kStep / 2), i / (kStep / 2));
        vec4 depths = textureGather(depthMap, vec2(low + at + 1) * view.picture.zw);
        vec4 x = (float(at.x) + vec4(0.0, 1.0, 1.0, 0.0)) / float(kStep);
        vec4 y = (float(at.y) + vec4(1.0, 1.0, 0.0, 0.0)) / float(kStep);
        vec4 strays = abs(depths - mix(mix(vec4(d00), vec4(d10), x), mix(vec4(d01), vec4(d11), x), y));
        stray = max(stray, max(max(strays.x, strays.y), max(strays.z, strays.w)));
        farthest = min(farthest, min(min(depths.x, depths.y), min(depths.z, depths.w)));
        nearest = max(nearest, max(max(depths.x, depths.y), max(depths.z, depths.w)));
    }
    // Surfaces that all lie behind the beams do not matter.
    float beamEnd = max(max(p00.a, p10.a), max(p01.a, p11.a));
    vec2 ndc = (vec2(low + high) + 1.0) * view.picture.zw - 1.0;
    float alongAxis = -viewRayDirection(ndc, view.halfExtent).z;
    float metres = viewDistance(nearest, view.depthTerms, view.halfExtent.z);
    bool behind = metres * (1.0 - 1.0e-3) > beamEnd * alongAxis;
    // Nearer surfaces take light away, if there is any; through a gap light may show that no corner has.
    vec3 light = shown(surface + max(max(p00.rgb, p10.rgb), max(p01.rgb, p11.rgb))) - shown(surface);
    bool bright = max(light.r, max(light.g, light.b)) > settings.adaptive.x;
    bool gap = farthest < farthestCorner * (1.0 - kSameSurface);
    return (bright || gap) && stray > kSameSurface * nearest && !behind;
}

bool needsSamples(ivec2 square) {
    vec4 p00 = point(square);
    vec4 p10 = point(square + ivec2(1, 0));
    vec4 p01 = point(square + ivec2(0, 1));
    vec4 p11 = point(square + ivec2(1, 1));
    ivec2 low = square * kStep;
    vec3 surface = min(texelFetch(colorMap, low, 0).rgb, texelFetch(colorMap, low + kStep, 0).rgb);
    return isBent(square, surface, p00, p10, p01, p11) || isCut(low, surface, p00, p10, p01, p11);
}
