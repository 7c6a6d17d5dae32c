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
layout(binding = kShadowPyramidUnit) uniform sampler2DArray shadowPyramid;
layout(binding = kLightMapsUnit) uniform sampler2DArray lightMaps;
layout(binding = kDepthUnit) uniform sampler2D depthMap;
#include "lib/shadow_runs.glsl"

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

bool isPyramid(SpotLamp lamp) { return lamp.projection.w > 0.5; }

/// Level of the light map that one texel a step of `slopes` (x / z, y / z) across it asks for.
float lightMapLevel(SpotLamp lamp, float slopes) {
    return log2(max(0.5 * lamp.projection.x * float(lamp.layers.z) * slopes, 1.0));
}

/// The part of a ray that lies in a beam, in the lamp's frame.
struct BeamPart {
    vec3 origin;     // of the ray
    vec3 direction;  // unit
    float entry;     // metres along the ray
    float exit;
    float z0;        // depth along the beam at the entry, in metres
    float z1;        // at the exit
    LampStretch stretch;
    float stepLevel;  // of the light map, for a sheet
};

/// False where the ray misses the beam, or a surface ends it before; beamEnd is grown to where the ray
/// leaves the beam, were there no surface.
bool clipToBeam(SpotLamp lamp, PixelRay ray, inout float beamEnd, out BeamPart part) {
    part.origin = (lamp.lampFromView * vec4(ray.origin, 1.0)).xyz;
    part.direction = mat3(lamp.lampFromView) * ray.direction;
    float zFar = lamp.candela.w > 0.0 ? 1.0 / lamp.candela.w : 1.0e30;
    float farthest = kEndOfBeams / -ray.direction.z;
    bool hit = isPyramid(lamp)
                   ? clipToPyramid(part.origin, part.direction, 1.0 / lamp.projection.x, kLensMetres,
                                   zFar, ray.begin, farthest, part.entry, part.exit)
                   : clipToCone(part.origin, part.direction, lamp.cone.z, lamp.cone.w, kLensMetres,
                                zFar, ray.begin, farthest, part.entry, part.exit);
    beamEnd = hit ? max(beamEnd, part.exit) : beamEnd;
    part.exit = min(part.exit, ray.end);
    vec3 first = part.origin + part.entry * part.direction;
    vec3 last = part.origin + part.exit * part.direction;
    part.z0 = max(first.z, 0.5 * kLensMetres);
    part.z1 = max(last.z, 0.5 * kLensMetres);
    part.stretch = LampStretch(first.xy / part.z0, last.xy / part.z1, 1.0 / part.z0, 1.0 / part.z1);
    // Half the step: sheets a little over a texel apart still see every feature.
    vec2 slopes = part.stretch.slope1 - part.stretch.slope0;
    part.stepLevel = lightMapLevel(lamp, 0.5 * length(slopes) / settings.planes.x);
    return hit && part.entry < part.exit;
}

/// Where a sheet cuts the ray.
struct SheetPoint {
    float t;  // metres along the ray
    vec3 lampToPoint;
    float lampMetres;
    vec2 slope;  // x / z, y / z
    float inverseDepth;
    float weight;  // dt / r^2 in units of wholeStep's
};

/// x: place among the sheets, 0..1.
SheetPoint sheetPoint(BeamPart part, float x) {
    SheetPoint point;
#ifdef EVEN_STEPS
    point.t = mix(part.entry, part.exit, x);
    point.lampToPoint = part.origin + point.t * part.direction;
    point.lampToPoint.z = max(point.lampToPoint.z, 0.5 * kLensMetres);
    point.inverseDepth = 1.0 / point.lampToPoint.z;
    point.slope = point.lampToPoint.xy * point.inverseDepth;
    point.lampMetres = length(point.lampToPoint);
    point.weight = inverseSquare(point.lampMetres);
#else
    point.slope = mix(part.stretch.slope0, part.stretch.slope1, x);
    point.inverseDepth = mix(part.stretch.inverse0, part.stretch.inverse1, x);
    float depth = 1.0 / point.inverseDepth;
    point.t = part.entry + (part.exit - part.entry) * projectiveStep(x, part.z0, part.z1);
    point.lampToPoint = vec3(point.slope * depth, depth);
    point.lampMetres = length(point.lampToPoint);
    // dt / r^2 = (b - a) / (z0 z1) cos^2 dx, the first factor standing in wholeStep.
    point.weight = 1.0 / (1.0 + dot(point.slope, point.slope));
#endif
    return point;
}

/// The sheets' weights stand for this.
float wholeStep(BeamPart part) {
#ifdef EVEN_STEPS
    return part.exit - part.entry;
#else
    return ((part.exit - part.entry) / part.z0) / part.z1;
#endif
}

/// Light that a sheet sends to the eye, for a lamp of one candela that nothing shades.
vec3 sheetLight(SpotLamp lamp, BeamPart part, SheetPoint point) {
    float phase = phaseFunction(PHASE_KIND, -dot(point.lampToPoint, part.direction) / point.lampMetres,
                                view.haze.z, view.haze.w);
    float share = scatteredShare(phase, view.haze.x, view.haze.y, point.lampMetres, point.t) *
                  rangeWindow(point.lampMetres, lamp.candela.w) * point.weight;
    if (!isPyramid(lamp)) {
        float cosAngle = point.lampToPoint.z / point.lampMetres;
        share *= coneFalloff(cosAngle, lamp.cone.x, lamp.cone.y);
    }
#ifdef LIGHT_MAPS
    if (lamp.layers.y >= 0) {
        vec2 uv = lightMapUv(point.slope, lamp.projection.x, lamp.projection.y, lamp.projection.z);
        float pixel = 2.0 * view.halfExtent.y * view.picture.w;  // its width, at unit distance or always
        float metres = view.halfExtent.z > 0.5 ? 1.0 : point.t;
        float level = max(part.stepLevel, lightMapLevel(lamp, pixel * metres * point.inverseDepth));
        level = settings.planes.x < kSheetsForSmoothLevels ? floor(level + 0.5) : level;
        return share * textureLod(lightMaps, vec3(uv, float(lamp.layers.y)), level).rgb;
    }
#endif
    return vec3(share);
}

/// Light of one lamp that reaches the eye along the ray; beamEnd as for clipToBeam.
// A ray that misses takes one sample: the loop's end, not a branch, so that little is computed for it
// where both sides of a branch are run. The test stands last, since a round that only finds the end
// costs as much as any other there.
vec3 beamRadiance(SpotLamp lamp, PixelRay ray, inout float beamEnd) {
    BeamPart part;
    bool hit = clipToBeam(lamp, ray, beamEnd, part);
    float count = settings.planes.x;
    vec3 sum = vec3(0.0);
#ifdef SHADOW_RUNS
    // Sets of sheets one after another, and of each only the lit sheets.
    float set = 0.0;
    do {
        uint lit = litSheets(lamp, part.stretch, set, count, hit);
        do {
            uint low = lit & (0u - lit);
            lit ^= low;
            float x = low != 0u ? (set + float(lowestBit(low)) + 0.5) / count : 0.5;
            vec3 light = sheetLight(lamp, part, sheetPoint(part, x));
            sum += low != 0u ? light : vec3(0.0);
        } while (lit != 0u);
        set += float(kSheetsASet);
    } while (hit && set < count);
#else
    // Steps are counted: a sum of 1 / count drifts until it takes a sample too many or too few.
    float stop = hit ? count : 0.0;
    float i = 0.5;
    do {
        SheetPoint point = sheetPoint(part, i / count);
        float lit = 1.0;
        if (lamp.layers.x >= 0) {
            vec3 at = shadowCoordinates(point.slope, point.inverseDepth, lamp.shadow.x, lamp.shadow.y);
            ivec3 texel = ivec3(ivec2(at.xy * lamp.shadow.w), lamp.layers.x);
            lit = texelFetch(shadowMaps, texel, 0).r <= at.z ? 1.0 : 0.0;
        }
        sum += lit * sheetLight(lamp, part, point);
        i += 1.0;
    } while (i < stop);
#endif
    return hit ? sum * lamp.candela.rgb * lamp.towardsEye.rgb * (wholeStep(part) / count) : vec3(0.0);
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
