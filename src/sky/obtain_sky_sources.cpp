#include "sky/obtain_sky_sources.h"

#include <cstring>
#include <span>
#include <string>

#include "base/content_hash.h"
#include "base/log.h"

namespace ribalta {
namespace {

const std::string kName = "sky";

// Of all that sources depend on: neither the sun's light nor its width.
std::string keyOf(const Atmosphere& air, int orders, const SkyTableSizes& sizes) {
    ContentHash hash;
    hash.add(skyRevision());
    std::vector<double> numbers = {air.groundRadiusMetres, air.topMetres,
                                   air.rayleighScaleHeightMetres, air.mieScaleHeightMetres,
                                   air.mieG};
    for (const glm::dvec3& colour : {air.rayleighScatteringPerMetre, air.mieScatteringPerMetre,
                                     air.mieExtinctionPerMetre, air.groundAlbedo}) {
        numbers.insert(numbers.end(), {colour.x, colour.y, colour.z});
    }
    hash.add(numbers);
    hash.add(std::vector<int>{orders, sizes.heights, sizes.suns, sizes.zenithAngles, sizes.azimuths,
                              sizes.firstDirections.above, sizes.firstDirections.below,
                              sizes.firstDirections.azimuths, sizes.laterDirections.above,
                              sizes.laterDirections.below, sizes.laterDirections.azimuths,
                              sizes.nodesOfFirst, sizes.nodesOfLater});
    return hash.text();
}

/// Tables of an order one after the other, in the machine's own byte order: they stay on it.
std::vector<std::byte> written(const SkySources::Tables& tables) {
    std::vector<std::byte> bytes;
    const auto append = [&](std::span<const std::byte> part) {
        bytes.insert(bytes.end(), part.begin(), part.end());
    };
    for (std::size_t i = 0; i < tables.grids.size(); ++i) {
        append(std::as_bytes(std::span(tables.grids[i])));
        append(std::as_bytes(std::span(tables.irradiances[i])));
    }
    return bytes;
}

std::optional<SkySources::Tables> read(std::span<const std::byte> bytes, int orders,
                                       const SkyTableSizes& sizes) {
    const auto suns = std::size_t(sizes.suns);
    const std::size_t cells = std::size_t(sizes.heights) * suns * std::size_t(sizes.zenithAngles) *
                              std::size_t(sizes.azimuths) * 6;
    const auto count = std::size_t(orders - 1);
    if (bytes.size() != count * (cells * sizeof(float) + suns * sizeof(glm::dvec3))) {
        return std::nullopt;
    }
    SkySources::Tables tables{std::vector(count, SkySources::Grid(cells)),
                              std::vector(count, std::vector<glm::dvec3>(suns))};
    const auto take = [&](auto& values) {
        const std::span<std::byte> place = std::as_writable_bytes(std::span(values));
        std::memcpy(place.data(), bytes.data(), place.size());
        bytes = bytes.subspan(place.size());
    };
    for (std::size_t i = 0; i < count; ++i) {
        take(tables.grids[i]);
        take(tables.irradiances[i]);
    }
    return tables;
}

}  // namespace

SkySources obtainSkySources(const OpticalLengthTable& table, int orders, const SkyTableSizes& sizes,
                            const FileCache* files) {
    if (files == nullptr) {
        return {table, orders, true, sizes};
    }
    const std::string key = keyOf(table.atmosphere(), orders, sizes);
    if (const std::optional<std::vector<std::byte>> bytes = files->find(kName, key)) {
        if (std::optional<SkySources::Tables> tables = read(*bytes, orders, sizes)) {
            logVerbose("sky: tables kept from before, " + files->folder().string());
            return {table, true, sizes, std::move(*tables)};
        }
        logVerbose("sky: tables kept in " + files->folder().string() +
                   " are of another size; they are made anew");
    }
    SkySources sources(table, orders, true, sizes);
    files->keep(kName, key, written(sources.tables()));
    return sources;
}

}  // namespace ribalta
