// The sky where its table is not to be interpolated, added to the picture: summed up along each
// pixel's own ray, in the listed tiles' pixels that are see-through still.
#include "passes/sky_seen.glsl"
#include "passes/sky_haze.glsl"
#include "shared/view.h"
#include "lib/haze.glsl"
#include "lib/view_ray.glsl"

layout(local_size_x = kSkyGroup, local_size_y = kSkyGroup) in;
layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(binding = kDepthUnit) uniform sampler2D depthMap;
layout(rgba32f, binding = kColorUnit) uniform image2D colorMap;
layout(std430, binding = kSkyEdgeTilesSlot) readonly buffer EdgeTiles {
    SkyEdgeHead head;
    uint tiles[];
};

void drawPixel(Air air, ivec2 at) {
    if (any(greaterThanEqual(at, ivec2(view.picture.xy)))) {
        return;
    }
    vec4 color = imageLoad(colorMap, at);
    if (color.a >= 1.0 || texelFetch(depthMap, at, 0).r > 0.0) {
        return;
    }
    vec2 uv = (vec2(at) + 0.5) * view.picture.zw;
    vec3 origin = viewRayOrigin(2.0 * uv - 1.0, view.halfExtent);
    vec3 direction = viewRayDirection(2.0 * uv - 1.0, view.halfExtent);
    float mu = dot(direction, sky.zenith.xyz);
    float nu = clamp(dot(direction, sky.sun.xyz), -1.0, 1.0);
    bool ground = mu < horizonPlace(air, sky.zenith.w).x;
    SeenLight seen =
        seenAlong(air, vec4(sky.zenith.w, mu, sky.sun.w, nu), zenithSine(direction), ground);
    vec3 light = seen.rest + seen.mie * phaseCornetteShanks(nu, air.mieG);
    float through = transmittance(view.haze.y, metresOfHaze(origin, direction, kEndOfHaze));
    color.rgb += (1.0 - color.a) * through * atmosphere.sun.rgb * light;
    color.a = 1.0;
    imageStore(colorMap, at, color);
}

void main() {
    Air air = readAir();
    for (uint i = gl_WorkGroupID.x; i < head.count; i += gl_NumWorkGroups.x) {
        ivec2 tile = ivec2(tiles[i] & 0xFFFFu, tiles[i] >> 16);
        drawPixel(air, tile * kSkyGroup + ivec2(gl_LocalInvocationID.xy));
    }
}
