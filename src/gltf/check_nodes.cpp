#include "gltf/check_nodes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gltf/bad_input.h"
#include "gltf/import.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Leaves each node one parent, the first. Returns the parents, -1 for roots.
std::vector<int> settleParents(std::vector<FileNode>& nodes, const Place& place, Report& report) {
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::span<int>& list = nodes[i].children;
        std::size_t kept = 0;
        for (std::size_t c = 0; c < list.size(); ++c) {
            const auto child = std::size_t(list[c]);
            if (parents[child] < 0) {
                parents[child] = int(i);
                list[kept++] = int(child);
                continue;
            }
            report.repaired(place.at(i).at("children").at(c),
                            "node " + std::to_string(child) + " already hangs on node " +
                                std::to_string(parents[child]) + " and stays there only");
        }
        list = list.first(kept);
    }
    return parents;
}

// The topmost ancestor of every node, itself where it is a root. Throws Error(kBadInput) where
// there is none, because nodes hang in a circle.
std::vector<std::size_t> findTops(const std::vector<int>& parents, const Place& place) {
    constexpr std::size_t kUnknown = SIZE_MAX;
    constexpr std::size_t kOnPath = SIZE_MAX - 1;
    std::vector<std::size_t> tops(parents.size(), kUnknown);
    std::vector<std::size_t> path;
    for (std::size_t start = 0; start < parents.size(); ++start) {
        path.clear();
        std::size_t node = start;
        while (tops[node] == kUnknown) {
            tops[node] = kOnPath;
            path.push_back(node);
            if (parents[node] < 0) {
                tops[node] = node;
                break;
            }
            node = std::size_t(parents[node]);
            if (tops[node] == kOnPath) {
                badInput(place.at(node), "contains itself, by way of node " +
                                             std::to_string(path.back()) +
                                             "; remove it from that node's children");
            }
        }
        for (const std::size_t below : path) {
            tops[below] = tops[node];
        }
    }
    return tops;
}

// Leaves in each scene's list true roots only, each once.
void settleRoots(json& scenes, const std::vector<std::size_t>& tops, const Place& place,
                 Report& report) {
    // By top, the scene that listed it last, counted from 1: a list of its own for every scene
    // would take a time of scenes times nodes.
    std::vector<std::size_t> listedBy(tops.size(), 0);
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        const auto roots = scenes[s].find("nodes");
        if (roots == scenes[s].end()) {
            continue;
        }
        auto& list = roots->get_ref<json::array_t&>();
        std::size_t kept = 0;
        for (std::size_t r = 0; r < list.size(); ++r) {
            const auto node = list[r].get<std::size_t>();
            const std::size_t top = tops[node];
            const bool isNew = std::exchange(listedBy[top], s + 1) != s + 1;
            if (top != node) {
                report.repaired(place.at(s).at("nodes").at(r),
                                "is node " + std::to_string(node) +
                                    ", no root; all from its root, node " + std::to_string(top) +
                                    ", is drawn");
            } else if (!isNew) {
                report.repaired(place.at(s).at("nodes").at(r),
                                "lists node " + std::to_string(node) + " again; it is drawn once");
            }
            if (isNew) {
                list[kept++] = top;
            }
        }
        list.resize(kept);
    }
}

}  // namespace

void checkNodes(std::vector<FileNode>& nodes, json& root, const Place& file, Report& report) {
    const std::vector<int> parents = settleParents(nodes, file.at("nodes"), report);
    const std::vector<std::size_t> tops = findTops(parents, file.at("nodes"));
    if (root.contains("scenes")) {
        settleRoots(root["scenes"], tops, file.at("scenes"), report);
    }
}

}  // namespace ribalta::gltf
