#include "sky_model_options.h"

#include <array>
#include <vector>

#include <CLI/CLI.hpp>

#include "parse_number.h"
#include "reference/integrate_sky.h"

namespace ribalta {
namespace {

constexpr int kMostTexels = 4096;

[[noreturn]] void refuse(const std::string& option, const std::string& message) {
    throw CLI::ValidationError(option, message);
}

/// Whole numbers between x: "256x64".
std::vector<int> parseTableSize(const std::string& option, const std::string& text,
                                std::size_t count, const std::string& expected) {
    std::vector<int> sizes;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('x', start), text.size());
        const std::optional<int> size = parseNumber<int>(text.substr(start, end - start));
        sizes.push_back(size.value_or(0));
        start = end + 1;
    }
    for (const int size : sizes) {
        if (size < 1 || size > kMostTexels || sizes.size() != count) {
            refuse(option, "'" + text + "' is not " + expected);
        }
    }
    return sizes;
}

SkyPlaneSize parsePlane(const std::string& option, const std::string& text) {
    const std::vector<int> sizes =
        parseTableSize(option, text, 2, "two sizes in 2..4096, e.g. 256x64");
    if (sizes[0] < 2 || sizes[1] < 2) {
        refuse(option, "'" + text + "' is not two sizes in 2..4096, e.g. 256x64");
    }
    return {sizes[0], sizes[1]};
}

SkyVolumeSize parseVolume(const std::string& text) {
    const std::string option = "--table-size";
    const std::string expected =
        "four sizes, heights x view angles x suns x angles between ray and sun, e.g. "
        "32x128x32x8: at least 2 heights, 4 view angles (an even number), 2 suns, 1 angle, and "
        "at most 4096 each and of the last two's product";
    const std::vector<int> sizes = parseTableSize(option, text, 4, expected);
    if (sizes[0] < 2 || sizes[1] < 4 || sizes[1] % 2 != 0 || sizes[2] < 2 ||
        sizes[2] * sizes[3] > kMostTexels) {
        refuse(option, "'" + text + "' is not " + expected);
    }
    return {sizes[0], sizes[1], sizes[2], sizes[3]};
}

}  // namespace

void SkyModelOptions::addTo(CLI::App& command) {
    const std::vector<std::string> models = {"reference", "auto", "bruneton", "single", "chapman"};
    command
        .add_option("--model", model,
                    "what computes it: reference (the integral in double precision), auto (the "
                    "renderer's own), bruneton "
                    "(precomputed tables of every order, Bruneton & Neyret 2008 as described in "
                    "2017), single (their simplified variant: light scattered once, 2008), or "
                    "chapman (no tables: Schuler's form of Chapman's function, without haze)")
        ->type_name("NAME")
        ->check(
            [models](const std::string& text) {
                std::string names;
                for (const std::string& known : models) {
                    if (text == known) {
                        return std::string();
                    }
                    names += (names.empty() ? "" : ", ") + known;
                }
                return "there is no model '" + text + "'; there are: " + names;
            },
            "")
        ->capture_default_str();
    command
        .add_option("--orders", orders,
                    "how often light may be scattered or reflected, 1..20 (default: 4, or 1 where "
                    "a model has no more)")
        ->type_name("COUNT")
        ->check(
            [](const std::string& text) {
                const std::optional<int> value = parseNumber<int>(text);
                return value && *value >= 1 && *value <= kMostSkyOrders
                           ? ""
                           : "'" + text + "' is not a whole number in 1.." +
                                 std::to_string(kMostSkyOrders);
            },
            "");
    addDetailsTo(command);
}

void SkyModelOptions::addDetailsTo(CLI::App& command) {
    command
        .add_option("--table-size", tableSize,
                    "with bruneton, single: texels of the scattering table, heights x view angles "
                    "x suns x angles between ray and sun (default: 32x128x32x8; single "
                    "32x64x64x4)")
        ->type_name("HxVxSxA");
    command
        .add_option("--transmittance-size", transmittanceSize,
                    "with bruneton, single: view angles x heights (default: 256x64)")
        ->type_name("VxH");
    command
        .add_option("--irradiance-size", irradianceSize,
                    "with bruneton: suns x heights (default: 64x16)")
        ->type_name("SxH");
    command
        .add_option("--precision", precision,
                    "with bruneton, single: floats of the scattering table, half (default) or "
                    "single")
        ->type_name("NAME")
        ->check(CLI::IsMember({"half", "single"}).description(""));
    command
        .add_option("--texels", texels,
                    "with bruneton, single: how light scattered once is computed at the texels, "
                    "exact (what is off is what interpolation loses; the default of single) or as "
                    "published, from the table of transmittance in 50 steps: 2017 (bruneton's "
                    "default), 2008 (single)")
        ->type_name("NAME")
        ->check(CLI::IsMember({"exact", "2017", "2008"}).description(""));
    command
        .add_option("--chapman", chapmanForm,
                    "with chapman: Chapman's function as Schuler has it (schuler, the default), "
                    "or by a better form (better)")
        ->type_name("FORM")
        ->check(CLI::IsMember({"schuler", "better"}).description(""));
    command
        .add_option("--segments", segments,
                    "with chapman: segments of each ray, 1..4096 (default: 64)")
        ->type_name("COUNT")
        ->check(CLI::Range(1, kMostTexels).description(""));
}

SkyModel SkyModelOptions::parsed(const std::string& modelOption,
                                 const std::string& ordersOption) const {
    const bool tables = model == "bruneton" || model == "single";
    const bool chapman = model == "chapman";
    const bool once = model == "single" || chapman;
    struct Given {
        const char* option;
        bool given;
        bool known;
    };
    const std::array<Given, 7> options = {{
        {"--table-size", !tableSize.empty(), tables},
        {"--transmittance-size", !transmittanceSize.empty(), tables},
        {"--irradiance-size", !irradianceSize.empty(), model == "bruneton"},
        {"--precision", !precision.empty(), tables},
        {"--texels", !texels.empty(), tables && texels != (once ? "2017" : "2008")},
        {"--chapman", !chapmanForm.empty(), chapman},
        {"--segments", segments.has_value(), chapman},
    }};
    for (const Given& option : options) {
        if (option.given && !option.known) {
            refuse(option.option,
                   "means nothing to " + modelOption + " " + model + "; leave it out");
        }
    }
    if (once && orders.value_or(1) != 1) {
        refuse(ordersOption,
               modelOption + " " + model + " knows light scattered once alone; leave it out");
    }
    if (chapman) {
        ChapmanSky sky;
        sky.better = chapmanForm == "better";
        sky.segments = segments.value_or(sky.segments);
        return sky;
    }
    if (model == "auto") {
        return AutoSky{orders.value_or(AutoSky{}.orders)};
    }
    if (!tables) {
        return ReferenceSky{orders.value_or(ReferenceSky{}.orders)};
    }
    PrecomputedSkySettings sky = once ? simplifiedSky() : PrecomputedSkySettings{};
    sky.orders = orders.value_or(sky.orders);
    sky.exactTexels = texels.empty() ? sky.exactTexels : texels == "exact";
    sky.halfFloats = precision != "single";
    if (!tableSize.empty()) {
        sky.scattering = parseVolume(tableSize);
    }
    if (!transmittanceSize.empty()) {
        sky.transmittance = parsePlane("--transmittance-size", transmittanceSize);
    }
    if (!irradianceSize.empty()) {
        sky.irradiance = parsePlane("--irradiance-size", irradianceSize);
    }
    return sky;
}

}  // namespace ribalta
