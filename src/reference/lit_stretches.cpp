// Lit stretches: where along a line something is seen that can only be asked point by point.
#include "reference/lit_stretches.h"

#include <algorithm>

#include "base/check.h"

namespace ribalta {
namespace {

double findChange(const std::function<bool(double)>& lit, Interval between, bool litAtFirst,
                  double tolerance) {
    while (between.length() > tolerance) {
        const double x = 0.5 * (between.first + between.last);
        if (x <= between.first || x >= between.last) {
            break;
        }
        (lit(x) == litAtFirst ? between.first : between.last) = x;
    }
    return 0.5 * (between.first + between.last);
}

}  // namespace

std::vector<Interval> litStretches(const std::function<bool(double)>& lit,
                                   std::span<const double> probes, double tolerance) {
    CHECK(probes.size() >= 2 && std::is_sorted(probes.begin(), probes.end()));
    std::vector<Interval> stretches;
    bool isLit = lit(probes.front());
    double start = probes.front();
    for (std::size_t i = 1; i < probes.size(); ++i) {
        if (lit(probes[i]) == isLit) {
            continue;
        }
        const double change = findChange(lit, {probes[i - 1], probes[i]}, isLit, tolerance);
        if (isLit) {
            stretches.push_back({start, change});
        }
        isLit = !isLit;
        start = change;
    }
    if (isLit) {
        stretches.push_back({start, probes.back()});
    }
    return stretches;
}

}  // namespace ribalta
