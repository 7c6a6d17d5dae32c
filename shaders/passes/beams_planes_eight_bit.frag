// Beams, method `planes`, added up in eight bits as in 2007: the sum, back in cd/m2.
#include "shared/slots.h"

layout(binding = kColorUnit) uniform sampler2D codes;
layout(location = 1) uniform float fullScale;  // cd/m2 that count as the highest code value
layout(location = 0) out vec4 radiance;
#ifdef BEAMS_OUTPUT
layout(location = 1) out vec4 beamsOutput;
#endif

void main() {
    vec3 light = texelFetch(codes, ivec2(gl_FragCoord.xy), 0).rgb * fullScale;
    radiance = vec4(light, 0.0);
#ifdef BEAMS_OUTPUT
    beamsOutput = vec4(light, 0.0);
#endif
}
