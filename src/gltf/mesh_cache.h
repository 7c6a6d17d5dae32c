// MeshCache: what a file's Draco data decodes to, kept on disk for the next start. Pictures and
// meshopt's data are not kept: they decode as fast as they could be read.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "base/file_cache.h"
#include "gltf/decode_draco.h"

namespace ribalta {

/// Changes whenever the code changes that meshes are decoded by.
const char* dracoRevision();

}  // namespace ribalta

namespace ribalta::gltf {

class MeshCache {
  public:
    /// `files` outlives this, or is null: then nothing is kept. `views`: all the Draco data of the
    /// glTF that will be decoded. What was kept of them is read now.
    MeshCache(const FileCache* files, const std::vector<std::span<const std::byte>>& views);
    /// Waits until all is written.
    ~MeshCache() = default;
    MeshCache(const MeshCache&) = delete;
    MeshCache& operator=(const MeshCache&) = delete;

    /// As decodeDraco, from what was kept where it was. May be called from several threads.
    DracoMesh decode(std::span<const std::byte> bytes, std::span<const DracoRequest> requests,
                     std::size_t expectedFaces, const Budget& budget, const Place& place);
    /// Begins to write what was decoded since, on a thread of its own.
    void keep();

    /// Meshes that did not need to be decoded.
    std::size_t found() const { return found_; }

  private:
    const FileCache* files_;  // null: nothing is kept
    std::string key_;
    std::vector<std::byte> kept_;                                // the file, mesh by mesh
    std::map<std::uint64_t, std::span<const std::byte>> known_;  // of these, by key
    std::atomic<std::size_t> found_ = 0;
    std::mutex mutex_;
    std::vector<std::byte> decoded_;  // to be kept as well
    std::jthread writer_;             // joined before the rest goes
};

}  // namespace ribalta::gltf
