#include "loading_options.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include "parse_number.h"

namespace ribalta {
namespace {

// A key of --limits.
struct LimitKey {
    std::string_view name;
    std::uint64_t LoadLimits::*limit;
    std::uint64_t highest;
};

constexpr LimitKey kKeys[] = {
    {"memory", &LoadLimits::memory, UINT64_MAX},    {"vertices", &LoadLimits::vertices, UINT64_MAX},
    {"nodes", &LoadLimits::nodes, UINT64_MAX},      {"pixels", &LoadLimits::pixels, UINT64_MAX},
    {"nesting", &LoadLimits::nesting, kMaxNesting},
};

[[noreturn]] void refuse(const std::string& entry) {
    throw CLI::ValidationError(
        "--limits", "'" + entry +
                        "' is none of memory, vertices, nodes, pixels=COUNT with K, M or G for "
                        "thousands, millions and billions, or nesting=1..1000; each once, by "
                        "comma, such as memory=4G,pixels=64M");
}

LoadLimits parseLimits(const std::string& text) {
    LoadLimits limits;
    std::set<std::string_view> given;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        const std::string entry = text.substr(start, end - start);
        const std::size_t equals = std::min(entry.find('='), entry.size());
        const LimitKey* const key =
            std::find_if(std::begin(kKeys), std::end(kKeys), [&](const LimitKey& each) {
                return each.name == std::string_view(entry).substr(0, equals);
            });
        if (key == std::end(kKeys) || !given.insert(key->name).second) {
            refuse(entry);
        }
        const auto count =
            parseCount(std::string_view(entry).substr(std::min(equals + 1, entry.size())));
        if (!count || *count > key->highest) {
            refuse(entry);
        }
        limits.*(key->limit) = *count;
        start = end + 1;
    }
    return limits;
}

// Wide enough for any unit, narrow enough for single precision.
std::string expectScale(const std::string& text) {
    const auto number = parseNumber<double>(text);
    return number && *number >= 1e-6 && *number <= 1e6
               ? ""
               : "'" + text + "' is not a number in 0.000001..1000000";
}

}  // namespace

void LoadingOptions::addTo(CLI::App& command) {
    command
        .add_option("--scene", scene,
                    "which of the file's scenes, by name or counted from 0 (default: the one that "
                    "the file names, else its first)")
        ->type_name("NAME|INDEX");
    command
        .add_option("--variant", variant,
                    "which of the file's material variants, by name or counted from 0 (default: "
                    "none, the materials that it shows without)")
        ->type_name("NAME|INDEX");
    command
        .add_option("--limits", limits,
                    "how much the file may ask for before it is refused: bytes of memory, "
                    "vertices and indices, nodes, pixels of one picture, nesting of its JSON; K, "
                    "M, G are thousands, millions, billions (default: memory=16G,vertices=150M,"
                    "nodes=4M,pixels=268435456,nesting=200)")
        ->type_name("KEY=N[,...]");
    command.add_flag("--allow-outside", allowOutside,
                     "read buffers and pictures that lie outside the scene's folder, too");
    command
        .add_option("--unit-scale", unitScale,
                    "metres of one of the file's units, such as 0.01 for centimetres (default: 1)")
        ->type_name("METRES")
        ->check(expectScale, "");
    command
        .add_option("--intensity-scale", intensityScale,
                    "factor for the intensity of all of the file's lamps (default: 1)")
        ->type_name("FACTOR")
        ->check(expectScale, "");
}

LoadOptions LoadingOptions::parsed() const {
    LoadOptions options;
    options.scene = scene;
    if (limits) {
        options.limits = parseLimits(*limits);
    }
    options.allowOutside = allowOutside;
    options.variant = variant;
    options.unitScale = unitScale;
    options.intensityScale = intensityScale;
    return options;
}

}  // namespace ribalta
