// Gauss-Legendre integration for tests: another rule than the program's own.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace ribalta {

/// The integral of f over [a, b] by Gauss-Legendre with 24 nodes.
template <typename Function>
double integratePanel(const Function& f, double a, double b) {
    constexpr int kNodes = 24;
    double sum = 0.0;
    for (int i = 0; i < kNodes; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (kNodes + 0.5));
        double slope = 0.0;
        for (int step = 0; step < 6; ++step) {
            double before = 1.0;
            double here = x;
            for (int n = 2; n <= kNodes; ++n) {
                const double next = ((2 * n - 1) * x * here - (n - 1) * before) / n;
                before = here;
                here = next;
            }
            slope = kNodes * (x * here - before) / (x * x - 1.0);
            x -= here / slope;
        }
        sum += 2.0 / ((1.0 - x * x) * slope * slope) * f(0.5 * (a + b) + 0.5 * (b - a) * x);
    }
    return 0.5 * (b - a) * sum;
}

/// 2 pi times the integral of f over the cosine from -1 to 1, on panels that shrink towards both
/// ends so that sharp peaks there are met.
template <typename Function>
double integrateSphere(const Function& f) {
    double sum = integratePanel(f, -0.5, 0.5);
    for (int k = 1; k < 40; ++k) {
        const double inner = std::ldexp(1.0, -k);
        const double outer = k == 39 ? 0.0 : 0.5 * inner;
        sum += integratePanel(f, 1.0 - inner, 1.0 - outer);
        sum += integratePanel(f, outer - 1.0, inner - 1.0);
    }
    return 2.0 * std::numbers::pi * sum;
}

}  // namespace ribalta
