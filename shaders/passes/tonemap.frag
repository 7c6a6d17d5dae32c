// The picture for a screen: exposure, tone curve, sRGB encoding, and dither of half a code value.
#include "shared/slots.h"
#include "lib/tonemap.glsl"

layout(std430, binding = kExposureSlot) readonly buffer Exposure { float ev100; int toneCurve; };
layout(binding = kColorUnit) uniform sampler2D colorMap;
layout(location = 0) out vec4 display;

/// Even noise in 0..1 that differs from pixel to pixel and is the same in every run (Jimenez 2014,
/// interleaved gradient noise).
float noise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

void main() {
    vec3 luminance = texelFetch(colorMap, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 encoded = srgbEncode(tonemap(toneCurve, luminance * exposureFromEv100(ev100)));
    display = vec4(encoded + (noise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);
}
