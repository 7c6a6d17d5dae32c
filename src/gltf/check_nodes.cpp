#include "gltf/check_nodes.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "gltf/bad_input.h"
#include "gltf/import.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Leaves each node one parent, the first. Returns the parents, -1 for roots.
std::vector<int> settleParents(json& nodes, const Place& place, Report& report) {
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes[i].find("children");
        if (children == nodes[i].end()) {
            continue;
        }
        json kept = json::array();
        for (std::size_t c = 0; c < children->size(); ++c) {
            const auto child = (*children)[c].get<std::size_t>();
            if (parents[child] < 0) {
                parents[child] = int(i);
                kept.push_back(child);
                continue;
            }
            report.repaired(place.at(i).at("children").at(c),
                            "node " + std::to_string(child) + " already hangs on node " +
                                std::to_string(parents[child]) + " and stays there only");
        }
        *children = std::move(kept);
    }
    return parents;
}

// Whoever is reached from no root hangs in a circle.
void checkCycles(const std::vector<int>& parents, const Place& place) {
    constexpr char kUnknown = 0;
    constexpr char kOnPath = 1;
    constexpr char kFine = 2;
    std::vector<char> state(parents.size(), kUnknown);
    std::vector<std::size_t> path;
    for (std::size_t start = 0; start < parents.size(); ++start) {
        path.clear();
        std::size_t node = start;
        while (state[node] == kUnknown) {
            state[node] = kOnPath;
            path.push_back(node);
            if (parents[node] < 0) {
                break;
            }
            node = std::size_t(parents[node]);
            if (state[node] == kOnPath) {
                badInput(place.at(node), "contains itself, by way of node " +
                                             std::to_string(path.back()) +
                                             "; remove it from that node's children");
            }
        }
        for (const std::size_t done : path) {
            state[done] = kFine;
        }
    }
}

void checkRoots(json& scenes, const std::vector<int>& parents, const Place& place, Report& report) {
    for (std::size_t s = 0; s < scenes.size(); ++s) {
        const auto roots = scenes[s].find("nodes");
        if (roots == scenes[s].end()) {
            continue;
        }
        json kept = json::array();
        std::vector<char> seen(parents.size(), 0);
        for (std::size_t r = 0; r < roots->size(); ++r) {
            const auto node = (*roots)[r].get<std::size_t>();
            const Place here = place.at(s).at("nodes").at(r);
            if (std::exchange(seen[node], 1) != 0) {
                report.repaired(here, "node " + std::to_string(node) +
                                          " is listed twice; the second is left out");
                continue;
            }
            if (parents[node] >= 0) {
                report.repaired(here, "node " + std::to_string(node) +
                                          " is listed as a root, but hangs on node " +
                                          std::to_string(parents[node]) +
                                          "; it is drawn with all that is above it");
            }
            kept.push_back(node);
        }
        *roots = std::move(kept);
    }
}

}  // namespace

void checkNodes(json& root, const Place& file, Report& report) {
    if (!root.contains("nodes")) {
        return;
    }
    const std::vector<int> parents = settleParents(root["nodes"], file.at("nodes"), report);
    checkCycles(parents, file.at("nodes"));
    if (root.contains("scenes")) {
        checkRoots(root["scenes"], parents, file.at("scenes"), report);
    }
}

}  // namespace ribalta::gltf
