// From luminance to what a screen shows: exposure, tone curve, sRGB encoding. No auto-exposure,
// no dither.

// The tone curves.
const int kToneNeutral = 0;
const int kToneAgx = 1;
const int kToneAces = 2;
const int kToneLinear = 3;

/// Largest channel that is shown as it is.
const float kToneStart = 0.8;
/// How fast colour fades to white above kToneStart.
const float kToneDesaturation = 0.15;

/// Factor in m2/cd for an exposure value at ISO 100: the luminance 1.2 * 2^ev100 cd/m2 maps to 1
/// (saturation-based sensitivity, ISO 12232; Lagarde & de Rousiers 2014, section 5). |ev100| < 120.
float exposureFromEv100(float ev100) {
    return 1.0 / (1.2 * pow(2.0, ev100));
}

/// Exposed linear sRGB as all curves take it: channels below 0 count as 0, over 65504 (the largest half
/// float; an infinity too) as that.
vec3 withinHalfFloats(vec3 exposedLinear) {
    return clamp(exposedLinear, vec3(0.0), vec3(65504.0));
}

/// Khronos PBR Neutral (Khronos 2024) with its Fresnel toe left out (F90 = 0): the toe mends
/// renderings of products under grey light and would crush dim haze, where a stage picture lives.
/// Below 0.8 the picture is what it was; above, the largest channel rolls off to 1 with a continuous
/// slope and the colour fades to white, its hue unchanged. Linear 0..1 of exposed linear sRGB.
vec3 toneNeutral(vec3 exposedLinear) {
    vec3 color = withinHalfFloats(exposedLinear);
    float peak = max(color.x, max(color.y, color.z));
    if (peak <= kToneStart) {
        return color;
    }
    float room = 1.0 - kToneStart;
    float newPeak = 1.0 - room * room / (peak + room - kToneStart);
    float fade = 1.0 - 1.0 / (kToneDesaturation * (peak - newPeak) + 1.0);
    return mix(color * (newPeak / peak), vec3(newPeak), fade);
}

/// The product of the matrix with these rows and a vector.
vec3 fromRows(vec3 first, vec3 second, vec3 third, vec3 color) {
    return vec3(dot(first, color), dot(second, color), dot(third, color));
}

/// AgX's curve of one channel, 0..1 to 0..1, by the polynomial of Wrensch (2023), within 0.01.
float agxContrast(float x) {
    float curve =
        ((((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x) + 0.1191) * x - 0.00232;
    return clamp(curve, 0.0, 1.0);
}

/// AgX (Sobotka 2022), as Blender shows scenes since version 4.0 but for its looks: in Rec. 2020,
/// primaries drawn in, 16.5 stops of logarithm under a contrast curve, so that bright colours lose
/// their colour as film does. Linear 0..1 of exposed linear sRGB.
vec3 toneAgx(vec3 exposedLinear) {
    vec3 wide = fromRows(vec3(0.6274, 0.3293, 0.0433), vec3(0.0691, 0.9195, 0.0113),
                         vec3(0.0164, 0.0880, 0.8956), withinHalfFloats(exposedLinear));
    vec3 inset = fromRows(vec3(0.856627153315983, 0.0951212405381588, 0.0482516061458583),
                          vec3(0.137318972929847, 0.761241990602591, 0.101439036467562),
                          vec3(0.11189821299995, 0.0767994186031903, 0.811302368396859), wide);
    vec3 stops = (log2(max(inset, vec3(1.0e-10))) + 12.47393) / 16.5;
    vec3 share = clamp(stops, vec3(0.0), vec3(1.0));
    vec3 curved = vec3(agxContrast(share.x), agxContrast(share.y), agxContrast(share.z));
    vec3 outset = fromRows(vec3(1.1271005818144368, -0.11060664309660323, -0.016493938717834573),
                           vec3(-0.1413297634984383, 1.157823702216272, -0.016493938717834257),
                           vec3(-0.14132976349843826, -0.11060664309660294, 1.2519364065950405), curved);
    vec3 linear = pow(max(outset, vec3(0.0)), vec3(2.2));
    vec3 narrow = fromRows(vec3(1.6605, -0.5876, -0.0728), vec3(-0.1246, 1.1329, -0.0083),
                           vec3(-0.0182, -0.1006, 1.1187), linear);
    return clamp(narrow, vec3(0.0), vec3(1.0));
}

/// ACES' reference rendering for an sRGB screen by the fit of Hill (2016), brightened by 1 / 0.6 as
/// is usual, so that mid grey stays near where the other curves have it. Linear 0..1 of exposed
/// linear sRGB.
vec3 toneAces(vec3 exposedLinear) {
    vec3 color = fromRows(vec3(0.59719, 0.35458, 0.04823), vec3(0.07600, 0.90834, 0.01566),
                          vec3(0.02840, 0.13383, 0.83777), withinHalfFloats(exposedLinear) / 0.6);
    vec3 rendered = (color * (color + 0.0245786) - 0.000090537) /
                    (color * (0.983729 * color + 0.4329510) + 0.238081);
    vec3 shown = fromRows(vec3(1.60475, -0.53108, -0.07367), vec3(-0.10208, 1.10813, -0.00605),
                          vec3(-0.00327, -0.07276, 1.07602), rendered);
    return clamp(shown, vec3(0.0), vec3(1.0));
}

/// Linear 0..1 of exposed linear sRGB by one of the curves kTone...; the linear one cuts off at 1.
vec3 tonemap(int curve, vec3 exposedLinear) {
    if (curve == kToneAgx) {
        return toneAgx(exposedLinear);
    }
    if (curve == kToneAces) {
        return toneAces(exposedLinear);
    }
    if (curve == kToneLinear) {
        return clamp(exposedLinear, vec3(0.0), vec3(1.0));
    }
    return toneNeutral(exposedLinear);
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
