// Light that comes from a direction after exactly as many scatterings as the order before has:
// order 1 from Rayleigh's and Mie's tables, later ones from one of plain radiance.
#ifdef SKY_FIRST
vec3 orderBefore(Air air, vec3 coordinate, float nu) {
    vec3 slices = nuSlices(nu);
    return fourDimensional(scatteringMap, coordinate, slices) * phaseRayleigh(nu) +
           fourDimensional(mieMap, coordinate, slices) * phaseCornetteShanks(nu, air.mieG);
}
#else
vec3 orderBefore(Air air, vec3 coordinate, float nu) {
    return fourDimensional(scatteringMap, coordinate, nuSlices(nu));
}
#endif
