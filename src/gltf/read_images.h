// Images: which of the file's are needed, each once, and their decoding in parallel.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/report.h"
#include "gltf/import.h"
#include "gltf/same_bytes.h"
#include "image/image.h"

namespace ribalta::gltf {

/// Collects the images that something drawn asks for; those with the same bytes are decoded once.
class ImageTable {
  public:
    explicit ImageTable(const Import& import) : import_(import) {}

    /// Index into the scene's images of an image of the glTF.
    int useImage(std::size_t image);
    /// Index into the scene's images of a file beside the glTF, named at `place`; a plain path,
    /// not a URI, with artists' habits forgiven and reported (find_artists_file).
    int useFile(const std::string& written, const Place& place, Report& report);

    /// Index into the scene's images of one that is made here, which `key` tells from others.
    int useMade(const std::string& key, Image image);
    /// The file beside the glTF that a URI names, artists' habits forgiven and noted (findUri).
    std::filesystem::path find(const std::string& uri, const Place& place);
    /// What was noted of URIs so far, to be told once.
    Report takeNotes() { return std::exchange(notes_, {}); }
    /// Adds a file beside the glTF, which is no image, to files().
    void noteFile(const std::filesystem::path& file);

    /// All that was asked for, with names and without pixels.
    std::vector<Image> undecoded() const;
    /// Reads and decodes all that was asked for, and hands each with its index to `take`, from any
    /// thread. One that is missing or broken becomes the visible stand-in; returns what is to be
    /// reported. Throws LimitError where they are too much.
    Report decode(const std::function<bool(std::size_t, Image)>& take) const;

    /// The files beside the glTF that were asked for and are there.
    const std::set<std::filesystem::path>& files() const { return files_; }

  private:
    // A search lists folders: so many files are searched for that are not where they should be.
    static constexpr int kMostSearches = 200;

    struct Request {
        Place place;
        std::string name;
        int image = -1;    // into the glTF's images, or
        std::string path;  // a path beside the file, or
        std::shared_ptr<const Image> made{};
        std::filesystem::path found{};  // of an image with a URI: the file, where it is there
    };

    /// `source`: where its encoded bytes are, where that is known.
    int use(const std::string& key, Request request, const std::optional<ByteSource>& source);
    Image decodeOne(const Request& request) const;
    /// Within the budget's memory and pixels.
    Image decodeWithin(std::span<const std::byte> encoded, const Place& place) const;

    const Import& import_;
    std::vector<Request> requests_;
    std::set<std::filesystem::path> files_;
    std::map<std::string, int> known_;
    Report notes_;
    int searchesLeft_ = kMostSearches;
    SameBytes same_;
};

}  // namespace ribalta::gltf
