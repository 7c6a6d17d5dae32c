#!/bin/sh
# Fails where a C++ file is not formatted as .clang-format says. Usage: tools/check_format.sh
# Mend with: clang-format-14 -i FILE
set -eu
cd "$(dirname "$0")/.."
find src tests tools samples \( -name '*.cpp' -o -name '*.h' \) -print0 |
    xargs -0 clang-format-14 --dry-run --Werror
