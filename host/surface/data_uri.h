#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace morphgrid {

/// Whether a URI holds its content itself: `data:[media type][;parameters][;base64],content`.
bool isDataUri(std::string_view uri);

/// The content of such a URI (RFC 2397); nothing when it is malformed.
std::optional<std::string> decodeDataUri(std::string_view uri);

/// Text with `%20` and the like decoded; a % that no two digits follow stands for itself.
std::string decodePercent(std::string_view text);

}  // namespace morphgrid
