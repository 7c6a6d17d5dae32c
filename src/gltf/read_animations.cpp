#include "gltf/read_animations.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gltf/bad_input.h"
#include "gltf/check_motion.h"
#include "gltf/read_accessor.h"
#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;
using Part = AnimationChannel::Part;
using Interpolation = AnimationSampler::Interpolation;

constexpr const char* kLeftOut = "; the channels that use this are left out";

Interpolation interpolationOf(const json& sampler) {
    const json& name = member(sampler, "interpolation");
    return name == "STEP"          ? Interpolation::kStep
           : name == "CUBICSPLINE" ? Interpolation::kCubicSpline
                                   : Interpolation::kLinear;
}

std::optional<Part> partOf(const std::string& path) {
    return path == "translation" ? std::optional(Part::kTranslation)
           : path == "rotation"  ? std::optional(Part::kRotation)
           : path == "scale"     ? std::optional(Part::kScale)
                                 : std::nullopt;
}

// Throws Error(kBadInput) where the keys are in no order.
void checkSeconds(const std::vector<float>& seconds, const Place& place) {
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        if (!std::isfinite(seconds[i])) {
            badInput(place, "has a time that is not finite at key " + std::to_string(i));
        }
        if (i > 0 && !(seconds[i] > seconds[i - 1])) {
            badInput(place, "has times that do not increase at key " + std::to_string(i) + ", " +
                                json(seconds[i]).dump() + " s after " +
                                json(seconds[i - 1]).dump() + " s");
        }
    }
}

// Throws Error(kBadInput) where there is no value, or a rotation that turns nothing.
void checkValues(const AnimationSampler& sampler, bool isRotation, const Place& place) {
    const std::size_t step = sampler.interpolation == Interpolation::kCubicSpline ? 3 : 1;
    for (std::size_t i = 0; i < sampler.values.size(); ++i) {
        const glm::dvec4 value(sampler.values[i]);
        const double length = glm::length(value);
        if (!std::isfinite(length)) {
            badInput(place, "is not finite at element " + std::to_string(i));
        }
        if (isRotation && i % step == step / 2 && !(length > 1e-6)) {
            badInput(place, "is no rotation at element " + std::to_string(i));
        }
    }
}

class Reader {
  public:
    Reader(const Import& import, const NodeList& list, Scene& scene, Report& report)
        : import_(import), list_(list), scene_(scene), report_(report) {
        for (std::size_t i = 0; i < list.gltfNodes.size(); ++i) {
            sceneNodes_.emplace(list.gltfNodes[i], i);
        }
    }

    void readAll();

  private:
    struct Source {
        const json& text;
        const Where& where;
        std::map<std::pair<std::size_t, bool>, int> samplers;  ///< by index and being rotations
        std::set<std::pair<int, Part>> moved;
    };

    void readChannel(Source& source, std::size_t index, Animation& animation);
    std::optional<std::size_t> nodeOf(const json& target, const Where& where);
    int moverOf(std::size_t node, const Where& where);
    int samplerOf(Source& source, std::size_t index, bool isRotation, Animation& animation);
    AnimationSampler readSampler(const json& source, bool isRotation);
    void checkAccessors(const json& source, bool isRotation);
    void hintAtRivals();

    const Import& import_;
    const NodeList& list_;
    Scene& scene_;
    Report& report_;
    std::map<std::size_t, std::size_t> sceneNodes_;  ///< by the glTF's index
    std::map<std::size_t, int> movers_;              ///< by node of the scene; -1: has a matrix
    std::size_t valuesLeft_ = kMaxAnimationValues;
    Tally ignored_;
    Tally hints_;
};

void Reader::readAll() {
    const json& animations = member(import_.json, "animations");
    const Where root(import_.file);
    const Where where(root, "animations");
    for (std::size_t i = 0; i < animations.size(); ++i) {
        const json& animation = animations[i];
        const json& name = member(animation, "name");
        Animation& read = scene_.animations.emplace_back();
        read.name = name.is_string() ? name.get<std::string>() : "";
        const Where here(where, i);
        Source source{animation, here, {}, {}};
        const std::size_t count = member(animation, "channels").size();
        for (std::size_t c = 0; c < count; ++c) {
            readChannel(source, c, read);
        }
    }
    ignored_.tell(Report::Kind::kIgnored, "", report_);
    hints_.tell(Report::Kind::kHint, "", report_);
    hintAtRivals();
    if (const std::optional<std::size_t> node = movesOutOfBounds(scene_, list_.nodes)) {
        report_.ignored(where.place(),
                        "may take node " + std::to_string(list_.gltfNodes[*node]) +
                            " out of all bounds, together with its parents; nothing is played");
        for (Animation& animation : scene_.animations) {
            animation.channels.clear();
        }
        scene_.movers.clear();
    }
}

void Reader::readChannel(Source& source, std::size_t index, Animation& animation) {
    const json& channel = source.text["channels"][index];
    if (channel.is_null()) {
        return;  // told already
    }
    const Where channels(source.where, "channels");
    const Where here(channels, index);
    const Where targetWhere(here, "target");
    const json& target = channel["target"];
    const auto& path = target["path"].get_ref<const std::string&>();
    const std::optional<Part> part = partOf(path);
    if (!part) {
        ignored_.add(path == "weights"   ? "weights of morph targets are not played"
                     : path == "pointer" ? "is animated by KHR_animation_pointer; not played"
                                         : "is none of translation, rotation, scale, weights; "
                                           "the channel is left out",
                     Where(targetWhere, "path"));
        return;
    }
    const auto samplerIndex = channel["sampler"].get<std::size_t>();
    const json& samplers = source.text["samplers"];
    if (samplerIndex >= samplers.size()) {
        report_.ignored(Where(here, "sampler").place(),
                        "is " + std::to_string(samplerIndex) + ", but the animation has " +
                            counted(samplers.size(), "samplers") + "; the channel is left out");
        return;
    }
    if (samplers[samplerIndex].is_null()) {
        return;  // told already
    }
    const std::optional<std::size_t> node = nodeOf(target, targetWhere);
    const int mover = node ? moverOf(*node, targetWhere) : -1;
    if (mover < 0) {
        return;
    }
    if (source.moved.contains({mover, *part})) {
        ignored_.add(
            "is moved by an earlier channel of the animation already; this one is left out",
            targetWhere);
        return;
    }
    const int sampler = samplerOf(source, samplerIndex, *part == Part::kRotation, animation);
    if (sampler >= 0) {
        source.moved.insert({mover, *part});
        animation.channels.push_back({mover, sampler, *part});
    }
}

std::optional<std::size_t> Reader::nodeOf(const json& target, const Where& where) {
    const json& node = member(target, "node");
    if (node.is_null()) {
        ignored_.add("names no node; the channel is left out", where);
        return std::nullopt;
    }
    const auto found = sceneNodes_.find(node.get<std::size_t>());
    if (found == sceneNodes_.end()) {
        ignored_.add(
            "is a node of another scene than the one that is drawn; the channel is left out",
            Where(where, "node"));
        return std::nullopt;
    }
    return found->second;
}

int Reader::moverOf(std::size_t node, const Where& where) {
    const auto [known, isNew] = movers_.try_emplace(node, -1);
    if (isNew) {
        if (const std::optional<Pose> rest = restPoseOf(import_, list_, node)) {
            known->second = int(scene_.movers.size());
            scene_.movers.push_back({int(node), *rest, *rest});
        }
    }
    if (known->second < 0) {
        ignored_.add(
            "is a node with a matrix, or with a transform out of bounds, which glTF 2.0 does not "
            "let move; the channel is left out",
            Where(where, "node"));
    }
    return known->second;
}

// Into Animation::samplers; -1 where it cannot be used, which is told once.
int Reader::samplerOf(Source& source, std::size_t index, bool isRotation, Animation& animation) {
    const auto [known, isNew] = source.samplers.try_emplace({index, isRotation}, -1);
    if (isNew) {
        try {
            animation.samplers.push_back(readSampler(source.text["samplers"][index], isRotation));
            known->second = int(animation.samplers.size()) - 1;
        } catch (const Error& error) {
            report_.ignored(error.place(), reasonOf(error) + kLeftOut);
        }
    }
    return known->second;
}

AnimationSampler Reader::readSampler(const json& source, bool isRotation) {
    checkAccessors(source, isRotation);
    const auto input = source["input"].get<std::size_t>();
    const auto output = source["output"].get<std::size_t>();
    const Place accessors = import_.file.at("accessors");
    AnimationSampler sampler;
    sampler.interpolation = interpolationOf(source);
    sampler.seconds = readScalars(import_, input);
    checkSeconds(sampler.seconds, accessors.at(input));
    if (sampler.seconds.front() < 0.0F) {
        const Where root(import_.file);
        const Where list(root, "accessors");
        hints_.add("has times below 0, which are not reached", Where(list, input));
    }
    if (isRotation) {
        sampler.values = readVec4(import_, output);
    } else {
        for (const glm::vec3& value : readVec3(import_, output)) {
            sampler.values.emplace_back(value, 0.0F);
        }
    }
    checkValues(sampler, isRotation, accessors.at(output));
    return sampler;
}

// Throws Error(kBadInput) where types or counts do not fit, before memory is taken.
void Reader::checkAccessors(const json& source, bool isRotation) {
    const auto input = source["input"].get<std::size_t>();
    const auto output = source["output"].get<std::size_t>();
    const tinygltf::Accessor& times = import_.model.accessors[input];
    const tinygltf::Accessor& values = import_.model.accessors[output];
    const Place accessors = import_.file.at("accessors");
    if (times.type != TINYGLTF_TYPE_SCALAR ||
        times.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        badInput(accessors.at(input), "does not hold float scalars, as the times of keys do");
    }
    if (values.type != (isRotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3)) {
        badInput(accessors.at(output).at("type"),
                 std::string("is not ") + (isRotation ? "VEC4, as rotations are"
                                                      : "VEC3, as translations and scales are"));
    }
    if (values.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT &&
        (!values.normalized || values.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
        badInput(accessors.at(output),
                 "holds neither floats nor normalized integers of 8 or 16 "
                 "bits, as the values of keys are");
    }
    const std::size_t each = interpolationOf(source) == Interpolation::kCubicSpline ? 3 : 1;
    if (values.count / each != times.count || values.count % each != 0) {
        badInput(accessors.at(output).at("count"),
                 "is " + std::to_string(values.count) + ", expected " +
                     (each == 3 ? "three for each of the " : "one for each of the ") +
                     counted(times.count, "keys") + " in accessor " + std::to_string(input));
    }
    if (values.count > valuesLeft_) {
        badInput(accessors.at(output), "has " + counted(values.count, "elements") + "; at most " +
                                           std::to_string(kMaxAnimationValues) +
                                           " are read, of all animations together");
    }
    valuesLeft_ -= values.count;
    const Where root(import_.file);
    const Where list(root, "accessors");
    for (const std::size_t accessor : {input, output}) {
        const int view = import_.model.accessors[accessor].bufferView;
        if (view >= 0 && import_.model.bufferViews[std::size_t(view)].byteStride != 0) {
            hints_.add("is in a buffer view with a byteStride, which glTF 2.0 keeps for vertices",
                       Where(list, accessor));
        }
    }
}

// Takes, runs, jumps of one figure are not meant to be seen together.
void Reader::hintAtRivals() {
    std::map<std::pair<int, Part>, std::size_t> first;
    for (std::size_t i = 0; i < scene_.animations.size(); ++i) {
        for (const AnimationChannel& channel : scene_.animations[i].channels) {
            const auto [known, isNew] = first.try_emplace({channel.mover, channel.part}, i);
            if (!isNew && known->second != i) {
                report_.hint(import_.file.at("animations").at(i),
                             "moves what animation " + std::to_string(known->second) +
                                 " moves; played together the earlier is seen, choose one with "
                                 "--animation");
                return;
            }
        }
    }
}

}  // namespace

void readAnimations(const Import& import, const NodeList& list, Scene& scene, Report& report) {
    if (member(import.json, "animations").empty()) {
        return;
    }
    Reader(import, list, scene, report).readAll();
}

}  // namespace ribalta::gltf
