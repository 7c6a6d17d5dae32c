// Gauss-Kronrod integration (Piessens et al. 1983, QUADPACK's qk15 for the nodes; the error is the
// plain difference of the two rules, not QUADPACK's power of it).
#include "reference/adaptive_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/check.h"

namespace ribalta {
namespace {

constexpr int kNodes = 15;

// Nodes of [-1, 1] from the outermost to the middle; the other half is their mirror image.
constexpr std::array<double, 8> kHalfNodes = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144691258755, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0};
constexpr std::array<double, 8> kKronrodWeights = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
// Gauss's seven nodes are every second one of Kronrod's.
constexpr std::array<double, 4> kGaussWeights = {
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
    0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

struct Piece {
    Interval interval;
    glm::dvec3 value{0.0};
    double error = 0.0;
};

bool smallerError(const Piece& a, const Piece& b) {
    return a.error < b.error;
}

double largestChannel(const glm::dvec3& value) {
    return std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
}

Piece measure(const std::function<glm::dvec3(double)>& integrand, const Interval& interval) {
    const double centre = 0.5 * (interval.first + interval.last);
    const double half = 0.5 * interval.length();
    const glm::dvec3 middle = integrand(centre);
    glm::dvec3 kronrod = kKronrodWeights[7] * middle;
    glm::dvec3 gauss = kGaussWeights[3] * middle;
    for (std::size_t i = 0; i < 7; ++i) {
        const double offset = half * kHalfNodes[i];
        const glm::dvec3 pair = integrand(centre - offset) + integrand(centre + offset);
        kronrod += kKronrodWeights[i] * pair;
        if (i % 2 == 1) {
            gauss += kGaussWeights[i / 2] * pair;
        }
    }
    return {interval, half * kronrod, half * largestChannel(kronrod - gauss)};
}

Integral sum(std::span<const Piece> pieces) {
    Integral total;
    for (const Piece& piece : pieces) {
        total.value += piece.value;
        total.error += piece.error;
    }
    return total;
}

std::vector<Piece> measureFirstPieces(const std::function<glm::dvec3(double)>& integrand,
                                      std::span<const Interval> stretches, int firstPieces) {
    double length = 0.0;
    for (const Interval& stretch : stretches) {
        length += stretch.length();
    }
    std::vector<Piece> pieces;
    for (const Interval& stretch : stretches) {
        CHECK(stretch.first <= stretch.last);
        const int count =
            stretch.length() > 0.0 ? int(std::ceil(firstPieces * stretch.length() / length)) : 0;
        const double step = stretch.length() / count;
        for (int i = 0; i < count; ++i) {
            const double last = i + 1 == count ? stretch.last : stretch.first + step * (i + 1);
            pieces.push_back(measure(integrand, {stretch.first + step * i, last}));
        }
    }
    return pieces;
}

}  // namespace

Integral integrateAdaptively(const std::function<glm::dvec3(double)>& integrand,
                             std::span<const Interval> stretches,
                             const IntegralAccuracy& accuracy) {
    CHECK(accuracy.firstPieces >= 1 && accuracy.relative >= 0.0 && accuracy.absolute >= 0.0);
    // A heap, the piece with the largest error in front.
    std::vector<Piece> pieces = measureFirstPieces(integrand, stretches, accuracy.firstPieces);
    std::make_heap(pieces.begin(), pieces.end(), smallerError);
    int measured = int(pieces.size());
    const auto isGoodEnough = [&](const Integral& total) {
        return total.error <=
               std::max(accuracy.absolute, accuracy.relative * largestChannel(total.value));
    };
    // The running total gathers rounding; what it ends on is summed afresh.
    Integral total = sum(pieces);
    while (!isGoodEnough(total) && int(pieces.size()) < accuracy.maxPieces) {
        std::pop_heap(pieces.begin(), pieces.end(), smallerError);
        const Piece worst = pieces.back();
        const double middle = 0.5 * (worst.interval.first + worst.interval.last);
        if (middle <= worst.interval.first || middle >= worst.interval.last) {
            break;
        }
        pieces.back() = measure(integrand, {worst.interval.first, middle});
        const Piece other = measure(integrand, {middle, worst.interval.last});
        measured += 2;
        total.value += pieces.back().value + other.value - worst.value;
        total.error += pieces.back().error + other.error - worst.error;
        std::push_heap(pieces.begin(), pieces.end(), smallerError);
        pieces.push_back(other);
        std::push_heap(pieces.begin(), pieces.end(), smallerError);
        if (isGoodEnough(total)) {
            total = sum(pieces);
        }
    }
    total = sum(pieces);
    total.evaluations = kNodes * measured;
    return total;
}

}  // namespace ribalta
