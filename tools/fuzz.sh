#!/bin/sh
# Feeds the readers of files with broken ones, made by the million. Builds in build/fuzz.
# Usage: tools/fuzz.sh [--minutes N | --seconds N] [--seed N] [--target NAME]... [--jobs N] [--build-only]
#   --minutes, --seconds  how long each target runs (default: 1 minute)
#   --seed                of the random choices (default: another in each run)
#   --target              gltf, glb, draco, ...; may be given several times (default: all)
#   --jobs                targets at once (default: as many as there are cores)
# What runs find new is kept in build/fuzz/corpus for the next one; what breaks a reader in
# build/fuzz/found, one file each. Prints executions and findings; the exit code is 1 where there
# are findings. Repeat one with: build/fuzz/bin/fuzz_TARGET FILE
set -eu
exec </dev/null
cd "$(dirname "$0")/.."

usage() {
    sed -n '3,7s/^# //p' tools/fuzz.sh >&2
    exit 2
}

number() {
    case $1 in
        '' | *[!0-9]* | 0) usage ;;
        *) echo "$1" ;;
    esac
}

# One target: its last lines are in build/fuzz/TARGET.log.
run() {
    target=$1
    cd build/fuzz
    mkdir -p "seeds/$target" "corpus/$target" "found/$target"
    # An input may take 20 s, which is some hundred times what any should, on a busy machine; memory
    # is far above the limits that the targets give the readers.
    status=0
    # With one thread a seed repeats what was covered.
    RIBALTA_THREADS=1 "bin/fuzz_$target" "corpus/$target" "seeds/$target" -dict=../../tests/fuzz/words.dict -seed="$3" \
        -max_total_time="$2" -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=1024 \
        -max_len=16384 -artifact_prefix="found/$target/" -print_final_stats=1 \
        >"$target.log" 2>&1 || status=$?
    executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$target.log")
    count=$(find "found/$target" -type f | wc -l)
    echo "fuzz: $target: ${executions:-no} executions, $count findings in build/fuzz/found/$target"
    if [ "$status" -ne 0 ]; then
        grep -E "ERROR|finding:|runtime error|SUMMARY" "$target.log" | head -5 || tail -5 "$target.log"
        exit 1
    fi
}

# This script again, for one target of several at once.
if [ "${FUZZ_TARGET:-}" ]; then
    run "$FUZZ_TARGET" "$FUZZ_SECONDS" "$FUZZ_SEED"
    exit 0
fi

seconds=60
seed=0 # libFuzzer takes one of its own
targets=""
jobs=$(nproc)
build_only=""
while [ $# -gt 0 ]; do
    case $1 in
        --minutes) seconds=$((60 * $(number "${2:-}"))) && shift 2 ;;
        --seconds) seconds=$(number "${2:-}") && shift 2 ;;
        --seed) seed=$(number "${2:-}") && shift 2 ;;
        --target) targets="$targets ${2:-}" && shift 2 ;;
        --jobs) jobs=$(number "${2:-}") && shift 2 ;;
        --build-only) build_only=yes && shift ;;
        *) usage ;;
    esac
done

tools/setup.sh --tests
echo "fuzz: building in build/fuzz"
cmake --preset fuzz
cmake --build --preset fuzz --target fuzz_targets
[ -z "$build_only" ] || exit 0

all=$(cd build/fuzz/bin && echo fuzz_* | sed 's/fuzz_//g')
for target in $targets; do
    case " $all " in
        *" $target "*) ;;
        *)
            echo "fuzz: no target '$target'; there are: $all" >&2
            exit 2
            ;;
    esac
done
targets=${targets:-$all}
python3 -B tests/fuzz/make_seeds.py build/fuzz/seeds

failed=0
for target in $targets; do echo "$target"; done |
    xargs -P "$jobs" -I{} env FUZZ_TARGET={} FUZZ_SECONDS="$seconds" FUZZ_SEED="$seed" tools/fuzz.sh || failed=1
exit "$failed"
