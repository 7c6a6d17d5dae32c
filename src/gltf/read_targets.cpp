#include "gltf/read_targets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gltf/bad_input.h"
#include "gltf/read_accessor.h"
#include "gltf/read_deformers.h"
#include "gltf/tally.h"
#include "gltf/where.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// Metres. So far does nothing move; weights, up to 1e6, and joints take it on from there, all in
// single precision.
constexpr float kLongest = 1e12F;

class TargetReader {
  public:
    TargetReader(const Import& import, std::size_t vertices,
                 const std::function<bool(std::uint64_t)>& mayTake, Tally& ignored, Tally& repaired)
        : import_(import),
          vertices_(vertices),
          mayTake_(mayTake),
          ignored_(ignored),
          repaired_(repaired) {}

    MorphTarget read(const json& target, const Where& where) {
        MorphTarget result;
        for (const auto& [name, accessor] : target.items()) {
            const Where here(where, name);
            if (name == "POSITION") {
                result.positions = readPart(accessor.get<std::size_t>(), here);
            } else if (name == "NORMAL") {
                result.normals = readPart(accessor.get<std::size_t>(), here);
            } else if (name == "TANGENT") {
                result.tangents = readPart(accessor.get<std::size_t>(), here);
            } else {
                ignored_.add("is not morphed: only POSITION, NORMAL and TANGENT are", here);
            }
        }
        return result;
    }

  private:
    std::vector<glm::vec3> readPart(std::size_t accessor, const Where& where) {
        const std::size_t count = import_.model.accessors[accessor].count;
        if (count != vertices_) {
            ignored_.add("has " + std::to_string(count) + " elements for " +
                             std::to_string(vertices_) + " vertices; it is left out",
                         where);
            return {};
        }
        if (!mayTake_(count)) {
            ignored_.add("is beyond the " + std::to_string(kMaxDisplacements) +
                             " displacements that are read in all; it is left out",
                         where);
            return {};
        }
        std::vector<glm::vec3> values;
        try {
            values = readVec3(import_, accessor);
        } catch (const LimitError&) {
            throw;
        } catch (const Error& error) {
            ignored_.add(reasonOf(error) + " (" + error.place().pointer + "); it is left out",
                         where);
            return {};
        }
        bool isMoved = false;
        bool isBroken = false;
        for (glm::vec3& value : values) {
            for (int axis = 0; axis < 3; ++axis) {
                if (!(std::abs(value[axis]) <= kLongest)) {
                    value[axis] = 0.0F;
                    isBroken = true;
                }
                isMoved = isMoved || value[axis] != 0.0F;
            }
        }
        if (isBroken) {
            repaired_.add("has displacements that are not finite, or out of all bounds; 0 is used",
                          where);
        }
        if (!isMoved) {
            values = {};
        }
        return values;
    }

    const Import& import_;
    std::size_t vertices_;
    const std::function<bool(std::uint64_t)>& mayTake_;
    Tally& ignored_;
    Tally& repaired_;
};

}  // namespace

std::vector<MorphTarget> readTargets(const Import& import, const json& object, std::size_t vertices,
                                     const Place& place,
                                     const std::function<bool(std::uint64_t)>& mayTake,
                                     Report& report) {
    std::vector<MorphTarget> targets;
    Tally ignored;
    Tally repaired;
    TargetReader reader(import, vertices, mayTake, ignored, repaired);
    const Where root(place);
    const Where list(root, "targets");
    const json& sources = member(object, "targets");
    for (std::size_t t = 0; t < sources.size(); ++t) {
        targets.push_back(reader.read(sources[t], Where(list, t)));
    }
    ignored.tell(Report::Kind::kIgnored, "", report);
    repaired.tell(Report::Kind::kRepaired, "", report);
    return targets;
}

}  // namespace ribalta::gltf
