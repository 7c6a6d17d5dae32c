// Surfaces of several layers: glTF's metallic-roughness model under the extensions KHR_materials_ior,
// specular, anisotropy, sheen and clearcoat, and thin transmission. Without them all values are
// metallicRoughnessBrdf's. Needs lib/pi.glsl and lib/brdf.glsl before it.

struct LayeredSurface {
    vec3 baseColor;        // linear 0..1
    float metallic;        // 0..1
    float roughness;       // 0..1
    vec3 dielectricF0;     // reflectance straight on of what is no metal, 0..1
    float specular;        // its reflectance edge on, 0..1
    float anisotropy;      // 0..1: how much rougher along the tangent
    vec3 sheenColor;       // linear 0..1
    float sheenRoughness;  // 0..1, drawn as kMinSheenRoughness or more
    float coat;            // 0..1
    float coatRoughness;   // 0..1
    float transmission;    // 0..1: share of what enters a dielectric that passes it
};

// Below it the fibres' grazing highlight would give back twice the light it gets.
const float kMinSheenRoughness = 0.2;
// A clear coat's reflectance straight on, of an index of refraction of 1.5.
const float kCoatF0 = 0.04;

float largestOf(vec3 v) { return max(v.x, max(v.y, v.z)); }

/// Reflectance straight on of a boundary with air; an index of 0 stands for a perfect one.
float f0FromIor(float ior) {
    float share = (ior - 1.0) / (ior + 1.0);
    return share * share;
}

/// (1 - cosine)^5.
float grazingShare(float cosine) {
    float away = 1.0 - clamp(abs(cosine), 0.0, 1.0);
    float square = away * away;
    return square * square * away;
}

/// GGX with alphas of its own along tangent and bitangent, in 1/sr.
float anisotropicDistribution(float tDotH, float bDotH, float nDotH, float alphaT, float alphaB) {
    float product = alphaT * alphaB;
    float t = alphaB * tDotH;
    float b = alphaT * bDotH;
    float n = product * nDotH;
    float share = product / (t * t + b * b + n * n);
    return kInversePi * product * share * share;
}

/// G / (4 N.L N.V), height-correlated.
float anisotropicVisibility(float tDotL, float bDotL, float nDotL, float tDotV, float bDotV,
                            float nDotV, float alphaT, float alphaB) {
    float towardsLight = sqrt(alphaT * alphaT * tDotL * tDotL + alphaB * alphaB * bDotL * bDotL +
                              nDotL * nDotL);
    float towardsView = sqrt(alphaT * alphaT * tDotV * tDotV + alphaB * alphaB * bDotV * bDotV +
                             nDotV * nDotV);
    return 0.5 / max(nDotL * towardsView + nDotV * towardsLight, 1.0e-7);
}

/// Fibres that stand up (Estevez and Kulla 2017): density of half vectors in 1/sr.
float sheenDistribution(float nDotH, float alpha) {
    float sineSquared = clamp(1.0 - nDotH * nDotH, 0.0, 1.0);
    return (2.0 + 1.0 / alpha) * pow(sineSquared, 0.5 / alpha) * 0.5 * kInversePi;
}

float sheenSlope(float cosine, float alpha) {
    float t = (1.0 - alpha) * (1.0 - alpha);
    return mix(21.5473, 25.3245, t) / (1.0 + mix(3.82987, 3.32435, t) *
                                                 pow(cosine, mix(0.19823, 0.16801, t))) +
           mix(-1.9776, -1.27393, t) * cosine + mix(-4.32054, -4.85967, t);
}

/// The fit of the same paper to how much fibres hide of each other.
float sheenLambda(float cosine, float alpha) {
    return cosine < 0.5 ? exp(sheenSlope(cosine, alpha))
                        : exp(2.0 * sheenSlope(0.5, alpha) - sheenSlope(1.0 - cosine, alpha));
}

float sheenVisibility(float nDotL, float nDotV, float alpha) {
    return 1.0 / (4.0 * nDotL * nDotV *
                  (1.0 + sheenLambda(nDotL, alpha) + sheenLambda(nDotV, alpha)));
}

// The share of light from a direction that white fibres send anywhere: rows by the root of its
// cosine, 0, 1/15 ... 1; columns by roughness, 0.2, 0.3 ... 1. Integrated numerically.
const float kSheenAlbedo[144] = {
    1.0263, 0.7717, 0.6782, 0.6547, 0.6702, 0.7082, 0.7531, 0.7853, 0.7810,
    1.1940, 0.9211, 0.8225, 0.8010, 0.8214, 0.8640, 0.9108, 0.9414, 0.9329,
    1.0733, 0.8639, 0.7897, 0.7802, 0.8068, 0.8520, 0.8992, 0.9294, 0.9218,
    0.8821, 0.7498, 0.7052, 0.7085, 0.7400, 0.7856, 0.8311, 0.8601, 0.8545,
    0.6901, 0.6278, 0.6114, 0.6267, 0.6625, 0.7082, 0.7520, 0.7801, 0.7770,
    0.5179, 0.5121, 0.5202, 0.5464, 0.5861, 0.6320, 0.6745, 0.7021, 0.7016,
    0.3721, 0.4074, 0.4352, 0.4706, 0.5138, 0.5600, 0.6016, 0.6289, 0.6312,
    0.2540, 0.3150, 0.3575, 0.4002, 0.4461, 0.4924, 0.5333, 0.5607, 0.5655,
    0.1630, 0.2354, 0.2871, 0.3348, 0.3826, 0.4289, 0.4690, 0.4964, 0.5038,
    0.0967, 0.1685, 0.2242, 0.2745, 0.3229, 0.3687, 0.4079, 0.4354, 0.4452,
    0.0518, 0.1141, 0.1687, 0.2190, 0.2669, 0.3115, 0.3497, 0.3772, 0.3891,
    0.0242, 0.0719, 0.1212, 0.1689, 0.2150, 0.2578, 0.2947, 0.3220, 0.3359,
    0.0094, 0.0414, 0.0825, 0.1260, 0.1692, 0.2100, 0.2455, 0.2728, 0.2886,
    0.0027, 0.0205, 0.0514, 0.0886, 0.1280, 0.1663, 0.2004, 0.2276, 0.2451,
    0.0004, 0.0075, 0.0268, 0.0557, 0.0898, 0.1249, 0.1574, 0.1845, 0.2036,
    0.0000, 0.0010, 0.0086, 0.0270, 0.0540, 0.0852, 0.1160, 0.1430, 0.1638
};

/// Between the table's rows and columns, at most 0.03 off.
float sheenAlbedo(float cosine, float roughness) {
    float row = 15.0 * sqrt(clamp(cosine, 0.0, 1.0));
    float column = 10.0 * (clamp(roughness, 0.2, 1.0) - 0.2);
    int i = int(min(row, 14.0));
    int j = int(min(column, 7.0));
    float down = row - float(i);
    float right = column - float(j);
    int at = 9 * i + j;
    return mix(mix(kSheenAlbedo[at], kSheenAlbedo[at + 1], right),
               mix(kSheenAlbedo[at + 9], kSheenAlbedo[at + 10], right), down);
}

/// Reflectance of a coat that is seen under this cosine.
float coatShare(float coat, float cosine) {
    return coat * (kCoatF0 + (1.0 - kCoatF0) * grazingShare(cosine));
}

/// What a dielectric's surface reflects, and what the whole mix of dielectric and metal does.
vec3 dielectricFresnel(LayeredSurface surface, float cosine) {
    float grazing = grazingShare(cosine);
    return surface.dielectricF0 * (1.0 - grazing) + vec3(surface.specular * grazing);
}

/// f N.L under one light, without coat and sheen. `tangent` is unit and across the normal, as
/// `bitangent`; neither matters without anisotropy.
vec3 baseReflection(LayeredSurface surface, vec3 normal, vec3 tangent, vec3 bitangent,
                    vec3 towardsLight, vec3 towardsEye) {
    float nDotL = dot(normal, towardsLight);
    if (nDotL <= 0.0) {
        return vec3(0.0);
    }
    // A shading normal may look away from the eye near a silhouette; light it as if edge on.
    float nDotV = max(dot(normal, towardsEye), 1.0e-4);
    vec3 halfway = normalize(towardsLight + towardsEye);
    float nDotH = clamp(dot(normal, halfway), 0.0, 1.0);
    float vDotH = clamp(dot(towardsEye, halfway), 0.0, 1.0);
    float alpha = alphaFromRoughness(surface.roughness);
    float lobe = 0.0;
    if (surface.anisotropy > 0.0) {
        float alphaT = mix(alpha, 1.0, surface.anisotropy * surface.anisotropy);
        lobe = anisotropicDistribution(dot(tangent, halfway), dot(bitangent, halfway), nDotH,
                                       alphaT, alpha) *
               anisotropicVisibility(dot(tangent, towardsLight), dot(bitangent, towardsLight),
                                     nDotL, dot(tangent, towardsEye), dot(bitangent, towardsEye),
                                     nDotV, alphaT, alpha);
    } else {
        lobe = ggxDistribution(nDotH, alpha) * smithVisibility(nDotL, nDotV, alpha);
    }
    vec3 dielectric = dielectricFresnel(surface, vDotH);
    vec3 metal = schlickFresnel(surface.baseColor, vDotH);
    vec3 fresnel = mix(dielectric, metal, surface.metallic);
    // Coloured highlights leave the colour of what is below them alone.
    vec3 entering = vec3(1.0) - mix(vec3(largestOf(dielectric)), metal, surface.metallic);
    vec3 diffuse = surface.baseColor *
                   ((1.0 - surface.metallic) * (1.0 - surface.transmission) * kInversePi);
    return nDotL * (entering * diffuse + fresnel * lobe);
}

/// The same with sheen, which takes from what is below as much as it gives. Where fibres alone
/// would give back more than they get, they are darkened to that.
vec3 sheenReflection(LayeredSurface surface, vec3 below, vec3 normal, vec3 towardsLight,
                     vec3 towardsEye) {
    float strength = largestOf(surface.sheenColor);
    float nDotL = dot(normal, towardsLight);
    if (strength <= 0.0 || nDotL <= 0.0) {
        return below;
    }
    float nDotV = max(dot(normal, towardsEye), 1.0e-4);
    float roughness = max(surface.sheenRoughness, kMinSheenRoughness);
    float alpha = roughness * roughness;
    float share = max(sheenAlbedo(nDotL, roughness), sheenAlbedo(nDotV, roughness));
    float most = max(share, 1.0);
    vec3 halfway = normalize(towardsLight + towardsEye);
    float lobe = sheenDistribution(clamp(dot(normal, halfway), 0.0, 1.0), alpha) *
                 sheenVisibility(max(nDotL, 1.0e-4), nDotV, alpha);
    return below * (1.0 - strength * (share / most)) + surface.sheenColor * (nDotL * lobe / most);
}

/// f N.L of all layers under one light. The coat has a normal of its own.
vec3 layeredReflection(LayeredSurface surface, vec3 normal, vec3 tangent, vec3 bitangent,
                       vec3 coatNormal, vec3 towardsLight, vec3 towardsEye) {
    vec3 sum = baseReflection(surface, normal, tangent, bitangent, towardsLight, towardsEye);
    sum = sheenReflection(surface, sum, normal, towardsLight, towardsEye);
    if (surface.coat <= 0.0) {
        return sum;
    }
    float nDotV = max(dot(coatNormal, towardsEye), 1.0e-4);
    float share = coatShare(surface.coat, nDotV);
    sum = sum * (1.0 - share);
    float nDotL = dot(coatNormal, towardsLight);
    if (nDotL > 0.0) {
        vec3 halfway = normalize(towardsLight + towardsEye);
        float alpha = alphaFromRoughness(surface.coatRoughness);
        float lobe = ggxDistribution(clamp(dot(coatNormal, halfway), 0.0, 1.0), alpha) *
                     smithVisibility(nDotL, nDotV, alpha);
        sum = sum + vec3(nDotL * share * lobe);
    }
    return sum;
}

/// The share of even light from all around that the layers send to the eye, about.
vec3 layeredAlbedo(LayeredSurface surface, float nDotV, float coatDotV) {
    vec3 specular = mix(surface.dielectricF0, surface.baseColor, surface.metallic);
    vec3 albedo = surface.baseColor * ((1.0 - surface.metallic) * (1.0 - surface.transmission)) +
                  specular;
    float strength = largestOf(surface.sheenColor);
    if (strength > 0.0) {
        float share = min(sheenAlbedo(nDotV, surface.sheenRoughness), 1.0);
        albedo = albedo * (1.0 - strength * share) + surface.sheenColor * share;
    }
    float coat = coatShare(surface.coat, coatDotV);
    return albedo * (1.0 - coat) + vec3(coat);
}

/// What light from straight behind keeps on its way to the eye through a thin wall: nothing is bent
/// or blurred.
vec3 seenThrough(LayeredSurface surface, float nDotV, float coatDotV) {
    float entering = 1.0 - largestOf(dielectricFresnel(surface, nDotV));
    float strength = largestOf(surface.sheenColor);
    if (strength > 0.0) {
        entering *= 1.0 - strength * min(sheenAlbedo(nDotV, surface.sheenRoughness), 1.0);
    }
    entering *= 1.0 - coatShare(surface.coat, coatDotV);
    return surface.baseColor * (surface.transmission * (1.0 - surface.metallic) * entering);
}
