#include "gltf/read_texture_slot.h"

#include <cmath>
#include <string>

namespace ribalta::gltf {
namespace {

using nlohmann::json;

bool readPair(const json& object, const char* key, glm::vec2& pair, const Place& place,
              Report& report) {
    const json& value = member(object, key);
    if (value.is_null()) {
        return true;
    }
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) {
        report.repaired(place.at(key), "is no pair of numbers; the default is used");
        return false;
    }
    pair = {value[0].get<float>(), value[1].get<float>()};
    return true;
}

// KHR_texture_transform: translation * rotation * scale.
glm::mat3 readTransform(const json& slot, const Place& slotPlace, Report& report) {
    const json& transform = extension(slot, "KHR_texture_transform");
    const Place place = slotPlace.at("extensions").at("KHR_texture_transform");
    glm::vec2 offset(0.0F);
    glm::vec2 scale(1.0F);
    readPair(transform, "offset", offset, place, report);
    readPair(transform, "scale", scale, place, report);
    const double rotation = numberOr(transform, "rotation", 0.0);
    const auto c = float(std::cos(rotation));
    const auto s = float(std::sin(rotation));
    const glm::mat3 result(glm::vec3(c * scale.x, -s * scale.x, 0.0F),
                           glm::vec3(s * scale.y, c * scale.y, 0.0F), glm::vec3(offset, 1.0F));
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (!std::isfinite(result[column][row])) {
                report.repaired(place, "is not finite; the texture is drawn unmoved");
                return glm::mat3(1.0F);
            }
        }
    }
    return result;
}

}  // namespace

int uvSetOf(const json& slot) {
    const json& moved = member(extension(slot, "KHR_texture_transform"), "texCoord");
    const json& plain = member(slot, "texCoord");
    const json& chosen = moved.is_number_integer() ? moved : plain;
    return chosen.is_number_integer() ? chosen.get<int>() : 0;
}

std::optional<TextureSlot> readTextureSlot(const json& holder, const char* key,
                                           const Place& holderPlace, TextureTable& textures,
                                           Report& report) {
    const json& source = member(holder, key);
    if (source.is_null()) {
        return std::nullopt;
    }
    const Place place = holderPlace.at(key);
    TextureSlot slot;
    slot.uvSet = uvSetOf(source);
    if (slot.uvSet < 0 || slot.uvSet >= kUvSets) {
        report.ignored(place, "uses TEXCOORD_" + std::to_string(slot.uvSet) +
                                  ", only 0 and 1 are read; the texture is not drawn");
        return std::nullopt;
    }
    slot.texture = textures.use(source["index"].get<std::size_t>());
    if (slot.texture < 0) {
        report.ignored(place, "uses texture " + source["index"].dump() + ", " +
                                  textures.faultOf(source["index"].get<std::size_t>()) +
                                  "; it is not drawn");
        return std::nullopt;
    }
    slot.textureFromUv = readTransform(source, place, report);
    return slot;
}

}  // namespace ribalta::gltf
