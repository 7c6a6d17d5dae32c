// Light of a beam along a view ray by the thesis's sheets (Pessoa 2007), confined to the part of the
// ray inside the beam and even in the lamp's own projection. No picture and no pixels.
// With EVEN_STEPS they are even along the ray instead: the plain march that others are measured by.
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/lamp.h"
#include "shared/beams.h"
#include "lib/haze.glsl"
#include "lib/spot_light.glsl"
#include "lib/phase_function.glsl"
#include "lib/beam_geometry.glsl"
#include "lib/beam_radiance.glsl"
#include "lib/shadow_projection.glsl"
#include "lib/view_ray.glsl"

layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std140, binding = kBeamSettingsSlot) uniform SettingsBlock { BeamSettings settings; };
layout(std430, binding = kLampsSlot) readonly buffer SpotLamps { SpotLamp spotLamps[]; };
layout(std430, binding = kTileLampsSlot) readonly buffer TileLamps { int tileLamps[]; };
layout(binding = kShadowMapsUnit) uniform sampler2DArray shadowMaps;
#ifdef SHADOW_RUNS
layout(binding = kShadowPyramidUnit) uniform sampler2DArray shadowPyramid;
#include "lib/shadow_runs.glsl"
#endif
layout(binding = kLightMapsUnit) uniform sampler2DArray lightMaps;
layout(binding = kDepthUnit) uniform sampler2D depthMap;

/// What a pixel sees of the haze: light from begin to end metres along the ray, in view space.
struct PixelRay {
    vec3 origin;
    vec3 direction;
    float begin;
    float end;
};

/// Distance along the ray of a pixel to the surface there, in metres; a little before it, so that no
/// sheet lies in it, and where there is none, far enough.
float pixelRayEnd(float depth, vec3 direction) {
    float metres = viewDistance(depth, view.depthTerms, view.halfExtent.z);
    return min(metres * (1.0 - 1.0e-4), kEndOfBeams) / -direction.z;
}

PixelRay pixelRay(ivec2 pixel) {
    vec2 ndc = 2.0 * (vec2(pixel) + 0.5) * view.picture.zw - 1.0;
    PixelRay ray;
    ray.origin = viewRayOrigin(ndc, view.halfExtent);
    ray.direction = viewRayDirection(ndc, view.halfExtent);
    ray.begin = view.depthTerms.z / -ray.direction.z;
    ray.end = pixelRayEnd(texelFetch(depthMap, pixel, 0).r, ray.direction);
    return ray;
}

/// From so many sheets on light maps are read between two of their levels; with fewer the levels would
/// not be what is wrong, and reading two takes longer.
const float kSheetsForSmoothLevels = 24.0;

/// Level of the light map that one texel a step of `slopes` (x / z, y / z) across it asks for.
float lightMapLevel(SpotLamp lamp, float slopes) {
    return log2(max(0.5 * lamp.projection.x * float(lamp.layers.z) * slopes, 1.0));
}

/// Light of one lamp that reaches the eye along the ray; beamEnd is grown to where the ray leaves the
/// beam, were there no surface.
vec3 beamRadiance(SpotLamp lamp, PixelRay ray, inout float beamEnd) {
    vec3 origin = (lamp.lampFromView * vec4(ray.origin, 1.0)).xyz;
    vec3 direction = mat3(lamp.lampFromView) * ray.direction;
    float entry;
    float exit;
    float zFar = lamp.candela.w > 0.0 ? 1.0 / lamp.candela.w : 1.0e30;
    bool pyramid = lamp.projection.w > 0.5;
    float farthest = kEndOfBeams / -ray.direction.z;
    bool hit = pyramid ? clipToPyramid(origin, direction, 1.0 / lamp.projection.x, kLensMetres, zFar,
                                       ray.begin, farthest, entry, exit)
                       : clipToCone(origin, direction, lamp.cone.z, lamp.cone.w, kLensMetres, zFar,
                                    ray.begin, farthest, entry, exit);
    beamEnd = hit ? max(beamEnd, exit) : beamEnd;
    exit = min(exit, ray.end);
    hit = hit && entry < exit;
    vec3 first = origin + entry * direction;
    vec3 last = origin + exit * direction;
    float z0 = max(first.z, 0.5 * kLensMetres);
    float z1 = max(last.z, 0.5 * kLensMetres);
    vec2 slope0 = first.xy / z0;
    vec2 slope1 = last.xy / z1;
    float width = exit - entry;
    float count = settings.planes.x;

    // Half the step: sheets a little over a texel apart still see every feature.
    float stepLevel = lightMapLevel(lamp, 0.5 * length(slope1 - slope0) / count);
    float pixel = 2.0 * view.halfExtent.y * view.picture.w;  // its width, at unit distance or always

    vec3 sum = vec3(0.0);
    // A ray that misses takes one sample: the loop's end, not a branch, so that little is computed for
    // it where both sides of a branch are run. The test stands last, since a round that only finds the
    // end costs as much as any other there.
    // Steps are counted: a sum of 1 / count drifts until it takes a sample too many or too few.
#ifdef SHADOW_RUNS
    // Sets of sheets one after another, and of each only the lit sheets.
    LampStretch stretch = LampStretch(slope0, slope1, 1.0 / z0, 1.0 / z1);
    float set = 0.0;
    do {
    uint lit = litSheets(lamp, stretch, set, count, hit);
    do {  // indented as the loop that it takes the place of
        uint low = lit & (0u - lit);
        lit ^= low;
        float x = low != 0u ? (set + float(lowestBit(low)) + 0.5) / count : 0.5;
#else
    float stop = hit ? count : 0.0;
    float i = 0.5;
    do {
        float x = i / count;
#endif
#ifdef EVEN_STEPS
        float t = mix(entry, exit, x);
        vec3 lampToPoint = origin + t * direction;
        lampToPoint.z = max(lampToPoint.z, 0.5 * kLensMetres);
        float depth = lampToPoint.z;
        float inverseDepth = 1.0 / depth;
        vec2 slope = lampToPoint.xy * inverseDepth;
        float lampMetres = length(lampToPoint);
        float weight = inverseSquare(lampMetres);
#else
        vec2 slope = mix(slope0, slope1, x);
        float inverseDepth = mix(1.0 / z0, 1.0 / z1, x);
        float depth = 1.0 / inverseDepth;
        float t = entry + width * projectiveStep(x, z0, z1);
        vec3 lampToPoint = vec3(slope * depth, depth);
        float lampMetres = length(lampToPoint);
        // dt / r^2 = (b - a) / (z0 z1) cos^2 dx, the first factor standing below.
        float weight = 1.0 / (1.0 + dot(slope, slope));
#endif
        float phase = phaseFunction(PHASE_KIND, -dot(lampToPoint, direction) / lampMetres,
                                    view.haze.z, view.haze.w);
        float share = scatteredShare(phase, view.haze.x, view.haze.y, lampMetres, t) *
                      rangeWindow(lampMetres, lamp.candela.w) * weight;
        if (!pyramid) {
            share *= coneFalloff(depth / lampMetres, lamp.cone.x, lamp.cone.y);
        }
#ifdef SHADOW_RUNS
        share = low != 0u ? share : 0.0;
#else
        if (lamp.layers.x >= 0) {
            vec3 at = shadowCoordinates(slope, inverseDepth, lamp.shadow.x, lamp.shadow.y);
            ivec3 texel = ivec3(ivec2(at.xy * lamp.shadow.w), lamp.layers.x);
            share *= texelFetch(shadowMaps, texel, 0).r <= at.z ? 1.0 : 0.0;
        }
#endif
        if (lamp.layers.y >= 0) {
            vec2 uv = lightMapUv(slope, lamp.projection.x, lamp.projection.y, lamp.projection.z);
            float metres = view.halfExtent.z > 0.5 ? 1.0 : t;
            float level = max(stepLevel, lightMapLevel(lamp, pixel * metres * inverseDepth));
            level = settings.planes.x < kSheetsForSmoothLevels ? floor(level + 0.5) : level;
            sum += share * textureLod(lightMaps, vec3(uv, float(lamp.layers.y)), level).rgb;
        } else {
            sum += vec3(share);
        }
#ifdef SHADOW_RUNS
    } while (lit != 0u);
    set += float(kSheetsASet);
    } while (hit && set < count);
#else
        i += 1.0;
    } while (i < stop);
#endif
#ifdef EVEN_STEPS
    float step = width / count;
#else
    float step = (width / z0) / (z1 * count);
#endif
    return hit ? sum * lamp.candela.rgb * step : vec3(0.0);
}

/// Light of a stretch of tileLamps: its first entry and their number, at least one.
vec3 beamsRadiance(PixelRay ray, ivec2 lampRange, inout float beamEnd) {
    vec3 sum = vec3(0.0);
    int i = lampRange.x;
    do {
        sum += beamRadiance(spotLamps[tileLamps[i]], ray, beamEnd);
        ++i;
    } while (i < lampRange.x + lampRange.y);
    return sum;
}
