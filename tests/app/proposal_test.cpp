#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/list_levers.h"
#include "app/proposal_text.h"
#include "app/try_design.h"
#include "propose/propose_scene.h"
#include "tests/propose/bowls.h"
#include "tests/support/shared_folder.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// z = 0.3 (x^2 - y^2), z up, as modellers export it.
TriangleMesh zUpSaddle() {
  return heights(16, [](double x, double y) { return 0.3 * (x * x - y * y); });
}

/// The upper half of a sphere, up to 84 degrees, seen from above along +x.
TriangleMesh steepDome() {
  TriangleMesh mesh = heights(40, [](double, double) { return 0; });
  for (auto v : mesh.vertices.colwise()) {
    const double across = std::max(std::abs(v.x()), std::abs(v.y()));
    const double angle = across * 1.47;
    const Eigen::Vector2d way = v.head<2>().norm() > 0 ? v.head<2>().normalized() : v.head<2>();
    v = Eigen::Vector3d(-std::cos(angle), way.x() * std::sin(angle), way.y() * std::sin(angle));
  }
  return mesh;
}

class ProposedScene {
 public:
  explicit ProposedScene(const TriangleMesh& mesh, bool isPapers = false)
      : proposal_(proposeScene({.mesh = folder_.write("m.obj", toObj(mesh)), .isPapers = isPapers},
                               tryDesign)) {
    folder_.write("mesh.toml", proposalMeshText(proposal_, "m.obj"));
    scene_ = loadScene(folder_.write("m.toml", proposalSceneText(proposal_, "mesh.toml")));
  }

  const SceneProposal& proposal() const { return proposal_; }
  const Scene& scene() const { return scene_; }

 private:
  TemporaryFolder folder_;
  SceneProposal proposal_;
  Scene scene_;
};

/// What loadScene() makes of keys that are left out is not in a proposal.
void expectSame(const Scene& scene, const SceneProposal& proposal) {
  const auto& surface = std::get<MeshRequest>(scene.surface);
  EXPECT_EQ(surface.box, proposal.surface.box);
  EXPECT_EQ(surface.fillHoles, proposal.surface.fillHoles);
  const MeshConfiguration& read = surface.configuration;
  const MeshConfiguration& written = proposal.surface.configuration;
  EXPECT_EQ(read.subdivisions, written.subdivisions);
  EXPECT_TRUE(read.worldFromMesh.isApprox(written.worldFromMesh, 1e-14));
  EXPECT_TRUE(std::filesystem::equivalent(read.mesh, written.mesh));
  DesignRequest design = scene.design;
  design.maxStrain = proposal.design.maxStrain;
  EXPECT_EQ(design, proposal.design);
  EXPECT_EQ(scene.material, proposal.material);
}

TEST(ProposalText, PrintsAtTheSizeThatIsAskedFor) {
  SceneProposal proposal = ProposedScene(bowl(6)).proposal();
  proposal.request.printerFile = "printer.toml";
  proposal.request.materialFile = "material.toml";
  EXPECT_THAT(proposalSceneText(proposal, "mesh.toml"), HasSubstr("\n# scale = 1 #"));
  proposal.request.size = 60;
  EXPECT_THAT(proposalSceneText(proposal, "mesh.toml"), HasSubstr("\nscale = 1 #"));
}

TEST(ProposalText, ReadsBackAsTheProposal) {
  const Eigen::Quaterniond tilt(0.8, 0.3, -0.4, 0.2);
  for (const TriangleMesh& mesh : {zUpSaddle(), turned(tilt.normalized(), bowl(6))}) {
    const ProposedScene proposed(mesh);
    expectSame(proposed.scene(), proposed.proposal());
    EXPECT_NO_THROW(designScene(proposed.scene()));
  }
}

TEST(ProposalText, OfThePapersDesignReadsBackToo) {
  const ProposedScene proposed(bowl(), true);
  expectSame(proposed.scene(), proposed.proposal());
  EXPECT_EQ(proposed.scene().material.model, Model::paper);
  EXPECT_EQ(proposed.scene().design.compensateRounds, 0);
}

TEST(ProposalText, HasMeshesFarFromTheOriginAtIt) {
  const TriangleMesh far =
      transformed(Eigen::Affine3d(Eigen::Translation3d(452310.25, 5412345.5, 600)), bowl());
  const ProposedScene proposed(far);
  expectSame(proposed.scene(), proposed.proposal());
  EXPECT_LT(std::abs(proposed.scene().surface.index() == 1
                         ? std::get<MeshRequest>(proposed.scene().surface).box->uStart
                         : 1e9),
            51);
}

TEST(ProposalSummary, NamesTheSides) {
  const ProposedScene proposed(zUpSaddle());
  EXPECT_THAT(proposalSummary(proposed.proposal()),
              AllOf(StartsWith("seen along -z: 9"), HasSubstr("along +z 100 %"),
                    HasSubstr("orthogonal net")));
}

/// A scene of a mesh as it is, in its box.
Scene plainScene(const TemporaryFolder& folder, const TriangleMesh& mesh, const char* box) {
  folder.write("m.obj", toObj(mesh));
  return loadScene(
      folder.write("plain.toml",
                   std::string("[surface]\nkind = \"mesh\"\nmesh = \"m.obj\"\n") + box +
                       "[grid]\nlayer_spacing = 0.01\nnodes_long = 10\ncurvature_cutoff = 0.95\n"));
}

TEST(MeshSides, NameTheTransformOfASideThatShowsMore) {
  const TemporaryFolder folder;
  const MeshSides sides = lookAtMesh(plainScene(folder, zUpSaddle(), ""));
  EXPECT_THAT(
      adviseOnSides(sides.sights),
      Contains(HasSubstr("{rotate = {axis = [0, 1, 0], degrees = -90}}, or from behind with "
                         "degrees = 90")));
  const MeshSides along =
      lookAtMesh(plainScene(folder,
                            turned(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(),
                                                                      -Eigen::Vector3d::UnitX()),
                                   zUpSaddle()),
                            ""));
  EXPECT_THAT(adviseOnSides(along.sights), IsEmpty());
}

TEST(Levers, AreTheOtherNetAndAGentlerBox) {
  const TemporaryFolder folder;
  const Scene scene = plainScene(
      folder, steepDome(), "u_start = -0.69\nv_start = -0.69\nu_length = 1.38\nv_length = 1.38\n");
  const auto levers = listLevers(scene, designScene(scene));
  EXPECT_THAT(levers, Contains(StartsWith("design.net = \"orthogonal\" leaves corners ")));
  EXPECT_THAT(levers, Contains(AllOf(StartsWith("a box without slopes beyond "),
                                     HasSubstr("\nu_start = -0."))));
}

TEST(Levers, AreSubdivisionsOfAFacetedMesh) {
  const TemporaryFolder folder;
  const Scene scene =
      plainScene(folder, turned(Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5), bowl(6)),
                 "u_start = -0.9\nv_start = -0.9\nu_length = 1.8\nv_length = 1.8\n");
  EXPECT_THAT(listLevers(scene, designScene(scene)), Contains(HasSubstr("subdivisions = 2")));
}

TEST(SharedCases, AreProposedFor) {
  const auto shared = sharedFolder();
  if (!shared) GTEST_SKIP() << "no shared folder";
  for (const char* mesh :
       {"cases/ledge_suggested_box/hood.obj", "cases/seam_suggested_box/roof.obj",
        "cases/utm_suggested_box/terrain.obj", "cases/net_and_gentle_box_hint/dome.obj",
        "cases/fill_holes_box/scan.obj", "cases/saddle_z_up/saddle.obj",
        "cases/mesh_named_directly/bowl.obj"}) {
    const SceneProposal proposal = proposeScene({.mesh = *shared / mesh}, tryDesign);
    EXPECT_GT(proposal.share, 0.35) << mesh;
    EXPECT_TRUE(proposal.trial.failure.empty()) << mesh;
  }
}

}  // namespace
}  // namespace morphgrid
