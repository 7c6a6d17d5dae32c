// Interpolation by cubics through four neighbouring values of an even grid.
#pragma once

#include <algorithm>
#include <array>

namespace ribalta {

/// What to take of the values at first .. first + 3.
struct CubicWeights {
    int first = 0;
    std::array<double, 4> weights{};
};

/// Lagrange's cubic at `place` in 0 .. count - 1 (clamped), count >= 4.
inline CubicWeights cubicWeights(double place, int count) {
    const double x = std::clamp(place, 0.0, double(count - 1));
    CubicWeights result;
    result.first = std::clamp(int(x) - 1, 0, count - 4);
    const double t = x - result.first;
    result.weights = {-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0,
                      -t * (t - 1.0) * (t - 3.0) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0};
    return result;
}

}  // namespace ribalta
