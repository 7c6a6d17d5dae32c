#!/bin/sh
# Builds and tests everything: the CPU code under the sanitizers first, then all tests of the release
# build. Usage: tools/test.sh      The last line is CTest's.
set -eu
exec </dev/null
cd "$(dirname "$0")/.."
jobs=$(nproc)

tools/setup.sh --tests

echo "test: building in build/release"
cmake --preset release -DRIBALTA_TESTS=ON
cmake --build --preset release

echo "test: building in build/sanitize"
cmake --preset sanitize
cmake --build --preset sanitize --target cpu_tests
ctest --preset sanitize --parallel "$jobs"

ctest --preset release --parallel "$jobs"
