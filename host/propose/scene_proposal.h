#pragma once
#include <functional>
#include <string>
#include <vector>

#include "design/grid_size.h"
#include "design/material.h"
#include "grid/shrink.h"
#include "layout/sheet_figures.h"
#include "propose/sight.h"
#include "target/target.h"
#include "target/target_request.h"

namespace morphgrid {

/// What a user says about a design besides the mesh.
struct ProposalRequest {
  std::filesystem::path mesh;
  /// Of the box's longer side in mm, > 0; where it is left out 100, and prints as large as fits.
  std::optional<double> size{};
  int nodesLong = 20;             ///< >= 4
  ShrinkRange shrink{0.02, 0.4};  ///< Of the material.
  bool isPapers = false;          ///< Springs and lengths by formula, as in the paper.
  /// Of a printer and of what `shrink` comes from, for the scene's [print]; both or none.
  std::filesystem::path printerFile{};
  std::filesystem::path materialFile{};
};

/// How a candidate's grid came out, by geometry alone.
struct DesignTrial {
  std::string failure;   ///< Why there is no design; empty where there is one.
  SheetFigures sheet{};  ///< Only of Layout::conformal.
  NetQuality net{};
};

/// Designs, simulates nothing. Throws Cancelled where that is requested, nothing else.
using TryDesign =
    std::function<DesignTrial(const MeshRequest&, const std::shared_ptr<const Target>&,
                              const DesignRequest&, const MaterialRequest&)>;

/// A candidate, in words, and what was found.
struct TriedCandidate {
  std::string what;
  std::string outcome;
};

/// How the mesh is moved: turned, then its `center` brought to the origin, then scaled.
struct Placement {
  Sight sight;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< Of what was turned.
  double scale = 1;

  Eigen::Affine3d worldFromMesh() const;
};

/// A scene for a mesh about which nobody has said anything, and why it is so.
struct SceneProposal {
  ProposalRequest request;
  Placement placement;
  /// Its box is there; its files are not, but for the mesh.
  MeshRequest surface;
  DesignRequest design;
  MaterialRequest material;
  double share = 0;    ///< Of the mesh's area that lies in the box.
  double slope = 0;    ///< The steepest that the box was chosen for.
  int triangles = 0;   ///< Of the mesh as loaded.
  TriangleMesh look;   ///< The mesh, coarsened().
  SamplingBox seen{};  ///< The box on the mesh that was turned, but neither moved nor scaled.
  DesignTrial trial;
  std::vector<SightRating> sights;    ///< The best first.
  std::vector<TriedCandidate> tried;  ///< Those before the one that was chosen, and it.
};

}  // namespace morphgrid
