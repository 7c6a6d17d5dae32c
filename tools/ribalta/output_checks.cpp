#include "output_checks.h"

#include <cmath>
#include <cstddef>
#include <system_error>

#include "base/error.h"
#include "base/log.h"

namespace ribalta {

void refuseReplacing(const std::filesystem::path& output,
                     const std::vector<std::filesystem::path>& inputs) {
    for (const std::filesystem::path& input : inputs) {
        std::error_code missing;  // then nothing is replaced
        if (std::filesystem::equivalent(output, input, missing)) {
            throw Error(ErrorKind::kUsage, {output.string(), ""},
                        "is what the picture is made from and would be replaced; give another "
                        "name");
        }
    }
}

void warnOfNonFinite(const FloatImage& image, const std::filesystem::path& file) {
    const std::size_t channels = image.channels.size();
    const int depth = image.channel("Z");
    const std::size_t pixels = image.values.size() / channels;
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        bool isFinite = true;
        for (std::size_t c = 0; c < channels; ++c) {
            isFinite =
                isFinite && (int(c) == depth || std::isfinite(image.values[pixel * channels + c]));
        }
        if (!isFinite && count++ == 0) {
            first = pixel;
        }
    }
    if (count > 0) {
        const auto width = std::size_t(image.width);
        logWarning(file.string() + ": " + std::to_string(count) + " of " + std::to_string(pixels) +
                   " pixels hold more light than a float can (infinity), the first at " +
                   std::to_string(first % width) + "," + std::to_string(first / width) +
                   " from the top left; lower the lamps, --ambient or --K");
    }
}

}  // namespace ribalta
