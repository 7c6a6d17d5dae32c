// Interpolation at Chebyshev's nodes (Trefethen 2013, Approximation Theory and Approximation
// Practice, chapters 2-4).
#include "reference/smooth_panel.h"

namespace ribalta {
namespace {

constexpr std::size_t kNodes = SmoothPanel::kNodes;
using Row = std::array<double, kNodes>;
using Matrix = std::array<Row, kNodes>;

// Chebyshev coefficients from the values at the nodes.
Matrix makeTransform() {
    Matrix matrix{};
    for (std::size_t k = 0; k < kNodes; ++k) {
        for (std::size_t j = 0; j < kNodes; ++j) {
            matrix[k][j] = (k == 0 ? 1.0 : 2.0) / kNodes *
                           std::cos(double(k) * std::numbers::pi * (double(j) + 0.5) / kNodes);
        }
    }
    return matrix;
}

// T_k's powers of y, by T_k = 2 y T_(k-1) - T_(k-2).
Matrix makePowers() {
    Matrix t{};
    t[0][0] = 1.0;
    t[1][1] = 1.0;
    for (std::size_t k = 2; k < kNodes; ++k) {
        for (std::size_t i = 0; i < kNodes; ++i) {
            t[k][i] = (i > 0 ? 2.0 * t[k - 1][i - 1] : 0.0) - t[k - 2][i];
        }
    }
    return t;
}

}  // namespace

const std::array<double, kNodes>& SmoothPanel::nodes() {
    static const Row places = [] {
        Row made{};
        for (std::size_t j = 0; j < kNodes; ++j) {
            made[j] = std::cos(std::numbers::pi * (double(j) + 0.5) / kNodes);
        }
        return made;
    }();
    return places;
}

void SmoothPanel::fit(const std::array<double, kNodes>& values) {
    static const Matrix transform = makeTransform();
    static const Matrix powersOf = makePowers();
    powers = {};
    for (std::size_t k = 0; k < kNodes; ++k) {
        double sum = 0.0;
        for (std::size_t j = 0; j < kNodes; ++j) {
            sum += transform[k][j] * values[j];
        }
        chebyshev[k] = sum;
        for (std::size_t i = 0; i <= k; ++i) {
            powers[i] += sum * powersOf[k][i];
        }
    }
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    smallest = *low;
    largest = *high;
}

// |T_k''| is at most k^2 (k^2 - 1) / 3 on [-1, 1], |T_k''''| at most that times (k^2 - 4)(k^2 - 9)
// / 35 (Markov).
double SmoothPanel::secondDerivative() const {
    double bound = 0.0;
    for (std::size_t k = 2; k < kNodes; ++k) {
        const auto square = double(k * k);
        bound += std::abs(chebyshev[k]) * square * (square - 1.0) / 3.0;
    }
    return bound;
}

double SmoothPanel::fourthDerivative() const {
    double bound = 0.0;
    for (std::size_t k = 4; k < kNodes; ++k) {
        const auto square = double(k * k);
        bound += std::abs(chebyshev[k]) * square * (square - 1.0) / 3.0 * (square - 4.0) *
                 (square - 9.0) / 35.0;
    }
    return bound;
}

}  // namespace ribalta
