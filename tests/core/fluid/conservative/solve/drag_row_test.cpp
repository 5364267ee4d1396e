#include "core/fluid/conservative/solve/drag_row.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pentimento::conservative {
namespace {

/// Faces side by side, of which the outermost only stand beside the others.
struct Faces {
  explicit Faces(std::size_t count)
      : depth(count, 1), nu(count, 1), friction(count, 0.1f), response(count) {}
  std::vector<float> depth, nu, friction, response;
  float per_d2 = 1;

  void sweep(int times) {
    response = friction;
    std::vector<float> next = response;
    for (int k = 0; k < times; ++k) {
      const auto at = [&](std::size_t from) {
        return DragFaces{&depth[from], &nu[from], &response[from]};
      };
      drag_row(at(0), at(1), at(2), &friction[1], per_d2, static_cast<int>(friction.size()) - 2,
               &next[1]);
      response = next;
    }
  }
};

TEST(DragRow, AUniformFilmKeepsWhatTheBedLeaves) {
  Faces film(9);
  film.per_d2 = 40;
  film.sweep(4);
  for (const float r : film.response) EXPECT_NEAR(r, 0.1f, 1e-7f);
}

TEST(DragRow, FourSweepsBringWhatAlternatesToItsSolution) {
  // f of 0.0145 and 0.0055, couplings of 79 (d = 1.5 dx). By hand, r of both kinds is
  // (1 + 158 r_other) / (1 / f + 158): 0.00954 and 0.00738, 1.293 of one another. Four sweeps have
  // their ratio to a per cent, and what all of them have in common to five.
  Faces film(16);
  film.per_d2 = 79;
  for (std::size_t i = 0; i < 16; ++i) film.friction[i] = i % 2 == 0 ? 0.0145f : 0.0055f;
  film.sweep(4);
  EXPECT_NEAR(film.response[8] / film.response[7], 1.293f, 0.013f);
  EXPECT_NEAR(film.response[8] / 0.00954f, 1, 0.05f);
}

/// The largest error of a strip of `cells` between standing sides against Brinkman's profile,
/// f (1 - cosh(x / l) / cosh(w / 2 l)) with l^2 = f c dx^2, as a share of f; l is a quarter of w.
double error_of_strip(int cells, float beside) {
  const auto count = static_cast<std::size_t>(cells) + 2;
  Faces strip(count);
  strip.depth.front() = strip.depth.back() = beside;
  strip.friction.front() = strip.friction.back() = 0;
  const double width = cells + 1.0, length = width / 4;  // the sides stand at their middle
  strip.per_d2 = static_cast<float>(length * length / 0.1);
  strip.sweep(40 * cells * cells);
  double worst = 0;
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const double x = static_cast<double>(i) - width / 2;
    const double expected = 1 - std::cosh(x / length) / std::cosh(width / 2 / length);
    worst = std::max(worst, std::abs(static_cast<double>(strip.response[i]) / 0.1 - expected));
  }
  return worst;
}

TEST(DragRow, ManySweepsGiveBrinkmansProfile) {
  for (const float beside : {0.0f, 1.0f}) {  // dry, and held
    const double coarse = error_of_strip(7, beside), fine = error_of_strip(15, beside);
    EXPECT_LT(coarse, 0.01);
    EXPECT_GT(coarse / fine, 3.5) << "second order";
  }
}

TEST(DragRow, TheWallSlips) {
  // Nothing is left beyond the canvas, and it would drag if it stood.
  Faces film(3);
  film.per_d2 = 50;
  film.depth.front() = film.depth.back() = -1;
  film.friction.front() = film.friction.back() = 0;
  film.sweep(1);
  EXPECT_NEAR(film.response[1], 0.1f, 1e-8f);
}

TEST(DragRow, HeldAndDryFacesStand) {
  Faces film(5);
  film.friction[2] = 0;
  film.sweep(4);
  EXPECT_EQ(film.response[2], 0);
  EXPECT_GT(film.response[1], 0);
  EXPECT_LT(film.response[1], 0.1f);
}

TEST(DragRow, ANeighbourThatStandsDragsWithThePaintsOwnViscosity) {
  // 1/f = 10, c = 3 x 4 beside a dry face, whatever its viscosity; a third of f stays by damping.
  Faces film(3);
  film.per_d2 = 3;
  film.nu = {100, 4, 100};
  film.depth.front() = film.depth.back() = 0;
  film.friction.front() = film.friction.back() = 0;
  film.sweep(1);
  EXPECT_NEAR(film.response[1], 0.1f / 3 + 2.0f / 3 / (10 + 24), 1e-7f);
  // Beside wet ones it is the mean, 52.
  film.depth = {1, 1, 1};
  film.sweep(1);
  EXPECT_NEAR(film.response[1], 0.1f / 3 + 2.0f / 3 / (10 + 2 * 3 * 52), 1e-7f);
}

// Wet and dry faces between two that stand, of which the last lies beyond the canvas; then a
// shorter row, which ends at a dry face.
TEST(DragRow, ARowByItselfHasTheBitsOfSweepAfterSweep) {
  DragAlongRow along;
  std::uint32_t seed = 1;
  const auto random = [&] { return static_cast<float>((seed = seed * 1664525 + 1013904223) >> 8); };
  for (const std::size_t count : {std::size_t{83}, std::size_t{35}}) {
    Faces faces(count);
    faces.per_d2 = 30;
    for (std::size_t i = 0; i < count; ++i) {
      faces.depth[i] = random() < 0x1p22f ? 0.0f : random();
      faces.nu[i] = random() * 0x1p-24f;
      faces.friction[i] = random() < 0x1p22f ? 0.0f : random() * 0x1p-24f;
    }
    faces.friction.front() = faces.friction.back() = 0;
    faces.depth.back() = count > 50 ? -1.0f : 0.0f;
    std::vector<float> friction = faces.friction;
    along.sweep(4, &faces.depth[1], &faces.nu[1], faces.per_d2, static_cast<int>(count) - 2,
                &friction[1]);
    faces.sweep(4);
    for (std::size_t i = 1; i + 1 < count; ++i) EXPECT_EQ(friction[i], faces.response[i]) << i;
  }
}

}  // namespace
}  // namespace pentimento::conservative
