// Legendre's polynomials by their recurrence, their zeros by Newton's method.
#include "base/gauss_rule.h"

#include <cmath>
#include <numbers>

#include "base/check.h"

namespace ribalta {

GaussRule gaussRule(int count) {
    CHECK(count >= 1);
    GaussRule rule;
    for (int i = 0; i < count; ++i) {
        double x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 8; ++step) {
            double before = 1.0;
            double here = x;
            for (int n = 2; n <= count; ++n) {
                const double next = ((2 * n - 1) * x * here - (n - 1) * before) / n;
                before = here;
                here = next;
            }
            slope = count * (x * here - before) / (x * x - 1.0);
            x -= here / slope;
        }
        rule.places.push_back(0.5 + 0.5 * x);
        rule.weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace ribalta
