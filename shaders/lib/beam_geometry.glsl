// Beam geometry: the part of a ray inside a beam, stable in single precision, and where to put
// samples on it. No light. Everywhere the beam's apex is the origin and its axis +z, so that z is
// the depth along the beam in metres.
//
// All quantities are taken at the ray's point p nearest to the apex, p = o + tp d, not at the
// ray's origin: a beam of half a degree seen from 50 m needs differences of squares whose terms
// would otherwise agree to six digits. With Q(v) = sin^2 vz^2 - cos^2 (vx^2 + vy^2) and Q(u, v) its
// bilinear form, the ray is inside the double cone where
//   qa s^2 + 2 qb s + qc >= 0,   qa = Q(d), qb = Q(d, p), qc = Q(p), s = t - tp,
// and the discriminant needs no difference of those products: with the moment n = d x o,
//   qb^2 - qa qc = -n adj(Q) n = cos^2 (sin^2 (nx^2 + ny^2) - cos^2 nz^2).
// Which root is an entry follows from the sign of the derivative qa s + qb = +-sqrt(D), not from
// the order of the roots, so the camera may stand inside the beam, at its apex or look along it.

/// Slopes below this are taken as parallel to a plane; over 10 km they move 1e-16 m.
const float kParallel = 1.0e-20;
/// Metres past every ray's ends.
const float kEndless = 1.0e30;

/// Restricts first..last to where offset + slope s >= 0; first > last afterwards where that is
/// nowhere.
void clipToPlane(float offset, float slope, float first, float last, OUT(float) clippedFirst,
                 OUT(float) clippedLast) {
    clippedFirst = first;
    clippedLast = last;
    if (abs(slope) < kParallel) {
        if (offset < 0.0) {
            clippedLast = first - 1.0 - abs(first);
        }
    } else if (slope > 0.0) {
        clippedFirst = max(first, -offset / slope);
    } else {
        clippedLast = min(last, -offset / slope);
    }
}

/// The overlap of first..last with t0..t1; false and entry = exit = t0 where there is none.
bool joinClip(float first, float last, float t0, float t1, OUT(float) entry, OUT(float) exit) {
    entry = max(first, t0);
    exit = min(last, t1);
    if (entry < exit) {
        return true;
    }
    entry = t0;
    exit = t0;
    return false;
}

/// Restricts the ray origin + t direction, t0 <= t <= t1, to the cone of half angle a around +z
/// (one nappe) between the planes z = zLens and z = zFar. direction is unit; cosSquared and
/// sinSquared of a come from double precision, 0.5 <= a <= 80 degrees; 0 < zLens < zFar <= 1e30;
/// t0, t1 finite. False where nothing is left (entry = exit = t0 then), else entry < exit.
/// In single precision the ends were off by more than 1 cm for none of 2 million rays that looked
/// from 50 m at beams of 0.5 to 80 degrees, and for 0.0004 % from 500 m (grazing the cone).
bool clipToCone(vec3 origin, vec3 direction, float cosSquared, float sinSquared, float zLens,
                float zFar, float t0, float t1, OUT(float) entry, OUT(float) exit) {
    entry = t0;
    exit = t0;

    float tNearest = -dot(origin, direction);
    vec3 moment = cross(direction, origin);
    vec3 nearest = cross(moment, direction);

    float first = -kEndless;
    float last = kEndless;
    clipToPlane(nearest.z - zLens, direction.z, first, last, first, last);
    clipToPlane(zFar - nearest.z, -direction.z, first, last, first, last);
    if (!(first < last)) {
        return false;
    }

    float qa = sinSquared * direction.z * direction.z -
               cosSquared * (direction.x * direction.x + direction.y * direction.y);
    float qb = sinSquared * direction.z * nearest.z -
               cosSquared * (direction.x * nearest.x + direction.y * nearest.y);
    float qc = sinSquared * nearest.z * nearest.z -
               cosSquared * (nearest.x * nearest.x + nearest.y * nearest.y);
    float discriminant = cosSquared * (sinSquared * (moment.x * moment.x + moment.y * moment.y) -
                                       cosSquared * moment.z * moment.z);
    if (qa == 0.0) {
        // Parallel to the cone's edge: as if a trace steeper, its second crossing far away.
        qa = -1.0e-30;
    }
    if (qa < 0.0 && discriminant <= 0.0) {
        return false;
    }

    // Roots are kept where they can matter, in front of the lens: those behind it belong to the
    // other nappe or to the part the lens plane has cut off. Half the depth is room for rounding.
    float zKeep = 0.5 * zLens;
    float root = sqrt(max(discriminant, 0.0));
    float q = qb < 0.0 ? root - qb : -(root + qb);
    bool anyRoot = false;
    float s = q / qa;
    if (nearest.z + s * direction.z >= zKeep) {
        anyRoot = true;
        if (qb < 0.0) {
            first = max(first, s);
        } else {
            last = min(last, s);
        }
    }
    if (q != 0.0) {
        s = qc / q;
        if (nearest.z + s * direction.z >= zKeep) {
            anyRoot = true;
            if (qb < 0.0) {
                last = min(last, s);
            } else {
                first = max(first, s);
            }
        }
    }
    // Steeper than the cone: inside only between its two crossings.
    if (qa < 0.0 && !anyRoot) {
        return false;
    }
    return joinClip(first + tNearest, last + tNearest, t0, t1, entry, exit);
}

/// The same for a square beam: |x| <= z tanHalfAngle and |y| <= z tanHalfAngle.
bool clipToPyramid(vec3 origin, vec3 direction, float tanHalfAngle, float zLens, float zFar,
                   float t0, float t1, OUT(float) entry, OUT(float) exit) {
    entry = t0;
    exit = t0;

    float tNearest = -dot(origin, direction);
    vec3 nearest = cross(cross(direction, origin), direction);
    float width = tanHalfAngle * nearest.z;
    float widening = tanHalfAngle * direction.z;

    float first = -kEndless;
    float last = kEndless;
    clipToPlane(nearest.z - zLens, direction.z, first, last, first, last);
    clipToPlane(zFar - nearest.z, -direction.z, first, last, first, last);
    clipToPlane(width - nearest.x, widening - direction.x, first, last, first, last);
    clipToPlane(width + nearest.x, widening + direction.x, first, last, first, last);
    clipToPlane(width - nearest.y, widening - direction.y, first, last, first, last);
    clipToPlane(width + nearest.y, widening + direction.y, first, last, first, last);
    return joinClip(first + tNearest, last + tNearest, t0, t1, entry, exit);
}

// Projective placement: samples that are even in x of [0, 1] in the lamp's own projection, where
// 1 / z is linear along the ray, and so are the slopes (x / z, y / z): light-map coordinates and
// shadow-map depth then take one multiply-add a sample. t = a + (b - a) f(x) between the clip's
// ends a and b at depths z0 and z1 (both > 0, metres).

/// f(x) = x z0 / (z1 (1 - x) + x z0): 0..1 for x in 0..1.
float projectiveStep(float x, float z0, float z1) {
    return x * z0 / (z1 * (1.0 - x) + x * z0);
}

/// f'(x) = z0 z1 / (z1 (1 - x) + x z0)^2, so that dt = (b - a) f'(x) dx.
float projectiveWeight(float x, float z0, float z1) {
    float depth = z1 * (1.0 - x) + x * z0;
    return (z0 / depth) * (z1 / depth);
}

/// dt / r^2 = (b - a) / (z0 z1) cos^2(beta) dx in 1/m, the weight of the sample with the inverse
/// square in it: lengthMetres = b - a, slope = (x / z, y / z) of the sample,
/// cos^2(beta) = 1 / (1 + slope^2). The inverse square is the plain one, the same as inverseSquare
/// in front of the lens plane.
float projectiveWeightOverSquare(float lengthMetres, float z0, float z1, vec2 slope) {
    return (lengthMetres / z0) / (z1 * (1.0 + dot(slope, slope)));
}
