#include <algorithm>
#include <span>

#include "report/report_json.h"
#include "state/history_array.h"
#include "state/run_state.h"
#include "state/state_format.h"

namespace morphgrid {
namespace {

/// The values of those struts that there are. struts: the array's shape.
std::vector<double> gather(const GridShape& shape, const std::vector<double>& values,
                           const ArrayShape& struts) {
  std::vector<double> gathered;
  gathered.reserve(elementCount(struts));
  for (std::size_t k = 0; k < struts[0]; ++k) {
    for (std::size_t j = 0; j < struts[1]; ++j) {
      const auto row = values.begin() + shape.index(0, static_cast<int>(j), static_cast<int>(k));
      gathered.insert(gathered.end(), row, row + static_cast<std::ptrdiff_t>(struts[2]));
    }
  }
  return gathered;
}

/// A value that all struts share is stored once.
void addStruts(ArrayList& arrays, const std::string& name, ArrayShape struts,
               std::vector<double> values) {
  const auto differs = [&](double value) { return value != values.front(); };
  if (!values.empty() && std::ranges::none_of(values, differs)) {
    values.erase(values.begin() + 1, values.end());
    struts = {1};
  }
  arrays.addMade(name, std::move(struts), std::move(values));
}

void addStruts(ArrayList& arrays, const std::string& name, const GridShape& shape,
               const StrutValues& values) {
  const StateShapes shapes(shape);
  addStruts(arrays, name + "_u", shapes.strutsU(), gather(shape, values.u, shapes.strutsU()));
  addStruts(arrays, name + "_v", shapes.strutsV(), gather(shape, values.v, shapes.strutsV()));
  addStruts(arrays, name + "_w", shapes.strutsW(), gather(shape, values.w, shapes.strutsW()));
}

void addGrid(ArrayList& arrays, const StrutGrid& grid) {
  arrays.add("spacing", grid.spacing);
  for (const TermWeight& weight : kTermWeights) {
    arrays.add(weightArray(weight), grid.weights.*weight.value);
  }
  arrays.add("printed_positions", StateShapes(grid.shape).points(), grid.positions);
  addStruts(arrays, "rest", grid.shape, grid.rest);
  addStruts(arrays, "stiffness", grid.shape, grid.stiffness);
}

/// All layers' struts along u or along v, as gather() gives them.
std::vector<double> joined(const std::vector<LateralField<double>>& layers,
                           const std::vector<double>& (LateralField<double>::*along)() const) {
  std::vector<double> values;
  for (const LateralField<double>& layer : layers) {
    values.insert(values.end(), (layer.*along)().begin(), (layer.*along)().end());
  }
  return values;
}

void addDesign(ArrayList& arrays, const GridDesign& design, const StrutGrid& grid) {
  using Field = LateralField<double>;
  const StateShapes shapes(grid.shape);
  const auto add = [&](const char* name, const ArrayShape& shape,
                       const std::vector<double>& values) {
    arrays.add(name, shape, std::span<const double>(values));
  };
  arrays.add("layer_spacing", design.layerSpacing);
  add("design_lengths_u", shapes.layerStrutsU(), design.lengths.allU());
  add("design_lengths_v", shapes.layerStrutsV(), design.lengths.allV());
  add("design_bend_angles_u", shapes.layerStrutsU(), design.bendAngles.allU());
  add("design_bend_angles_v", shapes.layerStrutsV(), design.bendAngles.allV());
  std::vector<double> restU = joined(design.rest, &Field::allU);
  std::vector<double> restV = joined(design.rest, &Field::allV);
  if (restU != gather(grid.shape, grid.rest.u, shapes.strutsU()) ||
      restV != gather(grid.shape, grid.rest.v, shapes.strutsV())) {
    arrays.addMade("design_rest_u", shapes.strutsU(), std::move(restU));
    arrays.addMade("design_rest_v", shapes.strutsV(), std::move(restV));
  }
}

void addResult(ArrayList& arrays, const RunState& state) {
  const StateShapes shapes(state.grid.shape);
  const RunRecord& record = state.record;
  arrays.add("in_plane_positions", shapes.layerPoints(), record.inPlane->positions);
  arrays.add("positions", shapes.points(), state.equilibrium().positions);
  if (const auto& rotations = state.equilibrium().rotations; rotations.cols() > 0) {
    arrays.add("joint_rotations", shapes.rotations(), rotations);
  }
  addHistory(arrays, "in_plane_history", record.inPlane->history);
  addHistory(arrays, "history", state.equilibrium().history);
  const Eigen::Matrix4d byRow = state.targetFromGrid.matrix().transpose();
  arrays.addMade("target_from_grid", {4, 4}, {byRow.data(), byRow.data() + byRow.size()});
  if (state.targets) {
    arrays.add("target_positions", shapes.layerPoints(), *state.targets);
  }
  if (state.angleErrors.size() > 0) {
    arrays.add("printed_angle_errors", shapes.layerVertices(), state.angleErrors);
  }
}

std::span<const std::uint8_t> flagsOf(const std::vector<char>& hit) {
  return {reinterpret_cast<const std::uint8_t*>(hit.data()), hit.size()};
}

void addSampling(ArrayList& arrays, const MeshSampling& sampling) {
  const auto& [mesh, hits] = sampling;
  const auto countU = static_cast<std::size_t>(hits.countU);
  const auto countV = static_cast<std::size_t>(hits.countV);
  arrays.add("mesh_vertices", {static_cast<std::size_t>(mesh.vertices.cols()), 3}, mesh.vertices);
  arrays.add("mesh_triangles", {static_cast<std::size_t>(mesh.triangles.cols()), 3},
             mesh.triangles);
  const SamplingBox& box = hits.box;
  arrays.addMade("ray_box", {4}, {box.uStart, box.vStart, box.uLength, box.vLength});
  arrays.add("ray_points", {countV, countU, 3}, hits.points);
  arrays.add("ray_hits", {countV, countU}, flagsOf(hits.hit));
}

}  // namespace

void writeState(const std::filesystem::path& file, const RunState& state) {
  ArrayList arrays;
  addGrid(arrays, state.grid);
  addDesign(arrays, state.design, state.grid);
  addResult(arrays, state);
  if (state.sampling) {
    addSampling(arrays, *state.sampling);
  }
  writeArrayFile(file, kStateFormat,
                 {{"program", state.program},
                  {"scene_file", state.sceneFile.string()},
                  {"scene", state.scene},
                  {"report", toJson(state.record)}},
                 arrays.all());
}

}  // namespace morphgrid
