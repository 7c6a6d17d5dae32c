// Beams, method `clipped`: the thesis's sheets (Pessoa 2007) confined, pixel by pixel, to the part of
// the view ray inside a beam, even in the lamp's own projection, summed in single precision over all
// lamps of the tile and written once.
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
layout(binding = kLightMapsUnit) uniform sampler2DArray lightMaps;
layout(binding = kDepthUnit) uniform sampler2D depthMap;

flat in ivec2 lampRange;
layout(location = 0) out vec4 radiance;
#ifdef BEAMS_OUTPUT
layout(location = 1) out vec4 beamsOutput;
#endif

/// Level of the light map that neither a pixel nor a step between sheets steps over: slopeStep is the
/// way across the map from one sheet to the next, rayWidth the width of the pixel's ray at unit depth
/// of the lamp, in slopes.
float lightMapLevel(SpotLamp lamp, vec2 slopeStep, float rayWidth) {
    float texels = 0.5 * lamp.projection.x * float(lamp.layers.z);
    // Half the step: sheets a little over a texel apart still see every feature.
    float footprint = texels * max(0.5 * length(slopeStep), rayWidth);
    return floor(max(log2(max(footprint, 1.0e-4)), 0.0) + 0.5);
}

/// Light of one lamp that reaches the eye along origin + t direction (the lamp's frame), t in
/// begin..end metres.
vec3 beamRadiance(SpotLamp lamp, vec3 origin, vec3 direction, float begin, float end) {
    float entry;
    float exit;
    float zFar = lamp.candela.w > 0.0 ? 1.0 / lamp.candela.w : 1.0e30;
    bool pyramid = lamp.projection.w > 0.5;
    bool hit = pyramid ? clipToPyramid(origin, direction, 1.0 / lamp.projection.x, kLensMetres, zFar,
                                       begin, end, entry, exit)
                       : clipToCone(origin, direction, lamp.cone.z, lamp.cone.w, kLensMetres, zFar,
                                    begin, end, entry, exit);
    vec3 first = origin + entry * direction;
    vec3 last = origin + exit * direction;
    float z0 = max(first.z, 0.5 * kLensMetres);
    float z1 = max(last.z, 0.5 * kLensMetres);
    vec2 slope0 = first.xy / z0;
    vec2 slope1 = last.xy / z1;
    float width = exit - entry;
    // As many sheets as are asked for where the ray runs right across the beam, or far along it; fewer,
    // in the same distance from each other, where it only cuts a corner.
    float across = 0.5 * lamp.projection.x * length(slope1 - slope0);
    float along = 1.0 - min(z0, z1) / max(z0, z1);
    float count = ceil(settings.planes.x * clamp(max(across, 2.0 * along), 0.5, 1.0));

    float level = 0.0;
    if (lamp.layers.y >= 0) {
        float pixel = 2.0 * view.halfExtent.y * view.picture.w;
        float nearer = view.halfExtent.z > 0.5 ? 1.0 : 0.5 * (entry + exit);
        level = lightMapLevel(lamp, (slope1 - slope0) / count, pixel * nearer / max(z0, z1));
    }

    vec3 sum = vec3(0.0);
    // A ray that misses takes no sample: the loop's end, not a branch, so that nothing is computed
    // for it where both sides of a branch are run.
    float stop = hit ? 1.0 : 0.0;
    for (float x = 0.5 / count; x < stop; x += 1.0 / count) {
        vec2 slope = mix(slope0, slope1, x);
        float inverseDepth = mix(1.0 / z0, 1.0 / z1, x);
        float depth = 1.0 / inverseDepth;
        float t = entry + width * projectiveStep(x, z0, z1);
        vec3 lampToPoint = vec3(slope * depth, depth);
        float lampMetres = length(lampToPoint);
        float phase = phaseFunction(PHASE_KIND, -dot(lampToPoint, direction) / lampMetres,
                                    view.haze.z, view.haze.w);
        float share = scatteredShare(phase, view.haze.x, view.haze.y, lampMetres, t) *
                      rangeWindow(lampMetres, lamp.candela.w) /
                      (1.0 + dot(slope, slope));
        if (!pyramid) {
            share *= coneFalloff(depth / lampMetres, lamp.cone.x, lamp.cone.y);
        }
        if (lamp.layers.x >= 0) {
            vec3 at = shadowCoordinates(slope, inverseDepth, lamp.shadow.x, lamp.shadow.y);
            ivec3 texel = ivec3(ivec2(at.xy * lamp.shadow.w), lamp.layers.x);
            share *= texelFetch(shadowMaps, texel, 0).r <= at.z ? 1.0 : 0.0;
        }
        if (lamp.layers.y >= 0) {
            vec2 uv = lightMapUv(slope, lamp.projection.x, lamp.projection.y, lamp.projection.z);
            sum += share * textureLod(lightMaps, vec3(uv, float(lamp.layers.y)), level).rgb;
        } else {
            sum += vec3(share);
        }
    }
    // dt / r^2 = (b - a) / (z0 z1) cos^2 dx, the cosine being in the sum.
    return sum * lamp.candela.rgb * ((width / z0) / (z1 * count));
}

void main() {
    vec2 ndc = 2.0 * gl_FragCoord.xy * view.picture.zw - 1.0;
    vec3 origin = viewRayOrigin(ndc, view.halfExtent);
    vec3 direction = viewRayDirection(ndc, view.halfExtent);
    float depth = texelFetch(depthMap, ivec2(gl_FragCoord.xy), 0).r;
    float distanceMetres = viewDistance(depth, view.depthTerms, view.halfExtent.z);
    // A little before the surface, so that no sheet lies in it; and where there is none, far enough.
    float end = min(distanceMetres * (1.0 - 1.0e-4), kEndOfBeams) / -direction.z;
    float begin = view.depthTerms.z / -direction.z;

    vec3 sum = vec3(0.0);
    for (int i = 0; i < lampRange.y; ++i) {
        SpotLamp lamp = spotLamps[tileLamps[lampRange.x + i]];
        sum += beamRadiance(lamp, (lamp.lampFromView * vec4(origin, 1.0)).xyz,
                            mat3(lamp.lampFromView) * direction, begin, end);
    }
    radiance = vec4(sum, 0.0);
#ifdef BEAMS_OUTPUT
    beamsOutput = vec4(sum, 0.0);
#endif
}
