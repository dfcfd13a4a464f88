# shellcheck shell=bash
# Sourced by the commands of this folder, after `set -euo pipefail`.

tools_folder=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
root=$(dirname "$tools_folder")

# Clones and worktrees share what ccache holds.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
# It keeps nothing that precompiled headers go into, unless told.
export CCACHE_SLOPPINESS=pch_defines,time_macros

trap 'exit 130' INT # Ctrl-C in a build is no failed build.

say() { printf '%s\n' "$*" >&2; }

die() {
  say "${0##*/}: $*"
  exit 1
}

# The comment that heads a command is its help.
print_help() { awk 'NR > 1 { if (!/^#/) exit; sub(/^# ?/, ""); print }' "$0"; }

# Lines that are redrawn suit a terminal, not a log.
draws_progress() { [[ -t 2 && ${CI:-} != true ]]; }

# show_progress TITLE LOG: copies stdin to LOG. On a terminal the latest line is redrawn in place;
# elsewhere TITLE is printed once, when there is something to do.
show_progress() {
  local title=$1 log=$2 line announced=no
  draws_progress && announced=yes
  while IFS= read -r line || [[ -n $line ]]; do
    printf '%s\n' "$line" >&3
    # Ninja's step 0 is its look for new files: not worth a word.
    [[ $line == '[0/'* || $line == 'ninja: no work to do.' ]] && continue
    if draws_progress; then
      line="$title: $line"
      printf '\r\033[K%s' "${line:0:${COLUMNS:-80}-1}" >&2
    elif [[ $announced == no ]]; then
      say "$title ..."
      announced=yes
    fi
  done 3>"$log"
  if draws_progress; then printf '\r\033[K' >&2; fi
}

# The part of a build's log that matters: from the first failure on, or the end, without Ninja's
# steps and clang-tidy's counts.
print_failure() {
  local first='^(FAILED: |CMake Error)' noise='^\[[0-9]+/[0-9]+\] |^[0-9]+ warnings? |__run_co_compile'
  if grep -qE "$first" "$1"; then
    sed -nE "/$first/,\$p" "$1" | grep -vE "$noise" >&2
  else
    tail -n 40 "$1" >&2
  fi
}

# run_logged TITLE LOG COMMAND...: silent unless COMMAND takes long or fails.
# A pipe, not a background job: Ctrl-C has to reach COMMAND.
run_logged() {
  local title=$1 log=$2
  shift 2
  mkdir -p "$(dirname "$log")"
  "$@" 2>&1 </dev/null | show_progress "$title" "$log" && return
  print_failure "$log"
  die "$title: failed, see above and $log"
}

# Two commands at once would write the same build folder.
lock_build() {
  mkdir -p "$root/build"
  exec {build_lock}>"$root/build/$1.lock"
  flock --nonblock "$build_lock" && return
  say "Waiting for another build of $1 ..."
  flock "$build_lock"
}

unlock_build() { exec {build_lock}>&-; }

# configure PRESET: ninja configures again by itself, except when the presets change, the checkout
# moves or the last try failed.
configure() {
  local folder=$root/build/$1
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    run_cmake "$1" --fresh
  elif [[ ! $folder/build.ninja -nt $root/CMakePresets.json ]]; then
    run_cmake "$1"
  fi
}

run_cmake() {
  run_logged "Configuring $1" "$root/build/$1.configure.log" cmake -S "$root" --preset "$@"
}

# build PRESET TARGET...
build() {
  local preset=$1
  shift
  lock_build "$preset"
  configure "$preset"
  run_logged "Building $preset ($1)" "$root/build/$preset.build.log" \
    cmake --build "$root/build/$preset" --parallel "$(nproc)" --target "$@"
  unlock_build
}

# Kernels are GLSL and have other extensions; clang-format does not know that language.
list_cpp_files() {
  local folders=() folder
  for folder in host tests tools shaders docs; do
    [[ -d $root/$folder ]] && folders+=("$root/$folder")
  done
  find "${folders[@]}" -type f '(' -name '*.h' -o -name '*.cpp' ')' -print0 | sort --zero-terminated
}
