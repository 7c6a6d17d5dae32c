// What a primitive's vertices hang on: JOINTS_n and WEIGHTS_n, any number of them, into Scene's
// form.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "base/report.h"
#include "gltf/import.h"
#include "scene/mesh.h"

namespace ribalta::gltf {

/// JOINTS_n and WEIGHTS_n of one n, as the file has them.
struct JointSet {
    std::vector<glm::vec4> joints;
    std::vector<glm::vec4> weights;
};

/// The sets of a primitive, n from 0 on, up to the first that lacks one or both. Reports those.
/// Throws Error(kBadInput) as accessors do. `place` is the primitive's.
std::vector<JointSet> readJointSets(const Import& import, const tinygltf::Primitive& source,
                                    const Place& place, Report& report);

/// Fills the primitive's influences, those that count alone: weights are brought to a sum of 1.
/// `joints` is how many the skins have that draw it. Reports what is mended: joints out of range,
/// weights that are not numbers, negative or without a sum, which leaves a vertex with the first
/// joint it names.
void setInfluences(const std::vector<JointSet>& sets, std::size_t joints, const Place& place,
                   Primitive& primitive, Report& report);

}  // namespace ribalta::gltf
