#include "fuzz/load_bytes.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/scratch_file.h"
#include "gltf/load_gltf.h"
#include "support/scene_faults.h"

namespace ribalta::fuzz {
namespace {

LoadOptions options() {
    LoadOptions result;
    result.limits.memory = 100'000'000;
    result.limits.vertices = 1'000'000;
    result.limits.nodes = 100'000;
    result.limits.pixels = 1'000'000;
    return result;
}

[[noreturn]] void found(const std::string& what) {
    std::fprintf(stderr, "finding: %s\n", what.c_str());
    std::abort();
}

void checkError(const Error& error, const std::filesystem::path& file) {
    if (error.kind() != ErrorKind::kBadInput && error.kind() != ErrorKind::kJobFailed) {
        found(std::string("an error of another kind: ") + error.what());
    }
    if (error.kind() == ErrorKind::kBadInput && error.place().file != file) {
        found(std::string("an error at no place: ") + error.what());
    }
}

}  // namespace

void loadBytes(std::span<const std::uint8_t> bytes, const char* extension) {
    static const ScratchFile file(extension);
    file.write(bytes);
    try {
        const LoadedScene loaded = loadGltf(file.path(), options());
        for (const std::string& fault : test::sceneFaults(loaded.scene)) {
            found(fault);
        }
        for (const Report::Entry& entry : loaded.report.entries()) {
            if (entry.message.empty() || entry.place.file != file.path()) {
                found("a line of the report without message or place: " + entry.message);
            }
        }
    } catch (const Error& error) {
        checkError(error, file.path());
    }
}

}  // namespace ribalta::fuzz
