// Beam radiance: the integrand of light scattered once on its way from a lamp to the eye
// (Pessoa 2007 after Dobashi 2000), without the lamp's own distribution and its visibility:
//   L = integral of I(direction) V(point) scatteredIntensity dt,
// with I in candela: intensity times coneFalloff, rangeWindow and light map; L in cd/m2.
// Needs lib/haze.glsl and lib/spot_light.glsl included before it.

/// The share of the light at a point that reaches the eye, in 1/(m sr): phase in 1/sr, scattering
/// and extinction in 1/m, lampMetres from the lamp to the point, eyeMetres from the point to the
/// eye. Without the inverse square, which projective placement cancels.
float scatteredShare(float phase, float scatteringPerMetre, float extinctionPerMetre,
                     float lampMetres, float eyeMetres) {
    return phase * scatteringPerMetre * transmittance(extinctionPerMetre, lampMetres + eyeMetres);
}

/// The whole integrand for one candela, in cd/m2 per metre of the ray (1/(m3 sr)): scatteredShare
/// times the inverse square of lampMetres.
float scatteredIntensity(float phase, float scatteringPerMetre, float extinctionPerMetre,
                         float lampMetres, float eyeMetres) {
    return inverseSquare(lampMetres) *
           scatteredShare(phase, scatteringPerMetre, extinctionPerMetre, lampMetres, eyeMetres);
}

/// Cosine of the scattering angle for `lampToPoint` in metres and the unit direction the eye looks
/// in; 1 is straight on (the eye looks into the lamp). 0 at the lamp itself.
float scatteringCosine(vec3 lampToPoint, vec3 viewDirection) {
    float square = dot(lampToPoint, lampToPoint);
    if (square <= 0.0) {
        return 0.0;
    }
    return clamp(-dot(lampToPoint, viewDirection) / sqrt(square), -1.0, 1.0);
}
