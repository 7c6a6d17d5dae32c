// Statistics: what repeated measurements say together. No clocks.
#pragma once

#include <vector>

namespace ribalta {

/// The value below which a part `q` in 0..1 of the values lies, linear between neighbours; 0 of
/// none.
double quantile(std::vector<double> values, double q);

/// The middle value, or the mean of the middle two; 0 of none.
double median(std::vector<double> values);

/// A middle and how far values lie about it.
struct Spread {
    double median = 0.0;
    double iqr = 0.0;  ///< from the lower to the upper quartile
};
Spread spreadOf(const std::vector<double>& values);

}  // namespace ribalta
