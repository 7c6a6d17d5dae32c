#include "gltf/read_layers.h"

#include <string>

#include "gltf/import.h"
#include "gltf/read_texture_slot.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// One extension of a material, and the way to what it holds. Everything is checked already.
class Layer {
  public:
    Layer(const json& material, const Place& place, const char* name, TextureTable& textures,
          Report& report)
        : object_(extension(material, name)),
          place_(place.at("extensions").at(name)),
          textures_(textures),
          report_(report) {}

    bool isThere() const { return !object_.is_null(); }
    Place place() const { return place_; }
    const json& at(const char* key) const { return member(object_, key); }

    void number(const char* key, float& value) const {
        const json& given = at(key);
        if (given.is_number()) {
            value = given.get<float>();
        }
    }
    template <int N>
    void color(const char* key, glm::vec<N, float>& value) const {
        const json& given = at(key);
        for (int c = 0; given.is_array() && c < N; ++c) {
            value[c] = given[std::size_t(c)].get<float>();
        }
    }
    void texture(const char* key, std::optional<TextureSlot>& slot) const {
        slot = readTextureSlot(object_, key, place_, textures_, report_);
    }

  private:
    const json& object_;
    Place place_;
    TextureTable& textures_;
    Report& report_;
};

void readSpecularGlossiness(const Layer& layer, Material& material, MaterialLayers& layers) {
    // All of it is a dielectric's surface whose reflectance straight on is the specular colour.
    material.baseColor = glm::vec4(1.0F);
    layer.color("diffuseFactor", material.baseColor);
    layer.texture("diffuseTexture", material.baseColorTexture);
    float glossiness = 1.0F;
    layer.number("glossinessFactor", glossiness);
    material.metallic = 0.0F;
    material.roughness = 1.0F - glossiness;
    material.metallicRoughnessTexture.reset();
    layers.ior = 0.0F;
    layer.color("specularFactor", layers.specularColor);
    layer.texture("specularGlossinessTexture", layers.specularColorTexture);
    layers.glossinessInSpecular = layers.specularColorTexture.has_value();
}

void readIorAndSpecular(const Layer& ior, const Layer& specular, MaterialLayers& layers,
                        Report& report) {
    ior.number("ior", layers.ior);
    if (layers.ior > 0.0F && layers.ior < 1.0F) {
        report.repaired(ior.place().at("ior"),
                        "is " + ior.at("ior").dump() + ", expected 0 or at least 1; 1 is used");
        layers.ior = 1.0F;
    }
    specular.number("specularFactor", layers.specular);
    specular.color("specularColorFactor", layers.specularColor);
    specular.texture("specularTexture", layers.specularTexture);
    specular.texture("specularColorTexture", layers.specularColorTexture);
}

void readCoat(const Layer& coat, MaterialLayers& layers) {
    coat.number("clearcoatFactor", layers.clearcoat);
    coat.number("clearcoatRoughnessFactor", layers.clearcoatRoughness);
    coat.texture("clearcoatTexture", layers.clearcoatTexture);
    coat.texture("clearcoatRoughnessTexture", layers.clearcoatRoughnessTexture);
    coat.texture("clearcoatNormalTexture", layers.clearcoatNormalTexture);
    const json& scale = member(coat.at("clearcoatNormalTexture"), "scale");
    if (scale.is_number()) {
        layers.clearcoatNormalScale = scale.get<float>();
    }
}

bool changesNothing(const MaterialLayers& layers) {
    const MaterialLayers plain;
    return layers.ior == plain.ior && layers.specular == plain.specular &&
           layers.specularColor == plain.specularColor && !layers.specularTexture &&
           !layers.specularColorTexture && layers.clearcoat == 0.0F &&
           layers.sheenColor == plain.sheenColor && layers.anisotropy == 0.0F &&
           layers.transmission == 0.0F;
}

}  // namespace

void readLayers(const json& object, const Place& place, TextureTable& textures, Material& material,
                Report& report) {
    const auto layer = [&](const char* name) {
        return Layer(object, place, name, textures, report);
    };
    MaterialLayers layers;
    const Layer glossiness = layer("KHR_materials_pbrSpecularGlossiness");
    if (glossiness.isThere()) {
        readSpecularGlossiness(glossiness, material, layers);
    }
    if (material.unlit) {
        return;
    }
    if (!glossiness.isThere()) {
        readIorAndSpecular(layer("KHR_materials_ior"), layer("KHR_materials_specular"), layers,
                           report);
    }
    readCoat(layer("KHR_materials_clearcoat"), layers);
    const Layer sheen = layer("KHR_materials_sheen");
    sheen.color("sheenColorFactor", layers.sheenColor);
    sheen.number("sheenRoughnessFactor", layers.sheenRoughness);
    sheen.texture("sheenColorTexture", layers.sheenColorTexture);
    sheen.texture("sheenRoughnessTexture", layers.sheenRoughnessTexture);
    const Layer anisotropy = layer("KHR_materials_anisotropy");
    anisotropy.number("anisotropyStrength", layers.anisotropy);
    anisotropy.number("anisotropyRotation", layers.anisotropyRotation);
    anisotropy.texture("anisotropyTexture", layers.anisotropyTexture);
    const Layer transmission = layer("KHR_materials_transmission");
    transmission.number("transmissionFactor", layers.transmission);
    transmission.texture("transmissionTexture", layers.transmissionTexture);
    if (layers.transmission > 0.0F &&
        (material.roughness > 0.0F || !extension(object, "KHR_materials_volume").is_null())) {
        report.ignored(transmission.place(),
                       "is drawn as a thin clear wall: what is behind it is tinted, and neither "
                       "blurred by its roughness nor bent by its volume");
    }
    if (!changesNothing(layers)) {
        material.layers = layers;
    }
}

}  // namespace ribalta::gltf
