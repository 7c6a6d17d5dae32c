// The shell of air as geometry: where a ray runs in it, ends and meets the planet's shadow. No
// light. Needs lib/air.glsl before it.
//
// A ray starts at a height h (metres, 0..air.top unless said otherwise); mu is the cosine between
// it and the zenith there, muS that between sun and zenith, nu that between ray and sun; t in
// metres along the ray. With R the ground's radius and r = R + h, differences of squared radii are
// written as products, r^2 - R^2 = h (2 R + h), so that no two large numbers are subtracted.

/// Metres past every ray's end.
const float kAirEndless = 1.0e30;

/// r^2 - R^2 at a height, m2.
float airSquare(Air air, float h) {
    return h * (2.0 * air.groundRadius + h);
}

/// (r mu)^2 - (r^2 - R^2): not negative where the ray's line meets the ground.
float groundDiscriminant(Air air, float h, float mu) {
    float b = (air.groundRadius + h) * mu;
    return b * b - airSquare(air, h);
}

/// Whether the ray ends on the ground: to be decided once a ray and passed on. One that starts on
/// the ground and looks level or up does not. Towards the sun (mu = muS): whether the sun is hidden.
bool hitsGround(Air air, float h, float mu) {
    return mu < 0.0 && groundDiscriminant(air, h, mu) >= 0.0;
}

/// Metres to the ground for a ray that hits it.
float distanceToGround(Air air, float h, float mu) {
    float ahead = -(air.groundRadius + h) * mu;
    float divisor = ahead + sqrt(max(groundDiscriminant(air, h, mu), 0.0));
    return divisor > 0.0 ? airSquare(air, h) / divisor : 0.0;
}

/// Metres to the air's end for a ray that does not hit the ground.
float distanceToTop(Air air, float h, float mu) {
    float b = (air.groundRadius + h) * mu;
    float q = max((air.top - h) * (2.0 * air.groundRadius + air.top + h), 0.0);
    float s = sqrt(b * b + q);
    if (mu > 0.0) {
        return q / (b + s);
    }
    return s - b;
}

/// Metres to the end of the ray's way through the air: ground or top.
float distanceInAir(Air air, float h, float mu, bool ground) {
    if (ground) {
        return distanceToGround(air, h, mu);
    }
    return distanceToTop(air, h, mu);
}

/// Height at t along the ray.
float heightAlong(Air air, float h, float mu, float t) {
    float r = air.groundRadius + h;
    float s = t * (2.0 * r * mu + t);
    return h + s / (sqrt(max(r * r + s, 0.0)) + r);
}

/// The cosine between the ray and the zenith at t along it; `height` is the one there.
float cosineAlong(Air air, float h, float mu, float t, float height) {
    return clamp(((air.groundRadius + h) * mu + t) / (air.groundRadius + height), -1.0, 1.0);
}

/// The cosine between sun and zenith at t along the ray; `height` is the one there.
float sunCosineAlong(Air air, float h, float muS, float nu, float t, float height) {
    return clamp(((air.groundRadius + h) * muS + t * nu) / (air.groundRadius + height), -1.0, 1.0);
}

/// Metres to the ray's lowest point; 0 where it rises from the start.
float distanceToLowest(Air air, float h, float mu) {
    return max(-(air.groundRadius + h) * mu, 0.0);
}

/// Height of the lowest point of the ray's whole line; below 0 where the line meets the ground.
float lowestHeight(Air air, float h, float mu) {
    float r = air.groundRadius + h;
    float square = -groundDiscriminant(air, h, mu);
    float lowest = r * sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
    return square / (lowest + air.groundRadius);
}

/// The part entry..exit of a ray's line (t >= 0) that lies in the planet's shadow, which is the
/// cylinder of its radius behind it; for points above the ground. False, entry = exit = 0, where no
/// part does. muS, nu at the ray's start. Edges are those of hitsGround(muS there).
bool planetShadow(Air air, float h, float mu, float muS, float nu, OUT(float) entry,
                  OUT(float) exit) {
    entry = 0.0;
    exit = 0.0;
    // Distance from the shadow's axis, squared, less R^2: a t^2 + 2 b t + c.
    float r = air.groundRadius + h;
    float a = max((1.0 - nu) * (1.0 + nu), 0.0);
    float b = r * (mu - muS * nu);
    float c = -groundDiscriminant(air, h, muS);
    float first = 0.0;
    float last = kAirEndless;
    float discriminant = b * b - a * c;
    if (discriminant <= 0.0) {
        if (c >= 0.0) {
            return false;
        }
    } else {
        // The root that does not cancel first; the other from their product c / a.
        float q = -(b + (b < 0.0 ? -sqrt(discriminant) : sqrt(discriminant)));
        float far = abs(q) < a * kAirEndless ? q / a : (q < 0.0 ? -kAirEndless : kAirEndless);
        float near = q != 0.0 ? c / q : 0.0;
        first = max(min(near, far), 0.0);
        last = min(max(near, far), kAirEndless);
    }
    // Behind the planet: r muS + t nu < 0.
    float start = r * muS;
    if (abs(nu) * kAirEndless <= abs(start)) {
        if (start >= 0.0) {
            return false;
        }
    } else if (nu > 0.0) {
        last = min(last, -start / nu);
    } else {
        first = max(first, -start / nu);
    }
    if (first >= last) {
        return false;
    }
    entry = first;
    exit = last;
    return true;
}

/// Moves a ray that starts above the air (h > air.top) to where it enters it: metres to there, and
/// mu and muS there; nu stays. False, and the start's values, where it passes the air by. `sine` is
/// of the angle whose cosine is mu: from far away mu alone does not tell where in the air a ray goes.
bool enterAir(Air air, float h, float mu, float sine, float muS, float nu, OUT(float) t,
              OUT(float) muThere, OUT(float) muSThere) {
    t = 0.0;
    muThere = mu;
    muSThere = muS;
    float r = air.groundRadius + h;
    float radius = air.groundRadius + air.top;
    float lowest = r * sine;
    if (mu >= 0.0 || lowest >= radius) {
        return false;
    }
    float s = sqrt((radius - lowest) * (radius + lowest));
    t = (h - air.top) * (2.0 * air.groundRadius + air.top + h) / (s - r * mu);
    muThere = max(-s / radius, -1.0);
    muSThere = clamp((r * muS + t * nu) / radius, -1.0, 1.0);
    return true;
}
