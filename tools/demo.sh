#!/bin/sh
# From a bare Debian 12 to a picture: installs what is needed, builds, and draws the stage.
# Usage: tools/demo.sh      The pictures go to out/stage.png and out/stage.exr.
set -eu
exec </dev/null
cd "$(dirname "$0")/.."

tools/setup.sh
echo "demo: building in build/release"
# Configured as it stands where it is there already: a tree with tests keeps them.
if [ ! -f build/release/build.ninja ]; then
    cmake --preset release -DRIBALTA_TESTS=OFF
fi
cmake --build --preset release --target ribalta

mkdir -p out
echo "demo: drawing samples/scenes/stage.glb"
build/release/bin/ribalta render samples/scenes/stage.glb --camera front_of_house \
    --size 1280x720 -o out/stage.png -o out/stage.exr --verbose
echo "demo: the picture is in $PWD/out/stage.png, its scene-linear cd/m2 in $PWD/out/stage.exr"
