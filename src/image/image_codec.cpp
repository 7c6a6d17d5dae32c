#include "image/image_codec.h"

#include <filesystem>
#include <memory>
#include <system_error>

#include <dlfcn.h>

#include "base/error.h"

namespace ribalta {
namespace {

// An installed module lies in a folder whose way from the executable is known when it is built.
std::filesystem::path findModule() {
    const std::filesystem::path name = RIBALTA_IMAGE_MODULE;
    std::error_code error;
    const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    for (const auto& candidate : {folder / name, folder / RIBALTA_IMAGE_MODULE_FROM_BIN / name,
                                  RIBALTA_IMAGE_MODULE_FOLDER / name}) {
        if (std::filesystem::exists(candidate, error)) {
            return candidate;
        }
    }
    throw Error(ErrorKind::kJobFailed, {name.string(), ""},
                "the image module is neither beside the program (" + folder.string() + ") nor in " +
                    RIBALTA_IMAGE_MODULE_FOLDER + "; install ribalta again");
}

const ImageCodec* openModule() {
    const std::filesystem::path path = findModule();
    // Never closed: OpenImageIO keeps threads and tables to the end of the process.
    void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
        throw Error(ErrorKind::kJobFailed, {path.string(), ""},
                    std::string("the image module cannot be opened: ") + dlerror() +
                        "; install libopenimageio2.4");
    }
    using Door = const ImageCodec* (*)();
    const auto door = reinterpret_cast<Door>(dlsym(module, kImageCodecSymbol));
    if (door == nullptr) {
        throw Error(ErrorKind::kJobFailed, {path.string(), ""},
                    "is not the image module; install ribalta again");
    }
    return door();
}

}  // namespace

const ImageCodec& imageCodec() {
    static const ImageCodec* const codec = openModule();
    return *codec;
}

}  // namespace ribalta
