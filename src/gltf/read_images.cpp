#include "gltf/read_images.h"

#include <atomic>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "base/parallel_for.h"
#include "base/progress.h"
#include "base/read_file.h"
#include "gltf/bad_input.h"
#include "gltf/find_artists_file.h"
#include "gltf/read_buffers.h"
#include "gltf/read_uri.h"
#include "image/claimed_size.h"
#include "image/image_format.h"
#include "image/read_image.h"

namespace ribalta::gltf {
namespace {

using nlohmann::json;

// A file is the same file whatever name it is called by; empty where there is none.
std::string identityOf(const std::filesystem::path& path) {
    std::error_code failed;
    const auto canonical = std::filesystem::canonical(path, failed);
    return failed ? std::string() : canonical.string();
}

}  // namespace

int ImageTable::use(const std::string& key, Request request,
                    const std::optional<ByteSource>& source) {
    const int next = int(requests_.size());
    const auto [entry, isNew] = known_.emplace(key, next);
    if (isNew) {
        entry->second = source ? same_.firstLike(*source, next) : next;
        if (entry->second == next) {
            requests_.push_back(std::move(request));
        }
    }
    return entry->second;
}

int ImageTable::useImage(std::size_t image) {
    const json& source = element(import_.json, "images", image);
    const Place place = import_.file.at("images").at(image);
    const json& uri = member(source, "uri");
    const json& name = member(source, "name");
    Request request{place, name.is_string() ? name.get<std::string>() : std::string(), int(image),
                    ""};
    std::string key = "image " + std::to_string(image);
    std::optional<ByteSource> bytes;
    if (uri.is_string() && !isDataUri(uri.get_ref<const std::string&>())) {
        const auto& text = uri.get_ref<const std::string&>();
        if (request.name.empty()) {
            request.name = text;
        }
        try {
            std::filesystem::path found = find(text, place.at("uri"));
            const std::string file = identityOf(found);
            if (!file.empty()) {
                key = file;
                files_.insert(file);
                bytes = std::filesystem::path(file);
                request.found = std::move(found);
            }
        } catch (const Error&) {
            // Found again, and reported, when it is decoded.
        }
    }
    if (uri.is_string() && isDataUri(uri.get_ref<const std::string&>())) {
        bytes = std::as_bytes(std::span(uri.get_ref<const std::string&>()));
    }
    const json& view = member(source, "bufferView");
    if (!uri.is_string() && view.is_number_integer()) {
        key = "bufferView " + view.dump();
        try {
            // Of packed views, too, those stay: no more reads are expected.
            bytes = std::span<const std::byte>(viewBytes(import_, view.get<std::size_t>()));
        } catch (const LimitError&) {
            throw;
        } catch (const Error&) {
            // As above.
        }
    }
    if (request.name.empty()) {
        request.name = "image_" + std::to_string(image);
    }
    return use(key, std::move(request), bytes);
}

int ImageTable::useFile(const std::string& written, const Place& place, Report& report) {
    const std::optional<FoundFile> found =
        findArtistsFile(written, import_.folder, import_.allowOutside, place);
    const std::string& path = found ? found->path : written;
    std::string key = "path " + path;
    std::optional<ByteSource> bytes;
    if (found) {
        tellOfFound(written, *found, place, report);
        const std::string file =
            identityOf(resolvePath(path, import_.folder, place, import_.allowOutside));
        if (!file.empty()) {
            key = file;
            files_.insert(file);
            bytes = std::filesystem::path(file);
        }
    }
    return use(key, {place, path, -1, path}, bytes);
}

int ImageTable::useMade(const std::string& key, Image image) {
    Request request{import_.file, image.name, -1, ""};
    request.made = std::make_shared<const Image>(std::move(image));
    return use("made " + key, std::move(request), std::nullopt);
}

void ImageTable::noteFile(const std::filesystem::path& file) {
    const std::string identity = identityOf(file);
    if (!identity.empty()) {
        files_.insert(identity);
    }
}

std::filesystem::path ImageTable::find(const std::string& uri, const Place& place) {
    if (searchesLeft_ == 0) {
        return resolveUri(uri, import_.folder, place, import_.allowOutside);
    }
    const std::size_t before = notes_.entries().size();
    std::filesystem::path found;
    try {
        found = findUri(uri, import_.folder, import_.allowOutside, place, notes_);
    } catch (const Error&) {
        --searchesLeft_;
        throw;
    }
    std::error_code failed;
    const bool isThere = std::filesystem::exists(found, failed);
    searchesLeft_ -= !isThere || notes_.entries().size() > before ? 1 : 0;
    return found;
}

Image ImageTable::decodeWithin(std::span<const std::byte> encoded, const Place& place) const {
    const LoadLimits& limits = import_.budget->limits();
    ImageLimits imageLimits;
    imageLimits.maxPixels = limits.pixels;
    const std::optional<ClaimedSize> claimed = claimedSize(encoded, imageFormat(encoded));
    if (claimed && sizeFault(claimed->width, claimed->height, imageLimits).empty()) {
        import_.budget->takeMemory(std::uint64_t(claimed->width) * std::uint64_t(claimed->height) *
                                       std::uint64_t(claimed->bytesPerPixel),
                                   place);
    }
    return decodeImage(encoded, place, imageLimits);
}

Image ImageTable::decodeOne(const Request& request) const {
    const auto decodeFile = [&](const std::filesystem::path& path, const Place& place) {
        try {
            return decodeWithin(readFile(path, import_.budget->memoryLeft()), place);
        } catch (const LimitError&) {
            throw;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::kBadInput) {
                throw;
            }
            // The picture's own path says more than where it is named; both are in the report.
            badInput(place, error.place().file == place.file
                                ? "\"" + request.name + "\": " + reasonOf(error)
                                : std::string(error.what()));
        }
    };
    if (request.made) {
        return *request.made;
    }
    if (request.image < 0) {
        return decodeFile(
            resolvePath(request.path, import_.folder, request.place, import_.allowOutside),
            request.place);
    }
    const json& source = element(import_.json, "images", std::size_t(request.image));
    const json& uri = member(source, "uri");
    const json& view = member(source, "bufferView");
    if (uri.is_string()) {
        const Place place = request.place.at("uri");
        const auto& text = uri.get_ref<const std::string&>();
        if (isDataUri(text)) {
            return decodeWithin(decodeDataUri(text, place), request.place);
        }
        return decodeFile(request.found.empty()
                              ? resolveUri(text, import_.folder, place, import_.allowOutside)
                              : request.found,
                          place);
    }
    if (view.is_null()) {
        badInput(request.place, "has neither uri nor bufferView; export the file again");
    }
    return decodeWithin(viewBytes(import_, view.get<std::size_t>()), request.place);
}

std::vector<Image> ImageTable::undecoded() const {
    std::vector<Image> images(requests_.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        images[i].name = requests_[i].name;
    }
    return images;
}

Report ImageTable::decode(const std::function<bool(std::size_t, Image)>& take) const {
    std::vector<std::optional<Error>> faults(requests_.size());
    Progress progress("decoding images", requests_.size());
    std::atomic<bool> moreAreWanted = true;
    parallelFor(requests_.size(), [&](std::size_t i) {
        if (!moreAreWanted) {
            return;
        }
        Image image;
        try {
            image = decodeOne(requests_[i]);
            image.name = requests_[i].name;
        } catch (const LimitError&) {
            throw;
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::kBadInput) {
                throw;  // no fault of the picture's: the reader of pictures is missing
            }
            faults[i] = error;
            image = makeStandInImage(requests_[i].name);
        }
        if (!take(i, std::move(image))) {
            moreAreWanted = false;
        }
        progress.step();
    });
    Report report;
    for (const std::optional<Error>& fault : faults) {
        if (fault) {
            report.repaired(fault->place(),
                            reasonOf(*fault) + "; a checkerboard is drawn in its place");
        }
    }
    return report;
}

}  // namespace ribalta::gltf
