// The picture for a screen where surfaces hold illuminance instead of luminance. Black where nothing is.
#include "shared/slots.h"
#include "lib/false_color.glsl"

layout(location = 0) uniform float highestLux;
layout(binding = kColorUnit) uniform sampler2D colorMap;
layout(binding = kDepthUnit) uniform sampler2D depthMap;
layout(location = 0) out vec4 display;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(depthMap, pixel, 0).r <= 0.0) {
        display = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    // Rec. 709: what the eye weighs the channels by.
    float lux = dot(texelFetch(colorMap, pixel, 0).rgb, vec3(0.2126, 0.7152, 0.0722));
    display = vec4(falseColor(falseColorShare(lux, highestLux)), 1.0);
}
