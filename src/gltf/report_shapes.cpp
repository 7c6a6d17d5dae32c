#include "gltf/report_shapes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// The nodes' forest, for questions that do not walk it: there may be as many skins as nodes.
class Forest {
  public:
    explicit Forest(const std::vector<FileNode>& nodes)
        : enter_(nodes.size(), 0), leave_(nodes.size(), 0), root_(nodes.size(), 0) {
        const std::vector<int> parents = parentsOf(nodes);
        for (std::size_t i = 0; i < parents.size(); ++i) {
            if (parents[i] < 0) {
                walk(nodes, i);
            }
        }
    }

    std::size_t rootOf(std::size_t node) const { return root_[node]; }
    bool isBelowOrSame(std::size_t node, std::size_t above) const {
        return enter_[above] <= enter_[node] && leave_[node] <= leave_[above];
    }

  private:
    void walk(const std::vector<FileNode>& nodes, std::size_t root) {
        std::vector<std::pair<std::size_t, std::size_t>> path = {{root, 0}};
        root_[root] = root;
        enter_[root] = ++time_;
        while (!path.empty()) {
            const std::size_t node = path.back().first;
            if (path.back().second == nodes[node].children.size()) {
                leave_[node] = ++time_;
                path.pop_back();
                continue;
            }
            const auto child = std::size_t(nodes[node].children[path.back().second++]);
            root_[child] = root;
            enter_[child] = ++time_;
            path.emplace_back(child, 0);
        }
    }

    std::vector<std::size_t> enter_;
    std::vector<std::size_t> leave_;
    std::vector<std::size_t> root_;
    std::size_t time_ = 0;
};

void tallyJoints(const json& skin, const Where& where, const Forest& forest, Tally& tally) {
    std::set<std::size_t> seen;
    bool isAgain = false;
    bool isApart = false;
    const auto first = skin["joints"].front().get<std::size_t>();
    for (const json& joint : skin["joints"]) {
        const auto node = joint.get<std::size_t>();
        isAgain = !seen.insert(node).second || isAgain;
        isApart = isApart || forest.rootOf(node) != forest.rootOf(first);
    }
    if (isAgain) {
        tally.add("lists a joint again", Where(where, "joints"));
    }
    if (isApart) {
        tally.add("has joints without a common root", Where(where, "joints"));
    }
    const json& skeleton = member(skin, "skeleton");
    if (!skeleton.is_null() && std::any_of(seen.begin(), seen.end(), [&](std::size_t joint) {
            return !forest.isBelowOrSame(joint, skeleton.get<std::size_t>());
        })) {
        tally.add("is no node above all joints", Where(where, "skeleton"));
    }
}

void tallyBindMatrices(const Import& import, const json& skin, const Where& where, Tally& tally) {
    const json& index = member(skin, "inverseBindMatrices");
    if (index.is_null()) {
        return;
    }
    const tinygltf::Accessor& accessor = import.model.accessors[index.get<std::size_t>()];
    const Where here(where, "inverseBindMatrices");
    if (accessor.type != TINYGLTF_TYPE_MAT4 ||
        accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
        tally.add("is an accessor of other things than MAT4 of floats", here);
    } else if (accessor.count < skin["joints"].size()) {
        tally.add("has fewer matrices than there are joints", here);
    }
}

void tallyTargets(const Import& import, std::size_t mesh, const Where& where, Tally& tally) {
    const json& primitives = element(import.json, "meshes", mesh)["primitives"];
    const Where list(where, "primitives");
    const std::size_t weights = member(element(import.json, "meshes", mesh), "weights").size();
    for (std::size_t p = 0; p < primitives.size(); ++p) {
        const Where here(list, p);
        const json& targets = member(primitives[p], "targets");
        if (targets.size() != member(primitives[0], "targets").size()) {
            tally.add("has another number of morph targets than the mesh's first primitive", here);
        }
        if (weights != 0 && weights != targets.size()) {
            tally.add("has another number of morph targets than its mesh has weights", here);
        }
        const json& attributes = primitives[p]["attributes"];
        if (targets.empty() || !attributes.contains("POSITION")) {
            continue;
        }
        const std::size_t vertices =
            import.model.accessors[attributes["POSITION"].get<std::size_t>()].count;
        const Where targetsWhere(here, "targets");
        for (std::size_t t = 0; t < targets.size(); ++t) {
            const Where target(targetsWhere, t);
            for (const auto& [name, index] : targets[t].items()) {
                const Where place(target, name);
                if (import.model.accessors[index.get<std::size_t>()].count != vertices) {
                    tally.add("has another number of elements than its primitive has vertices",
                              place);
                }
                if (!attributes.contains(name)) {
                    tally.add("displaces what its primitive lacks", place);
                }
            }
        }
    }
}

}  // namespace

void reportShapes(const Import& import, Report& report) {
    Tally tally;
    const Where root(import.file);
    const json& skins = member(import.json, "skins");
    const Where skinsWhere(root, "skins");
    const std::optional<Forest> forest =
        skins.empty() ? std::nullopt : std::optional<Forest>(import.nodes);
    for (std::size_t s = 0; s < skins.size(); ++s) {
        if (!skins[s].is_null()) {
            const Where here(skinsWhere, s);
            tallyJoints(skins[s], here, *forest, tally);
            tallyBindMatrices(import, skins[s], here, tally);
        }
    }
    const Where meshes(root, "meshes");
    for (std::size_t m = 0; m < import.model.meshes.size(); ++m) {
        tallyTargets(import, m, Where(meshes, m), tally);
    }
    tally.tell(Report::Kind::kHint, "", report);
}

}  // namespace ribalta::gltf
