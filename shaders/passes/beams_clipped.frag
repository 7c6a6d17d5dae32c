// Beams, methods `clipped` and `march`: at every pixel the light of the tile's lamps, summed in single
// precision and written once.
#include "passes/beams_sheets.glsl"

flat in ivec2 lampRange;
layout(location = 0) out vec4 radiance;
#ifdef BEAMS_OUTPUT
layout(location = 1) out vec4 beamsOutput;
#endif

void main() {
    float beamEnd = 0.0;
    vec3 sum = beamsRadiance(pixelRay(ivec2(gl_FragCoord.xy)), lampRange, beamEnd);
    radiance = vec4(sum, 0.0);
#ifdef BEAMS_OUTPUT
    beamsOutput = vec4(sum, 0.0);
#endif
}
