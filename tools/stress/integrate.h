// Integrals of colours over pieces of a line by Gauss and Legendre's rule, pieces halved until two
// answers agree.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/glm.hpp>

#include "reference/interval.h"

namespace ribalta::stress {

/// Seven points: exact for polynomials up to degree 13.
template <typename Integrand>
glm::dvec3 gaussLegendre(const Integrand& integrand, const Interval& piece) {
    constexpr std::array<double, 4> kPlaces = {0.0, 0.405845151377397167, 0.741531185599394440,
                                               0.949107912342758525};
    constexpr std::array<double, 4> kWeights = {0.417959183673469388, 0.381830050505118945,
                                                0.279705391489276668, 0.129484966168869693};
    const double half = 0.5 * piece.length();
    const double centre = piece.first + half;
    glm::dvec3 sum = kWeights[0] * integrand(centre);
    for (std::size_t i = 1; i < kPlaces.size(); ++i) {
        sum += kWeights[i] *
               (integrand(centre - half * kPlaces[i]) + integrand(centre + half * kPlaces[i]));
    }
    return half * sum;
}

/// The sum over `pieces`, which must be cut so that no feature hides between the points of all of
/// them, to about `relative` of itself. The integrand must not be negative.
template <typename Integrand>
glm::dvec3 integrate(const Integrand& integrand, const std::vector<Interval>& pieces,
                     double relative) {
    struct Work {
        Interval piece;
        glm::dvec3 value;
    };
    std::vector<Work> open;
    glm::dvec3 rough(0.0);
    for (const Interval& piece : pieces) {
        open.push_back({piece, gaussLegendre(integrand, piece)});
        rough += open.back().value;
    }
    // A tenth for each piece: their errors seldom add up.
    const double allowed = 0.01 * relative * std::max({rough.x, rough.y, rough.z});
    // Enough for hundreds of kinks; where it is not, the integrand is nothing but rounding.
    int splits = 5000;
    glm::dvec3 sum(0.0);
    while (!open.empty()) {
        const Work work = open.back();
        open.pop_back();
        const double middle = 0.5 * (work.piece.first + work.piece.last);
        const Interval left{work.piece.first, middle};
        const Interval right{middle, work.piece.last};
        const glm::dvec3 first = gaussLegendre(integrand, left);
        const glm::dvec3 second = gaussLegendre(integrand, right);
        const glm::dvec3 change = glm::abs(first + second - work.value);
        if (std::max({change.x, change.y, change.z}) <= allowed || splits == 0) {
            sum += first + second;
        } else {
            --splits;
            open.push_back({left, first});
            open.push_back({right, second});
        }
    }
    return sum;
}

}  // namespace ribalta::stress
