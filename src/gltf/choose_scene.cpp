#include "gltf/choose_scene.h"

#include <algorithm>
#include <charconv>

namespace ribalta::gltf {
namespace {

std::optional<std::size_t> numberIn(const std::string& text) {
    std::size_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

std::size_t find(const std::vector<std::string>& names, const std::string& nameOrIndex,
                 const Place& file) {
    const auto named = std::find(names.begin(), names.end(), nameOrIndex);
    if (named != names.end()) {
        return std::size_t(named - names.begin());
    }
    const std::optional<std::size_t> number = numberIn(nameOrIndex);
    if (number && *number < names.size()) {
        return *number;
    }
    constexpr std::size_t kListed = 20;
    std::string there;
    for (std::size_t i = 0; i < std::min(names.size(), kListed); ++i) {
        there += (i == 0 ? "" : ", ") + std::to_string(i) + " " + names[i];
    }
    if (names.size() > kListed) {
        there += " and " + std::to_string(names.size() - kListed) + " more";
    }
    throw Error(ErrorKind::kUsage, file,
                "has no scene '" + nameOrIndex + "'; " +
                    (there.empty() ? "it has none at all, ask for none to draw all of its nodes"
                                   : "there are: " + there));
}

std::vector<std::size_t> nodesWithoutParent(const tinygltf::Model& model) {
    std::vector<char> hasParent(model.nodes.size(), 0);
    for (const tinygltf::Node& node : model.nodes) {
        for (const int child : node.children) {
            hasParent[std::size_t(child)] = 1;
        }
    }
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < hasParent.size(); ++i) {
        if (hasParent[i] == 0) {
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
        index = find(chosen.allNames, *nameOrIndex, import.file);
    } else if (model.scenes.empty()) {
        chosen.roots = nodesWithoutParent(model);
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
