// A cloud of haze that thins out in all directions like Gauss' bell: how much of it lies on a way.
// Its own brightness and colour are not here.

/// The error function, at most 2e-7 off (Abramowitz & Stegun 7.1.26).
float errorFunction(float x) {
    float size = min(abs(x), 6.0);
    float t = 1.0 / (1.0 + 0.3275911 * size);
    float sum = t * (0.254829592 +
                     t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
    float value = 1.0 - sum * exp(-size * size);
    return x < 0.0 ? -value : value;
}

/// Metres of haze as dense as in the cloud's middle on `metres` >= 0 of a ray. `from`: from the
/// middle to the ray's start; `way`: its unit direction; `perMetre`: one over the distances, along
/// the axes, at which the density is 1 / e; > 0.
float hazeCloudMetres(vec3 from, vec3 way, vec3 perMetre, float metres) {
    vec3 start = from * perMetre;
    vec3 step = way * perMetre;
    float speed = sqrt(dot(step, step));
    float nearest = dot(start, step) / speed;
    float aside = max(dot(start, start) - nearest * nearest, 0.0);
    float halfRootOfPi = 0.886226925452758;
    return halfRootOfPi / speed * exp(-aside) *
           max(errorFunction(nearest + speed * metres) - errorFunction(nearest), 0.0);
}
