# Writes OUTPUT, a C++ file that holds the text of every shader of FILES (relative to ROOT).
set(entries "")
foreach(file IN LISTS FILES)
    file(READ ${ROOT}/${file} text)
    string(APPEND entries "    {\"${file}\", R\"~~shader~~(${text})~~shader~~\"},\n")
endforeach()
file(
    WRITE ${OUTPUT}.new
    "// Made by cmake/embed_shaders.cmake.\n#include \"gl/shader_library.h\"\n\n"
    "namespace ribalta {\n\nconst std::map<std::string, std::string>& embeddedShaders() {\n"
    "    static const std::map<std::string, std::string> sources = {\n${entries}    };\n"
    "    return sources;\n}\n\n}  // namespace ribalta\n")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(TOUCH ${OUTPUT})
