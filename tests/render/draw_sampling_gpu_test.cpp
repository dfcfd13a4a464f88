#include "render/draw_sampling.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "core/error.h"
#include "render/sampling_layout.h"
#include "tests/render/pixels.h"
#include "tests/render/sample_samplings.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

const SamplingBox kBox{1, 1, 8, 6};  // Within the meshes of 10 x 8.
constexpr int kWidth = 401;
constexpr int kHeight = 301;  // Odd: no line runs between pixels.
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

double flat(double, double) { return 0; }
double dome(double y, double z) { return 0.1 * ((y - 5) * (y - 5) + (z - 4) * (z - 4)); }

bool isRed(const Pixel& pixel) { return pixel[0] > pixel[1] + 60 && pixel[1] < pixel[2] + 30; }
bool isBlue(const Pixel& pixel) { return pixel[2] > pixel[0] + 60; }
bool isOrange(const Pixel& pixel) { return pixel[0] > 180 && pixel[1] > pixel[2] + 60; }
bool isDark(const Pixel& pixel) { return *std::max_element(pixel.begin(), pixel.end()) < 110; }
bool isGrey(const Pixel& pixel) {
  const auto [least, most] = std::minmax_element(pixel.begin(), pixel.end());
  return *most - *least < 12 && *least > 110 && !isWhite(pixel);
}

auto countOf(const Image& image, bool (*has)(const Pixel&)) {
  const auto pixels = coloredPixels(image);
  return std::count_if(pixels.begin(), pixels.end(), has);
}

class SamplingPicture : public DeviceTest {
 protected:
  Image draw(const TriangleMesh& mesh, const RayHits& hits, int samples = 4) const {
    return drawSampling(device_, mesh, hits, frameRays(mesh, hits, kAspect), kWidth, kHeight,
                        samples);
  }
  /// The pixel that shows a point, where frameRays() looks.
  static Pixel pixelOfPoint(const Image& image, const TriangleMesh& mesh, const RayHits& hits,
                            const Eigen::Vector3d& point) {
    return pixelThrough(image, frameRays(mesh, hits, kAspect), point);
  }
  static Pixel pixelThrough(const Image& image, const Camera& camera,
                            const Eigen::Vector3d& point) {
    const glm::dvec2 place = pixelOf(image, camera, point);
    return pixelAt(image, static_cast<int>(place.x), static_cast<int>(place.y));
  }
};

TEST_F(SamplingPicture, ShowsBallsOnHitsAndLinesBetweenThem) {
  for (const auto& heights : {Heights(flat), Heights(dome)}) {
    const TriangleMesh mesh = heightMesh(heights, 10, 8, 60, 50);
    const RayHits hits = heightHits(heights, kBox, 9, 7);
    const Image image = draw(mesh, hits);
    for (int j = 0; j < 7; ++j) {
      for (int i = 0; i < 9; ++i) {
        const auto at = [&](double stepsU, double stepsV) {
          const double y = 1 + i + stepsU, z = 1 + j + stepsV;
          return pixelOfPoint(image, mesh, hits, {heights(y, z), y, z});
        };
        EXPECT_TRUE(isDark(at(0, 0)));
        EXPECT_TRUE(i == 8 || isRed(at(0.5, 0))) << "along u, " << i << ", " << j;
        EXPECT_TRUE(j == 6 || isBlue(at(0, 0.5))) << "along v, " << i << ", " << j;
        EXPECT_TRUE(i == 8 || j == 6 || isGrey(at(0.5, 0.5)));
      }
    }
    EXPECT_EQ(countOf(image, isOrange), 0);
  }
}

TEST_F(SamplingPicture, LinesAreCatmullRomSplines) {
  // They reproduce parabolas, also where they end.
  const auto parabola = [](double y, double) { return 0.25 * (y - 5) * (y - 5); };
  RayHits hits = heightHits(parabola, kBox, 9, 2);
  miss(hits, 5, 0);  // Two pieces, of five and of three hits.
  const Camera camera = frameAll(hits.points, {0, 0, 1}, kRayView.up, kAspect);
  const Image image = drawSampling(device_, speckAt({0, 5, 4}), hits, camera, kWidth, kHeight);
  for (double y = 1.25; y < 9; y += 0.25) {
    if (y != std::floor(y)) {
      const bool missing = y > 5 && y < 7;
      EXPECT_NE(isRed(pixelThrough(image, camera, {parabola(y, 1), y, 1})), missing) << y;
    }
  }
}

TEST_F(SamplingPicture, TwoHitsAreJoinedByAStraightLine) {
  const auto ramp = [](double y, double z) { return y + 2 * z; };
  const RayHits hits = heightHits(ramp, kBox, 2, 2);
  const TriangleMesh mesh = speckAt({5, 5, 4});
  const Image image = draw(mesh, hits);
  for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double y = 1 + 8 * t, z = 1 + 6 * t;
    EXPECT_TRUE(isRed(pixelOfPoint(image, mesh, hits, {ramp(y, 1), y, 1})));
    EXPECT_TRUE(isBlue(pixelOfPoint(image, mesh, hits, {ramp(9, z), 9, z})));
  }
}

TEST_F(SamplingPicture, MeshHidesWhatLiesBehindIt) {
  const TriangleMesh curtain = heightMesh([](double, double) { return -5.0; }, 10, 8, 1, 1);
  const Image image = draw(curtain, heightHits(flat, kBox, 9, 7));
  for (const auto& mark : {isRed, isBlue, isOrange, isDark}) {
    EXPECT_EQ(countOf(image, mark), 0);
  }
  EXPECT_GT(countOf(image, isGrey), kWidth * kHeight / 2);
}

TEST_F(SamplingPicture, MeshBehindHidesNothing) {
  const RayHits hits = heightHits(dome, kBox, 9, 7);
  const Image free = draw(speckAt({1, 5, 4}), hits);
  const TriangleMesh behind = heightMesh([](double, double) { return 4.0; }, 10, 8, 1, 1);
  const Image image = drawSampling(device_, behind, hits,
                                   frameRays(speckAt({1, 5, 4}), hits, kAspect), kWidth, kHeight);
  EXPECT_NEAR(countOf(image, isRed), countOf(free, isRed), 0.1 * countOf(free, isRed));
}

TEST_F(SamplingPicture, SurfaceDoesNotSwallowItsLines) {
  // Its facets lie in front of it.
  const auto bowl = [](double y, double z) { return -dome(y, z); };
  const RayHits hits = heightHits(bowl, kBox, 25, 19);
  const TriangleMesh mesh = heightMesh(bowl, 10, 8, 17, 13);
  const TriangleMesh speck = speckAt({1, 5, 4});
  const Camera camera = frameRays(mesh, hits, kAspect);
  const Image free = drawSampling(device_, speck, hits, camera, kWidth, kHeight);
  const Image image = drawSampling(device_, mesh, hits, camera, kWidth, kHeight);
  // The edges of lines mix with white or grey: only full colours compare.
  const auto full = [](const Pixel& pixel) { return pixel[0] > pixel[1] + 110; };
  EXPECT_GT(countOf(free, full), 500);
  EXPECT_GT(countOf(image, full), 0.97 * countOf(free, full));
}

TEST_F(SamplingPicture, MissedRaysAreMarkedAndInterruptTheLines) {
  const TriangleMesh mesh = heightMesh(flat, 10, 8, 20, 16);
  RayHits hits = heightHits(flat, kBox, 9, 7);
  miss(hits, 4, 3);
  const Image image = draw(mesh, hits);
  const auto at = [&](double y, double z) { return pixelOfPoint(image, mesh, hits, {0, y, z}); };
  EXPECT_TRUE(isOrange(at(5, 4)));
  for (const double step : {-0.5, 0.5}) {
    EXPECT_TRUE(isGrey(at(5 + step, 4)));
    EXPECT_TRUE(isGrey(at(5, 4 + step)));
    EXPECT_TRUE(isRed(at(5 + 3 * step, 4)));
    EXPECT_TRUE(isBlue(at(5, 4 + 3 * step)));
  }
}

TEST_F(SamplingPicture, NoHitShowsTheMeshAndMarks) {
  const TriangleMesh mesh = heightMesh(flat, 10, 8, 1, 1);
  RayHits hits = heightHits(flat, kBox, 3, 3);
  hits.hit.assign(9, 0);
  const Image image = draw(mesh, hits);
  EXPECT_EQ(countOf(image, isRed) + countOf(image, isBlue) + countOf(image, isDark), 0);
  for (const double y : {1, 5, 9}) {
    EXPECT_TRUE(isOrange(pixelOfPoint(image, mesh, hits, {0, y, 4})));
  }
  EXPECT_GT(countOf(image, isGrey), kWidth * kHeight / 2);
}

TEST_F(SamplingPicture, DegenerateMeshesAreDrawn) {
  TriangleMesh one = speckAt({0, 0, 0});
  one.vertices = Eigen::Matrix3d{{0, 0, 0}, {0, 10, 0}, {0, 0, 8}};
  const RayHits hits = heightHits(flat, kBox, 5, 4);
  EXPECT_TRUE(isGrey(pixelOfPoint(draw(one, hits), one, hits, {0, 2, 2})));

  one.vertices.col(2) = 2 * one.vertices.col(1);  // No area, in front of a ray.
  EXPECT_TRUE(isRed(pixelOfPoint(draw(one, hits), one, hits, {0, 2, 1})));
}

TEST_F(SamplingPicture, IsLitFromBothSides) {
  TriangleMesh mesh = heightMesh(dome, 10, 8, 20, 16);
  const RayHits hits = heightHits(dome, kBox, 5, 4);
  const Image image = draw(mesh, hits);
  mesh.triangles.row(1).swap(mesh.triangles.row(2));
  EXPECT_LT(differenceOf(image, draw(mesh, hits)).mean, 0.01);
}

TEST_F(SamplingPicture, LightShowsTheShape) {
  const TriangleMesh mesh = heightMesh(dome, 10, 8, 20, 16);
  const RayHits hits = heightHits(dome, kBox, 2, 2);
  const Image image = draw(mesh, hits);
  const auto brightnessAt = [&](double y, double z) {
    return pixelOfPoint(image, mesh, hits, {dome(y, z), y, z})[0];
  };
  EXPECT_GT(brightnessAt(8, 2), brightnessAt(2, 6) + 40) << "from above on the left";
}

TEST_F(SamplingPicture, ManyRaysStayLegible) {
  const TriangleMesh mesh = heightMesh(dome, 10, 8, 20, 16);
  const Image few = draw(mesh, heightHits(dome, kBox, 41, 31));
  RayHits hits = heightHits(dome, kBox, 1000, 1000);
  const Image many = draw(mesh, hits);
  EXPECT_GT(countOf(many, isGrey), 0.3 * kWidth * kHeight);
  EXPECT_GT(countOf(many, isRed), 1000);
  EXPECT_GT(countOf(many, isBlue), 1000);
  EXPECT_GT(countOf(few, isGrey), 0.3 * kWidth * kHeight);
  miss(hits, 487, 512);  // On no drawn isoline.
  const Image holed = draw(mesh, hits);
  EXPECT_GT(countOf(holed, isOrange), 5);
  EXPECT_LT(countOf(holed, isOrange), 50);
}

TEST_F(SamplingPicture, MillionTriangles) {
  const TriangleMesh mesh = heightMesh(dome, 10, 8, 1000, 500);
  const TriangleMesh coarse = heightMesh(dome, 10, 8, 100, 50);
  const RayHits hits = heightHits(dome, kBox, 9, 7);
  ASSERT_EQ(mesh.triangles.cols(), 1000000);
  EXPECT_LT(differenceOf(draw(mesh, hits), draw(coarse, hits)).mean, 1);
}

TEST_F(SamplingPicture, MeshBeyondTheDevicesLimitsIsRefused) {
  const auto most = static_cast<Eigen::Index>(device_.limits().maxStorageBufferRange / 12);
  if (most > 50'000'000) {
    GTEST_SKIP() << "this device draws " << most << " triangles";
  }
  TriangleMesh mesh = speckAt({0, 0, 0});
  mesh.triangles.setZero(3, most + 1);
  try {
    draw(mesh, heightHits(flat, kBox, 3, 3));
    FAIL() << "no error";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("draws at most " + std::to_string(most) +
                                   " triangles of a mesh, got " + std::to_string(most + 1)));
  }
}

TEST_F(SamplingPicture, DoesNotDependOnUnitAndPlace) {
  TriangleMesh mesh = heightMesh(dome, 10, 8, 20, 16);
  RayHits hits = heightHits(dome, kBox, 9, 7);
  const Image image = draw(mesh, hits);
  const double unit = 1000, move = 30000;
  mesh.vertices = (unit * mesh.vertices).array() + move;
  hits.points = (unit * hits.points).array() + move;
  hits.box = {unit * kBox.uStart + move, unit * kBox.vStart + move, unit * kBox.uLength,
              unit * kBox.vLength};
  EXPECT_LT(differenceOf(image, draw(mesh, hits)).mean, 0.1);
}

TEST_F(SamplingPicture, OneSampleLooksLikeFour) {
  const TriangleMesh mesh = heightMesh(dome, 10, 8, 20, 16);
  const RayHits hits = heightHits(dome, kBox, 9, 7);
  EXPECT_LT(differenceOf(draw(mesh, hits, 1), draw(mesh, hits, 4)).mean, 3);
}

}  // namespace
}  // namespace morphgrid
