#include "gltf/read_sampler.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "gltf/bad_input.h"
#include "gltf/read_accessor.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;
using Interpolation = AnimationSampler::Interpolation;
using Values = SamplerUse::Values;

// A product with a displacement still fits single precision.
constexpr float kLargestWeight = 1e6F;

Interpolation interpolationOf(const json& sampler) {
    const json& name = member(sampler, "interpolation");
    return name == "STEP"          ? Interpolation::kStep
           : name == "CUBICSPLINE" ? Interpolation::kCubicSpline
                                   : Interpolation::kLinear;
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

std::vector<glm::vec4> readValues(const Import& import, std::size_t output, Values values) {
    std::vector<glm::vec4> result;
    switch (values) {
        case Values::kVec3:
            for (const glm::vec3& value : readVec3(import, output)) {
                result.emplace_back(value, 0.0F);
            }
            break;
        case Values::kRotation:
        case Values::kVec4:
            result = readVec4(import, output);
            break;
        case Values::kNumber:
        case Values::kSwitch:
            for (const float value : readScalars(import, output)) {
                result.emplace_back(value, 0.0F, 0.0F, 0.0F);
            }
            break;
        case Values::kWeights:
            break;  // in rows
    }
    return result;
}

// What the accessor of the values must be, and in words.
struct OutputType {
    int type;
    const char* words;
};

OutputType outputType(Values values) {
    switch (values) {
        case Values::kVec3:
            return {TINYGLTF_TYPE_VEC3, "VEC3, as translations, scales and colours are"};
        case Values::kRotation:
            return {TINYGLTF_TYPE_VEC4, "VEC4, as rotations are"};
        case Values::kVec4:
            return {TINYGLTF_TYPE_VEC4, "VEC4, as colours with alpha are"};
        case Values::kWeights:
            return {TINYGLTF_TYPE_SCALAR, "SCALAR, as weights are"};
        case Values::kNumber:
        case Values::kSwitch:
            break;
    }
    return {TINYGLTF_TYPE_SCALAR, "SCALAR, as single numbers are"};
}

}  // namespace

AnimationSampler SamplerReader::read(const json& source, const SamplerUse& use,
                                     const Place& place) {
    checkAccessors(source, use);
    takeValues(source, use);
    hintAtAccessors(source);
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
    if (use.values == Values::kWeights) {
        readWeights(output, use.targets, sampler);
    } else {
        sampler.values = readValues(import_, output, use.values);
    }
    checkValues(sampler, use.values == Values::kRotation, accessors.at(output));
    if (use.values == Values::kSwitch) {
        settleSwitch(output, sampler, place);
    }
    return sampler;
}

// On or off, and nothing between. Throws Error(kBadInput) of what has tangents.
void SamplerReader::settleSwitch(std::size_t output, AnimationSampler& sampler,
                                 const Place& place) {
    if (sampler.interpolation == Interpolation::kCubicSpline) {
        badInput(place.at("interpolation"), "is CUBICSPLINE, expected STEP for what is on or off");
    }
    if (sampler.interpolation == Interpolation::kLinear) {
        report_.repaired(place.at("interpolation"),
                         "is LINEAR, expected STEP for what is on or off, which is played");
        sampler.interpolation = Interpolation::kStep;
    }
    const tinygltf::Accessor& accessor = import_.model.accessors[output];
    if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) {
        const Where root(import_.file);
        const Where list(root, "accessors");
        hints_.add("holds no unsigned bytes, as what is on or off asks; what is not 0 is on",
                   Where(list, output));
    }
}

// Rows of as many weights as there are targets: of longer ones the first, shorter ones are filled
// up with 0. Throws Error(kBadInput).
void SamplerReader::readWeights(std::size_t output, std::size_t targets,
                                AnimationSampler& sampler) {
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

// Throws Error(kBadInput) where types or counts do not fit.
void SamplerReader::checkAccessors(const json& source, const SamplerUse& use) {
    const bool isWeights = use.values == Values::kWeights;
    const auto input = source["input"].get<std::size_t>();
    const auto output = source["output"].get<std::size_t>();
    const tinygltf::Accessor& times = import_.model.accessors[input];
    const tinygltf::Accessor& values = import_.model.accessors[output];
    const Place accessors = import_.file.at("accessors");
    if (times.type != TINYGLTF_TYPE_SCALAR ||
        times.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        badInput(accessors.at(input), "does not hold float scalars, as the times of keys do");
    }
    const OutputType expected = outputType(use.values);
    if (values.type != expected.type) {
        badInput(accessors.at(output).at("type"), std::string("is not ") + expected.words);
    }
    if (!use.plainIntegers && values.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT &&
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
}

// Of weights what is kept counts too, which may be more than is read; no product overflows where
// what is read is in bounds. Throws Error(kBadInput) where it is too much.
void SamplerReader::takeValues(const json& source, const SamplerUse& use) {
    const auto output = source["output"].get<std::size_t>();
    const std::size_t read = import_.model.accessors[output].count;
    const std::size_t keys = import_.model.accessors[source["input"].get<std::size_t>()].count;
    const bool isOver = read > valuesLeft_;
    const std::size_t kept =
        use.values == Values::kWeights && !isOver
            ? std::max(read, keyLength(interpolationOf(source)) * keys * use.targets)
            : read;
    if (kept > valuesLeft_) {
        badInput(import_.file.at("accessors").at(output),
                 "has " + counted(kept, "elements") + "; at most " +
                     std::to_string(kMaxAnimationValues) + " are read, of all animations together");
    }
    valuesLeft_ -= kept;
}

void SamplerReader::hintAtAccessors(const json& source) {
    const Where root(import_.file);
    const Where list(root, "accessors");
    for (const char* end : {"input", "output"}) {
        const auto accessor = source[end].get<std::size_t>();
        const int view = import_.model.accessors[accessor].bufferView;
        if (view >= 0 && import_.model.bufferViews[std::size_t(view)].byteStride != 0) {
            hints_.add("is in a buffer view with a byteStride, which glTF 2.0 keeps for vertices",
                       Where(list, accessor));
        }
    }
}

}  // namespace ribalta::gltf
