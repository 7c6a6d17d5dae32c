# How every library, program and test of the project is built: one set of warnings, all errors.

add_library(ribalta_options INTERFACE)
target_compile_options(
    ribalta_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                              -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough -Werror)
target_compile_definitions(
    ribalta_options INTERFACE GLM_FORCE_DEPTH_ZERO_TO_ONE GLM_FORCE_XYZW_ONLY
                              GLM_ENABLE_EXPERIMENTAL)
target_include_directories(ribalta_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
if(RIBALTA_SANITIZE)
    # Instrumented code makes g++ warn of conversions that it otherwise knows to be fine; the other
    # builds keep warnings as errors.
    target_compile_options(ribalta_options INTERFACE -Wno-error -fsanitize=address,undefined
                                                     -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(ribalta_options INTERFACE -fsanitize=address,undefined)
    if(RIBALTA_FUZZ)
        target_compile_options(ribalta_options INTERFACE -fsanitize=fuzzer-no-link)
    endif()
    # Undefined behaviour is looked for in the program and not in the tests' own code, whose
    # compilation would take half as long again. Linked after ribalta_options.
    add_library(ribalta_tests_own_code INTERFACE)
    target_compile_options(ribalta_tests_own_code INTERFACE -fno-sanitize=undefined -Werror)
endif()

# Large headers are what takes longest to compile.
if(RIBALTA_BATCH)
    set(CMAKE_UNITY_BUILD ON)
    set(CMAKE_UNITY_BUILD_BATCH_SIZE 10)
    # Of names and values that meet there alone; the other compiler looks at each file by itself.
    target_compile_options(
        ribalta_options
        INTERFACE -Wno-shadow
                  "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wno-maybe-uninitialized>")
endif()

# ribalta_precompile(TARGET KIND HEADERS ...): parses HEADERS once for all targets of one KIND, which
# are compiled alike. Only where all is built from nothing: elsewhere a file that lacks an include is to
# be found, and ccache to be of use.
function(ribalta_precompile TARGET KIND)
    if(NOT RIBALTA_BATCH)
        return()
    endif()
    get_property(first GLOBAL PROPERTY ribalta_precompiled_${KIND})
    if(first)
        target_precompile_headers(${TARGET} REUSE_FROM ${first})
    else()
        target_precompile_headers(${TARGET} PRIVATE ${ARGN})
        set_property(GLOBAL PROPERTY ribalta_precompiled_${KIND} ${TARGET})
    endif()
endfunction()

# ribalta_module(NAME SOURCES ... LINKS ... PRIVATE_LINKS ...): a static library ribalta_NAME
# from sources in the current folder. LINKS are seen by whoever uses the module.
function(ribalta_module NAME)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
    add_library(ribalta_${NAME} STATIC ${ARG_SOURCES})
    target_link_libraries(
        ribalta_${NAME}
        PUBLIC glm::glm ${ARG_LINKS}
        PRIVATE ribalta_options ${ARG_PRIVATE_LINKS})
    target_include_directories(ribalta_${NAME} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    ribalta_precompile(
        ribalta_${NAME}
        module
        <algorithm>
        <cmath>
        <filesystem>
        <functional>
        <map>
        <memory>
        <optional>
        <string>
        <variant>
        <vector>
        <glm/glm.hpp>)
endfunction()

# All tests that need no OpenGL, which is what the sanitized build is made for, and all others, with
# the programs that they run.
add_custom_target(cpu_tests)
add_custom_target(gpu_tests)

# ribalta_test(NAME [HEADER_CODE] LABEL unit|gpu|images|corpus SOURCES ... LINKS ...): a GoogleTest
# program whose cases CTest runs one by one. HEADER_CODE: what it tests is compiled with the test.
function(ribalta_test NAME)
    cmake_parse_arguments(ARG "HEADER_CODE" "LABEL" "SOURCES;LINKS" ${ARGN})
    add_executable(${NAME} ${ARG_SOURCES})
    target_link_libraries(${NAME} PRIVATE ribalta_options GTest::gtest GTest::gtest_main
                                          ${ARG_LINKS})
    if(RIBALTA_SANITIZE AND NOT ARG_HEADER_CODE)
        target_link_libraries(${NAME} PRIVATE ribalta_tests_own_code)
    endif()
    if(ARG_HEADER_CODE)
        ribalta_precompile(${NAME} test_of_headers <gtest/gtest.h> <glm/glm.hpp>)
    else()
        ribalta_precompile(${NAME} test <gtest/gtest.h> <glm/glm.hpp>)
    endif()
    target_include_directories(${NAME} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    target_compile_definitions(
        ${NAME} PRIVATE RIBALTA_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                        RIBALTA_BINARY_DIR="${PROJECT_BINARY_DIR}")
    if(ARG_LABEL MATCHES "^(unit|corpus)$")
        add_dependencies(cpu_tests ${NAME})
    else()
        add_dependencies(gpu_tests ${NAME})
    endif()
    # Tests over whole files take longest, and start first.
    set(cost 1)
    if(ARG_LABEL STREQUAL corpus)
        set(cost 100)
    endif()
    gtest_discover_tests(
        ${NAME}
        TEST_PREFIX "${NAME}."
        DISCOVERY_TIMEOUT 60
        PROPERTIES LABELS ${ARG_LABEL} COST ${cost} TIMEOUT 600)
endfunction()
