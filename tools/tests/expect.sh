# shellcheck shell=bash
# Sourced by the tests of this folder, after `set -euo pipefail`.

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
tools=$(dirname "$here")
scratch=$(mktemp --directory)
trap 'rm -rf "$scratch"' EXIT
# shellcheck disable=SC2034 # The tests use them.
readonly here tools scratch
export TMPDIR=$scratch

# expect EXIT_CODE TEXT COMMAND...: COMMAND ends with EXIT_CODE and says TEXT; '' is nothing at all.
expect() {
  local code=$1 text=$2 output actual=0
  shift 2
  output=$("$@" 2>&1) || actual=$?
  if ((actual != code)); then
    wrong "exit code $actual, not $code" "$output" "$@"
  elif [[ -z $text && -n $output ]]; then
    wrong 'it should have been silent' "$output" "$@"
  elif [[ $output != *"$text"* ]]; then
    wrong "it did not say: $text" "$output" "$@"
  fi
}

# wrong WHAT OUTPUT COMMAND...
wrong() {
  printf 'FAILED: %s\n  %s\n  its output was:\n%s\n' "${*:3}" "$1" "$2" >&2
  exit 1
}

# stand_in NAME LINE...: a command of that name in $scratch/bin.
stand_in() {
  mkdir -p "$scratch/bin"
  printf '%s\n' '#!/usr/bin/env bash' "${@:2}" >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}
