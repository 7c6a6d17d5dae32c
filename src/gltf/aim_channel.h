// What an animation's channel moves: the target that the file names, as the scene knows it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "base/report.h"
#include "gltf/bind_dials.h"
#include "gltf/import.h"
#include "gltf/read_nodes.h"
#include "gltf/read_sampler.h"
#include "gltf/tally.h"
#include "gltf/where.h"
#include "scene/scene.h"

namespace ribalta::gltf {

/// A channel without its sampler, and what its sampler is read as.
struct Aim {
    AnimationChannel channel;  ///< of Part::kDial the mover counts into the dials' sources
    SamplerUse use;
};

class Aimer {
  public:
    /// What it is given must outlive it; the scene gets movers. Its deformers are there already.
    Aimer(const Import& import, const NodeList& list, Scene& scene);

    /// Whether a target's path is any that is played; else that is noted.
    bool knowsPath(const nlohmann::json& target, const Where& where);
    /// Nothing where the target is none that can move, which is noted.
    std::optional<Aim> aim(const nlohmann::json& target, const Where& where);
    /// To be called once when all are aimed: reports what was noted.
    void tell(Report& report) const;
    const std::vector<DialSource>& dialSources() const { return dials_; }

    /// Notes a channel that is left out, and why.
    void leaveOut(const std::string& why, const Where& where) {
        ignored_.add(why + "; the channel is left out", where);
    }

  private:
    std::optional<Aim> aimAtNode(std::size_t gltfNode, AnimationChannel::Part part,
                                 const Where& where);
    std::optional<Aim> aimByPointer(const nlohmann::json& target, const Where& where);
    bool isThere(const PointedAt& at, const Where& where);
    bool isLightThere(const PointedAt& at, const Where& where);
    bool isCameraThere(const PointedAt& at, const Where& where);
    bool isMaterialThere(const PointedAt& at, const Where& where);
    void hintWhereUndefined(const nlohmann::json& object, const char* key, const Where& where);
    std::optional<std::size_t> nodeOf(std::size_t gltfNode, const Where& where);
    int moverOf(std::size_t node, const Where& where);
    int dialOf(const PointedAt& at, const Where& where);

    const Import& import_;
    const NodeList& list_;
    Scene& scene_;
    std::map<std::size_t, std::size_t> sceneNodes_;  ///< by the glTF's index
    std::map<std::size_t, int> deformers_;           ///< with morph targets, by the glTF's index
    std::map<std::size_t, int> movers_;              ///< by node of the scene; -1: has a matrix
    std::vector<DialSource> dials_;
    std::map<std::tuple<PointedAt::Owner, std::size_t, Dial::Numbers>, int> dialIndices_;
    Tally ignored_;
    Tally hints_;
};

}  // namespace ribalta::gltf
