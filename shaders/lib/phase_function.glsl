// Phase functions: how haze and air spread light over directions, in 1/sr; not how much of it.
// Gibbons as in Pessoa 2007 and Dobashi 2000; Henyey & Greenstein 1941; Cornette & Shanks 1992;
// Rayleigh without depolarisation. In all of them cosAngle = 1 is straight on (forward), so with
// w the way the light travels and d the way the eye looks, cosAngle = -dot(w, d).
// All integrate to one over the sphere (Gibbons with k = 1 / (8 pi)).

const int kPhaseGibbons = 0;
const int kPhaseIsotropic = 1;
const int kPhaseHenyeyGreenstein = 2;
const int kPhaseCornetteShanks = 3;
const int kPhaseRayleigh = 4;

const float kInverseFourPi = 0.0795774715459477;
/// Beyond this |g| the peak no longer fits single precision; g is clamped to it.
const float kMaxMeanCosine = 0.9999;

/// k (1 + 9 cos^16(alpha / 2)) with cos^2(alpha / 2) = (1 + cosAngle) / 2. Exact.
float phaseGibbons(float cosAngle, float k) {
    float half1 = 0.5 + 0.5 * clamp(cosAngle, -1.0, 1.0);
    float half2 = half1 * half1;
    float half4 = half2 * half2;
    return k * (1.0 + 9.0 * half4 * half4);
}

/// 1 / (4 pi).
float phaseIsotropic() {
    return kInverseFourPi;
}

/// 1 + g^2 - 2 g cosAngle as a sum of terms that are not negative, so that nothing cancels at the
/// peak; at least 1e-8. |g| <= kMaxMeanCosine, |cosAngle| <= 1.
float phaseDenominator(float cosAngle, float g) {
    float size = abs(g);
    float along = g < 0.0 ? -cosAngle : cosAngle;
    return (1.0 - size) * (1.0 - size) + 2.0 * size * (1.0 - along);
}

/// Mean cosine g, -1 < g < 1.
float phaseHenyeyGreenstein(float cosAngle, float g) {
    float mean = clamp(g, -kMaxMeanCosine, kMaxMeanCosine);
    float base = phaseDenominator(clamp(cosAngle, -1.0, 1.0), mean);
    return kInverseFourPi * (1.0 - mean) * (1.0 + mean) / (base * sqrt(base));
}

/// Asymmetry g, -1 < g < 1; the mean cosine is 3 g (4 + g^2) / (5 (2 + g^2)).
float phaseCornetteShanks(float cosAngle, float g) {
    float mean = clamp(g, -kMaxMeanCosine, kMaxMeanCosine);
    float mu = clamp(cosAngle, -1.0, 1.0);
    float base = phaseDenominator(mu, mean);
    return 1.5 * kInverseFourPi * (1.0 - mean) * (1.0 + mean) * (1.0 + mu * mu) /
           ((2.0 + mean * mean) * base * sqrt(base));
}

/// 3 / (16 pi) (1 + cosAngle^2).
float phaseRayleigh(float cosAngle) {
    float mu = clamp(cosAngle, -1.0, 1.0);
    return 0.75 * kInverseFourPi * (1.0 + mu * mu);
}

/// The phase function of a kind kPhase...; g and k are read by the kinds that have them. A kind
/// that is none of the five scatters evenly.
float phaseFunction(int kind, float cosAngle, float g, float k) {
    if (kind == kPhaseGibbons) {
        return phaseGibbons(cosAngle, k);
    }
    if (kind == kPhaseHenyeyGreenstein) {
        return phaseHenyeyGreenstein(cosAngle, g);
    }
    if (kind == kPhaseCornetteShanks) {
        return phaseCornetteShanks(cosAngle, g);
    }
    if (kind == kPhaseRayleigh) {
        return phaseRayleigh(cosAngle);
    }
    return phaseIsotropic();
}
