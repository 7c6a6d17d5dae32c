#include "gltf/mesh_cache.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include <draco/core/draco_version.h>

#include "base/content_hash.h"
#include "base/log.h"

namespace ribalta::gltf {
namespace {

using Bytes = std::span<const std::byte>;

const std::string kName = "draco";

// Less is decoded sooner than a file is found.
constexpr std::size_t kWorthwhile = 16384;
// What is collected to be kept is in memory twice.
constexpr std::size_t kMost = 100'000'000;

std::string keyOf(const std::vector<Bytes>& views) {
    ContentHash hash;
    hash.add(std::string_view(dracoRevision()));
    hash.add(std::string_view(draco::kDracoVersion));
    for (const Bytes view : views) {
        hash.add(std::vector<std::uint64_t>{view.size()});
        hash.add(view);
    }
    return hash.text();
}

// Of all that one mesh is decoded from.
std::uint64_t keyOf(Bytes bytes, std::span<const DracoRequest> requests, std::size_t faces) {
    ContentHash hash;
    hash.add(bytes);
    std::vector<std::uint64_t> numbers = {bytes.size(), faces};
    for (const DracoRequest& request : requests) {
        numbers.insert(numbers.end(), {request.id, std::uint64_t(request.components),
                                       std::uint64_t(request.normalized)});
    }
    hash.add(numbers);
    return hash.value();
}

/// Numbers and arrays one behind the other, in the machine's own byte order: they stay on it.
class Writer {
  public:
    void number(std::uint64_t value) { append(std::as_bytes(std::span(&value, 1))); }
    template <typename Value>
    void array(const std::vector<Value>& values) {
        number(values.size());
        append(std::as_bytes(std::span(values)));
    }
    std::vector<std::byte> bytes;

  private:
    void append(Bytes part) { bytes.insert(bytes.end(), part.begin(), part.end()); }
};

class Reader {
  public:
    explicit Reader(Bytes bytes) : left_(bytes) {}

    bool isAtEnd() const { return left_.empty(); }
    bool number(std::uint64_t& value) { return take(std::as_writable_bytes(std::span(&value, 1))); }
    template <typename Value>
    bool array(std::vector<Value>& values) {
        std::uint64_t count = 0;
        if (!number(count) || count > left_.size() / sizeof(Value)) {
            return false;
        }
        values.resize(count);
        return take(std::as_writable_bytes(std::span(values)));
    }
    std::optional<Bytes> part(std::uint64_t size) {
        if (size > left_.size()) {
            return std::nullopt;
        }
        const Bytes part = left_.first(size);
        left_ = left_.subspan(size);
        return part;
    }

  private:
    bool take(std::span<std::byte> place) {
        const std::optional<Bytes> from = part(place.size());
        if (from) {
            std::copy(from->begin(), from->end(), place.begin());
        }
        return from.has_value();
    }

    Bytes left_;
};

std::vector<std::byte> written(const DracoMesh& mesh) {
    Writer writer;
    writer.number(mesh.vertices);
    writer.array(mesh.indices);
    writer.number(mesh.attributes.size());
    for (const DracoAttribute& attribute : mesh.attributes) {
        writer.number(std::uint64_t(attribute.components));
        writer.array(attribute.values);
    }
    return std::move(writer.bytes);
}

// None where it is no mesh with what is asked for.
std::optional<DracoMesh> readMesh(Bytes bytes, std::span<const DracoRequest> requests) {
    Reader reader(bytes);
    DracoMesh mesh;
    std::uint64_t vertices = 0;
    std::uint64_t attributes = 0;
    if (!reader.number(vertices) || !reader.array(mesh.indices) || !reader.number(attributes) ||
        attributes != requests.size()) {
        return std::nullopt;
    }
    mesh.vertices = vertices;
    for (const DracoRequest& request : requests) {
        DracoAttribute& attribute = mesh.attributes.emplace_back();
        std::uint64_t components = 0;
        if (!reader.number(components) || components < std::uint64_t(request.components) ||
            components > 4 || !reader.array(attribute.values) ||
            attribute.values.size() % components != 0 ||
            attribute.values.size() / components != vertices) {
            return std::nullopt;
        }
        attribute.components = int(components);
    }
    const bool isInRange =
        std::all_of(mesh.indices.begin(), mesh.indices.end(),
                    [&](std::uint32_t index) { return std::uint64_t(index) < vertices; });
    return isInRange && reader.isAtEnd() ? std::optional(std::move(mesh)) : std::nullopt;
}

std::uint64_t bytesOf(const DracoMesh& mesh) {
    std::uint64_t bytes = mesh.indices.size() * sizeof(std::uint32_t);
    for (const DracoAttribute& attribute : mesh.attributes) {
        bytes += attribute.values.size() * sizeof(float);
    }
    return bytes;
}

}  // namespace

MeshCache::MeshCache(const FileCache* files, const std::vector<Bytes>& views) : files_(files) {
    std::size_t total = 0;
    for (const Bytes view : views) {
        total += view.size();
    }
    if (files_ == nullptr || total < kWorthwhile) {
        files_ = nullptr;
        return;
    }
    key_ = keyOf(views);
    std::optional<std::vector<std::byte>> kept = files_->find(kName, key_);
    if (!kept) {
        return;
    }
    kept_ = std::move(*kept);
    Reader reader(kept_);
    while (!reader.isAtEnd()) {
        std::uint64_t key = 0;
        std::uint64_t size = 0;
        const std::optional<Bytes> part =
            reader.number(key) && reader.number(size) ? reader.part(size) : std::nullopt;
        if (!part) {
            logVerbose("cache: meshes kept in " + files_->folder().string() +
                       " are incomplete; they are decoded anew");
            known_.clear();
            kept_.clear();
            return;
        }
        known_.emplace(key, *part);
    }
    logVerbose("cache: " + std::to_string(known_.size()) + " decoded meshes kept from before, " +
               files_->folder().string());
}

DracoMesh MeshCache::decode(Bytes bytes, std::span<const DracoRequest> requests,
                            std::size_t expectedFaces, const Budget& budget, const Place& place) {
    if (files_ == nullptr) {
        return decodeDraco(bytes, requests, expectedFaces, budget, place);
    }
    const std::uint64_t key = keyOf(bytes, requests, expectedFaces);
    const auto known = known_.find(key);
    if (known != known_.end()) {
        budget.expectMemory(known->second.size(), place);
        if (std::optional<DracoMesh> mesh = readMesh(known->second, requests)) {
            budget.expectVertices(mesh->indices.size() + mesh->vertices, place);
            ++found_;
            return std::move(*mesh);
        }
    }
    DracoMesh mesh = decodeDraco(bytes, requests, expectedFaces, budget, place);
    const std::scoped_lock lock(mutex_);
    if (decoded_.size() + kept_.size() + bytesOf(mesh) <= kMost) {
        const std::vector<std::byte> content = written(mesh);
        Writer head;
        head.number(key);
        head.number(content.size());
        decoded_.insert(decoded_.end(), head.bytes.begin(), head.bytes.end());
        decoded_.insert(decoded_.end(), content.begin(), content.end());
    }
    return mesh;
}

void MeshCache::keep() {
    if (decoded_.empty()) {
        known_.clear();
        kept_ = {};
        return;
    }
    known_.clear();
    writer_ = std::jthread([this] {
        kept_.insert(kept_.end(), decoded_.begin(), decoded_.end());
        files_->keep(kName, key_, kept_);
        kept_ = {};
        decoded_ = {};
    });
}

}  // namespace ribalta::gltf
