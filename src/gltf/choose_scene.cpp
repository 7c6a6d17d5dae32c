#include "gltf/choose_scene.h"

#include "gltf/find_named.h"

namespace ribalta::gltf {
namespace {

std::vector<std::size_t> nodesWithoutParent(const std::vector<FileNode>& nodes) {
    const std::vector<int> parents = parentsOf(nodes);
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i] < 0) {
            roots.push_back(i);
        }
    }
    return roots;
}

}  // namespace

ChosenScene chooseScene(const Import& import, const std::optional<std::string>& nameOrIndex,
                        Report& report) {
    const tinygltf::Model& model = import.model;
    ChosenScene chosen;
    for (const tinygltf::Scene& scene : model.scenes) {
        chosen.allNames.push_back(scene.name);
    }
    const nlohmann::json& fileChoice = member(import.json, "scene");
    std::size_t index = 0;
    if (nameOrIndex) {
        index = findNamed(chosen.allNames, *nameOrIndex, "scene",
                          "it has none at all, ask for none to draw all of its nodes", import.file);
    } else if (model.scenes.empty()) {
        chosen.roots = nodesWithoutParent(import.nodes);
        return chosen;
    } else if (!fileChoice.is_null()) {
        index = fileChoice.get<std::size_t>();
    }
    chosen.index = int(index);
    chosen.roots.assign(model.scenes[index].nodes.begin(), model.scenes[index].nodes.end());
    if (model.scenes.size() > 1 && !nameOrIndex) {
        report.ignored(import.file.at("scenes"), "has " + std::to_string(model.scenes.size()) +
                                                     " scenes; scene " + std::to_string(index) +
                                                     " is drawn, another one by its name or index");
    }
    return chosen;
}

}  // namespace ribalta::gltf
