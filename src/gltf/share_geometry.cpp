#include "gltf/share_geometry.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <span>
#include <utility>

#include "base/content_hash.h"

namespace ribalta::gltf {
namespace {

// A file made for it could else have many that look alike compared to their ends, each with each.
constexpr std::size_t kMostAlike = 16;

// Of few elements from all over the array: unequal ones mostly differ there.
template <typename Value>
void addSample(const std::vector<Value>& values, ContentHash& hash) {
    constexpr std::size_t kSamples = 16;
    const std::size_t step = values.size() / kSamples + 1;
    for (std::size_t i = 0; i < values.size(); i += step) {
        hash.add(std::as_bytes(std::span(&values[i], 1)));
    }
}

template <typename Value>
bool areEqual(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

bool haveEqualVertices(const Primitive& a, const Primitive& b) {
    return a.targets.empty() && b.targets.empty() && areEqual(a.positions, b.positions) &&
           areEqual(a.normals, b.normals) && areEqual(a.tangents, b.tangents) &&
           areEqual(a.uv0, b.uv0) && areEqual(a.uv1, b.uv1) && areEqual(a.colors, b.colors) &&
           a.influencesPerVertex == b.influencesPerVertex && areEqual(a.influences, b.influences);
}

bool haveEqualIndices(const Primitive& a, const Primitive& b) {
    return areEqual(a.indices, b.indices);
}

// Numbers one of a primitive's two parts where there is an equal one.
class Sharing {
  public:
    Sharing(int Primitive::*number, bool (*areAlike)(const Primitive&, const Primitive&))
        : number_(number), areAlike_(areAlike) {}

    void add(Primitive& primitive, std::uint64_t size, std::uint64_t sample) {
        std::vector<Primitive*>& seen = seen_[{size, sample}];
        const auto like = std::find_if(seen.begin(), seen.end(), [&](const Primitive* known) {
            return areAlike_(*known, primitive);
        });
        if (like == seen.end()) {
            if (seen.size() < kMostAlike) {
                seen.push_back(&primitive);
            }
            return;
        }
        int& number = (*like)->*number_;
        number = number < 0 ? next_++ : number;
        primitive.*number_ = number;
    }

  private:
    int Primitive::*number_;
    bool (*areAlike_)(const Primitive&, const Primitive&);
    int next_ = 0;
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::vector<Primitive*>> seen_;
};

}  // namespace

void shareGeometry(std::vector<Mesh>& meshes) {
    Sharing vertices(&Primitive::sharedVertices, haveEqualVertices);
    Sharing indices(&Primitive::sharedIndices, haveEqualIndices);
    for (Mesh& mesh : meshes) {
        for (Primitive& primitive : mesh.primitives) {
            ContentHash sample;
            addSample(primitive.positions, sample);
            addSample(primitive.normals, sample);
            addSample(primitive.uv0, sample);
            vertices.add(primitive, primitive.positions.size(), sample.value());
            ContentHash indexSample;
            addSample(primitive.indices, indexSample);
            indices.add(primitive, primitive.indices.size(), indexSample.value());
        }
    }
}

}  // namespace ribalta::gltf
