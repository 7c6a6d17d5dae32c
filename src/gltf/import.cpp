#include "gltf/import.h"

#include "gltf/mesh_cache.h"

namespace ribalta::gltf {

Import::Import() = default;
Import::~Import() = default;

const nlohmann::json& member(const nlohmann::json& object, std::string_view key) {
    static const nlohmann::json kNull;
    if (!object.is_object()) {
        return kNull;
    }
    const auto found = object.find(key);
    return found == object.end() ? kNull : *found;
}

double numberOr(const nlohmann::json& object, std::string_view key, double otherwise) {
    const nlohmann::json& value = member(object, key);
    return value.is_number() ? value.get<double>() : otherwise;
}

const nlohmann::json& element(const nlohmann::json& json, std::string_view array,
                              std::size_t index) {
    return member(json, array).at(index);
}

const nlohmann::json& extension(const nlohmann::json& object, std::string_view name) {
    return member(member(object, "extensions"), name);
}

}  // namespace ribalta::gltf
