// Gauss-Kronrod integration with lit and dark stretches (Piessens et al. 1983, QUADPACK's qk15 for
// the nodes; the error is the plain difference of the two rules, not QUADPACK's scaled one).
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

struct End {
    double x;
    bool lit;
};

struct Piece {
    double first;
    double last;
    bool firstLit;
    bool lastLit;
    glm::dvec3 value{0.0};
    double error = 0.0;
};

bool smallerError(const Piece& a, const Piece& b) {
    return a.error < b.error;
}

double largestChannel(const glm::dvec3& value) {
    return std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
}

double nodePosition(int i) {
    return i < 8 ? -kHalfNodes[i] : kHalfNodes[14 - i];
}
int mirrored(int i) {
    return i < 8 ? i : 14 - i;
}

class LitIntegral {
  public:
    LitIntegral(const std::function<glm::dvec3(double)>& integrand,
                const std::function<bool(double)>& lit, double span)
        : integrand_(integrand), lit_(lit), narrowest_(1e-12 * span) {}

    bool isLit(double x) const { return !lit_ || lit_(x); }

    /// Adds [a.x, b.x], cut at every change of `lit` that its nodes show.
    void add(const End& a, const End& b) {
        const double centre = 0.5 * (a.x + b.x);
        const double half = 0.5 * (b.x - a.x);
        std::array<End, kNodes + 2> points;
        points[0] = a;
        points[kNodes + 1] = b;
        bool changes = a.lit != b.lit;
        for (int i = 0; i < kNodes; ++i) {
            const double x = centre + half * nodePosition(i);
            points[i + 1] = {x, isLit(x)};
            changes = changes || points[i + 1].lit != a.lit;
        }
        const bool canSplit = b.x - a.x > 1e3 * narrowest_;
        if (changes && canSplit) {
            addRuns(points);
            return;
        }
        Piece piece{.first = a.x, .last = b.x, .firstLit = a.lit, .lastLit = b.lit};
        measure(points, half, piece);
        if (changes) {
            piece.error = largestChannel(piece.value);
        }
        pieces_.push_back(piece);
        std::push_heap(pieces_.begin(), pieces_.end(), smallerError);
    }

    /// Halves the worst piece; false where it is too short for that.
    bool refine() {
        std::pop_heap(pieces_.begin(), pieces_.end(), smallerError);
        const Piece worst = pieces_.back();
        if (worst.last - worst.first < 2.0 * narrowest_) {
            std::push_heap(pieces_.begin(), pieces_.end(), smallerError);
            return false;
        }
        pieces_.pop_back();
        const double x = 0.5 * (worst.first + worst.last);
        const End middle{x, isLit(x)};
        add({worst.first, worst.firstLit}, middle);
        add(middle, {worst.last, worst.lastLit});
        return true;
    }

    Integral sum() const {
        Integral total;
        for (const Piece& piece : pieces_) {
            total.value += piece.value;
            total.error += piece.error;
        }
        total.evaluations = evaluations_;
        return total;
    }

    std::size_t pieceCount() const { return pieces_.size(); }

  private:
    void addRuns(const std::array<End, kNodes + 2>& points) {
        End start = points[0];
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (points[i].lit != points[i - 1].lit) {
                const double change = findChange(points[i - 1], points[i]);
                add(start, {change, start.lit});
                start = {change, points[i].lit};
            }
        }
        add(start, points.back());
    }

    double findChange(End a, End b) const {
        while (b.x - a.x > narrowest_) {
            const double x = 0.5 * (a.x + b.x);
            if (x <= a.x || x >= b.x) {
                break;
            }
            (isLit(x) == a.lit ? a.x : b.x) = x;
        }
        return 0.5 * (a.x + b.x);
    }

    void measure(const std::array<End, kNodes + 2>& points, double half, Piece& piece) {
        glm::dvec3 kronrod{0.0};
        glm::dvec3 gauss{0.0};
        for (int i = 0; i < kNodes; ++i) {
            const End& node = points[i + 1];
            if (!node.lit) {
                continue;
            }
            const glm::dvec3 value = integrand_(node.x);
            ++evaluations_;
            kronrod += kKronrodWeights[mirrored(i)] * value;
            if (i % 2 == 1) {
                gauss += kGaussWeights[mirrored(i) / 2] * value;
            }
        }
        piece.value = half * kronrod;
        piece.error = half * largestChannel(kronrod - gauss);
    }

    const std::function<glm::dvec3(double)>& integrand_;
    const std::function<bool(double)>& lit_;
    double narrowest_;
    std::vector<Piece> pieces_;  // a heap, the largest error in front
    int evaluations_ = 0;
};

}  // namespace

Integral integrateLit(const std::function<glm::dvec3(double)>& integrand,
                      const std::function<bool(double)>& lit, std::span<const double> ends,
                      const IntegralAccuracy& accuracy) {
    CHECK(ends.size() >= 2 && std::is_sorted(ends.begin(), ends.end()));
    CHECK(accuracy.firstPieces >= 1 && accuracy.relative >= 0.0 && accuracy.absolute >= 0.0);
    const double span = ends.back() - ends.front();
    if (span <= 0.0) {
        return {};
    }
    LitIntegral integral(integrand, lit, span);
    End from{ends.front(), integral.isLit(ends.front())};
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const double start = from.x;
        const double length = ends[i] - start;
        const int count = int(std::ceil(accuracy.firstPieces * length / span));
        for (int k = 1; k <= count; ++k) {
            const double x = k == count ? ends[i] : start + length * k / count;
            const End to{x, integral.isLit(x)};
            integral.add(from, to);
            from = to;
        }
    }
    Integral total = integral.sum();
    while (total.error >
               std::max(accuracy.absolute, accuracy.relative * largestChannel(total.value)) &&
           integral.pieceCount() < std::size_t(accuracy.maxPieces) && integral.refine()) {
        total = integral.sum();
    }
    return total;
}

}  // namespace ribalta
