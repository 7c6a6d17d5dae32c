#include "measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ribalta {

std::vector<std::size_t> paretoFront(const std::vector<Cost>& points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].timeMs) && std::isfinite(points[i].error)) {
            order.push_back(i);
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].timeMs != points[b].timeMs ? points[a].timeMs < points[b].timeMs
                                                    : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        const bool equalsLast = !front.empty() && points[front.back()].timeMs == points[i].timeMs &&
                                points[front.back()].error == points[i].error;
        if (points[i].error < least || equalsLast) {
            front.push_back(i);
            least = points[i].error;
        }
    }
    return front;
}

std::optional<double> timeToError(const std::vector<Cost>& points, double error) {
    const std::vector<std::size_t> front = paretoFront(points);
    const auto reaches = std::find_if(front.begin(), front.end(),
                                      [&](std::size_t i) { return points[i].error <= error; });
    if (reaches == front.end()) {
        return std::nullopt;
    }
    const Cost& good = points[*reaches];
    if (reaches == front.begin() || good.error == error) {
        return good.timeMs;
    }
    const Cost& bad = points[*(reaches - 1)];
    if (good.error <= 0.0 || error <= 0.0 || bad.timeMs <= 0.0) {
        return good.timeMs;
    }
    const double part = std::log(bad.error / error) / std::log(bad.error / good.error);
    return bad.timeMs * std::pow(good.timeMs / bad.timeMs, part);
}

}  // namespace ribalta
