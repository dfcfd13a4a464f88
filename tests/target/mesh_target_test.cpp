#include "target/mesh_target.h"

#include <gmock/gmock.h>

#include <chrono>

#include "core/error.h"
#include "tests/support/height_field.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const Place kPlace{"scene.toml", 4, 11};

class MeshOnDisk : public testing::Test {
 protected:
  MeshRequest request(const std::string& obj) const {
    MeshRequest request;
    request.configuration = {folder_.write("m.obj", obj), Eigen::Affine3d::Identity(), 21, 21, 0};
    request.box = SamplingBox{-1, -1, 2, 2};
    request.boxPlace = kPlace;
    return request;
  }
  static std::string problemOf(const MeshRequest& request) {
    try {
      loadMeshTarget(request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(MeshOnDisk, IsLoadedAndSurveyed) {
  const auto target = loadMeshTarget(request(heightFieldObj(dome)));
  ASSERT_TRUE(target->meshSampling());
  EXPECT_EQ(target->meshSampling()->mesh.triangles.cols(), 800);
  EXPECT_EQ(target->meshSampling()->hits.countU, 21);
  EXPECT_NEAR(target->survey().longestIsolineU, 2.052, 0.002);  // A parabola: y^2 / 5.
  EXPECT_TRUE(target->curvatureNoise());
  EXPECT_EQ(target->view().direction, kMeshView.direction);
}

TEST_F(MeshOnDisk, IsMovedAndSubdividedAsItsConfigurationAsks) {
  MeshRequest moved = request(heightFieldObj(dome));
  moved.configuration.worldFromMesh = Eigen::Translation3d(10, 0, 0);
  moved.configuration.subdivisions = 1;
  moved.box = SamplingBox{-0.9, -0.9, 1.8, 1.8};  // Loop subdivision rounds the corners.
  const auto target = loadMeshTarget(moved);
  EXPECT_EQ(target->meshSampling()->mesh.triangles.cols(), 3200);
  EXPECT_NEAR(target->sampler({})->points(isolineNet(2, 2)).at(1, 1).x(), 10, 0.01);
}

TEST_F(MeshOnDisk, TellsHowItWasLoaded) {
  EXPECT_THAT(loadMeshTarget(request(heightFieldObj(dome)))->notices(), testing::IsEmpty());
  MeshRequest odd =
      request(heightFieldObj(dome) + "f 1 2\nv 5 0 0\nv 5 0 1\nf 200 201 442\nf 200 201 443\n");
  odd.configuration.subdivisions = 1;
  odd.box = SamplingBox{-0.9, -0.9, 1.8, 1.8};
  const std::string file = odd.configuration.mesh.string();
  EXPECT_THAT(
      loadMeshTarget(odd)->notices(),
      testing::ElementsAre(
          file + ": passed over 1 face of fewer than three corners",
          StartsWith(file + ": cut open before Loop subdivision along 1 edge of more than")));
}

TEST_F(MeshOnDisk, CountsTheRaysOfEachDesignApart) {
  const auto target = loadMeshTarget(request(heightFieldObj(dome)));
  for (int design = 0; design < 2; ++design) {
    const auto sampler = target->sampler({});
    sampler->points(isolineNet(8, 4));
    EXPECT_EQ(sampler->meshFigures()->rays, 21 * 21 + 9 * 5);
    EXPECT_EQ(sampler->meshFigures()->missed, 0);
  }
}

TEST_F(MeshOnDisk, KnowsWhatIsClosest) {
  const auto target = loadMeshTarget(request(heightFieldObj([](double, double) { return 1.0; })));
  EXPECT_NEAR(target->closestPoints().distance({3, 0.2, 0.3}), 2, 1e-6);
}

TEST_F(MeshOnDisk, WithoutABoxIsToldWithOneToStartFrom) {
  MeshRequest without = request(heightFieldObj(dome));
  without.box.reset();
  EXPECT_THAT(problemOf(without),
              AllOf(StartsWith("scene.toml:4:11: surface.u_start, v_start, u_length and v_length "
                               "are missing: the box that rays sample; the mesh spans u -1 to 1"),
                    HasSubstr("a box without holes:\nu_start = -0.99")));
}

TEST_F(MeshOnDisk, WhatRaysMissIsToldWithTheBox) {
  MeshRequest beside = request(heightFieldObj(dome));
  beside.box->uStart = 0;
  EXPECT_THAT(problemOf(beside), AllOf(StartsWith("scene.toml:4:11: "), HasSubstr("rays miss ")));
}

TEST_F(MeshOnDisk, ThatIsBrokenIsToldWithItsFile) {
  EXPECT_THAT(problemOf(request("v 0 0 0\nf 1 2 3\n")), StartsWith((folder_ / "m.obj").string()));
}

TEST_F(MeshOnDisk, ThatIsMovedTooFarIsToldWithItsFile) {
  MeshRequest far = request(heightFieldObj(dome));
  far.configuration.worldFromMesh = Eigen::Scaling(1e17);
  EXPECT_EQ(problemOf(far), (folder_ / "m.obj").string() +
                                ": each coordinate must be a number >= -1e+15 and <= 1e+15 once "
                                "transforms are done, got -1e+17");
}

TEST_F(MeshOnDisk, IsOutdatedOnceItsFileChanges) {
  const auto target = loadMeshTarget(request(heightFieldObj(dome)));
  EXPECT_FALSE(target->isOutdated());
  const auto file = folder_ / "m.obj";
  std::filesystem::last_write_time(
      file, std::filesystem::last_write_time(file) + std::chrono::seconds(1));
  EXPECT_TRUE(target->isOutdated());
}

TEST_F(MeshOnDisk, RaysAskWhetherToGoOn) {
  const MeshRequest dome20 = request(heightFieldObj(dome));
  const Cancellation cancelled([] { return true; });
  EXPECT_THROW(loadMeshTarget(dome20, cancelled), Cancelled);
  EXPECT_THROW(loadMeshTarget(dome20)->sampler(cancelled)->points(isolineNet(8, 4)), Cancelled);
}

TEST(MeshRequest, DiffersByEachOfItsSettings) {
  const MeshRequest plain;
  EXPECT_EQ(plain, MeshRequest());
  for (const auto& change : std::vector<std::function<void(MeshRequest&)>>{
           [](MeshRequest& r) { r.file = "m.toml"; },
           [](MeshRequest& r) { r.configuration.mesh = "m.obj"; },
           [](MeshRequest& r) { r.configuration.worldFromMesh.translation().x() = 1; },
           [](MeshRequest& r) { r.configuration.samplesU = 4; },
           [](MeshRequest& r) { r.configuration.samplesV = 4; },
           [](MeshRequest& r) { r.configuration.subdivisions = 1; },
           [](MeshRequest& r) {
             r.box = SamplingBox{0, 0, 1, 1};
           },
           [](MeshRequest& r) { r.boxPlace.line = 3; }, [](MeshRequest& r) { r.fillHoles = 1; },
           [](MeshRequest& r) { r.steepestSlope = 1; },
           [](MeshRequest& r) { r.smoothingWidth = 1; }}) {
    MeshRequest changed;
    change(changed);
    EXPECT_FALSE(changed == plain);
  }
}

}  // namespace
}  // namespace morphgrid
