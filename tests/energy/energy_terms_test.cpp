#include "energy/energy_terms.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <set>

#include "energy/strut_energy.h"
#include "tests/solve/dense_hessian.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double kLeast = 1e-10;  // Square below which edges of about length 1 count as 0.

/// The derivative at 0 by differences of fourth order; `at` returns a matrix or a number for an
/// argument near 0.
template <typename At>
auto derivative(const At& at) {
  constexpr double kStep = 1e-3;
  using Result = std::decay_t<decltype(at(0.0))>;
  return Result((8 * (at(kStep) - at(-kStep)) - (at(2 * kStep) - at(-2 * kStep))) / (12 * kStep));
}

template <int count>
EdgeVectors<count> randomVectors() {
  return EdgeVectors<count>::Random();
}

/// What every term must fulfil at the edges e.
template <typename Term>
void expectConsistent(const Term& term, const EdgeVectors<Term::kEdges>& e) {
  using Vectors = EdgeVectors<Term::kEdges>;
  const Vectors gradient = term.evaluate(e).gradient;
  for (int trial = 0; trial < 4; ++trial) {
    const Vectors z = randomVectors<Term::kEdges>();
    const double slope = derivative([&](double t) { return term.evaluate(e + t * z).energy; });
    EXPECT_NEAR(gradient.cwiseProduct(z).sum(), slope, 1e-8 * (1 + gradient.norm()));
    const Vectors product = term.hessianProduct(e, z);
    const Vectors change =
        derivative([&](double t) { return Vectors(term.evaluate(e + t * z).gradient); });
    EXPECT_LT((product - change).norm(), 1e-8 * (1 + product.norm()));
    const Vectors y = randomVectors<Term::kEdges>();
    EXPECT_NEAR(product.cwiseProduct(y).sum(), term.hessianProduct(e, y).cwiseProduct(z).sum(),
                1e-12 * (1 + product.norm()));
  }
  const MatrixXd block = term.gaussNewton(e);
  EXPECT_LT((block - block.transpose()).norm(), 1e-12 * block.norm());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(block);
  EXPECT_GT(solver.eigenvalues()[0], -1e-12 * block.norm());
}

TEST(StrutTerm, DerivativesAgreeWithDifferences) {
  std::srand(1);
  const StrutTerm term{3, 0.9, kLeast};
  expectConsistent(term, Vector3d(0.7, -0.4, 1.1));
  expectConsistent(term, Vector3d(0.2, 0.3, -0.4));
}

TEST(StrutTerm, ClosedForms) {
  const StrutTerm term{3, 2, kLeast};
  const Vector3d along(3, 4, 0);
  EXPECT_DOUBLE_EQ(term.evaluate(along).energy, 3 * 9.0);
  EXPECT_TRUE(term.evaluate(along).gradient.isApprox(2 * 3 * 3 * along / 5));
  const Vector3d z(0, 0, 1);  // Across: only 1 - L / l of the stiffness is left.
  EXPECT_TRUE(term.hessianProduct(along, z).isApprox(2 * 3 * (1 - 2.0 / 5) * z));
  EXPECT_TRUE(term.hessianProduct(along, along).isApprox(2 * 3 * along));
  // Stretched, the Gauss-Newton block is the Hessian; compressed, it has nothing across.
  EXPECT_TRUE((term.gaussNewton(along) * z).isApprox(term.hessianProduct(along, z)));
  const Vector3d pressed(0.3, 0.4, 0);
  EXPECT_LT((term.gaussNewton(pressed) * z).norm(), 1e-15);
  EXPECT_LT(term.hessianProduct(pressed, z).z(), 0);
}

TEST(StrutTerm, GradientByRestAgreesWithDifferences) {
  const Vector3d e(0.7, -0.4, 1.1);
  const Vector3d change = derivative([&](double t) {
    return Vector3d(StrutTerm{3, 0.9 + t, kLeast}.evaluate(e).gradient);
  });
  EXPECT_TRUE((StrutTerm{3, 0.9, kLeast}.gradientByRest(e)).isApprox(change, 1e-10));
}

CornerTerm::Vectors armsAt(double lengthA, double lengthB, double angle) {
  CornerTerm::Vectors arms;
  arms.col(0) = lengthA * Vector3d(1, 0, 0);
  arms.col(1) = lengthB * Vector3d(std::cos(angle), std::sin(angle), 0);
  const Eigen::Matrix3d turned =
      (Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized()).toRotationMatrix();
  return turned * arms;
}

CornerTerm cornerRestingAt(double theta) {
  const CornerTerm::Vectors rest = armsAt(1, 1, theta);
  return {2, kLeast, RestAngle::between(rest.col(0), rest.col(1))};
}

TEST(CornerTerm, DerivativesAgreeWithDifferences) {
  std::srand(2);
  for (const double angle : {0.4, 1.2, std::numbers::pi / 2, 2.5}) {
    expectConsistent(CornerTerm{2, kLeast}, armsAt(1, 0.8, angle));
    expectConsistent(cornerRestingAt(1.2), armsAt(1, 0.8, angle));
    expectConsistent(cornerRestingAt(1.9), armsAt(1, 0.8, angle));
  }
}

// Arms of one length a at an angle gamma: T = 2 a^2, D = 2 a^2 sin gamma.
TEST(CornerTerm, ClosedForms) {
  const CornerTerm term{2, kLeast};
  for (const double angle : {0.4, 1.2, std::numbers::pi / 2, 2.5}) {
    EXPECT_NEAR(term.evaluate(armsAt(3, 3, angle)).energy, 2 * 9 * (1 - std::sin(angle)), 1e-13);
  }
  const CornerTerm::Vectors right = armsAt(1, 0.8, std::numbers::pi / 2);
  EXPECT_LT(term.evaluate(right).gradient.norm(), 1e-15);
  // At rest Gauss-Newton is exact.
  const CornerTerm::Vectors z = CornerTerm::Vectors::Random();
  const Eigen::VectorXd product = term.gaussNewton(right) * z.reshaped();
  EXPECT_LT((product - term.hessianProduct(right, z).reshaped()).norm(), 1e-5);
}

/// The energy per weight where the arms shall have the angle theta: the best direction of p,
/// sought.
double energyAtRestAngle(const CornerTerm::Vectors& arms, double theta) {
  const double lengthA = arms.col(0).norm();
  const double lengthB = arms.col(1).norm();
  const double gamma = std::acos(arms.col(0).dot(arms.col(1)) / (lengthA * lengthB));
  const auto at = [&](double direction) {
    return std::pow(lengthA * std::sin(direction), 2) +
           std::pow(lengthB * std::sin(gamma - theta - direction), 2);
  };
  double low = -1;
  double high = 1;
  const double kGolden = (std::sqrt(5) - 1) / 2;
  for (int step = 0; step < 100; ++step) {
    const double left = high - kGolden * (high - low);
    const double right = low + kGolden * (high - low);
    (at(left) < at(right) ? high : low) = at(left) < at(right) ? right : left;
  }
  return at(low);
}

TEST(CornerTerm, IsTheDistanceToTheNearestArmsAtItsRestAngle) {
  for (const double theta : {1.2, std::numbers::pi / 2, 1.9}) {
    for (const double angle : {0.7, 1.1, std::numbers::pi / 2, 2.2}) {
      const CornerTerm::Vectors arms = armsAt(1, 0.8, angle);
      EXPECT_NEAR(cornerRestingAt(theta).evaluate(arms).energy, 2 * energyAtRestAngle(arms, theta),
                  1e-12);
    }
  }
}

TEST(CornerTerm, GradientByRestAgreesWithDifferences) {
  for (const double theta : {1.2, std::numbers::pi / 2}) {
    for (const double angle : {1.1, std::numbers::pi / 2, 1.9}) {
      const CornerTerm::Vectors arms = armsAt(1, 0.8, angle);
      const CornerTerm::Vectors byRest = cornerRestingAt(theta).gradientByRest(arms);
      for (int trial = 0; trial < 4; ++trial) {
        const CornerTerm::Vectors z = CornerTerm::Vectors::Random();
        const double change = derivative([&](double turn) {
          return derivative(
              [&](double t) { return 2 * energyAtRestAngle(arms + t * z, theta + turn); });
        });
        EXPECT_NEAR(byRest.cwiseProduct(z).sum(), change, 1e-6 * (1 + byRest.norm())) << angle;
      }
    }
  }
}

TEST(CornerTerm, CollinearAndVanishingArmsStayFinite) {
  const CornerTerm term = cornerRestingAt(1.2);
  CornerTerm::Vectors none = CornerTerm::Vectors::Zero();
  CornerTerm::Vectors one = none;
  one.col(0) = Vector3d(1, 0, 0);
  for (const CornerTerm::Vectors& arms : {armsAt(1, 2, 0), none, one}) {
    EXPECT_TRUE(std::isfinite(term.evaluate(arms).energy));
    EXPECT_TRUE(term.evaluate(arms).gradient.allFinite());
    EXPECT_TRUE(term.hessianProduct(arms, armsAt(1, 1, 1)).allFinite());
    EXPECT_TRUE(term.gaussNewton(arms).allFinite());
    EXPECT_TRUE(term.gradientByRest(arms).allFinite());
  }
  EXPECT_EQ(term.evaluate(one).energy, 0);  // A missing arm: no corner.
  EXPECT_EQ(term.evaluate(one).gradient.norm(), 0);
}

TEST(StrutTerm, VanishingEdgeStaysFinite) {
  const StrutTerm term{3, 2, kLeast};
  EXPECT_TRUE(term.evaluate(Vector3d::Zero()).gradient.allFinite());
  EXPECT_TRUE(term.hessianProduct(Vector3d::Zero(), Vector3d::Ones()).allFinite());
  EXPECT_TRUE(term.gaussNewton(Vector3d::Zero()).allFinite());
}

TEST(EnergyTerms, StencilsSpanAsManyVerticesAsSaid) {
  const StrutGrid grid = bentGrid({3, 4, 3}, 3);
  int most = 0;
  forEachTerm(grid, [&]<typename Term>(const Term&, const EdgeStencil<Term::kEdges>& stencil) {
    std::set<int> vertices;
    for (const Edge& edge : stencil) {
      vertices.insert({edge.from, edge.to});
    }
    ASSERT_EQ(static_cast<int>(vertices.size()), Term::kVertices);
    most = std::max(most, Term::kVertices);
  });
  EXPECT_EQ(StrutEnergy(grid).mostVertices(), most);
}

// The blocks of all terms together are the Hessian that the device is tested against.
TEST(EnergyTerms, GaussNewtonBlocksAddUpToTheDenseHessian) {
  StrutGrid grid = bentGrid({3, 4, 3}, 3);
  grid.positions = shaken(grid.positions, 0.1, 5);
  MatrixXd sum = MatrixXd::Zero(grid.positions.size(), grid.positions.size());
  forEachTerm(grid, [&](const auto& term, const auto& stencil) {
    const MatrixXd block = term.gaussNewton(differencesAlong(stencil, grid.positions));
    MatrixXd byEnds = MatrixXd::Zero(block.rows(), grid.positions.size());
    for (std::size_t n = 0; n < stencil.size(); ++n) {
      const auto row = 3 * static_cast<Eigen::Index>(n);
      byEnds.block<3, 3>(row, 3 * stencil[n].to) += Eigen::Matrix3d::Identity();
      byEnds.block<3, 3>(row, 3 * stencil[n].from) -= Eigen::Matrix3d::Identity();
    }
    sum += byEnds.transpose() * block * byEnds;
  });
  const MatrixXd expected = denseHessian(grid);
  EXPECT_LT((sum - expected).norm(), 1e-5 * expected.norm());
}

}  // namespace
}  // namespace morphgrid
