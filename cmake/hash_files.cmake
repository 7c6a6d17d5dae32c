# Writes OUTPUT, a C++ file whose FUNCTION, declared in HEADER, returns a hash of the contents of FILES.
set(hashes "")
foreach(file IN LISTS FILES)
    file(SHA256 ${file} hash)
    string(APPEND hashes ${hash})
endforeach()
string(SHA256 hash "${hashes}")
file(
    WRITE ${OUTPUT}.new
    "// Made by cmake/hash_files.cmake.\n#include \"${HEADER}\"\n\nnamespace ribalta {\n\n"
    "const char* ${FUNCTION}() {\n    return \"${hash}\";\n}\n\n}  // namespace ribalta\n")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
file(TOUCH ${OUTPUT})
