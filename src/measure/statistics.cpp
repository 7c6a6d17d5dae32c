#include "measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ribalta {

double quantile(std::vector<double> values, double q) {
    if (values.empty()) {
        return 0.0;
    }
    std::sort(values.begin(), values.end());
    const double place = std::clamp(q, 0.0, 1.0) * double(values.size() - 1);
    const auto below = std::size_t(std::floor(place));
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double part = place - double(below);
    return values[below] * (1.0 - part) + values[above] * part;
}

double median(std::vector<double> values) {
    return quantile(std::move(values), 0.5);
}

Spread spreadOf(const std::vector<double>& values) {
    return {median(values), quantile(values, 0.75) - quantile(values, 0.25)};
}

}  // namespace ribalta
