// Shadow runs: which sheets of a stretch of ray a lamp sees, as a set of bits, told for many sheets at
// once where the shadow map's pyramid shows that nothing or everything is in the way. No light.
// Agrees to the bit with looking at every sheet's texel: boxes are grown by more than rounding can
// move a sheet, and what leaves the map, or is not a number, is looked at sheet by sheet.

/// Bits of a set of sheets.
const int kSheetsASet = 32;
/// Pieces of a set that are judged one by one: a ray across a beam passes over most of its map.
const float kRunPieces = 2.0;
/// How far rounding may move a sheet's place in the map, in texels, and more.
const float kTexelSlack = 0.01;
/// The same of its depth, as a share of the stretch's largest.
const float kDepthSlack = 2.0e-6;

/// A stretch of ray in its lamp's projection, in which it is straight: at its ends the slopes
/// (x / z, y / z) and the inverse depths in 1/m.
struct LampStretch {
    vec2 slope0;
    vec2 slope1;
    float inverse0;
    float inverse1;
};

/// The place of a set's lowest bit; anything where it has none.
int lowestBit(uint low) { return ((floatBitsToInt(float(int(low))) >> 23) & 255) - 127; }

/// Bits first .. end - 1; 0 <= first < end <= 32.
uint bitsBetween(int first, int end) {
    return (0xffffffffu >> uint(32 - (end - first))) << uint(first);
}

/// Place in texels and reversed depth in the shadow map of sheet `i` of `count`.
vec3 sheetInMap(SpotLamp lamp, LampStretch stretch, float i, float count) {
    float x = i / count;
    vec3 at = shadowCoordinates(mix(stretch.slope0, stretch.slope1, x),
                                mix(stretch.inverse0, stretch.inverse1, x), lamp.shadow.x, lamp.shadow.y);
    return vec3(at.xy * lamp.shadow.w, at.z);
}

/// 1: every sheet from a to b lit, 0: none, -1: some or not known.
int judgeRun(SpotLamp lamp, vec3 a, vec3 b) {
    vec2 low = min(a.xy, b.xy) - kTexelSlack;
    vec2 high = max(a.xy, b.xy) + kTexelSlack;
    bool within = min(low.x, low.y) >= 0.0 && max(high.x, high.y) < lamp.shadow.w;
    float extent = max(high.x - low.x, high.y - low.y);
    // The level whose texels are at least as wide, 4 << level: each also covers its next neighbours.
    int level = max(((floatBitsToInt(extent) >> 23) & 255) - 128, 1);
    ivec2 texel = within ? ivec2(low) >> (level + 2) : ivec2(0);
    vec2 depths = texelFetch(shadowPyramid, ivec3(texel, lamp.layers.x), level).rg;
    float slack = kDepthSlack * max(a.z, b.z);
    bool lit = within && depths.y <= min(a.z, b.z) - slack;
    bool dark = within && depths.x > max(a.z, b.z) + slack;
    return lit ? 1 : dark ? 0 : -1;
}

#ifdef COUNT_RUNS
layout(std430, binding = kRunCountsSlot) buffer RunCountsBlock { RunCounts runCounts; };

void countRun(bool shadowed, int judged, int sheets) {
    if (!shadowed) {
        return;
    }
    if (judged > 0) {
        atomicAdd(runCounts.lit, 1u);
    } else if (judged == 0) {
        atomicAdd(runCounts.dark, 1u);
    } else {
        atomicAdd(runCounts.mixed, 1u);
        atomicAdd(runCounts.fetches, uint(sheets));
    }
}
#endif

/// The lit ones of the sheets `first` .. first + 31, or fewer where there are only `count`.
uint litSheets(SpotLamp lamp, LampStretch stretch, float first, float count, bool any) {
    int sheets = min(int(count - first), kSheetsASet);
    uint lit = bitsBetween(0, sheets);
    int step = int(ceil(float(sheets) / kRunPieces));
    bool shadowed = any && lamp.layers.x >= 0;
    // Judged in pieces.
    uint asked = 0u;
    int piece = 0;
    int last = shadowed ? sheets : 0;
    do {
        int end = min(piece + step, sheets);
        int judged = judgeRun(lamp, sheetInMap(lamp, stretch, first + float(piece) + 0.5, count),
                              sheetInMap(lamp, stretch, first + float(end) - 0.5, count));
        uint bits = bitsBetween(piece, end);
        lit = shadowed && judged != 1 ? lit & ~bits : lit;
        asked |= shadowed && judged < 0 ? bits : 0u;
#ifdef COUNT_RUNS
        countRun(shadowed, judged, end - piece);
#endif
        piece = end;
    } while (piece < last);
    // Sheet by sheet.
    do {
        uint low = asked & (0u - asked);
        vec3 at = sheetInMap(lamp, stretch, first + float(lowestBit(low)) + 0.5, count);
        ivec3 texel = ivec3(ivec2(at.xy), lamp.layers.x);
        lit |= texelFetch(shadowMaps, texel, 0).r <= at.z ? low : 0u;
        asked ^= low;
    } while (asked != 0u);
    return any ? lit : 0u;
}
