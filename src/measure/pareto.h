// Pareto: which measured points no other beats, and what they say of a given error.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ribalta {

/// What a point costs and what it is worth; less is better of both.
struct Cost {
    double timeMs = 0.0;
    double error = 0.0;
};

/// Indices of the points to which no other is at least equal in both and better in one, by rising
/// time. Points that are not finite are left out.
std::vector<std::size_t> paretoFront(const std::vector<Cost>& points);

/// The time at which one method's points reach `error`: on the front, between the last point above
/// and the first at or below, a straight line in log-log (in time alone where an error is 0). The
/// first point's time where it is good enough already. None: no point reaches it.
std::optional<double> timeToError(const std::vector<Cost>& points, double error);

}  // namespace ribalta
