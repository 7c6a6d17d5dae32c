// Target: photometric files, and their light in some directions.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "gltf/parse_ies.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ribalta;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const gltf::IesProfile profile = gltf::parseIes(text, {"file", ""});
        double brightest = 0.0;
        for (const double candela : profile.web.candela) {
            brightest = candela > brightest ? candela : brightest;
        }
        for (int v = 0; v <= 36; ++v) {
            for (int h = -36; h <= 36; ++h) {
                const double off = 0.0872664625997165 * v;
                const double around = 0.0872664625997165 * h;
                const double candela =
                    profile.web.at({std::sin(off) * std::cos(around),
                                    std::sin(off) * std::sin(around), -std::cos(off)});
                if (!(candela >= 0.0 && candela <= brightest * (1.0 + 1e-9))) {
                    std::abort();
                }
            }
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kBadInput || error.place().file != "file") {
            std::abort();
        }
    }
    return 0;
}
