// Any bytes through loadGltf, as the targets do it. Decides what is a finding; finds nothing
// itself.
#pragma once

#include <cstdint>
#include <span>

namespace ribalta::fuzz {

/// Loads the bytes as a file of that extension, within limits small enough that one that is not
/// kept shows. Ends the program where the scene breaks a promise of its headers, or what is thrown
/// is no Error that names the file.
void loadBytes(std::span<const std::uint8_t> bytes, const char* extension);

}  // namespace ribalta::fuzz
