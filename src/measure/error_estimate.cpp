#include "measure/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "base/error.h"
#include "base/parallel_for.h"
#include "measure/display_picture.h"
#include "measure/drawn_frame.h"
#include "measure/measure_point.h"

namespace ribalta {
namespace {

// Enough when it is known to so much of itself, from so many pixels.
constexpr double kEnough = 0.05;
constexpr std::size_t kFewest = 2000;
constexpr std::size_t kBatch = 128;

// Of the mean square of what has been seen: its root in %, and the root's standard error.
struct RootMeanSquare {
    double sum = 0.0;
    double sumOfSquares = 0.0;
    std::size_t count = 0;

    void add(double square) {
        sum += square;
        sumOfSquares += square * square;
        ++count;
    }
    double percent() const { return 100.0 * std::sqrt(sum / double(count)); }
    double uncertainty() const {
        const double mean = sum / double(count);
        const double variance = std::max(0.0, sumOfSquares / double(count) - mean * mean);
        return mean > 0.0 ? 100.0 * std::sqrt(variance / double(count)) / (2.0 * std::sqrt(mean))
                          : 0.0;
    }
};

// All pixels of a picture, well mixed, the same way in every run.
std::vector<std::uint32_t> mixedPixels(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    return order;
}

}  // namespace

ErrorEstimate::ErrorEstimate(Renderer& renderer, const Scene& scene, const Camera& camera,
                             const FrameSettings& settings, double ev100, Against against)
    : ev100_(ev100), toneCurve_(settings.toneCurve) {
    reference_.camera = camera;
    reference_.width = settings.width;
    reference_.height = settings.height;
    reference_.haze = settings.haze;
    reference_.ambientLux = settings.ambientLux;
    FrameSettings shown = settings;
    shown.ev100 = ev100;
    DrawnLight light = drawLight(renderer, camera, shown);
    total_ = std::move(light.total);
    beams_ = std::move(light.beams);
    drawn_ = drawForReference(renderer, scene, reference_);
    thread_ = std::jthread(
        [this, &scene, against](const std::stop_token& stop) { run(stop, scene, against); });
}

ErrorEstimate::Value ErrorEstimate::value() const {
    const std::scoped_lock lock(mutex_);
    return value_;
}

double ErrorEstimate::squareError(int x, int y, const glm::dvec3& beams) const {
    const glm::dvec3 total(total_.at(x, y));
    const glm::dvec3 right = total - glm::dvec3(beams_.at(x, y)) + beams;
    const glm::dvec3 difference = displayPixel(total, ev100_, toneCurve_) -
                                  displayPixel(glm::max(right, 0.0), ev100_, toneCurve_);
    return glm::dot(difference, difference) / 3.0;
}

void ErrorEstimate::run(const std::stop_token& stop, const Scene& scene, Against against) {
    try {
        ReferenceSettings settings = reference_;
        settings.drawn = against == Against::kShadowMaps ? &drawn_ : nullptr;
        ReferencePixels pixels(scene, settings);
        const auto width = std::uint32_t(settings.width);
        const std::vector<std::uint32_t> order =
            mixedPixels(std::size_t(width) * std::size_t(settings.height));
        RootMeanSquare seen;
        while (seen.count < order.size()) {
            std::vector<double> squares(std::min(kBatch, order.size() - seen.count));
            parallelFor(squares.size(), [&](std::size_t i) {
                if (stop.stop_requested()) {
                    return;
                }
                const std::uint32_t pixel = order[seen.count + i];
                const auto x = int(pixel % width);
                const auto y = int(pixel / width);
                squares[i] = squareError(x, y, pixels.beams(x, y));
            });
            if (stop.stop_requested()) {
                return;
            }
            for (const double square : squares) {
                seen.add(square);
            }
            const bool isEnough =
                seen.count >= kFewest && seen.uncertainty() <= kEnough * seen.percent();
            const std::scoped_lock lock(mutex_);
            value_ = {seen.percent(), seen.uncertainty(), seen.count,
                      isEnough || seen.count == order.size(), ""};
            if (value_.isDone) {
                return;
            }
        }
    } catch (const std::exception& error) {
        const std::scoped_lock lock(mutex_);
        value_.failure = oneLine(error.what());
        value_.isDone = true;
    }
}

}  // namespace ribalta
