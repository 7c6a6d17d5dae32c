// The shader sources, embedded at build time, and how a whole GLSL text is put together from them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ribalta {

/// Every file of shaders/ by its path there, e.g. "lib/brdf.glsl".
const std::map<std::string, std::string_view>& embeddedShaders();

/// From now on sources are read from this folder, laid out as shaders/ is, whenever a program is
/// made: for work on the shaders themselves.
void readShadersFrom(const std::filesystem::path& folder);

struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  ///< the numbers that #line gives to the compiler's messages
};

/// `file` with its #include "..." lines resolved (each file once), behind a #version line, the
/// defines and the few words that let lib/ and shared/ be C++ as well. Throws Error(kBadInput)
/// where a folder that was given lacks a file.
ShaderSource assembleShader(const std::string& file, const std::vector<std::string>& defines);

}  // namespace ribalta
