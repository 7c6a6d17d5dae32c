// Beams, method `adaptive`, third step: every pixel between the lattice's points, but for the cells
// that are sampled.
#include "shared/slots.h"
#include "shared/beams.h"
#include "lib/beam_lattice.glsl"

layout(binding = kBeamLatticeUnit) uniform sampler2D latticeMap;
layout(binding = kBeamCellsUnit) uniform sampler2D cellsMap;
layout(location = 0) out vec4 radiance;
#ifdef BEAMS_OUTPUT
layout(location = 1) out vec4 beamsOutput;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 cell = pixel / kLatticeStep;
    vec2 f = latticeFraction(pixel);
    vec3 low = mix(texelFetch(latticeMap, cell, 0).rgb,
                   texelFetch(latticeMap, cell + ivec2(1, 0), 0).rgb, f.x);
    vec3 high = mix(texelFetch(latticeMap, cell + ivec2(0, 1), 0).rgb,
                    texelFetch(latticeMap, cell + ivec2(1, 1), 0).rgb, f.x);
    bool sampled = texelFetch(cellsMap, cell, 0).r > 0.5;
    radiance = sampled ? vec4(0.0) : vec4(mix(low, high, f.y), 0.0);
#ifdef BEAMS_OUTPUT
    beamsOutput = radiance;
#endif
}
