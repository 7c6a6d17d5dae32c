#!/bin/sh
# Draws random and adversarial set-ups and checks every picture; see tools/stress/README.md.
# Usage: tools/stress.sh [--seconds N] [--seed S] [--case K] [--beams METHOD] [--verbose]
#        tools/stress.sh sky [--seconds N] [--seed S] [--case K] [--verbose]
set -eu
cd "$(dirname "$0")/.."
program=ribalta_stress
if [ "${1:-}" = sky ]; then
    program=ribalta_stress_sky
    shift
fi
if [ ! -f build/release/build.ninja ]; then
    cmake --preset release -DRIBALTA_TESTS=ON >&2
fi
cmake --build --preset release --target "$program" >&2
exec build/release/bin/"$program" "$@"
