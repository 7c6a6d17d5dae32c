// Target: look files. One that is read can be written, and that can be read again.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "base/error.h"
#include "fuzz/scratch_file.h"
#include "look/look_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ribalta;
    static const fuzz::ScratchFile file(".json");
    file.write({data, size});
    try {
        const Look look = readLook(file.path());
        writeLook(look, file.path());
        static_cast<void>(readLook(file.path()));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kBadInput || error.place().file != file.path()) {
            std::fprintf(stderr, "finding: %s\n", error.what());
            std::abort();
        }
    }
    return 0;
}
