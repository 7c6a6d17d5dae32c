// From luminance to what a screen shows: exposure, tone curve, sRGB encoding. No auto-exposure,
// no dither.
// The operator is Khronos PBR Neutral (Khronos 2024) with its Fresnel toe left out (F90 = 0): the
// toe mends renderings of products under grey light and would crush dim haze, where a stage picture
// lives. Below 0.8 the picture is what it was; above, the largest channel rolls off to 1 with a
// continuous slope and the colour fades to white, its hue unchanged. Invertible.

/// Largest channel that is shown as it is.
const float kToneStart = 0.8;
/// How fast colour fades to white above kToneStart.
const float kToneDesaturation = 0.15;

/// Factor in m2/cd for an exposure value at ISO 100: the luminance 1.2 * 2^ev100 cd/m2 maps to 1
/// (saturation-based sensitivity, ISO 12232; Lagarde & de Rousiers 2014, section 5). |ev100| < 120.
float exposureFromEv100(float ev100) {
    return 1.0 / (1.2 * pow(2.0, ev100));
}

/// Linear 0..1 of exposed linear sRGB >= 0. Channels below 0 count as 0, over 65504 (the largest
/// half float; an infinity too) as that.
vec3 tonemap(vec3 exposedLinear) {
    vec3 color = clamp(exposedLinear, vec3(0.0), vec3(65504.0));
    float peak = max(color.x, max(color.y, color.z));
    if (peak <= kToneStart) {
        return color;
    }
    float room = 1.0 - kToneStart;
    float newPeak = 1.0 - room * room / (peak + room - kToneStart);
    float fade = 1.0 - 1.0 / (kToneDesaturation * (peak - newPeak) + 1.0);
    return mix(color * (newPeak / peak), vec3(newPeak), fade);
}

/// IEC 61966-2-1 for one channel, 0..1 to 0..1; values outside are clamped.
float srgbEncodeChannel(float linear) {
    float value = clamp(linear, 0.0, 1.0);
    if (value <= 0.0031308) {
        return 12.92 * value;
    }
    return 1.055 * pow(value, 1.0 / 2.4) - 0.055;
}

/// The inverse: linear 0..1 of an encoded channel 0..1.
float srgbDecodeChannel(float encoded) {
    float value = clamp(encoded, 0.0, 1.0);
    if (value <= 0.04045) {
        return value / 12.92;
    }
    return pow((value + 0.055) / 1.055, 2.4);
}

vec3 srgbEncode(vec3 linear) {
    return vec3(srgbEncodeChannel(linear.x), srgbEncodeChannel(linear.y),
                srgbEncodeChannel(linear.z));
}

vec3 srgbDecode(vec3 encoded) {
    return vec3(srgbDecodeChannel(encoded.x), srgbDecodeChannel(encoded.y),
                srgbDecodeChannel(encoded.z));
}
