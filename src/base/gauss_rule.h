// Gauss and Legendre's nodes and weights, of any number.
#pragma once

#include <vector>

namespace ribalta {

struct GaussRule {
    std::vector<double> places;   ///< 0..1, ascending
    std::vector<double> weights;  ///< they sum up to 1
};

/// The rule of `count` >= 1 nodes: exact for polynomials of degree 2 count - 1.
GaussRule gaussRule(int count);

}  // namespace ribalta
