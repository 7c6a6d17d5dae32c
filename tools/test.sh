#!/bin/sh
# Builds and tests everything: what needs no OpenGL under the sanitizers, readers of files by a minute
# of fuzzing each, then the rest as it is released. Usage: tools/test.sh      The last line is CTest's.
set -eu
exec </dev/null
cd "$(dirname "$0")/.."
jobs=$(nproc)

tools/setup.sh --tests

echo "test: building in build/sanitize"
cmake --preset sanitize
cmake --build --preset sanitize --target cpu_tests
ctest --preset sanitize --parallel "$jobs"

# The same choices each time: a change is judged by what it changes.
tools/fuzz.sh --seconds 60 --seed 1

# Tests without OpenGL would find nothing new here, and take as long again to compile.
echo "test: building in build/release"
cmake --preset release -DRIBALTA_TESTS=ON -DRIBALTA_BATCH=ON
cmake --build --preset release --target gpu_tests
ctest --preset release --parallel "$jobs" --label-exclude '^(unit|corpus)$' --exclude-regex '_NOT_BUILT$'
