#include "report/explain_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace morphgrid {
namespace {

struct RowMeaning {
  const char* label;  ///< As the row begins, without what follows a name that varies.
  const char* meaning;
};

/// In the order of the table. "Eq." are equations of the paper.
constexpr RowMeaning kRowMeanings[] = {
    {"triangles", "of the mesh"},
    {"rays, missed", "rays that sampled the mesh along +x, and those that met nothing"},
    {"steepest step", "in x between neighbouring rays, over their distance"},
    {"mesh spans", "the mesh's extent, in the scene's unit of length"},
    {"a box without holes:", "a box of rays that all meet the mesh"},
    {"longest isolines, u x v", "lengths of the longest curves along u and v on the target"},
    {"largest curvature", "of those curves, 1 / radius"},
    {"layer spacing at most", "thicker, a strut would shrink by more than it can (Eq. 21)"},
    {"fewest nodes", "fewer, struts would be too long for the curvature (Eq. 23)"},
    {"curvature noise",
     "how much of the curvature is roughness of the mesh: where it is much of the largest, "
     "subdivisions or surface.smoothing_width help"},
    {"nodes, u x v", "struts of a layer along u and v"},
    {"layers, spacing", "layers, and the distance of neighbouring ones (tau in the paper)"},
    {"model", "what a strut is to the solver: the paper's spring, a bar, or a frame's welded bar"},
    {"vertices, struts", "of the grid"},
    {"largest L_b shrink",
     "L_b is a strut's rest length on the side that shrinks, L0 on the side that keeps the "
     "surface's lengths: by how much L_b is below L0 at most"},
    {"net", "how the grid's lines run over the target"},
    {"modulus, blend",
     "modulus: height over width of the rectangle that the target maps to; blend: share of the "
     "isolines that design.max_strut_ratio mixed in, 0 to 1"},
    {"longest / shortest", "strut of the net"},
    {"off 90 deg, mean / max", "by how much the lines cross at other than right angles"},
    {"sheet", "the flat sheet as laid out, in the scene's unit of length"},
    {"angle off, mean / max", "between the sheet's angles and the target's"},
    {"twist, mean / max", "by how much layers turn against each other at a joint"},
    {"scale varies by", "largest over smallest enlargement of the sheet against the target"},
    {"struts out of range", "whose shrink the sheet cannot bring within the material's"},
    {"curvature cutoff",
     "p is the share of measured curvatures that stay as they are (grid.curvature_cutoff = p); "
     "stronger ones count as the largest of these. What each p would mean:"},
    {"suggested p", "the largest cutoff that keeps the layer spacing and nodes asked for"},
    {"L0 error", "how far struts of the side that keeps its lengths end from rest, on average"},
    {"L_b error", "the same of the side that shrinks"},
    {"angle error", "how far corners end from 90 degrees, on average"},
    {"distance, RMS / max",
     "of the morphed middle layer from the target's points of the same parameters, in % of the "
     "target's diagonal: whether the shape is right"},
    {"to closest point", "the same to the target's closest points"},
    {"largest shrink", "share of its printed length that a strut has to lose at most"},
    {"largest strain", "of a lateral strut at rest: its length over its rest length, less 1"},
    {"struts over the limit", "that have to lose more than grid.max_shrinkage"},
    {"weight", "of the grid"},
    {"sags by", "how far weight moves the joint that it moves most"},
    {"struts at the limit", "that shrink by just grid.max_shrinkage"},
    {"struts that must grow",
     "which only materials do that grow across their lines: else bend less"},
    {"struts under the least", "that shrink by less than material.least_shrinkage"},
    {"inverted cells", "that lie face down in the result: it folds instead of bending"},
    {"collapsed cells", "whose area is next to nothing"},
    {"self-intersecting cells", "that pass through another"},
    {"struts too close", "closer to another than grid.strut_thickness"},
    {"layout:", "the flat sheet is laid out"},
    {"in plane:", "one layer of square cells comes to rest in its plane: the sheet to print"},
    {"full:",
     "all layers come to rest in space. Energy is what the struts still store (0: no stress), "
     "residual what force is left, over a strut's stiffness and length"},
    {"printed", "the sheet was enlarged so that every strut shrinks within the material's range"},
    {"inverse design:",
     "lengths changed step by step to bring the simulated grid to the target; distance RMS / max "
     "from the first to the last"},
    {"its end:", "where the grid rests with the final lengths; iterations are of the last step"},
    {"check from flat:", "whether the sheet gets to that shape by itself, from flat"},
    {"minimum:", "no small motion lowers the energy: the grid stays there"},
    {"saddle:", "some motion lowers the energy: the grid leaves by itself"},
    {"undecided:", "the smallest eigenvalue is too close to 0 to tell a minimum from a saddle"},
};

std::string_view trimmed(std::string_view line) {
  const auto begin = line.find_first_not_of(' ');
  return begin == line.npos ? std::string_view() : line.substr(begin);
}

bool isRowOf(std::string_view row, std::string_view label) {
  if (!row.starts_with(label)) return false;
  return row.size() == label.size() || row[label.size()] == ' ';
}

bool hasRow(std::string_view table, std::string_view label) {
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = std::min(table.find('\n', begin), table.size());
    if (isRowOf(trimmed(table.substr(begin, end - begin)), label)) return true;
    begin = end + 1;
  }
  return false;
}

}  // namespace

std::string explainTable(const std::string& table) {
  const std::string rows = table.substr(table.find('\n') + 1);  // The first line is the title.
  std::string text = "What the rows mean:\n";
  for (const auto& [label, meaning] : kRowMeanings) {
    if (hasRow(rows, label)) text += fmt::format("  {}\n      {}\n", label, meaning);
  }
  return text;
}

}  // namespace morphgrid
