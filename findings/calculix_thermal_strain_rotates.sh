#!/usr/bin/env bash
# CalculiX 2.20 (Debian 12's calculix-ccx 2.20-1): with NLGEOM, thermal strain is not objective.
#
# One brick of 1 x 0.2 x 0.2 whose expansion is -0.1 a degree gets one degree warmer and is then turned
# about z as a rigid body: six displacements are prescribed, no force acts. It should be 0.9 long at any angle.
# CalculiX makes it longer the further it is turned: 0.9000 at 0 degrees, 0.9120 at 30, 0.9454 at 60, and
# reports stresses up to 19 % of Young's modulus x expansion in a brick that nothing holds. It says nothing.
# So with thermal strain CalculiX is no oracle for structures that shrink and bend far: a strip
# bends less and less along its length.
#
# Downloads the package and its libraries from Debian's archive into a temporary folder. Exits 0 while the
# behaviour is as seen, 1 when it has changed, 2 when it cannot be tried.
set -euo pipefail

version=2.20-1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

give_up() {
  echo "cannot be tried: $*" >&2
  exit 2
}

install_calculix() {
  local packages
  packages=$(apt-cache depends --recurse --no-recommends --no-suggests --no-conflicts --no-breaks \
    --no-replaces --no-enhances calculix-ccx | grep -E '^[a-z]' |
    grep -vE '^(libc6|libgcc-s1|gcc-12-base|libcrypt1|debconf|dpkg|tar|install-info)' | sort -u)
  (cd "$folder" && apt-get download "calculix-ccx=$version" $(grep -vx calculix-ccx <<<"$packages") \
    >download.log 2>&1) || give_up "apt-get download failed"
  for package in "$folder"/*.deb; do dpkg -x "$package" "$folder/root"; done
  LD_LIBRARY_PATH=$(find "$folder/root" -name '*.so*' -printf '%h\n' | sort -u | paste -sd:)
  export LD_LIBRARY_PATH OMP_NUM_THREADS=1
}

# write_deck ANGLE: the brick shrinks, then turns by so many degrees.
write_deck() {
  cat <<DECK
*NODE,NSET=NALL
1,0,0,0
2,1,0,0
3,1,0.2,0
4,0,0.2,0
5,0,0,0.2
6,1,0,0.2
7,1,0.2,0.2
8,0,0.2,0.2
*ELEMENT,TYPE=C3D8,ELSET=BRICK
1,1,2,3,4,5,6,7,8
*MATERIAL,NAME=M
*ELASTIC
1000,0.
*EXPANSION,ZERO=0
-0.1
*SOLID SECTION,ELSET=BRICK,MATERIAL=M
*BOUNDARY
1,1,3
5,1,2
*INITIAL CONDITIONS,TYPE=TEMPERATURE
NALL,0
*STEP,NLGEOM,INC=1000
*STATIC
0.05,1.,1e-5,0.05
*TEMPERATURE
NALL,1
*BOUNDARY
4,1,1,0
4,2,2,-0.02
*END STEP
*STEP,NLGEOM,INC=1000
*STATIC
0.02,1.,1e-5,0.02
*BOUNDARY
$(awk -v angle="$1" 'BEGIN { a = angle * atan2(0, -1) / 180
  printf "4,1,1,%.10f\n4,2,2,%.10f\n", -0.18 * sin(a), 0.18 * cos(a) - 0.2 }')
*NODE PRINT,NSET=NALL,FREQUENCY=1000
U
*EL PRINT,ELSET=BRICK,FREQUENCY=1000
S
*END STEP
DECK
}

# length_at ANGLE: of the edge from node 1 to node 2, and the largest stress.
length_at() {
  write_deck "$1" >"$folder/brick.inp"
  (cd "$folder" && "$folder/root/usr/bin/ccx" brick >ccx.log 2>&1) || give_up "ccx failed, see its log: $(tail -3 "$folder/ccx.log")"
  awk '/displacements/ { part = "u" } /stresses/ { part = "s" }
    part == "u" && $1 == 2 && NF == 4 { u = $2; v = $3; w = $4 }
    part == "s" && NF == 8 { for (n = 3; n <= 8; ++n) { s = $n < 0 ? -$n : $n; if (s > most) most = s } }
    END { printf "%.4f %.2g", sqrt((1 + u) ^ 2 + v ^ 2 + w ^ 2), most }' "$folder/brick.dat"
}

install_calculix
lengths=()
for angle in 0 30 60; do
  read -r length stress <<<"$(length_at "$angle")"
  echo "turned by $angle degrees: $length long, largest stress $stress"
  lengths+=("$length")
done
# Seen: 0.9000, 0.9120 and 0.9454; stresses 2e-14, 5.3 and 19, where E x expansion is 100.
awk -v a="${lengths[0]}" -v b="${lengths[2]}" 'BEGIN { exit !(a > 0.899 && a < 0.901 && b > 0.93) }' ||
  { echo 'the behaviour has changed'; exit 1; }
