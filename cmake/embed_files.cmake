# Writes OUTPUT, a C++ file that holds the bytes of every file of FILES as the map that FUNCTION, declared
# in HEADER, returns: by its path below ROOT where that is given (FILES are then relative to it), by the
# last part of its path otherwise. Bytes, because no compiler has to take a string as long as a script.
set(arrays "")
set(entries "")
set(count 0)
foreach(file IN LISTS FILES)
    if(DEFINED ROOT)
        set(name ${file})
        file(READ ${ROOT}/${file} bytes HEX)
    else()
        get_filename_component(name ${file} NAME)
        file(READ ${file} bytes HEX)
    endif()
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
