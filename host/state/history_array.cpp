#include "state/history_array.h"

#include "state/state_format.h"

namespace morphgrid {
namespace {

constexpr std::size_t kSampleNumbers = 5;

}  // namespace

void addHistory(ArrayList& arrays, const std::string& name,
                const std::vector<ConvergenceSample>& history) {
  std::vector<double> values;
  values.reserve(kSampleNumbers * history.size());
  for (const ConvergenceSample& sample : history) {
    values.insert(values.end(), {static_cast<double>(sample.iteration), sample.energy,
                                 sample.residual, sample.seconds, sample.gridShare});
  }
  arrays.addMade(name, {history.size(), kSampleNumbers}, std::move(values));
}

std::vector<ConvergenceSample> readHistory(const ArrayReader& reader, const std::string& name) {
  const std::size_t count = reader.rowCount(name, kSampleNumbers);
  const std::vector<double> values = reader.bare(name, {count, kSampleNumbers});
  std::vector<ConvergenceSample> history;
  history.reserve(count);
  for (auto at = values.begin(); at != values.end(); at += kSampleNumbers) {
    const long iteration = reader.integer(at[0], 0, kLargestExactInteger);
    history.push_back({iteration, at[1], at[2], at[3], at[4]});
  }
  return history;
}

}  // namespace morphgrid
