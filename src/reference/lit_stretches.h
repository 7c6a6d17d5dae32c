// Lit stretches: where along a line something is seen that can only be asked point by point.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "reference/interval.h"

namespace ribalta {

/// The stretches of [probes.front(), probes.back()] where `lit` holds, ascending. `lit` is asked
/// at the probes (ascending, at least two); between neighbours that agree it is taken to be the
/// same, and a change between others is followed by bisection to `tolerance`.
std::vector<Interval> litStretches(const std::function<bool(double)>& lit,
                                   std::span<const double> probes, double tolerance = 1e-12);

}  // namespace ribalta
