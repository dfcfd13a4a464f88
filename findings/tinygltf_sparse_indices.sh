#!/usr/bin/env bash
# tinygltf 2.7.0 (Debian 12's libtinygltf-dev 2.7.0+dfsg-2) and two things that glTF 2.0 leaves optional.
#
# 1. An accessor without a buffer view holds zeros, over which its sparse values are laid. tinygltf reads such an
#    accessor where it holds positions, but refuses the whole file where it holds the indices of a primitive:
#    "accessor[1] invalid bufferView".
# 2. A skin without inverseBindMatrices has identities. tinygltf puts an error into its error string, yet returns success
#    and a model: who looks at the string refuses a valid file, who looks at the result is told nothing.
#
# Downloads the package from Debian's archive into a temporary folder, and needs g++ and nlohmann-json3-dev's header,
# which it downloads too. Exits 0 while the behaviour is as seen, 1 when it has changed, 2 when it cannot be tried.
set -euo pipefail

version=2.7.0+dfsg-2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

give_up() {
  echo "cannot be tried: $*" >&2
  exit 2
}

install_tinygltf() {
  (cd "$folder" && apt-get download "libtinygltf-dev=$version" "libtinygltf2d=$version" nlohmann-json3-dev \
    >download.log 2>&1) || give_up "apt-get download failed"
  for package in "$folder"/*.deb; do dpkg -x "$package" "$folder/root"; done
  command -v g++ >/dev/null || give_up "g++ is missing"
}

# A triangle at (1, 0, 0), (0, 1, 0), (0, 0, 1): positions, then sparse places 0 1 2 and indices 0 1 2 as bytes.
write_files() {
  local positions=AACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/ bytes=AAECAA==
  cat >"$folder/indices.gltf" <<GLTF
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,$positions"},
             {"byteLength": 4, "uri": "data:application/octet-stream;base64,$bytes"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 1, "byteLength": 4}],
 "accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
  {"componentType": 5121, "count": 3, "type": "SCALAR", "sparse": {"count": 3,
   "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 1}}}]}
GLTF
  cat >"$folder/positions.gltf" <<GLTF
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,$positions"},
             {"byteLength": 4, "uri": "data:application/octet-stream;base64,$bytes"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 1, "byteLength": 4}],
 "accessors": [{"componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1],
  "sparse": {"count": 3, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}}}]}
GLTF
  cat >"$folder/skin.gltf" <<GLTF
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}], "nodes": [{"mesh": 0, "skin": 0}, {}],
 "skins": [{"joints": [1]}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,$positions"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
  {"componentType": 5121, "count": 3, "type": "VEC4"}, {"componentType": 5126, "count": 3, "type": "VEC4"}]}
GLTF
}

read_files() {
  cat >"$folder/read.cpp" <<'CPP'
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include <iostream>

int main(int count, char** files) {
  for (int n = 1; n < count; ++n) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader([](auto...) { return true; }, nullptr);
    tinygltf::Model model;
    std::string error, warning;
    const bool read = loader.LoadASCIIFromFile(&model, &error, &warning, files[n]);
    while (!error.empty() && error.back() == '\n') error.pop_back();
    std::cout << files[n] << ": " << (read ? "read" : "refused") << ", error \"" << error << "\"\n";
  }
}
CPP
  g++ -std=c++17 "-I$folder/root/usr/include" "$folder/read.cpp" -o "$folder/read" 2>"$folder/build.log" ||
    give_up "$(head -n 3 "$folder/build.log")"
  (cd "$folder" && ./read positions.gltf indices.gltf skin.gltf)
}

install_tinygltf
write_files
seen=$(read_files)
expected="positions.gltf: read, error \"\"
indices.gltf: refused, error \"accessor[1] invalid bufferView\"
skin.gltf: read, error \"'inverseBindMatrices' property is missing in Skin.\""
printf '%s\n' "$seen"
[[ $seen == "$expected" ]] || {
  echo "changed; expected was:" >&2
  printf '%s\n' "$expected" >&2
  exit 1
}
