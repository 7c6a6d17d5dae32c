// Integrals of several smooth functions at once by Gauss and Kronrod's rules, pieces halved until
// every one of them is good enough.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace ribalta {

/// A piece of the way, its integrals by 15 points and how far those by 7 of them were off.
template <std::size_t N>
struct KronrodPiece {
    double first = 0.0;
    double last = 0.0;
    std::array<double, N> value{};
    std::array<double, N> error{};
};

/// Kronrod's 15 points around Gauss' 7. `f(x)` gives a std::array<double, N>.
template <std::size_t N, typename Function>
KronrodPiece<N> kronrodPiece(const Function& f, double first, double last) {
    constexpr std::array<double, 8> kPlaces = {
        0.991455371120812639, 0.949107912342758525, 0.864864423359769073, 0.741531185599394440,
        0.586087235467691130, 0.405845151377397167, 0.207784955007898468, 0.0};
    constexpr std::array<double, 8> kWeights = {
        0.0229353220105292250, 0.0630920926299785533, 0.104790010322250184, 0.140653259715525919,
        0.169004726639267903,  0.190350578064785410,  0.204432940075298892, 0.209482141084727828};
    constexpr std::array<double, 4> kGauss = {0.129484966168869693, 0.279705391489276668,
                                              0.381830050505118945, 0.417959183673469388};
    KronrodPiece<N> piece;
    piece.first = first;
    piece.last = last;
    const double half = 0.5 * (last - first);
    const double centre = first + half;
    std::array<double, N> gauss{};
    const auto add = [&](double x, std::size_t node) {
        const std::array<double, N> values = f(x);
        for (std::size_t c = 0; c < N; ++c) {
            piece.value[c] += half * kWeights[node] * values[c];
            gauss[c] += node % 2 == 1 ? half * kGauss[node / 2] * values[c] : 0.0;
        }
    };
    add(centre, 7);
    for (std::size_t node = 0; node < 7; ++node) {
        add(centre - half * kPlaces[node], node);
        add(centre + half * kPlaces[node], node);
    }
    for (std::size_t c = 0; c < N; ++c) {
        piece.error[c] = std::abs(piece.value[c] - gauss[c]);
    }
    return piece;
}

/// The integrals over cuts.front() .. cuts.back() of functions that are smooth between the cuts,
/// which ascend. Each component comes to about `relative` of its own size or better; so that it
/// can, it should not change its sign.
template <std::size_t N, typename Function>
std::array<double, N> integrateAdaptively(const Function& f, std::span<const double> cuts,
                                          double relative) {
    std::vector<KronrodPiece<N>> open;
    std::array<double, N> rough{};
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (cuts[i] > cuts[i - 1]) {
            open.push_back(kronrodPiece<N>(f, cuts[i - 1], cuts[i]));
            for (std::size_t c = 0; c < N; ++c) {
                rough[c] += std::abs(open.back().value[c]);
            }
        }
    }
    // Where this is not enough, nothing but rounding is left to halve.
    int splits = 2000;
    std::array<double, N> sum{};
    while (!open.empty()) {
        const KronrodPiece<N> piece = open.back();
        open.pop_back();
        bool good = splits == 0;
        if (!good) {
            good = true;
            for (std::size_t c = 0; c < N; ++c) {
                // The 15 points are far better than the 7 whose error this is.
                good = good && piece.error[c] <= relative * rough[c];
            }
        }
        if (good) {
            for (std::size_t c = 0; c < N; ++c) {
                sum[c] += piece.value[c];
            }
            continue;
        }
        --splits;
        const double middle = 0.5 * (piece.first + piece.last);
        open.push_back(kronrodPiece<N>(f, piece.first, middle));
        open.push_back(kronrodPiece<N>(f, middle, piece.last));
        for (std::size_t c = 0; c < N; ++c) {
            // A peak that the first look missed raises what an error is held against.
            rough[c] = std::max(rough[c], std::abs(open.back().value[c]) +
                                              std::abs(open[open.size() - 2].value[c]));
        }
    }
    return sum;
}

}  // namespace ribalta
