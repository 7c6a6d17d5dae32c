// How much of the sun a point of a surface sees, by cascades of shadow maps: near ones fine, far
// ones coarse. Each point takes the finest that holds it, and towards that one's sides more and more
// of the next, so that no line is seen between them.

layout(std140, binding = kSunShadowSlot) uniform SunShadowBlock { SunShadow sunShadow; };
layout(binding = kSunShadowUnit) uniform sampler2DArrayShadow sunShadowMaps;
layout(binding = kSunDepthUnit) uniform sampler2DArray sunShadowDepths;

const float kSunBlend = 0.06;        // of a cascade's half side
const float kSteepest = 64.0;         // slope of a surface, as the sun sees it, that is followed
const int kSearchTaps = 12;
const int kFilterTaps = 16;
// Places on a disc of radius 1, equally spread (Vogel's spiral).
const vec2 kSearchPlaces[kSearchTaps] = vec2[](
    vec2(0.2041, 0.0000), vec2(-0.2607, 0.2388), vec2(0.0399, -0.4547), vec2(0.3286, 0.4286),
    vec2(-0.6030, -0.1067), vec2(0.5712, -0.3634), vec2(-0.1911, 0.7107), vec2(-0.3644, -0.7016),
    vec2(0.7906, 0.2887), vec2(-0.8224, 0.3395), vec2(0.3965, -0.8472), vec2(0.2930, 0.9341));
const vec2 kFilterPlaces[kFilterTaps] = vec2[](
    vec2(0.1768, 0.0000), vec2(-0.2258, 0.2068), vec2(0.0346, -0.3938), vec2(0.2846, 0.3712),
    vec2(-0.5222, -0.0924), vec2(0.4947, -0.3147), vec2(-0.1655, 0.6155), vec2(-0.3156, -0.6076),
    vec2(0.6846, 0.2500), vec2(-0.7123, 0.2940), vec2(0.3434, -0.7337), vec2(0.2537, 0.8089),
    vec2(-0.7647, -0.4432), vec2(0.8971, -0.1972), vec2(-0.5475, 0.7788), vec2(-0.1265, -0.9761));

/// 0..1: the share of a point, relative to the cascade's middle in the sun's frame, that the cascade
/// answers for.
float shareOfCascade(int i, vec3 place) {
    float halfSide = sunShadow.cascades[i].w;
    float margin = float(sunShadow.counts.z) * sunShadow.depths[i].y;
    float room = min(halfSide - margin - max(abs(place.x), abs(place.y)), place.z - margin);
    return clamp(room / (kSunBlend * halfSide), 0.0, 1.0);
}

/// Depth beside a place of the map (xy 0..1, z depth) on its plane (depth for a unit of uv); where
/// that leaves the map behind, its end, so that what is empty there is not taken for a caster.
float depthBeside(vec3 at, vec2 slope, vec2 offset) {
    return max(at.z + dot(slope, offset), 0.0);
}

/// 0..1: what the map lets through to a place of it (xy 0..1, z depth), its neighbours at the same
/// slope (depth for a unit of uv).
float throughMap(vec3 at, float layer, vec2 slope, vec2 offset) {
    return texture(sunShadowMaps,
                   vec4(at.xy + offset, layer, depthBeside(at, slope, offset)));
}

/// Half the width of the half-shadow, in texels: as far from the edge's caster as the casters nearby
/// are on average. Negative where all around is lit; 0 where all is in the dark.
float penumbraTexels(int i, vec3 at, vec2 slope, float layer) {
    float texels = float(sunShadow.counts.y);
    // All that may be in the way stands no nearer to the sun than the map begins.
    float widest = (1.0 - at.z) / sunShadow.depths[i].x * sunShadow.sun.x / sunShadow.depths[i].y;
    float search = clamp(widest, 1.0, float(sunShadow.counts.z) - 3.0);
    float sum = 0.0;
    float count = 0.0;
    for (int tap = 0; tap < kSearchTaps; ++tap) {
        vec2 offset = kSearchPlaces[tap] * search / texels;
        float depth = textureLod(sunShadowDepths, vec3(at.xy + offset, layer), 0.0).r;
        float above = depth - depthBeside(at, slope, offset);
        if (above > 0.0) {
            sum += above;
            count += 1.0;
        }
    }
    if (count == 0.0 || count == float(kSearchTaps)) {
        return count == 0.0 ? -1.0 : 0.0;
    }
    float metres = sum / count / sunShadow.depths[i].x;
    return clamp(metres * sunShadow.sun.x / sunShadow.depths[i].y, 1e-3, search);
}

/// 0..1 by one cascade; `place` from its middle, `normal` of the triangle, both in the sun's frame.
float sunThroughCascade(int i, vec3 place, vec3 normal) {
    float halfSide = sunShadow.cascades[i].w;
    float texel = sunShadow.depths[i].y;
    float sine = sqrt(max(1.0 - normal.z * normal.z, 0.0));
    // Off the surface by what a texel covers there, so that it does not shade itself.
    vec3 moved = place + normal * (texel * (0.25 + 1.6 * sine)) + vec3(0.0, 0.0, 0.5 * texel);
    vec3 at = vec3(0.5 + 0.5 * moved.xy / halfSide, moved.z * sunShadow.depths[i].x);
    vec2 lean = -normal.xy / max(normal.z, 1.0 / kSteepest);
    vec2 slope = lean * (2.0 * halfSide * sunShadow.depths[i].x);
    float layer = float(i);
    float texels = float(sunShadow.counts.y);
    float penumbra = penumbraTexels(i, at, slope, layer);
    // No taps where it is all light or all dark.
    int taps = penumbra > 0.0 ? kFilterTaps : 0;
    float sum = penumbra < 0.0 ? 1.0 : 0.0;
    for (int tap = 0; tap < taps; ++tap) {
        vec2 offset = kFilterPlaces[tap] * max(penumbra, 1.0) / texels;
        sum += throughMap(at, layer, slope, offset) / float(kFilterTaps);
    }
    return sum;
}

/// 0..1 for a point in view space and the normal of its triangle.
float sunOnSurface(vec3 position, vec3 geometric) {
    vec3 fromEye = mat3(sunShadow.sunFromView) * position;
    vec3 normal = mat3(sunShadow.sunFromView) * geometric;
    // Lit from the side that faces the sun, whichever the eye sees.
    normal = normal.z < 0.0 ? -normal : normal;
    float sum = 0.0;
    float left = 1.0;
    int i = 0;
    // The next cascade that holds the point is looked for on its own: a processor that runs both
    // sides of a branch still spends nothing on the others.
    while (left > 0.0) {
        float share = 0.0;
        while (i < sunShadow.counts.x && share <= 0.0) {
            share = shareOfCascade(i, fromEye - sunShadow.cascades[i].xyz);
            ++i;
        }
        if (share <= 0.0) {
            break;
        }
        share *= left;
        sum += share * sunThroughCascade(i - 1, fromEye - sunShadow.cascades[i - 1].xyz, normal);
        left -= share;
    }
    // What no further cascade holds is as what there is.
    return left < 1.0 ? sum / (1.0 - left) : 1.0;
}
