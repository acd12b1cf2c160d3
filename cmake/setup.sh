# Sourced by studies/run, tests/run and others: functions that install the missing packages of packages.txt,
# and configure and build. A second call has nothing to do.

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cores=$(nproc)

started=${started:-$(date +%s)} # start of the outermost script
export started
say() { printf '== %s (%d s)\n' "$*" $(($(date +%s) - started)); }

install_packages() {
  local missing=() package
  while read -r package; do
    case $package in '' | '#'*) continue ;; esac
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' ||
      missing+=("$package")
  done <"$root/packages.txt"
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  if ! command -v apt-get >/dev/null; then
    echo "these packages are missing and there is no apt-get: ${missing[*]}" >&2
    exit 1
  fi
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "run this as root once, to install: ${missing[*]}" >&2; exit 1; }
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends \
    "${missing[@]}"
}

build() {  # build PRESET [TARGET..]
  local preset=$1
  shift
  say "building ($preset)"
  local once=OFF
  if [ -n "${CI:-}" ]; then once=ON; fi  # built once, so that joined sources save time
  (cd "$root" && cmake --preset "$preset" -DCMAKE_UNITY_BUILD=$once) >"$root/build-$preset.log" 2>&1 ||
    { cat "$root/build-$preset.log"; exit 1; }
  rm -f "$root/build-$preset.log"
  (cd "$root" && cmake --build --preset "$preset" -j "$cores" ${1:+--target "$@"})
}
