# Writes OUTPUT, a C++ file that holds the bytes of every file of FILES under the last part of its path,
# as the map that FUNCTION, declared in HEADER, returns. Bytes, because no compiler has to take a string
# as long as a script.
set(arrays "")
set(entries "")
set(count 0)
foreach(file IN LISTS FILES)
    get_filename_component(name ${file} NAME)
    file(READ ${file} bytes HEX)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
    string(APPEND arrays "const unsigned char kFile${count}[] = {${bytes}};\n")
    string(APPEND entries "        {\"${name}\", text(kFile${count}, sizeof kFile${count})},\n")
    math(EXPR count "${count} + 1")
endforeach()
file(
    WRITE ${OUTPUT}.new
    "// Made by cmake/embed_files.cmake.\n#include \"${HEADER}\"\n\n#include <cstddef>\n\n"
    "namespace ribalta {\nnamespace {\n\n${arrays}\n"
    "std::string_view text(const unsigned char* bytes, std::size_t size) {\n"
    "    return {reinterpret_cast<const char*>(bytes), size};\n}\n\n}  // namespace\n\n"
    "const std::map<std::string, std::string_view>& ${FUNCTION}() {\n"
    "    static const std::map<std::string, std::string_view> files = {\n${entries}    };\n"
    "    return files;\n}\n\n}  // namespace ribalta\n")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(TOUCH ${OUTPUT})
