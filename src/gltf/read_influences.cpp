#include "gltf/read_influences.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gltf/read_accessor.h"

namespace ribalta::gltf {
namespace {

// Weights in eight bits are off by a few steps of rounding.
constexpr double kSumTolerance = 0.02;

// How often something was mended.
struct Mended {
    std::size_t outOfRange = 0;
    std::size_t notPositive = 0;
    std::size_t withoutSum = 0;
    std::size_t otherSum = 0;
};

class Builder {
  public:
    Builder(const std::vector<const JointSet*>& sets, std::size_t joints)
        : sets_(sets), joints_(joints) {}

    // The influences of one vertex, the strongest first, none of weight 0; until the next call.
    const std::vector<Influence>& influencesOf(std::size_t vertex) {
        std::vector<Influence>& found = found_;
        found.clear();
        double sum = 0.0;
        for (const JointSet* set : sets_) {
            for (int i = 0; i < 4; ++i) {
                add(set->joints[vertex][i], set->weights[vertex][i], found, sum);
            }
        }
        if (found.empty()) {
            ++mended_.withoutSum;
            const double first(sets_.front()->joints[vertex][0]);
            found.push_back({isInRange(first) ? std::uint32_t(first) : 0, 1.0F});
            return found;
        }
        mended_.otherSum += std::abs(sum - 1.0) > kSumTolerance ? 1 : 0;
        for (Influence& influence : found) {
            influence.weight = float(double(influence.weight) / sum);
        }
        std::stable_sort(found.begin(), found.end(), [](const Influence& a, const Influence& b) {
            return a.weight > b.weight;
        });
        return found;
    }

    const Mended& mended() const { return mended_; }

  private:
    bool isInRange(double joint) const { return joint >= 0.0 && joint < double(joints_); }

    void add(float joint, float weight, std::vector<Influence>& found, double& sum) {
        if (weight == 0.0F) {
            return;  // whatever its joint
        }
        if (!std::isfinite(weight) || weight < 0.0F) {
            ++mended_.notPositive;
        } else if (!isInRange(double(joint))) {
            ++mended_.outOfRange;
        } else {
            found.push_back({std::uint32_t(joint), weight});
            sum += double(weight);
        }
    }

    const std::vector<const JointSet*>& sets_;
    std::size_t joints_;
    std::vector<Influence> found_;
    Mended mended_;
};

void tellMended(const Mended& mended, std::size_t joints, const Place& attributes, Report& report) {
    const auto tell = [&](std::size_t count, const char* attribute, const std::string& what) {
        if (count > 0) {
            report.repaired(attributes.at(attribute), std::to_string(count) + what);
        }
    };
    tell(mended.outOfRange, "JOINTS_0",
         " joints are beyond the " + std::to_string(joints) + " of the skin; they are left out");
    tell(mended.notPositive, "WEIGHTS_0", " weights are negative or no numbers; 0 is used");
    tell(mended.otherSum, "WEIGHTS_0",
         " vertices have weights that do not add up to 1; they are brought to that");
    tell(mended.withoutSum, "WEIGHTS_0",
         " vertices have no weights above 0; they follow the first joint they name");
}

}  // namespace

std::vector<JointSet> readJointSets(const Import& import, const tinygltf::Primitive& source,
                                    const Place& place, Report& report) {
    std::vector<JointSet> sets;
    for (std::size_t n = 0;; ++n) {
        const std::string joints = "JOINTS_" + std::to_string(n);
        const std::string weights = "WEIGHTS_" + std::to_string(n);
        const auto foundJoints = source.attributes.find(joints);
        const auto foundWeights = source.attributes.find(weights);
        const auto end = source.attributes.end();
        if (foundJoints == end && foundWeights == end) {
            return sets;
        }
        if (foundJoints == end || foundWeights == end) {
            report.ignored(
                place.at("attributes").at(foundJoints == end ? weights : joints),
                "has no " + (foundJoints == end ? joints : weights) + " beside it; it is left out");
            return sets;
        }
        JointSet& set = sets.emplace_back();
        set.joints = readVec4(import, std::size_t(foundJoints->second));
        set.weights = readVec4(import, std::size_t(foundWeights->second));
    }
}

void setInfluences(const std::vector<JointSet>& sets, std::size_t joints, const Place& place,
                   Primitive& primitive, Report& report) {
    const std::size_t vertices = primitive.positions.size();
    std::vector<const JointSet*> fitting;
    for (std::size_t n = 0; n < sets.size(); ++n) {
        if (sets[n].joints.size() == vertices && sets[n].weights.size() == vertices) {
            fitting.push_back(&sets[n]);
            continue;
        }
        report.repaired(place.at("attributes").at("JOINTS_" + std::to_string(n)),
                        "has with its weights " + std::to_string(sets[n].joints.size()) + " and " +
                            std::to_string(sets[n].weights.size()) + " elements for " +
                            std::to_string(vertices) + " vertices; both are left out");
    }
    if (fitting.empty()) {
        // A mesh moves as a whole.
        report.repaired(
            place.at("attributes"),
            "lacks joints and weights for the mesh's skin; all follows the first joint");
        primitive.influencesPerVertex = 1;
        primitive.influences.assign(vertices, {0, 1.0F});
        return;
    }
    Builder builder(fitting, joints);
    std::vector<std::size_t> ends;
    std::vector<Influence> all;
    std::size_t most = 0;
    ends.reserve(vertices);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const std::vector<Influence>& own = builder.influencesOf(vertex);
        all.insert(all.end(), own.begin(), own.end());
        ends.push_back(all.size());
        most = std::max(most, own.size());
    }
    primitive.influencesPerVertex = int(most);
    primitive.influences.assign(vertices * most, {});
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const std::size_t first = vertex == 0 ? 0 : ends[vertex - 1];
        std::copy(all.begin() + std::ptrdiff_t(first), all.begin() + std::ptrdiff_t(ends[vertex]),
                  primitive.influences.begin() + std::ptrdiff_t(vertex * most));
    }
    tellMended(builder.mended(), joints, place.at("attributes"), report);
}

}  // namespace ribalta::gltf
