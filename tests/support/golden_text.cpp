#include "tests/support/golden_text.h"

#include <fstream>
#include <iterator>

#include "tests/support/folders.h"

namespace morphgrid {

std::string readGolden(const std::string& name) {
  std::ifstream stream(sourceFolder() / "tests/golden" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string keepActual(const std::string& text, const std::string& name) {
  const auto actual = binaryFolder() / "golden" / name;
  std::filesystem::create_directories(actual.parent_path());
  std::ofstream(actual, std::ios::binary) << text;
  return "compare " + actual.string() + " with tests/golden/" + name +
         "; if this is how it should be, copy it there";
}

std::string differenceFromGolden(const std::string& text, const std::string& name) {
  return text == readGolden(name) ? "" : keepActual(text, name);
}

}  // namespace morphgrid
