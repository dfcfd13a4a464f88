// Writes the tables of keys into docs/scene_format.md.
#include <cstdio>

#include "app/scene_document.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/read_file.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_scene_format DOCUMENT\n");
    return 2;
  }
  try {
    morphgrid::writeFileAtomically(argv[1], morphgrid::withSceneKeys(morphgrid::readFile(argv[1])));
  } catch (const morphgrid::InputError& error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
    return 2;
  }
}
