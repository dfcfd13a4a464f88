#pragma once
#include <string>
#include <string_view>

namespace morphgrid {

/// A state file of these bytes, with a length and a checksum that are right: what a reader sees who
/// gets past them. input: the header, a line break, the arrays without the checksum.
std::string framedState(std::string_view input);

/// Reads such a file. Throws std::logic_error when readState() breaks its word: a state whose sizes
/// do not fit together or that holds what is no number, an error that is not one short line.
void readFuzzedState(std::string_view input);

}  // namespace morphgrid
