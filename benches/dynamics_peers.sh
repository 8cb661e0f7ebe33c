#!/usr/bin/env bash
# Error and CPU time of the time-steppers beside other engines, on the same scenes: benches/dynamics_peers.sh [SCENE…]
# or, into a chart of plan chart measured before: benches/dynamics_peers.sh --chart DIR
#
# A SCENE is the beginning of a name in tests/dynamics/peer_scenes.json; none means all. Installs what is missing: Siconos
# from Debian's packages (as root), MuJoCo, Chipmunk and DART from PyPI into a virtual environment of its own, Rapier from
# crates.io. An engine that cannot be installed is said and left out. All are run one after the other, none is linked
# with partplan.
set -euo pipefail
cd "$(dirname "$0")/.."

scenes=tests/dynamics/peer_scenes.json
here=benches/peers/dynamics
cache=${XDG_CACHE_HOME:-$HOME/.cache}/partplan-peers
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$cache"
# threads of the linear algebra would cost Siconos more than they save
export OPENBLAS_NUM_THREADS=1

chart=
if [ "${1:-}" = --chart ]; then
    chart=$2/chart.csv
    [ -f "$chart" ] || { echo "no $chart: run plan chart --out $2 before" >&2; exit 2; }
    set -- slide_stop incline_slip backspin_57 bounce_e08
fi

mapfile -t names < <(python3 - "$scenes" "$@" <<'END'
import json, sys
names = [scene["name"] for scene in json.load(open(sys.argv[1]))["scenes"]]
print(*[name for name in names if name.startswith(tuple(sys.argv[2:]) or "")], sep="\n")
END
)
[ -n "${names[0]}" ] || { echo "no scene begins with: $*" >&2; exit 2; }

without() { echo "left out: $1 could not be installed" >&2; }

siconos() {
    local packages=(g++ libsiconos-kernel-dev libsiconos-numerics-dev nlohmann-json3-dev) includes
    if ! dpkg-query -W -f '${Status}\n' "${packages[@]}" 2>/dev/null | grep -cx 'install ok installed' |
        grep -qx ${#packages[@]}; then
        apt-get update -qq && apt-get install -y -qq --no-install-recommends "${packages[@]}" >&2 || return
    fi
    mapfile -t includes < <(find /usr/include/siconos -type d -printf '-isystem\n%p\n')
    g++ -O2 -std=c++17 -Wall -Wextra "${includes[@]}" "$here/siconos.cpp" -o "$cache/siconos" \
        -lsiconos_kernel -lsiconos_numerics
}

python_engine() {
    [ -x "$cache/venv/bin/python" ] || python3 -m venv "$cache/venv" || return
    "$cache/venv/bin/pip" install --quiet --disable-pip-version-check "$1"
}

rapier() {
    cargo build --quiet --release --locked --manifest-path "$here/rapier/Cargo.toml" --target-dir "$cache/rapier"
}

run() { echo "running $1" >&2; shift; "$@" "$scenes" "${names[@]}" >>"$work/peers"; }

touch "$work/peers"
if siconos; then run "Siconos (driver in C++)" "$cache/siconos"; else without Siconos; fi
for pinned in mujoco==4.0.0 pymunk==7.3.1 dartpy==6.20.0; do
    engine=${pinned%%==*}
    if python_engine "$pinned"; then
        run "$engine" env PYTHONDONTWRITEBYTECODE=1 "$cache/venv/bin/python" "$here/${engine}_driver.py"
    else
        without "$engine"
    fi
done
if rapier; then run "Rapier (driver in Rust)" "$cache/rapier/release/rapier-driver"; else without Rapier; fi

if [ -n "$chart" ]; then
    python3 "$here/to_chart.py" "$scenes" "$work/peers" "$chart"
    cargo run --quiet --release --locked -- chart --from "$chart" --out "$(dirname "$chart")"
    exit
fi

echo "running partplan" >&2
cargo bench --quiet --locked --bench dynamics -- --csv "${names[@]}" >"$work/ours"
python3 "$here/compare.py" "$scenes" "$work/ours" "$work/peers"
