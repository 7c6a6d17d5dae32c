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

// A product with a displacement still fits single precision.
constexpr float kLargestWeight = 1e6F;
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
           : path == "weights"   ? std::optional(Part::kWeights)
                                 : std::nullopt;
}

// Values, or rows of weights, of one key.
std::size_t keyLength(Interpolation interpolation) {
    return interpolation == Interpolation::kCubicSpline ? 3 : 1;
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
    const std::size_t step = keyLength(sampler.interpolation);
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
        for (std::size_t i = 0; i < scene.deformers.size(); ++i) {
            if (!scene.deformers[i].restWeights.empty()) {
                deformers_.emplace(list.gltfNodes[std::size_t(scene.deformers[i].node)], int(i));
            }
        }
    }

    void readAll();

  private:
    // What a sampler's numbers mean: how they are read.
    struct Values {
        Part part = Part::kTranslation;  ///< kTranslation stands for kScale too
        std::size_t targets = 0;         ///< of kWeights
        auto operator<=>(const Values&) const = default;
    };

    struct Source {
        const json& text;
        const Where& where;
        std::map<std::pair<std::size_t, Values>, int> samplers;  ///< by index and meaning
        std::set<std::pair<int, Part>> moved;
    };

    void readChannel(Source& source, std::size_t index, Animation& animation);
    std::optional<std::size_t> nodeOf(const json& target, const Where& where);
    int moverOf(std::size_t node, const Where& where);
    int deformerOf(std::size_t node, const Where& where);
    int samplerOf(Source& source, std::size_t index, Values values, Animation& animation);
    AnimationSampler readSampler(const json& source, const Values& values);
    void readWeights(std::size_t output, std::size_t targets, AnimationSampler& sampler);
    void checkAccessors(const json& source, const Values& values);
    void hintAtRivals();

    const Import& import_;
    const NodeList& list_;
    Scene& scene_;
    Report& report_;
    std::map<std::size_t, std::size_t> sceneNodes_;  ///< by the glTF's index
    std::map<std::size_t, int> deformers_;           ///< with morph targets, by the glTF's index
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
        ignored_.add(path == "pointer" ? "is animated by KHR_animation_pointer; not played"
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
    if (!node) {
        return;
    }
    const int mover =
        *part == Part::kWeights ? deformerOf(*node, targetWhere) : moverOf(*node, targetWhere);
    if (mover < 0) {
        return;
    }
    if (source.moved.contains({mover, *part})) {
        ignored_.add(
            "is moved by an earlier channel of the animation already; this one is left out",
            targetWhere);
        return;
    }
    const std::size_t targets =
        *part == Part::kWeights ? scene_.deformers[std::size_t(mover)].restWeights.size() : 0;
    const int sampler = samplerOf(source, samplerIndex, {*part, targets}, animation);
    if (sampler >= 0) {
        source.moved.insert({mover, *part});
        animation.channels.push_back({mover, sampler, *part});
    }
}

// Into Scene::deformers: the one whose weights the node of the glTF has.
int Reader::deformerOf(std::size_t node, const Where& where) {
    const auto found = deformers_.find(list_.gltfNodes[node]);
    if (found == deformers_.end()) {
        ignored_.add("is a node without morph targets; the channel is left out",
                     Where(where, "node"));
        return -1;
    }
    return found->second;
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
int Reader::samplerOf(Source& source, std::size_t index, Values values, Animation& animation) {
    values.part = values.part == Part::kScale ? Part::kTranslation : values.part;
    const auto [known, isNew] = source.samplers.try_emplace({index, values}, -1);
    if (isNew) {
        try {
            animation.samplers.push_back(readSampler(source.text["samplers"][index], values));
            known->second = int(animation.samplers.size()) - 1;
        } catch (const Error& error) {
            report_.ignored(error.place(), reasonOf(error) + kLeftOut);
        }
    }
    return known->second;
}

AnimationSampler Reader::readSampler(const json& source, const Values& values) {
    checkAccessors(source, values);
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
    const bool isRotation = values.part == Part::kRotation;
    if (values.part == Part::kWeights) {
        readWeights(output, values.targets, sampler);
    } else if (isRotation) {
        sampler.values = readVec4(import_, output);
    } else {
        for (const glm::vec3& value : readVec3(import_, output)) {
            sampler.values.emplace_back(value, 0.0F);
        }
    }
    checkValues(sampler, isRotation, accessors.at(output));
    return sampler;
}

// Rows of as many weights as there are targets: of longer ones the first, shorter ones are filled
// up with 0. Throws Error(kBadInput).
void Reader::readWeights(std::size_t output, std::size_t targets, AnimationSampler& sampler) {
    const std::vector<float> read = readScalars(import_, output);
    const Place place = import_.file.at("accessors").at(output);
    const auto wrong = std::find_if(read.begin(), read.end(), [](float weight) {
        return !(std::abs(weight) <= kLargestWeight);
    });
    if (wrong != read.end()) {
        badInput(place, "is not finite, or over " + json(kLargestWeight).dump() + ", at element " +
                            std::to_string(wrong - read.begin()));
    }
    const std::size_t rows = sampler.seconds.size() * keyLength(sampler.interpolation);
    const std::size_t inRow = read.size() / rows;
    if (inRow != targets) {
        report_.repaired(place.at("count"), "gives each key " + counted(inRow, "weights") +
                                                " for " + counted(targets, "morph targets") +
                                                (inRow < targets ? "; 0 is used for the others"
                                                                 : "; the others are left out"));
    }
    sampler.targets = targets;
    sampler.weights.resize(rows * targets, 0.0F);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t t = 0; t < std::min(inRow, targets); ++t) {
            sampler.weights[row * targets + t] = read[row * inRow + t];
        }
    }
}

// Throws Error(kBadInput) where types or counts do not fit, before memory is taken.
void Reader::checkAccessors(const json& source, const Values& use) {
    const bool isRotation = use.part == Part::kRotation;
    const bool isWeights = use.part == Part::kWeights;
    const auto input = source["input"].get<std::size_t>();
    const auto output = source["output"].get<std::size_t>();
    const tinygltf::Accessor& times = import_.model.accessors[input];
    const tinygltf::Accessor& values = import_.model.accessors[output];
    const Place accessors = import_.file.at("accessors");
    if (times.type != TINYGLTF_TYPE_SCALAR ||
        times.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        badInput(accessors.at(input), "does not hold float scalars, as the times of keys do");
    }
    if (values.type != (isRotation  ? TINYGLTF_TYPE_VEC4
                        : isWeights ? TINYGLTF_TYPE_SCALAR
                                    : TINYGLTF_TYPE_VEC3)) {
        badInput(accessors.at(output).at("type"),
                 std::string("is not ") + (isRotation  ? "VEC4, as rotations are"
                                           : isWeights ? "SCALAR, as weights are"
                                                       : "VEC3, as translations and scales are"));
    }
    if (values.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT &&
        (!values.normalized || values.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)) {
        badInput(accessors.at(output),
                 "holds neither floats nor normalized integers of 8 or 16 "
                 "bits, as the values of keys are");
    }
    const std::size_t each = keyLength(interpolationOf(source));
    if (isWeights &&
        (values.count / each < times.count || values.count % (each * times.count) != 0)) {
        badInput(accessors.at(output).at("count"),
                 "is " + std::to_string(values.count) + ", expected " +
                     std::to_string(each * use.targets) + " for each of the " +
                     counted(times.count, "keys") + " in accessor " + std::to_string(input));
    }
    if (!isWeights && (values.count / each != times.count || values.count % each != 0)) {
        badInput(accessors.at(output).at("count"),
                 "is " + std::to_string(values.count) + ", expected " +
                     (each == 3 ? "three for each of the " : "one for each of the ") +
                     counted(times.count, "keys") + " in accessor " + std::to_string(input));
    }
    // Of weights what is kept counts too, which may be more than is read; no product overflows
    // where what is read is in bounds.
    const bool isOver = values.count > valuesLeft_;
    const std::size_t kept = isWeights && !isOver
                                 ? std::max(values.count, each * times.count * use.targets)
                                 : values.count;
    if (kept > valuesLeft_) {
        badInput(accessors.at(output), "has " + counted(kept, "elements") + "; at most " +
                                           std::to_string(kMaxAnimationValues) +
                                           " are read, of all animations together");
    }
    valuesLeft_ -= kept;
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
