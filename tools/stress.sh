#!/bin/sh
# Draws random and adversarial set-ups and checks every picture; see tools/stress/README.md.
# Usage: tools/stress.sh [--seconds N] [--seed S] [--case K] [--beams METHOD] [--verbose]
set -eu
cd "$(dirname "$0")/.."
if [ ! -f build/release/build.ninja ]; then
    cmake --preset release -DRIBALTA_TESTS=ON >&2
fi
cmake --build --preset release --target ribalta_stress >&2
exec build/release/bin/ribalta_stress "$@"
