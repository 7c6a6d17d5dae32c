// Illuminance as colours that can be told apart and read off a legend: three decades below the highest,
// from dark blue over green and yellow to white.

/// Decades between the first and the last colour.
const float kFalseColorDecades = 3.0;

/// Where an illuminance lies among the colours, 0..1. Both in lux, `highest` > 0.
float falseColorShare(float lux, float highest) {
    float decades = log(max(lux, 1.0e-30) / highest) / 2.302585092994046;
    return clamp(1.0 + decades / kFalseColorDecades, 0.0, 1.0);
}

/// sRGB-encoded, for a share of 0..1.
vec3 falseColor(float share) {
    float at = 6.0 * share;
    vec3 color = mix(vec3(0.03, 0.03, 0.15), vec3(0.10, 0.25, 0.85), clamp(at, 0.0, 1.0));
    color = mix(color, vec3(0.05, 0.70, 0.80), clamp(at - 1.0, 0.0, 1.0));
    color = mix(color, vec3(0.15, 0.75, 0.20), clamp(at - 2.0, 0.0, 1.0));
    color = mix(color, vec3(0.95, 0.90, 0.15), clamp(at - 3.0, 0.0, 1.0));
    color = mix(color, vec3(0.90, 0.25, 0.10), clamp(at - 4.0, 0.0, 1.0));
    return mix(color, vec3(1.00, 0.95, 0.95), clamp(at - 5.0, 0.0, 1.0));
}
