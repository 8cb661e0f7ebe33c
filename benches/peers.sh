#!/usr/bin/env bash
# Times the conversions of the public polyhedra beside cddlib, PPL, lrslib and Normaliz: benches/peers.sh [NAME…]
#
# Installs what is missing from Debian's packages (as root), compiles one driver for each library against it, and runs
# all programs on one instance after the other. The libraries are under the GPL: nothing here is linked with partplan.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=(g++ libcdd-dev libgmp-dev libnormaliz-dev libppl-dev lrslib)
missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
    apt-get update -qq
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
fi

drivers=$(mktemp -d)
trap 'rm -rf "$drivers"' EXIT
compile() { g++ -O2 -std=c++17 -Wall -Wextra "benches/peers/$1.cpp" -o "$drivers/$1" "${@:2}"; }
compile cdd -lcddgmp -lgmpxx -lgmp
compile lrs -lgmpxx -lgmp
compile normaliz -fopenmp -lnormaliz -leanticxx -leantic -lflint -lgmpxx -lgmp
compile ppl -lppl -lgmpxx -lgmp

cargo bench --quiet --locked --bench polyhedra -- --peers "$drivers" "$@"
