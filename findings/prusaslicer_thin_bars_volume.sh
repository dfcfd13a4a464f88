#!/usr/bin/env bash
# PrusaSlicer 2.5.0 (Debian 12's prusa-slicer 2.5.0+dfsg-4), a lattice of bars at 100 % infill, lines of 0.45 mm: the plastic
# that it lays is not the plastic that the solid holds, by an amount that jumps with the width of the bars and with the
# perimeter generator, and nothing says so. Its own "filament used", over the solid's volume:
#
#   width of bars, mm    classic   arachne
#   0.6                   +9.9 %    -2.3 %
#   0.8                   +8.5 %    -1.4 %
#   0.9                   -3.9 %    -1.9 %
#   1.5                   +0.2 %    +2.5 %
#   1.8                   -4.1 %    -0.5 %
#
# One lattice with bars of 0.8 and 0.9 mm gets 12 % more plastic per volume in one than in the other. Who prints bars that shrink
# by how they are laid, or compares prints by weight, should choose widths by such a table or lay the lines himself.
#
# Installs the package and its libraries from Debian's archive into a temporary folder. Exits 0 while the behaviour is
# as seen, 1 when it has changed, 2 when it cannot be tried.
set -euo pipefail

version=2.5.0+dfsg-4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

give_up() {
  echo "cannot be tried: $*" >&2
  exit 2
}

install_slicer() {
  local packages
  packages=$(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks \
    --no-replaces --no-enhances prusa-slicer | grep -E '^[a-z]' |
    grep -vE '^(libc6|libgcc-s1|gcc-12-base|libcrypt1|debconf|dpkg|tar|install-info|prusa-slicer)$' | sort -u)
  (cd "$folder" && apt-get download "prusa-slicer=$version" $packages >download.log 2>&1) ||
    give_up "apt-get download failed"
  for package in "$folder"/*.deb; do dpkg -x "$package" "$folder/root"; done
  LD_LIBRARY_PATH=$(find "$folder/root" -name '*.so*' -printf '%h\n' | sort -u | paste -sd:)
  export LD_LIBRARY_PATH
}

# lattice WIDTH: a closed solid of 5 x 5 bars, 10 mm apart, 0.8 mm high, as STL; says its volume in mm3.
lattice() {
  awk -v w="$1" -v stl="$folder/lattice.stl" '
    function solid(i, j) { return i >= 0 && j >= 0 && i < n && j < n && (i % 2 == 0 || j % 2 == 0) }
    function triangle(a, b, c) {
      printf "facet normal 0 0 0\nouter loop\nvertex %s\nvertex %s\nvertex %s\nendloop\nendfacet\n", a, b, c > stl
    }
    function face(a, b, c, d) { triangle(a, b, c); triangle(a, c, d) }
    function point(x, y, z) { return sprintf("%.6f %.6f %.6f", x, y, z) }
    BEGIN {
      h = 0.8
      for (k = 0; k < 5; ++k) { x[2 * k] = 10 * k - w / 2; x[2 * k + 1] = 10 * k + w / 2 }
      n = 9
      print "solid lattice" > stl
      for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
        if (!solid(i, j)) continue
        volume += h * (x[i + 1] - x[i]) * (x[j + 1] - x[j])
        for (k = 0; k < 2; ++k) {
          sw[k] = point(x[i], x[j], k * h); se[k] = point(x[i + 1], x[j], k * h)
          ne[k] = point(x[i + 1], x[j + 1], k * h); nw[k] = point(x[i], x[j + 1], k * h)
        }
        face(sw[1], se[1], ne[1], nw[1]); face(nw[0], ne[0], se[0], sw[0])
        if (!solid(i - 1, j)) face(nw[0], sw[0], sw[1], nw[1])
        if (!solid(i + 1, j)) face(se[0], ne[0], ne[1], se[1])
        if (!solid(i, j - 1)) face(sw[0], se[0], se[1], sw[1])
        if (!solid(i, j + 1)) face(ne[0], nw[0], nw[1], ne[1])
      }
      print "endsolid lattice" > stl
      print volume
    }'
}

# filament GENERATOR: its length in mm, as the G-code says.
filament() {
  "$folder/root/usr/bin/prusa-slicer" --export-gcode --perimeter-generator "$1" --layer-height 0.08 --first-layer-height 0.08 \
    --perimeters 2 --nozzle-diameter 0.4 --filament-diameter 1.75 --fill-density 100% --fill-pattern rectilinear --skirts 0 \
    --extrusion-width 0.45 --first-layer-extrusion-width 0.45 --perimeter-extrusion-width 0.45 \
    --external-perimeter-extrusion-width 0.45 --infill-extrusion-width 0.45 --solid-infill-extrusion-width 0.45 \
    --output "$folder/lattice.gcode" "$folder/lattice.stl" >"$folder/slice.log" 2>&1 ||
    give_up "prusa-slicer: $(tail -n 1 "$folder/slice.log")"
  grep -qi warning "$folder/slice.log" && echo "a warning now: $(grep -i warning "$folder/slice.log")" >&2
  sed -n 's/^; filament used \[mm\] = //p' "$folder/lattice.gcode"
}

table() {
  local width volume generator row
  for width in 0.6 0.8 0.9 1.5 1.8; do
    volume=$(lattice "$width")
    row=$width
    for generator in classic arachne; do
      row+=$(awk -v mm="$(filament "$generator")" -v volume="$volume" \
        'BEGIN { printf " %+.1f %%", 100 * (mm * 3.14159265 * 1.75 ^ 2 / 4 / volume - 1) }')
    done
    echo "$row"
  done
}

install_slicer
seen=$(table)
expected='0.6 +9.9 % -2.3 %
0.8 +8.5 % -1.4 %
0.9 -3.9 % -1.9 %
1.5 +0.2 % +2.5 %
1.8 -4.1 % -0.5 %'
printf '%s\n' "$seen"
[[ $seen == "$expected" ]] || {
  echo "changed; expected was:" >&2
  printf '%s\n' "$expected" >&2
  exit 1
}
