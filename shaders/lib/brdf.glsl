// Surface reflection: glTF 2.0's metallic-roughness model, appendix B: GGX with height-correlated
// Smith (Heitz 2014), Schlick's Fresnel, Lambert below. Values in 1/sr, without the cosine. Needs
// lib/pi.glsl before it.

/// Smallest alpha (roughness squared). Below it the highlight's denominator is nothing but rounding
/// in single precision; 0.002025 is a roughness of 0.045.
const float kMinAlpha = 0.002025;

/// alpha = roughness^2 under kMinAlpha's rule. roughness in 0..1.
float alphaFromRoughness(float roughness) {
    return clamp(roughness * roughness, kMinAlpha, 1.0);
}

/// Density of facets around the half vector in 1/sr: alpha^2 / (pi ((N.H)^2 (alpha^2 - 1) + 1)^2).
float ggxDistribution(float nDotH, float alpha) {
    float cosine = clamp(nDotH, 0.0, 1.0);
    float alphaSquared = alpha * alpha;
    float base = (1.0 - cosine) * (1.0 + cosine) + cosine * cosine * alphaSquared;
    return kInversePi * alphaSquared / (base * base);
}

/// G / (4 N.L N.V), height-correlated. At most 5e6, reached where both cosines vanish.
float smithVisibility(float nDotL, float nDotV, float alpha) {
    float light = clamp(nDotL, 0.0, 1.0);
    float view = clamp(nDotV, 0.0, 1.0);
    float alphaSquared = alpha * alpha;
    float spread = 1.0 - alphaSquared;
    float sum = light * sqrt(view * view * spread + alphaSquared) +
                view * sqrt(light * light * spread + alphaSquared);
    return 0.5 / max(sum, 1.0e-7);
}

/// Schlick: f0 + (1 - f0) (1 - V.H)^5.
vec3 schlickFresnel(vec3 f0, float vDotH) {
    float grazing = 1.0 - clamp(abs(vDotH), 0.0, 1.0);
    float square = grazing * grazing;
    return mix(f0, vec3(1.0), square * square * grazing);
}

/// f in 1/sr. baseColor linear 0..1, metallic and roughness 0..1; the cosines between unit normal,
/// light, view and half vector. Black where light or eye are below the surface.
/// A highlight alone gives back no more than it gets. The standard's mix of the two by V.H does:
/// a white dielectric returns up to 1.05 of even light on the whole, and towards grazing eyes
/// 1.8 (mirror-smooth) to 1.01 (roughness 1) of it.
vec3 metallicRoughnessBrdf(vec3 baseColor, float metallic, float roughness, float nDotL,
                           float nDotV, float nDotH, float vDotH) {
    if (nDotL <= 0.0 || nDotV <= 0.0) {
        return vec3(0.0);
    }
    float alpha = alphaFromRoughness(roughness);
    vec3 fresnel = schlickFresnel(mix(vec3(0.04), baseColor, metallic), vDotH);
    vec3 diffuse = baseColor * ((1.0 - metallic) * kInversePi);
    float specular = ggxDistribution(nDotH, alpha) * smithVisibility(nDotL, nDotV, alpha);
    return (vec3(1.0) - fresnel) * diffuse + fresnel * specular;
}
