// Writes the tables of keys into docs/scene_format.md and docs/printing_format.md.
#include <cstdio>

#include "app/print_document.h"
#include "app/scene_document.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/read_file.h"

namespace {

void rewrite(const char* document, std::string (*withKeys)(std::string)) {
  morphgrid::writeFileAtomically(document, withKeys(morphgrid::readFile(document)));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: write_scene_format SCENE_FORMAT PRINTING_FORMAT\n");
    return 2;
  }
  try {
    rewrite(argv[1], morphgrid::withSceneKeys);
    rewrite(argv[2], morphgrid::withPrintKeys);
  } catch (const morphgrid::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
