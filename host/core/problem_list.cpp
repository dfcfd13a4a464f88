#include "core/problem_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace morphgrid {

std::string toString(const Place& place) {
  if (place.line == 0) return place.source;
  return fmt::format("{}:{}:{}", place.source, place.line, place.column);
}

InputError errorAt(const Place& place, const std::string& what) {
  return InputError(place.source.empty() ? what : fmt::format("{}: {}", toString(place), what));
}

void ProblemList::add(Place place, std::string text) {
  problems_.push_back({std::move(place), std::move(text)});
}

void ProblemList::add(const InputError& error) { add(Place(), error.what()); }

void ProblemList::throwIfAny() const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  const auto order = [](const Problem& problem) {
    const Place& place = problem.place;
    const int rank = place.line > 0 ? 0 : !place.source.empty() ? 1 : 2;
    return std::tuple(rank, rank == 0 ? place.source : "", place.line, place.column);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Problem& a, const Problem& b) { return order(a) < order(b); });
  std::string text;
  for (const Problem& problem : sorted) {
    if (!text.empty()) text += '\n';
    text += errorAt(problem.place, problem.text).what();
  }
  throw InputError(text);
}

}  // namespace morphgrid
