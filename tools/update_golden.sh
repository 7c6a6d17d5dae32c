#!/bin/sh
# Draws the golden images of tests/images anew, after a change that is meant to be seen; look at them,
# and at what git says has changed, before you commit them.
# Usage: tools/update_golden.sh [BUILD_FOLDER]      default: build/release, configured and built
set -eu
exec </dev/null
cd "$(dirname "$0")/.."
build=${1:-build/release}

cmake --build "$build" --target images_test
mkdir -p tests/images/golden
RIBALTA_UPDATE_GOLDEN=1 "$build/bin/images_test" --gtest_filter='*Golden*' --gtest_brief=1
git status --short -- tests/images/golden
