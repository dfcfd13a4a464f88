#include "propose/propose_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "surface/ray_hits.h"
#include "target/mesh_target.h"
#include "tests/propose/bowls.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

/// Every design is good.
DesignTrial accept(const MeshRequest&, const std::shared_ptr<const Target>&, const DesignRequest&,
                   const MaterialRequest&) {
  return {.sheet = {.lateralStruts = 100}};
}

class Proposals : public testing::Test {
 protected:
  SceneProposal propose(const TriangleMesh& mesh, const TryDesign& tryDesign = accept) {
    return proposeScene({.mesh = folder_.write("m.obj", toObj(mesh))}, tryDesign);
  }
  TemporaryFolder folder_;
};

TEST_F(Proposals, ScaleTheBoxToWhatIsPrinted) {
  const SceneProposal proposal = propose(bowl());
  ASSERT_TRUE(proposal.surface.box);
  EXPECT_NEAR(proposal.surface.box->uLength, 100, 1);
  EXPECT_NEAR(proposal.surface.box->uStart, -50, 1);
  EXPECT_NEAR(proposal.surface.box->vStart, -50, 1);
  EXPECT_GT(proposal.share, 0.95);
  EXPECT_EQ(proposal.design.layers, 3);
  EXPECT_EQ(proposal.design.nodesLong, 20);
  EXPECT_NEAR(proposal.design.layerSpacing, 0.35 * 5, 0.4);
  EXPECT_EQ(proposal.material.model, Model::frame);
}

TEST_F(Proposals, HoldForRaysOfOtherCounts) {
  TriangleMesh holed = bowl(60);
  holed.triangles.col(3500).setConstant(0);  // Half of a cell is missing.
  const SceneProposal proposal = propose(holed);
  EXPECT_GT(proposal.share, 0.9);
  const auto target = loadMeshTarget(proposal.surface);
  for (const int nodes : {7, 12, 24, 33, 160}) {
    EXPECT_NO_THROW(target->sampler({})->points(isolineNet(nodes, nodes))) << nodes;
  }
}

TEST_F(Proposals, SmoothFlatFacetsOnly) {
  EXPECT_GT(propose(bowl(8)).surface.configuration.subdivisions, 0);
  EXPECT_EQ(propose(bowl(120)).surface.configuration.subdivisions, 0);
  const auto step = [](double x, double) { return x > 0 ? 0.5 : 0.0; };
  EXPECT_EQ(propose(heights(9, step)).surface.configuration.subdivisions, 0);
}

TEST_F(Proposals, TryTheOtherNetAndGentlerBoxes) {
  const auto gentleOnly = [](const MeshRequest& surface,
                             const std::shared_ptr<const Target>& target,
                             const DesignRequest& design, const MaterialRequest&) {
    const double jump = target->sampler({})->meshFigures()->largestJump;
    const bool isGood = jump < 0.5 && design.net == NetKind::orthogonal && surface.box;
    return DesignTrial{.failure = isGood ? "" : "too steep", .sheet = {.lateralStruts = 100}};
  };
  const SceneProposal proposal = propose(bowl(), gentleOnly);
  EXPECT_LE(proposal.slope, 0.6);
  EXPECT_EQ(proposal.design.net, NetKind::orthogonal);
  EXPECT_THAT(proposal.tried.front().outcome, HasSubstr("too steep"));
}

TEST_F(Proposals, TakeTheLeastBadWhereNoneIsGood) {
  const auto twisted = [](const MeshRequest&, const std::shared_ptr<const Target>&,
                          const DesignRequest& design, const MaterialRequest&) {
    return DesignTrial{.sheet = {.lateralStruts = 100,
                                 .strutsOutOfRange = design.net == NetKind::isoline ? 30 : 20}};
  };
  EXPECT_EQ(propose(bowl(), twisted).design.net, NetKind::orthogonal);
}

TEST_F(Proposals, SayWhatDidNotWork) {
  const auto refuse = [](const MeshRequest&, const std::shared_ptr<const Target>&,
                         const DesignRequest&, const MaterialRequest&) {
    return DesignTrial{.failure = "the sheet overlaps itself"};
  };
  try {
    propose(bowl(), refuse);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("m.obj: no design was possible; tried were"));
    EXPECT_THAT(error.what(), HasSubstr("along -z, slopes up to 20, isoline net"));
    EXPECT_THAT(error.what(), HasSubstr("the sheet overlaps itself"));
  }
}

TEST_F(Proposals, EndWhereNobodyWaitsForThem) {
  const auto mesh = folder_.write("m.obj", toObj(bowl()));
  EXPECT_THROW(proposeScene({.mesh = mesh}, accept, {Cancellation([] { return true; }), {}}),
               Cancelled);
}

}  // namespace
}  // namespace morphgrid
