# The one list of Debian packages the scripts need, by purpose, and how to install what is missing.
# Sourced by the scripts; expects bash.

declare -A packages=(
  [build]="g++ cmake ninja-build ccache pkg-config git libtomlplusplus-dev libcli11-dev libfmt-dev libspdlog-dev
           libhdf5-dev libxxhash-dev libeigen3-dev nlohmann-json3-dev libpcg-cpp-dev libgtest-dev libgmock-dev"
  [test]="python3 python3-numpy python3-h5py"
  [bench]="libbenchmark-dev"
  [fuzz]="clang libclang-rt-dev"
  [format]="clang-format"
  [layers]="python3"
  [quickstart]="python3 python3-numpy python3-h5py python3-matplotlib"
)

# need PURPOSE...: installs the packages of these purposes that are missing; silent when none is.
need() {
  local purpose package missing=()
  command -v dpkg-query >/dev/null || {
    echo "Not a Debian system: the equivalents of these packages must be present:" >&2
    for purpose in "$@"; do echo "  $purpose:" ${packages[$purpose]} >&2; done
    return 0
  }
  for purpose in "$@"; do
    for package in ${packages[$purpose]}; do
      dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q ' installed$' || missing+=("$package")
    done
  done
  ((${#missing[@]})) || return 0

  local as_root=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || {
      echo "These packages are missing and only root can install them: ${missing[*]}" >&2
      return 1
    }
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}" >&2
  quietly "${as_root[@]}" apt-get update
  quietly "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# quietly COMMAND...: runs it and shows its output only if it fails.
quietly() {
  local output
  output=$("$@" 2>&1) || {
    printf '%s\n' "$output" "failed: $*" >&2
    return 1
  }
}

# build_folder PRESET: where CMakePresets.json puts the build.
build_folder() { if [[ $1 == release ]]; then echo build; else echo "build/$1"; fi; }

# Debian's interpreter, which sees Debian's modules whatever else is on PATH.
python=/usr/bin/python3
[[ -x $python ]] || python=python3
