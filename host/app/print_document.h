#pragma once
#include <string>

namespace morphgrid {

/// docs/printing_format.md with the tables of keys as printerKeys() and printMaterialKeys() have
/// them, between the lines that mark them. Throws InputError where those are missing.
std::string withPrintKeys(std::string document);

}  // namespace morphgrid
