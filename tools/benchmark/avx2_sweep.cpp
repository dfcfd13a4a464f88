#include "benchmark/avx2_sweep.h"

#include <fmt/format.h>
#include <immintrin.h>

#include <algorithm>
#include <barrier>
#include <thread>

#include "core/error.h"
#include "energy/strut_energy.h"

// Only what follows: Eigen's types above must keep the alignment that the other files know.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx2,fma")
#endif

namespace morphgrid {
namespace {

constexpr int kLanes = 8;
constexpr float kRelaxation = 0.9F;

/// Eight floats; a thin coat over the intrinsics so that the formulas can be read.
struct Floats {
  __m256 v;

  static Floats all(float value) { return {_mm256_set1_ps(value)}; }
  static Floats load(const float* at) { return {_mm256_loadu_ps(at)}; }
  void store(float* at) const { _mm256_storeu_ps(at, v); }
};
inline Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }
inline Floats operator-(Floats a, Floats b) { return {_mm256_sub_ps(a.v, b.v)}; }
inline Floats operator*(Floats a, Floats b) { return {_mm256_mul_ps(a.v, b.v)}; }
inline Floats operator/(Floats a, Floats b) { return {_mm256_div_ps(a.v, b.v)}; }
inline Floats fma(Floats a, Floats b, Floats c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
inline Floats sqrt(Floats a) { return {_mm256_sqrt_ps(a.v)}; }
inline Floats max(Floats a, Floats b) { return {_mm256_max_ps(a.v, b.v)}; }
inline Floats keep(Floats mask, Floats a) { return {_mm256_and_ps(mask.v, a.v)}; }

struct Vectors {
  Floats x, y, z;
};
inline Vectors operator-(const Vectors& a, const Vectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline void addScaled(Vectors& sum, Floats s, const Vectors& a) {
  sum = {fma(s, a.x, sum.x), fma(s, a.y, sum.y), fma(s, a.z, sum.z)};
}
inline Floats dot(const Vectors& a, const Vectors& b) {
  return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
}
inline Vectors zero() { return {Floats::all(0), Floats::all(0), Floats::all(0)}; }

/// Lanes whose column lies in [low, high).
Floats columnsBetween(int first, int low, int high) {
  const __m256i column =
      _mm256_add_epi32(_mm256_set1_epi32(first), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  return {
      _mm256_castsi256_ps(_mm256_and_si256(_mm256_cmpgt_epi32(column, _mm256_set1_epi32(low - 1)),
                                           _mm256_cmpgt_epi32(_mm256_set1_epi32(high), column)))};
}

/// Gradients at the ends of both arms of a corner, added to theirs; the apex gets the opposite.
inline void projectCorner(const Vectors& a, const Vectors& b, Floats aa, Floats bb, Vectors& pullA,
                          Vectors& pullB, Floats& apexA, Floats& apexB) {
  const Floats s = dot(a, b);
  const Floats t = aa + bb;
  const Floats ss4 = Floats::all(4) * s * s;
  const Floats tt = t * t;
  const Floats d = sqrt(max(tt - ss4, fma(Floats::all(1e-12F), tt, Floats::all(1e-30F))));
  const Floats sum = t + d;
  const Floats inverse = Floats::all(1) / (d * sum);
  const Floats own = Floats::all(0) - ss4 * inverse;
  const Floats other = Floats::all(2) * s * sum * inverse;
  addScaled(pullA, own, a);
  addScaled(pullA, other, b);
  addScaled(pullB, own, b);
  addScaled(pullB, other, a);
  apexA = apexA + own + other;
  apexB = apexB + own + other;
}

/// Gradient of a strut at its far end is this times the strut.
inline Floats strutFactor(Floats squaredLength, Floats rest, Floats stiffness) {
  const Floats length = sqrt(max(squaredLength, Floats::all(1e-20F)));
  return Floats::all(2) * stiffness * (Floats::all(1) - rest / length);
}

/// What the loops below know.
void requireStrutsAndCornersAlone(const StrutGrid& grid) {
  if (mechanicsOf(grid) != Mechanics::springs || grid.weights.postAngle != grid.weights.angle) {
    throw InputError(
        "the AVX2 sweep knows springs and corners of one weight at right angles only; take "
        "material.model = \"paper\"");
  }
}

}  // namespace

/// Gradients of three rows at a time, every layer: what the rows still to come may add to.
struct Avx2Sweep::Window {
  Window(int rowPitch, int layerCount) : pitch(rowPitch), layers(layerCount) {
    for (auto* field : {&x, &y, &z}) {
      field->assign(static_cast<std::size_t>(3) * layers * pitch, 0.0F);
    }
  }
  std::size_t row(int j, int k) const {
    return (static_cast<std::size_t>((j + 3) % 3) * layers + k) * pitch + kLanes;
  }
  void clearRow(int j) {
    const auto begin = row(j, 0) - kLanes;
    for (auto* field : {&x, &y, &z}) {
      std::fill_n(field->begin() + begin, static_cast<std::size_t>(layers) * pitch, 0.0F);
    }
  }
  void add(std::size_t at, const Vectors& g) {
    (Floats::load(&x[at]) + g.x).store(&x[at]);
    (Floats::load(&y[at]) + g.y).store(&y[at]);
    (Floats::load(&z[at]) + g.z).store(&z[at]);
  }
  int pitch;
  int layers;
  std::vector<float> x, y, z;
};

Avx2Sweep::Avx2Sweep(const StrutGrid& grid)
    : shape_(grid.shape),
      spacing_(grid.spacing),
      angleWeight_(static_cast<float>(grid.weights.angle)),
      origin_(grid.positions.rowwise().mean()),
      pitch_((grid.shape.verticesU + kLanes - 1) / kLanes * kLanes + 2 * kLanes) {
  requireStrutsAndCornersAlone(grid);
  const auto size = static_cast<std::size_t>(pitch_) * shape_.verticesV * shape_.layers;
  for (auto* field : {&now_.x, &now_.y, &now_.z, &next_.x, &next_.y, &next_.z, &restU_, &restV_,
                      &restW_, &stiffnessU_, &stiffnessV_, &stiffnessW_, &stepPerForce_}) {
    field->assign(size, 0);
  }
  const Eigen::VectorXd weights = StrutEnergy(grid).constraintWeights();
  for (int k = 0; k < shape_.layers; ++k) {
    for (int j = 0; j < shape_.verticesV; ++j) {
      for (int i = 0; i < shape_.verticesU; ++i) {
        const int from = shape_.index(i, j, k);
        const std::size_t to = offset(i, j, k);
        const Eigen::Vector3d p = (grid.positions.col(from) - origin_) / spacing_;
        now_.x[to] = static_cast<float>(p.x());
        now_.y[to] = static_cast<float>(p.y());
        now_.z[to] = static_cast<float>(p.z());
        restU_[to] = static_cast<float>(grid.rest.u[from] / spacing_);
        restV_[to] = static_cast<float>(grid.rest.v[from] / spacing_);
        restW_[to] = static_cast<float>(grid.rest.w[from] / spacing_);
        stiffnessU_[to] = static_cast<float>(grid.stiffness.u[from]);
        stiffnessV_[to] = static_cast<float>(grid.stiffness.v[from]);
        stiffnessW_[to] = static_cast<float>(grid.stiffness.w[from]);
        stepPerForce_[to] = static_cast<float>(1 / (2 * weights[from]));
      }
    }
  }
}

bool Avx2Sweep::isSupported() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

std::size_t Avx2Sweep::offset(int i, int j, int k) const {
  return (static_cast<std::size_t>(k) * shape_.verticesV + j) * pitch_ + kLanes + i;
}

void Avx2Sweep::projectRow(int j, int k, Window& window) {
  const int north = std::min(j + 1, shape_.verticesV - 1);
  const int south = std::max(j - 1, 0);
  const int up = std::min(k + 1, shape_.layers - 1);
  const int down = std::max(k - 1, 0);
  const auto at = [&](int row, int layer, int i) {
    const std::size_t n = offset(i, row, layer);
    return Vectors{Floats::load(&now_.x[n]), Floats::load(&now_.y[n]), Floats::load(&now_.z[n])};
  };
  const Floats angleWeight = Floats::all(angleWeight_);
  for (int i = 0; i < shape_.verticesU; i += kLanes) {
    const Vectors center = at(j, k, i);
    const Floats hasEast = columnsBetween(i, 0, shape_.verticesU - 1);
    const Floats hasWest = columnsBetween(i, 1, shape_.verticesU);
    const Floats inside = columnsBetween(i, 0, shape_.verticesU);
    const auto arm = [&](const Vectors& to, Floats mask) {
      const Vectors d = to - center;
      return Vectors{keep(mask, d.x), keep(mask, d.y), keep(mask, d.z)};
    };
    enum { kEast, kWest, kNorth, kSouth, kUp, kDown, kArms };
    const Vectors arms[kArms] = {arm(at(j, k, i + 1), hasEast), arm(at(j, k, i - 1), hasWest),
                                 arm(at(north, k, i), inside),  arm(at(south, k, i), inside),
                                 arm(at(j, up, i), inside),     arm(at(j, down, i), inside)};
    Floats squares[kArms];
    Vectors pulls[kArms];
    Floats apex[kArms];
    for (int a = 0; a < kArms; ++a) {
      squares[a] = dot(arms[a], arms[a]);
      pulls[a] = zero();
      apex[a] = Floats::all(0);
    }
    const auto corner = [&](int a, int b) {
      projectCorner(arms[a], arms[b], squares[a], squares[b], pulls[a], pulls[b], apex[a], apex[b]);
    };
    corner(kEast, kNorth), corner(kEast, kSouth), corner(kWest, kNorth), corner(kWest, kSouth);
    if (shape_.layers > 1) {
      corner(kEast, kUp), corner(kEast, kDown), corner(kWest, kUp), corner(kWest, kDown);
      corner(kNorth, kUp), corner(kNorth, kDown), corner(kSouth, kUp), corner(kSouth, kDown);
    }
    Vectors own = zero();
    for (int a = 0; a < kArms; ++a) {
      addScaled(own, Floats::all(0) - apex[a], arms[a]);
      pulls[a] = {angleWeight * pulls[a].x, angleWeight * pulls[a].y, angleWeight * pulls[a].z};
    }
    own = {angleWeight * own.x, angleWeight * own.y, angleWeight * own.z};

    const std::size_t n = offset(i, j, k);
    const auto strut = [&](int a, const std::vector<float>& rest,
                           const std::vector<float>& stiffness) {
      const Floats factor =
          strutFactor(squares[a], Floats::load(&rest[n]), Floats::load(&stiffness[n]));
      addScaled(pulls[a], factor, arms[a]);
      addScaled(own, Floats::all(0) - factor, arms[a]);
    };
    strut(kEast, restU_, stiffnessU_);
    strut(kNorth, restV_, stiffnessV_);
    strut(kUp, restW_, stiffnessW_);

    const std::size_t here = window.row(j, k) + i;
    window.add(here, own);
    window.add(here + 1, pulls[kEast]);
    window.add(here - 1, pulls[kWest]);
    window.add(window.row(j + 1, k) + i, pulls[kNorth]);
    window.add(window.row(j - 1, k) + i, pulls[kSouth]);
    if (shape_.layers > 1) {
      window.add(window.row(j, up) + i, pulls[kUp]);
      window.add(window.row(j, down) + i, pulls[kDown]);
    }
  }
}

void Avx2Sweep::updateRow(int j, int k, Window& window) {
  const Floats relaxation = Floats::all(-(1 + momentum_) * kRelaxation);
  for (int i = 0; i < shape_.verticesU; i += kLanes) {
    const std::size_t n = offset(i, j, k);
    const std::size_t g = window.row(j, k) + i;
    const Floats step = relaxation * Floats::load(&stepPerForce_[n]);
    // With momentum the previous positions lie where the next ones go: the same traffic.
    const Floats momentum = Floats::all(momentum_);
    const auto advance = [&](const std::vector<float>& now, std::vector<float>& next,
                             const std::vector<float>& gradient) {
      const Floats p = Floats::load(&now[n]);
      const Floats velocity = p - Floats::load(&next[n]);
      fma(step, Floats::load(&gradient[g]), fma(momentum, velocity, p)).store(&next[n]);
    };
    advance(now_.x, next_.x, window.x);
    advance(now_.y, next_.y, window.y);
    advance(now_.z, next_.z, window.z);
  }
}

/// Rows [begin, end): their neighbours outside are projected too, by both threads.
void Avx2Sweep::sweepRows(int begin, int end, Window& window) {
  for (int row = begin - 2; row <= begin; ++row) {
    window.clearRow(row);
  }
  for (int j = begin - 1; j <= end; ++j) {
    window.clearRow(j + 1);
    if (j >= 0 && j < shape_.verticesV) {
      for (int k = 0; k < shape_.layers; ++k) {
        projectRow(j, k, window);
      }
    }
    if (j - 1 >= begin && j - 1 < end) {
      for (int k = 0; k < shape_.layers; ++k) {
        updateRow(j - 1, k, window);
      }
    }
  }
}

void Avx2Sweep::beginSweep(int sweep) {
  const float root = static_cast<float>(sweep) / static_cast<float>(sweep + 2);
  momentum_ = root * root;
}

void Avx2Sweep::run(int count) {
  int sweep = 0;
  beginSweep(sweep);
  std::barrier together(2, [&]() noexcept {
    std::swap(now_, next_);
    beginSweep(++sweep);
  });
  const auto sweepAll = [&](int begin, int end) {
    Window window(pitch_, shape_.layers);
    for (int n = 0; n < count; ++n) {
      sweepRows(begin, end, window);
      together.arrive_and_wait();
    }
  };
  const int middle = shape_.verticesV / 2;
  std::thread helper([&] { sweepAll(0, middle); });
  sweepAll(middle, shape_.verticesV);
  helper.join();
}

Eigen::Matrix3Xd Avx2Sweep::positions() const {
  Eigen::Matrix3Xd positions(3, shape_.vertexCount());
  for (int k = 0; k < shape_.layers; ++k) {
    for (int j = 0; j < shape_.verticesV; ++j) {
      for (int i = 0; i < shape_.verticesU; ++i) {
        const std::size_t n = offset(i, j, k);
        positions.col(shape_.index(i, j, k)) =
            origin_ + spacing_ * Eigen::Vector3d(now_.x[n], now_.y[n], now_.z[n]);
      }
    }
  }
  return positions;
}

}  // namespace morphgrid

#ifdef __clang__
#pragma clang attribute pop
#endif
