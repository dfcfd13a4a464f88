#include "core/nearest_name.h"

#include <algorithm>

namespace morphgrid {

int editDistance(std::string_view from, std::string_view to) {
  const std::size_t rows = from.size() + 1, columns = to.size() + 1;
  std::vector<std::vector<int>> distance(rows, std::vector<int>(columns));
  for (std::size_t i = 0; i < rows; ++i) distance[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j < columns; ++j) distance[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i < rows; ++i) {
    for (std::size_t j = 1; j < columns; ++j) {
      const int replace = distance[i - 1][j - 1] + (from[i - 1] != to[j - 1]);
      int best = std::min({replace, distance[i - 1][j] + 1, distance[i][j - 1] + 1});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        best = std::min(best, distance[i - 2][j - 2] + 1);
      }
      distance[i][j] = best;
    }
  }
  return distance[rows - 1][columns - 1];
}

std::optional<std::string> nearestName(std::string_view word,
                                       const std::vector<std::string>& names) {
  constexpr std::size_t kLongestWord = 64;  // A longer one is no slip of the finger.
  if (word.size() > kLongestWord) return std::nullopt;
  std::optional<std::string> nearest;
  int best = std::max(1, (static_cast<int>(word.size()) + 1) / 3);
  for (const std::string& name : names) {
    const int distance = editDistance(word, name);
    if (distance < best || (distance == best && !nearest)) {
      nearest = name;
      best = distance;
    }
  }
  return nearest;
}

}  // namespace morphgrid
