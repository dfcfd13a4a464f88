#pragma once
#include <string_view>

namespace morphgrid {

/// Reads a mesh file's bytes behind a letter for the format: o OBJ, s STL, p PLY, g glTF or GLB; a
/// capital has the mesh subdivided too. Throws std::logic_error when readMesh or subdivideLoop
/// break their word: a mesh without triangles, an index out of range, a coordinate that is not
/// finite, an error that does not name the file, a message that is not one short line.
void readFuzzedMesh(std::string_view input);

}  // namespace morphgrid
