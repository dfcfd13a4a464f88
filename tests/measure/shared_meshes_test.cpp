// Scanned and modelled meshes of the shared folder, where there is one.
#include <gtest/gtest.h>

#include <ostream>

#include "measure/lattice_measurement.h"
#include "surface/load_mesh.h"
#include "surface/mesh_ray_caster.h"
#include "tests/support/shared_folder.h"

namespace morphgrid {
namespace {

/// Turned as meshes/SOURCES.md says for the face and the torso: x' = -z, y' = y, z' = x.
TriangleMesh turned(TriangleMesh mesh, double scale) {
  Eigen::Matrix3d turn;
  turn << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  return transformed(Eigen::Affine3d(scale * turn), std::move(mesh));
}

struct SharedMesh {
  const char* file;
  double scale;
  SamplingBox box;
  double curvatures[5];  ///< |kappa| at 50, 90, 95, 99 and 100 %, independently computed.
  double tolerance;      ///< Relative: quads can be split along either diagonal.
  double isolineU, isolineV;
};

std::ostream& operator<<(std::ostream& stream, const SharedMesh& mesh) {
  return stream << mesh.file;
}

class SharedMeshes : public testing::TestWithParam<SharedMesh> {};

TEST_P(SharedMeshes, HaveTheKnownCurvature) {
  const auto folder = sharedFolder();
  if (!folder) GTEST_SKIP() << "no shared meshes";
  const SharedMesh& known = GetParam();
  const TriangleMesh mesh = turned(loadMesh(*folder / "meshes" / known.file).mesh, known.scale);
  const PointLattice hits = MeshRayCaster(mesh).cast(known.box, 100, 100).lattice();
  const SurfaceSurvey survey = surveyLattice(hits, 0).survey;
  constexpr double kShares[] = {0.5, 0.9, 0.95, 0.99, 1};
  for (int n = 0; n < 5; ++n) {
    EXPECT_NEAR(curvatureAtCutoff(survey, kShares[n]), known.curvatures[n],
                known.tolerance * known.curvatures[n]);
  }
  EXPECT_NEAR(survey.longestIsolineU, known.isolineU, 1e-3 * known.isolineU);
  EXPECT_NEAR(survey.longestIsolineV, known.isolineV, 1e-3 * known.isolineV);
}

INSTANTIATE_TEST_SUITE_P(, SharedMeshes,
                         testing::Values(SharedMesh{"mediapipe_canonical_face.obj",
                                                    1,
                                                    {-6, -5.9, 12.5, 11.8},
                                                    {0.139, 1.61, 2.53, 5.49, 48.1},
                                                    0.005,
                                                    14.900,
                                                    16.947},
                                         SharedMesh{"mh_male_torso.obj",
                                                    10,
                                                    {7, -12.5, 57, 25},
                                                    {0.0565, 0.379, 0.592, 1.23, 4.52},
                                                    0.15,
                                                    62.614,
                                                    30.260}));

}  // namespace
}  // namespace morphgrid
