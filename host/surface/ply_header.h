#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "surface/text_reader.h"

namespace morphgrid {

enum class PlyFormat { ascii, binaryLittleEndian, binaryBigEndian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t byteCount(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> countType;  ///< Only for lists: the type of the count before the values.
};

/// A table: `rowCount` rows of all its properties.
struct PlyElement {
  std::string name;
  std::size_t rowCount;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;  ///< In the file's order.
};

/// Reads up to and with the line `end_header`. Throws InputError with the line.
PlyHeader readPlyHeader(TextReader& text);

}  // namespace morphgrid
