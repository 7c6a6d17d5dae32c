# What is kept on disk must not outlive the code that made it.

# code_revision(VARIABLE HEADER FUNCTION FILES...): sets VARIABLE to a source file to be compiled, which
# defines the function that HEADER declares. It returns a text that changes whenever one of FILES does.
function(code_revision variable header function)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
    add_custom_command(
        OUTPUT ${source}
        COMMAND ${CMAKE_COMMAND} "-DFILES=${ARGN}" -DOUTPUT=${source} -DHEADER=${header}
                -DFUNCTION=${function} -P ${PROJECT_SOURCE_DIR}/cmake/hash_files.cmake
        DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/hash_files.cmake
        VERBATIM)
    set(${variable} ${source} PARENT_SCOPE)
endfunction()
