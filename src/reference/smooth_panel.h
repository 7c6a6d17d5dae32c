// SmoothPanel: a smooth function over a short interval as a polynomial with a known error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "reference/interval.h"

namespace ribalta {

/// A polynomial of degree 7 in y, which runs from -1 to 1 over `place`.
struct SmoothPanel {
    static constexpr std::size_t kNodes = 8;

    Interval place;
    std::array<double, kNodes> chebyshev{};  ///< coefficients of T_0 .. T_7
    std::array<double, kNodes> powers{};     ///< of y^0 .. y^7
    double smallest = 0.0;                   ///< of the values it was made from
    double largest = 0.0;

    /// Estimate of how far the polynomial is from the function: the size of its last two terms.
    /// High where the terms fall quickly, as those of a smooth function do.
    double error() const { return std::abs(chebyshev[6]) + std::abs(chebyshev[7]); }
    /// Of the polynomial over `place`.
    double integral() const {
        return place.length() *
               (chebyshev[0] - chebyshev[2] / 3.0 - chebyshev[4] / 15.0 - chebyshev[6] / 35.0);
    }
    double at(double y) const {
        double value = powers[kNodes - 1];
        for (std::size_t k = kNodes - 1; k-- > 0;) {
            value = value * y + powers[k];
        }
        return value;
    }
    /// Bounds of the second and the fourth derivative by y.
    double secondDerivative() const;
    double fourthDerivative() const;

    /// Fills chebyshev and powers from the values at nodes().
    void fit(const std::array<double, kNodes>& values);

    /// Chebyshev's nodes of the first kind in -1..1: the function is asked within the interval,
    /// never at its ends.
    static const std::array<double, kNodes>& nodes();
};

/// Fits a panel to f(x), 8 evaluations.
template <typename Function>
SmoothPanel fitPanel(const Function& f, const Interval& place) {
    SmoothPanel panel;
    panel.place = place;
    const double centre = 0.5 * (place.first + place.last);
    std::array<double, SmoothPanel::kNodes> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = f(centre + 0.5 * place.length() * SmoothPanel::nodes()[i]);
    }
    panel.fit(values);
    return panel;
}

}  // namespace ribalta
