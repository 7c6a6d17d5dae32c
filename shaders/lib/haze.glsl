// Haze: what even haze takes from light on its way (Beer-Lambert). Not how it scatters.

/// 0..1: the part of the light left after `distanceMetres` >= 0; extinction in 1/m, >= 0.
float transmittance(float extinctionPerMetre, float distanceMetres) {
    return exp(-extinctionPerMetre * distanceMetres);
}

/// (1 - exp(-x)) / x, the mean transmittance over an optical depth x >= 0; 1 at 0. Below 1e-2 a
/// series, off by less than x^4 / 120 = 1e-10; in single precision at most 7e-6 off just above it,
/// where the plain form begins to cancel.
float oneMinusExpOver(float x) {
    if (abs(x) < 1.0e-2) {
        return 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0)));
    }
    return (1.0 - exp(-x)) / x;
}
