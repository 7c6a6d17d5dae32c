// Beams, method `adaptive`, second step: lists the cells of the lattice that interpolation does not
// fill well enough, because the light bends between its points, by what the screen would show of it,
// or because something in the cell ends the beams at another depth than at its corners.
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/beams.h"
#include "lib/tonemap.glsl"
#include "lib/view_ray.glsl"
#include "lib/beam_lattice.glsl"

layout(local_size_x = kBeamGroup) in;
layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std140, binding = kBeamSettingsSlot) uniform SettingsBlock { BeamSettings settings; };
layout(std430, binding = kExposureSlot) readonly buffer Exposure { float ev100; };
layout(std430, binding = kTilesSlot) readonly buffer Tiles { BeamTile tiles[]; };
layout(std430, binding = kSampledCellsSlot) buffer SampledCells { SampledCellsHead sampled; ivec4 cells[]; };
layout(binding = kDepthUnit) uniform sampler2D depthMap;
layout(binding = kColorUnit) uniform sampler2D colorMap;
layout(binding = kBeamLatticeUnit) uniform sampler2D latticeMap;
layout(r8, binding = kBeamCellsUnit) uniform writeonly image2D cellsMap;

/// Relative difference of two reversed depths up to which they count as one surface.
const float kSameSurface = 0.01;

vec4 point(ivec2 at) {
    return texelFetch(latticeMap, clamp(at, ivec2(0), settings.lattice.xy - 1), 0);
}

/// Second difference at b on a line of points a, b, c.
vec3 bend(vec4 a, vec4 b, vec4 c) { return abs(a.rgb - 2.0 * b.rgb + c.rgb); }

/// What a screen shows, 0..1.
vec3 shown(vec3 luminance) {
    return srgbEncode(tonemap(max(luminance, vec3(0.0)) * exposureFromEv100(ev100)));
}

bool needsSamples(ivec2 cell) {
    vec4 p00 = point(cell);
    vec4 p10 = point(cell + ivec2(1, 0));
    vec4 p01 = point(cell + ivec2(0, 1));
    vec4 p11 = point(cell + ivec2(1, 1));
    vec3 across = max(max(bend(point(cell + ivec2(-1, 0)), p00, p10), bend(p00, p10, point(cell + ivec2(2, 0)))),
                      max(bend(point(cell + ivec2(-1, 1)), p01, p11), bend(p01, p11, point(cell + ivec2(2, 1)))));
    vec3 down = max(max(bend(point(cell + ivec2(0, -1)), p00, p01), bend(p00, p01, point(cell + ivec2(0, 2)))),
                    max(bend(point(cell + ivec2(1, -1)), p10, p11), bend(p10, p11, point(cell + ivec2(1, 2)))));
    // A parabola strays from its chord by an eighth of its second difference; an edge by up to half.
    vec3 astray = 0.25 * (across + down);
    vec3 mean = 0.25 * (p00.rgb + p10.rgb + p01.rgb + p11.rgb);
    ivec2 low = cell * kLatticeStep;
    ivec2 high = low + kLatticeStep;
    vec3 surface = min(texelFetch(colorMap, low, 0).rgb, texelFetch(colorMap, high, 0).rgb);
    vec3 error = shown(surface + mean + astray) - shown(surface + max(mean - astray, vec3(0.0)));
    bool bent = 0.5 * max(error.r, max(error.g, error.b)) > settings.adaptive.x;

    float d00 = texelFetch(depthMap, low, 0).r;
    float d10 = texelFetch(depthMap, ivec2(high.x, low.y), 0).r;
    float d01 = texelFetch(depthMap, ivec2(low.x, high.y), 0).r;
    float d11 = texelFetch(depthMap, high, 0).r;
    float nearest = max(max(d00, d10), max(d01, d11));
    float stray = 0.0;
    for (int i = 0; i < kLatticeStep * kLatticeStep; ++i) {
        ivec2 offset = ivec2(i % kLatticeStep, i / kLatticeStep);
        float depth = texelFetch(depthMap, low + offset, 0).r;
        vec2 f = latticeFraction(low + offset);
        float plane = mix(mix(d00, d10, f.x), mix(d01, d11, f.x), f.y);
        stray = max(stray, abs(depth - plane) / max(max(depth, plane), 1.0e-30));
        nearest = max(nearest, depth);
    }
    // Surfaces that all lie behind the beams do not matter.
    float beamEnd = max(max(p00.a, p10.a), max(p01.a, p11.a));
    vec2 ndc = (vec2(low + high) + 1.0) * view.picture.zw - 1.0;
    float alongAxis = -viewRayDirection(ndc, view.halfExtent).z;
    float metres = viewDistance(nearest, view.depthTerms, view.halfExtent.z);
    bool behind = metres * (1.0 - 1.0e-3) > beamEnd * alongAxis;
    vec3 light = shown(surface + max(max(p00.rgb, p10.rgb), max(p01.rgb, p11.rgb))) - shown(surface);
    bool bright = max(light.r, max(light.g, light.b)) > settings.adaptive.x;
    return bent || (bright && stray > kSameSurface && !behind);
}

void judgeCell(BeamTile tile, int place) {
    ivec2 cell = tile.place.xy * kTileCellsAcross +
                 ivec2(place % kTileCellsAcross, place / kTileCellsAcross);
    if (cell.x >= settings.lattice.x || cell.y >= settings.lattice.y) {
        return;
    }
    bool needed = tile.detail.x != 0 || !isWholeCell(cell, settings.lattice.xy) || needsSamples(cell);
    imageStore(cellsMap, cell, vec4(needed ? 1.0 : 0.0));
    if (needed) {
        uint slot = atomicAdd(sampled.count, 1u);
        cells[slot] = ivec4(cell, tile.place.zw);
        if (slot % uint(kCellsAGroup) == 0u && slot < uint(kMaxBeamGroups * kCellsAGroup)) {
            atomicAdd(sampled.groupsX, 1u);
        }
    }
}

void main() {
    int cell = int(gl_GlobalInvocationID.x);
    int count = settings.lattice.z * kTileCells;
    do {
        if (cell < count) {
            judgeCell(tiles[cell / kTileCells], cell % kTileCells);
        }
        cell += int(gl_NumWorkGroups.x) * kBeamGroup;
    } while (cell < count);
}
