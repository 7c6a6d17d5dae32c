#!/bin/sh
# Prints how long each pass of the sample stage takes at 640x360, cold and with its shadow maps kept.
# Usage: tools/bench.sh [OPTION...]      those of tests/bench/bench.py; --help lists them
# Wants the program built, in build/release; does not stop others from using the machine meanwhile.
set -eu
exec </dev/null
cd "$(dirname "$0")/.."
exec python3 -B tests/bench/bench.py "$@"
