// IES LM-63 files (1986, 1991, 1995, 2002, 2019) into photometric webs. Reads no files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "gltf/photometric_web.h"

namespace ribalta::gltf {

struct IesProfile {
    PhotometricWeb web;
    std::vector<std::string> remarks;  ///< what of the file is not used or was mended, a line each
};

/// The web in candela, with the file's multiplier and ballast factors. Keywords, the lamp's tilt
/// and what the luminaire measures are not used. Throws Error(kBadInput) at `place` with the number
/// of the line where the text is no such file, before memory is taken for what it merely claims.
IesProfile parseIes(std::string_view text, const Place& place);

}  // namespace ribalta::gltf
