// Air: the numbers of a planet's air, as every function of the sky takes them, and how dense it is
// at a height. Not where rays go in it (air_shell.glsl), nor how it spreads light over directions
// (phase_function.glsl: Rayleigh and Cornette-Shanks).
//
// Metres throughout. Singles have the same 24 bits at every scale, so kilometres would gain nothing
// and cost a conversion wherever the scene's metres come in; what would lose precision is a radius,
// whose last bit is half a metre. Hence heights above the ground as arguments, never radii.

struct Air {
    float groundRadius;  ///< m
    float top;           ///< height at which the air ends, m
    float rayleighHeight;  ///< scale heights, m
    float mieHeight;
    vec3 rayleighScattering;  ///< at the ground, 1/m for R, G, B
    vec3 mieScattering;
    vec3 mieExtinction;
    float mieG;  ///< asymmetry of Cornette and Shanks, -1 < g < 1
};

/// 0..1: density relative to the ground's, exp(-height / scaleHeight); below the ground as at it.
float airDensity(float height, float scaleHeight) {
    return exp(-max(height, 0.0) / scaleHeight);
}

/// Extinction in 1/m at a height. Rayleigh's air absorbs nothing.
vec3 airExtinction(Air air, float height) {
    return airDensity(height, air.rayleighHeight) * air.rayleighScattering +
           airDensity(height, air.mieHeight) * air.mieExtinction;
}

/// 0..1: what is left of light after a way that holds as much air as so many metres at the ground
/// (optical lengths), of Rayleigh's and of Mie's.
vec3 airTransmittance(Air air, float rayleighMetres, float mieMetres) {
    return exp(-(rayleighMetres * air.rayleighScattering + mieMetres * air.mieExtinction));
}
