#include "gl/shader_library.h"

#include <algorithm>
#include <sstream>

#include "base/check.h"
#include "base/read_file.h"

namespace ribalta {
namespace {

constexpr const char* kPrologue =
    "#version 450 core\n"
    "#define GLSL 1\n"
    "#define OUT(T) out T\n";

std::filesystem::path& shaderFolder() {
    static std::filesystem::path folder;
    return folder;
}

std::string textOf(const std::string& file) {
    if (!shaderFolder().empty()) {
        const std::vector<std::byte> bytes = readFile(shaderFolder() / file);
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    const auto found = embeddedShaders().find(file);
    CHECK(found != embeddedShaders().end());
    return std::string(found->second);
}

void append(const std::string& file, ShaderSource& source) {
    const std::size_t number = source.files.size();
    source.files.push_back(file);
    source.text += "#line 1 " + std::to_string(number) + "\n";

    std::istringstream lines{textOf(file)};
    std::string line;
    for (int lineNumber = 1; std::getline(lines, line); ++lineNumber) {
        const std::string directive = "#include \"";
        // C++ alone needs the standard headers that a shared file names, and #pragma once.
        if (line.starts_with("#include <") || line.starts_with("#pragma once")) {
            source.text += "\n";
        } else if (line.starts_with(directive)) {
            const std::string included =
                line.substr(directive.size(), line.rfind('"') - directive.size());
            if (std::find(source.files.begin(), source.files.end(), included) ==
                source.files.end()) {
                append(included, source);
            }
            source.text +=
                "#line " + std::to_string(lineNumber + 1) + " " + std::to_string(number) + "\n";
        } else {
            source.text += line + "\n";
        }
    }
}

}  // namespace

void readShadersFrom(const std::filesystem::path& folder) {
    shaderFolder() = folder;
}

ShaderSource assembleShader(const std::string& file, const std::vector<std::string>& defines) {
    ShaderSource source;
    source.text = kPrologue;
    for (const std::string& define : defines) {
        source.text +=
            "#define " + define + (define.find(' ') == std::string::npos ? " 1\n" : "\n");
    }
    append(file, source);
    return source;
}

}  // namespace ribalta
