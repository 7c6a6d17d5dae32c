#include "gltf/aim_channel.h"

#include <string>

namespace ribalta::gltf {
namespace {

using nlohmann::json;
using Part = AnimationChannel::Part;
using Numbers = Dial::Numbers;
using Owner = PointedAt::Owner;
using Values = SamplerUse::Values;

constexpr const char* kExtension = "KHR_animation_pointer";

std::optional<Part> partOf(const std::string& path) {
    return path == "translation" ? std::optional(Part::kTranslation)
           : path == "rotation"  ? std::optional(Part::kRotation)
           : path == "scale"     ? std::optional(Part::kScale)
           : path == "weights"   ? std::optional(Part::kWeights)
                                 : std::nullopt;
}

const std::string& pathOf(const json& target) {
    return target["path"].get_ref<const std::string&>();
}

Values valuesOf(Part part) {
    return part == Part::kRotation  ? Values::kRotation
           : part == Part::kWeights ? Values::kWeights
                                    : Values::kVec3;
}

}  // namespace

Aimer::Aimer(const Import& import, const NodeList& list, Scene& scene)
    : import_(import), list_(list), scene_(scene) {
    for (std::size_t i = 0; i < list.gltfNodes.size(); ++i) {
        sceneNodes_.emplace(list.gltfNodes[i], i);
    }
    for (std::size_t i = 0; i < scene.deformers.size(); ++i) {
        if (!scene.deformers[i].restWeights.empty()) {
            deformers_.emplace(list.gltfNodes[std::size_t(scene.deformers[i].node)], int(i));
        }
    }
}

bool Aimer::knowsPath(const json& target, const Where& where) {
    if (pathOf(target) == "pointer" || partOf(pathOf(target))) {
        return true;
    }
    leaveOut("is none of translation, rotation, scale, weights, pointer", Where(where, "path"));
    return false;
}

std::optional<Aim> Aimer::aim(const json& target, const Where& where) {
    if (pathOf(target) == "pointer") {
        return aimByPointer(target, where);
    }
    const json& node = member(target, "node");
    if (node.is_null()) {
        leaveOut("names no node", where);
        return std::nullopt;
    }
    return aimAtNode(node.get<std::size_t>(), *partOf(pathOf(target)), Where(where, "node"));
}

std::optional<Aim> Aimer::aimAtNode(std::size_t gltfNode, Part part, const Where& where) {
    const std::optional<std::size_t> node = nodeOf(gltfNode, where);
    if (!node) {
        return std::nullopt;
    }
    Aim aim;
    aim.channel.part = part;
    aim.use.values = valuesOf(part);
    if (part != Part::kWeights) {
        aim.channel.mover = moverOf(*node, where);
        return aim.channel.mover < 0 ? std::nullopt : std::optional(aim);
    }
    const auto deformer = deformers_.find(gltfNode);
    if (deformer == deformers_.end()) {
        leaveOut("is a node without morph targets", where);
        return std::nullopt;
    }
    aim.channel.mover = deformer->second;
    aim.use.targets = scene_.deformers[std::size_t(deformer->second)].restWeights.size();
    return aim;
}

std::optional<Aim> Aimer::aimByPointer(const json& target, const Where& where) {
    const Where extensions(where, "extensions");
    const Where own(extensions, kExtension);
    const Where here(own, "pointer");
    const json& pointer = member(extension(target, kExtension), "pointer");
    if (!pointer.is_string()) {
        leaveOut(std::string("is a pointer, but the target has none in extensions/") + kExtension,
                 Where(where, "path"));
        return std::nullopt;
    }
    const auto& text = pointer.get_ref<const std::string&>();
    const std::optional<PointedAt> at = parsePointer(text);
    if (!at) {
        leaveOut("is \"" + withoutIndices(text) + "\", " +
                     (text.starts_with('/') ? "which is not animated here"
                                            : "no JSON pointer, which starts with /"),
                 here);
        return std::nullopt;
    }
    if (!member(target, "node").is_null()) {
        hints_.add("is named beside a pointer, which is followed instead", Where(where, "node"));
    }
    if (!isThere(*at, here)) {
        return std::nullopt;
    }
    std::optional<Aim> aim;
    if (at->part != Part::kDial) {
        aim = aimAtNode(at->index, at->part, here);
    } else if (const int dial = dialOf(*at, here); dial >= 0) {
        aim.emplace();
        aim->channel = {dial, -1, Part::kDial, at->first, at->count};
        aim->use.values = at->values;
    }
    if (aim) {
        aim->use.plainIntegers = true;
    }
    return aim;
}

// Whether the document has what is pointed at, of the kind that has the property.
bool Aimer::isThere(const PointedAt& at, const Where& where) {
    const auto isBelow = [&](const json& list, const char* things) {
        if (at.index >= list.size()) {
            leaveOut("names one of " + counted(list.size(), things) + ", which is not there",
                     where);
        }
        return at.index < list.size();
    };
    switch (at.owner) {
        case Owner::kNode:
            return isBelow(member(import_.json, "nodes"), "nodes");
        case Owner::kLight:
            return isBelow(member(extension(import_.json, kLightsPunctual), "lights"), "lights") &&
                   isLightThere(at, where);
        case Owner::kCamera:
            return isBelow(member(import_.json, "cameras"), "cameras") && isCameraThere(at, where);
        case Owner::kMaterial:
            break;
    }
    return isBelow(member(import_.json, "materials"), "materials") && isMaterialThere(at, where);
}

bool Aimer::isLightThere(const PointedAt& at, const Where& where) {
    const json& light = member(extension(import_.json, kLightsPunctual), "lights")[at.index];
    if (light.is_null()) {
        leaveOut("is of a light that cannot be read", where);
        return false;
    }
    if (at.numbers == Numbers::kCone && light["type"] != "spot") {
        leaveOut("is of a light that is no spot and has no cone", where);
        return false;
    }
    if (at.numbers == Numbers::kRange && light["type"] == "directional") {
        leaveOut("is of a directional light, which has no range", where);
        return false;
    }
    if (at.numbers == Numbers::kRange) {
        hintWhereUndefined(light, "range", where);
    }
    return true;
}

bool Aimer::isCameraThere(const PointedAt& at, const Where& where) {
    const json& camera = element(import_.json, "cameras", at.index);
    const bool isOfBox = at.numbers == Numbers::kExtent || at.numbers == Numbers::kBoxDepth;
    if (isOfBox != (camera["type"] == "orthographic")) {
        leaveOut("is of a camera that is " + camera["type"].get<std::string>(), where);
        return false;
    }
    if (at.numbers == Numbers::kAspect) {
        hintWhereUndefined(member(camera, "perspective"), "aspectRatio", where);
    } else if (at.numbers == Numbers::kDepth && at.first == 1) {
        hintWhereUndefined(member(camera, "perspective"), "zfar", where);
    }
    return true;
}

bool Aimer::isMaterialThere(const PointedAt& at, const Where& where) {
    const json& material = element(import_.json, "materials", at.index);
    if (at.numbers == Numbers::kBaseColor &&
        !extension(material, "KHR_materials_pbrSpecularGlossiness").is_null()) {
        leaveOut("is of a material that is drawn by KHR_materials_pbrSpecularGlossiness instead",
                 where);
        return false;
    }
    return true;
}

void Aimer::hintWhereUndefined(const json& object, const char* key, const Where& where) {
    if (member(object, key).is_null()) {
        hints_.add(std::string("names \"") + key +
                       "\", which has no default and is not in the file; it is played all the same",
                   where);
    }
}

std::optional<std::size_t> Aimer::nodeOf(std::size_t gltfNode, const Where& where) {
    const auto found = sceneNodes_.find(gltfNode);
    if (found == sceneNodes_.end()) {
        leaveOut("is a node of another scene than the one that is drawn", where);
        return std::nullopt;
    }
    return found->second;
}

int Aimer::moverOf(std::size_t node, const Where& where) {
    const auto [known, isNew] = movers_.try_emplace(node, -1);
    if (isNew) {
        if (const std::optional<Pose> rest = restPoseOf(import_, list_, node)) {
            known->second = int(scene_.movers.size());
            scene_.movers.push_back({int(node), *rest, *rest});
        }
    }
    if (known->second < 0) {
        leaveOut(
            "is a node with a matrix, or with a transform out of bounds, which glTF 2.0 does not "
            "let move",
            where);
    }
    return known->second;
}

// Into dialSources(); -1 where it is of a node that is not drawn.
int Aimer::dialOf(const PointedAt& at, const Where& where) {
    std::optional<std::size_t> index = at.index;
    if (at.owner == Owner::kNode) {
        index = nodeOf(at.index, where);
        if (!index) {
            return -1;
        }
    }
    const auto [known, isNew] =
        dialIndices_.try_emplace({at.owner, *index, at.numbers}, int(dials_.size()));
    if (isNew) {
        dials_.push_back({at.owner, *index, at.numbers, where.place()});
    }
    return known->second;
}

void Aimer::tell(Report& report) const {
    ignored_.tell(Report::Kind::kIgnored, "", report);
    hints_.tell(Report::Kind::kHint, "", report);
}

}  // namespace ribalta::gltf
