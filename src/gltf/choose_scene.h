// Which of a file's scenes is drawn, and with which root nodes. Nodes are read elsewhere.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"

namespace ribalta::gltf {

struct ChosenScene {
    std::vector<std::string> allNames;  ///< of the file's scenes, in its order; may be empty
    int index = -1;                     ///< of the chosen one; -1: the file has none
    std::vector<std::size_t> roots;     ///< the glTF's indices of nodes
};

/// The scene of that name, else of that index; where nothing is asked for the file's default, else
/// its first one, else one of all nodes without a parent. Reports that there are others, unless one
/// was asked for. Throws Error(kUsage) that lists the scenes where there is no such one.
ChosenScene chooseScene(const Import& import, const std::optional<std::string>& nameOrIndex,
                        Report& report);

}  // namespace ribalta::gltf
