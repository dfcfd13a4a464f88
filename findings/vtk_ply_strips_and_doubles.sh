#!/usr/bin/env bash
# VTK 9.1 (Debian 12's python3-vtk9 9.1.0): two things that vtkPLYReader does to valid files, with error code 0 and no
# warning.
#
# 1. A surface given as triangle strips (the element `tristrips`, in which scans of the nineties are kept) comes
#    out as points without a cell: 4 points and 0 cells of two triangles.
# 2. Properties of type double are rounded to float, and so are the coordinates of OBJ files (vtkOBJReader, whose
#    format has no precision). In metres of a map's grid, 5,411,000 north, a triangle of 0.1 m stands on corners
#    that are 0.5 m apart: two of its edges end up 0.09 and 0.5 m long. ParaView shows what VTK reads, so a small part
#    far from the origin looks broken although its file is right; VTK's own formats (.vtu) keep doubles.
#
# Installs the package and its libraries from Debian's archive into a temporary folder. Exits 0 while the
# behaviour is as seen, 1 when it has changed, 2 when it cannot be tried.
set -euo pipefail

version=9.1.0+really9.1.0+dfsg2-5+deb12u1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

give_up() {
  echo "cannot be tried: $*" >&2
  exit 2
}

install_vtk() {
  local packages
  packages=$(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks \
    --no-replaces --no-enhances python3-vtk9 | grep -E '^[a-z]' |
    grep -vE '^(libc6|libgcc-s1|gcc-12-base|libcrypt1|debconf|dpkg|tar|install-info|python3|python3-vtk9)$' | sort -u)
  (cd "$folder" && apt-get download "python3-vtk9=$version" $packages >download.log 2>&1) ||
    give_up "apt-get download failed"
  for package in "$folder"/*.deb; do dpkg -x "$package" "$folder/root"; done
  LD_LIBRARY_PATH=$(find "$folder/root" -name '*.so*' -printf '%h\n' | sort -u | paste -sd:)
  export LD_LIBRARY_PATH PYTHONPATH=$folder/root/usr/lib/python3/dist-packages
}

write_files() {
  cat >"$folder/strip.ply" <<'PLY'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element tristrips 1
property list int int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
1 1 0
4 0 1 2 3
PLY
  cat >"$folder/far.ply" <<'PLY'
ply
format ascii 1.0
element vertex 3
property double x
property double y
property double z
element face 1
property list uchar int vertex_indices
end_header
447000.12 5411000.2 1
447000.22 5411000.2 1
447000.12 5411000.3 1
3 0 1 2
PLY
  printf 'v 447000.12 5411000.2 1\nv 447000.22 5411000.2 1\nv 447000.12 5411000.3 1\nf 1 2 3\n' \
    >"$folder/far.obj"
}

read_files() {
  /usr/bin/python3 - "$folder" <<'PYTHON'
import math
import sys

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOPLY import vtkPLYReader


def read(reader, name):
    reader.SetFileName(f"{sys.argv[1]}/{name}")
    reader.Update()
    return reader.GetOutput(), reader.GetErrorCode()


print("VTK", vtkVersion.GetVTKVersion())
surface, error = read(vtkPLYReader(), "strip.ply")
print(f"strip.ply: {surface.GetNumberOfPoints()} points, {surface.GetNumberOfCells()} cells, error {error}")
for name, reader in (("far.ply", vtkPLYReader()), ("far.obj", vtkOBJReader())):
    surface, error = read(reader, name)
    corners = [surface.GetPoint(n) for n in range(3)]
    edges = " and ".join(f"{math.dist(corners[0], corner):.2f}" for corner in corners[1:])
    print(f"{name}: edges of 0.10 and 0.10 are read as {edges}, error {error}")
PYTHON
}

install_vtk
write_files
seen=$(read_files 2>&1) || give_up "$seen"
expected='VTK 9.1.0
strip.ply: 4 points, 0 cells, error 0
far.ply: edges of 0.10 and 0.10 are read as 0.09 and 0.50, error 0
far.obj: edges of 0.10 and 0.10 are read as 0.09 and 0.50, error 0'
printf '%s\n' "$seen"
[[ $seen == "$expected" ]] || {
  echo "changed; expected was:" >&2
  printf '%s\n' "$expected" >&2
  exit 1
}
