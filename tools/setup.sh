#!/bin/sh
# Installs the Debian packages that ribalta needs and that are missing, and nothing else.
# Usage: tools/setup.sh [--tests]      --tests adds what only the tests need
# Needs no network, and changes nothing, where all of them are there.
set -eu
exec </dev/null
cd "$(dirname "$0")"

lists=packages.txt
if [ "${1:-}" = --tests ]; then
    lists="packages.txt packages_test.txt"
elif [ $# -gt 0 ]; then
    echo "usage: tools/setup.sh [--tests]" >&2
    exit 2
fi

packages=$(for list in $lists; do sed 's/#.*//' "$list"; done)
if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "setup: no apt here; these must be there by other means:" $packages
    exit 0
fi

missing=""
for package in $packages; do
    state=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    if [ "$state" != installed ]; then
        missing="$missing $package"
    fi
done
if [ -z "$missing" ]; then
    echo "setup: all packages are installed"
    exit 0
fi

as_root=""
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "setup: no root and no sudo; as root, run: apt-get install$missing" >&2
        exit 1
    fi
    as_root=sudo
fi
echo "setup: installing with ${as_root:+$as_root }apt-get:$missing"
$as_root env DEBIAN_FRONTEND=noninteractive apt-get update --quiet
# shellcheck disable=SC2086  # the list is split on purpose
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet \
    --no-install-recommends $missing
