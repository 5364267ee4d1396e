#include "core/shading/guided_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/edge_coverage.h"
#include "tests/reference/made_up_canvas.h"
#include "tests/reference/painted_scene.h"
#include "tests/reference/whole_picture.h"

namespace pentimento {
namespace {

using reference::WholePicture;

constexpr int kDetail = 4;

/// Fine relief that sums to zero over the cells of a block, m. Rows and columns of signs.
float bristle_m(int x, int y) {
  const float u = reference::MadeUpCanvas::unit(x / 2, y / kDetail, 1);
  const float v = reference::MadeUpCanvas::unit(x / kDetail, y / 2, 2);
  return 4e-5f * (u * (x % 2 == 0 ? 1.0f : -1.0f) + v * (y % 2 == 0 ? 1.0f : -1.0f));
}

/// The state cell by cell kDetail times larger, and the relief of bristles on it. At the edges of
/// films, paint lies on as many fine cells of a block as it covers of the cell, and is deeper
/// there.
CanvasState finer(const CanvasState& guide) {
  CanvasGeometry g = guide.geometry;
  g.width *= kDetail;
  g.height *= kDetail;
  CanvasState fine = make_canvas_state(g, guide.layers, guide.channels, guide.bands, 0);
  const auto gather = [&](PlaneId plane) {
    constexpr int kBlock = kDetail * kDetail;
    const reference::EdgeCoverage coverage(guide);
    for (int y = 0; y < g.height; ++y) {
      for (int x = 0; x < g.width; ++x) {
        const int u = x / kDetail, v = y / kDetail;
        const int covered = std::max(1, static_cast<int>(std::lround(coverage(u, v) * kBlock)));
        const bool there = y % kDetail * kDetail + x % kDetail < covered;
        plane_of(fine, plane)(x, y) =
            there ? plane_of(guide, plane)(u, v) * kBlock / static_cast<float>(covered) : 0;
      }
    }
  };
  gather({PlaneKind::kDepth, 0, 0});
  for (int layer = 0; layer < guide.layers; ++layer)
    for (int c = 0; c < guide.channels; ++c) gather(pigment_plane(layer, c));
  for (int y = 0; y < g.height; ++y)
    for (int x = 0; x < g.width; ++x) {
      const int u = x / kDetail, v = y / kDetail;
      fine.base_m(x, y) = guide.base_m(u, v) + bristle_m(x, y);
      fine.paper.set(x, y, fine.base_m(x, y), guide.paper.at(u, v, guide.base_m(u, v)));
      for (std::size_t b = 0; b < guide.reflectance.size(); ++b)
        fine.reflectance[b].set(x, y, guide.reflectance[b](u, v));
    }
  return fine;
}

/// A guide, its finer canvas and the light on them.
struct Painting {
  ChannelBasis basis = palette_channels(painted::palette());
  CanvasState guide = painted::scene(basis, 48, 36);
  CanvasState fine = finer(guide);
  Model model;
  Lighting lighting;
  std::unique_ptr<Shader> shader;

  Painting() {
    auto opened = Shader::open(GlBackend::kAuto, 2);
    EXPECT_TRUE(opened) << opened.error().message;
    if (opened) shader = std::move(*opened);
  }
  Result<void> show(const ShadeRequest& request, PictureSink& sink) const {
    const StateSource of_guide(guide), of_fine(fine);
    return shade_guided(*shader, {of_guide, of_fine}, basis, model, lighting, request, Threads(2),
                        {&sink});
  }
  WholePicture guided(const ShadeRequest& request) const {
    WholePicture picture;
    const auto done = show(request, picture);
    EXPECT_TRUE(done) << done.error().message;
    return picture;
  }
  WholePicture alone(const CanvasState& state, const ShadeRequest& request) const {
    WholePicture picture;
    const auto done =
        shader->shade(StateSource(state), basis, model, lighting, request, {&picture});
    EXPECT_TRUE(done) << done.error().message;
    return picture;
  }
};

ShadeRequest request(int width, int height, std::vector<std::string> aovs = {}) {
  ShadeRequest r;
  r.width = width;
  r.height = height;
  r.aovs = std::move(aovs);
  return r;
}

struct Difference {
  double rms = 0;
  double mean = 0;  // signed, share of the light
};
/// Block means of a larger picture, less the small picture.
Difference difference(const WholePicture& small, const WholePicture& large) {
  const int across = large.width / small.width, down = large.rows / small.rows;
  Difference out;
  double light = 0;
  for (const char* colour : {"R", "G", "B"}) {
    for (int y = 0; y < small.rows; ++y) {
      for (int x = 0; x < small.width; ++x) {
        double sum = 0;
        for (int v = 0; v < down; ++v)
          for (int u = 0; u < across; ++u)
            sum += static_cast<double>(large.at(colour, across * x + u, down * y + v));
        const double wanted = static_cast<double>(small.at(colour, x, y));
        const double off = sum / (across * down) - wanted;
        out.rms += off * off;
        out.mean += off;
        light += wanted;
      }
    }
  }
  out.rms = std::sqrt(out.rms / (3 * small.rows * small.width));
  out.mean /= light;
  return out;
}

TEST(GuidedPicture, AFinerCanvasShowsTheLightOfTheGuide) {
  const Painting p;
  const WholePicture guide = p.alone(p.guide, request(48, 36));
  // As many pixels as fine cells, fewer, more, and more along one axis only.
  for (const auto& [width, height] : {std::pair{192, 144}, {96, 72}, {384, 288}, {192, 36}}) {
    const ShadeRequest r = request(width, height);
    ShadeRequest fine = r;
    fine.edges = EdgeCells::kCovered;
    const Difference free = difference(guide, p.alone(p.fine, fine));
    const Difference held = difference(guide, p.guided(r));
    // Relief that changes from cell to cell is beyond the lock's spline: of a miss of 0.026 to
    // 0.030 of white 0.007 to 0.010 is left. The mean light is held: -0.016 % at most was measured,
    // of -1.8 %.
    EXPECT_LT(held.rms, 0.0125) << width;
    EXPECT_LT(held.rms, 0.5 * free.rms) << width;
    EXPECT_LT(std::abs(held.mean), 0.0005) << width;
    EXPECT_GT(std::abs(free.mean), 0.01) << width;
  }
}

TEST(GuidedPicture, TheLightIsThatOfAllSlopes) {
  const Painting p;
  ShadeRequest r = request(48, 36);
  const WholePicture all = p.alone(p.guide, r);
  r.relief_samples = 1;
  const WholePicture one = p.alone(p.guide, r), poster = p.guided(request(192, 144));
  // The two are 0.0087 apart; the poster is 0.0104 from the one and 0.0126 from the other.
  EXPECT_LT(difference(all, poster).rms, 0.9 * difference(one, poster).rms);
}

TEST(GuidedPicture, NoLargerThanTheGuideItIsTheGuides) {
  const Painting p;
  const std::vector<std::string> aovs = {"normal", "height", "specular"};
  for (const auto& [width, height] : {std::pair{48, 36}, {24, 18}, {17, 36}}) {
    ShadeRequest r = request(width, height, aovs);
    EXPECT_EQ(p.guided(r).planes, p.alone(p.guide, r).planes) << width;
    r.crop_x = 3;
    r.crop_y = 5;
    r.crop_width = 11;
    r.crop_height = 7;
    EXPECT_EQ(p.guided(r).planes, p.alone(p.guide, r).planes) << width;
  }
}

TEST(GuidedPicture, ACropIsThePartOfTheWhole) {
  const Painting p;
  for (const auto& [width, height] : {std::pair{192, 144}, {110, 83}, {200, 30}}) {
    ShadeRequest r = request(width, height, {"height"});
    const WholePicture whole = p.guided(r);
    r.crop_x = width / 3;
    r.crop_y = height / 4;
    r.crop_width = width / 5;
    r.crop_height = height / 3;
    r.tile = 16;
    const WholePicture part = p.guided(r);
    ASSERT_EQ(part.width, r.crop_width);
    ASSERT_EQ(part.rows, r.crop_height);
    for (const auto& [name, plane] : part.planes)
      for (int y = 0; y < r.crop_height; ++y)
        for (int x = 0; x < r.crop_width; ++x)
          ASSERT_EQ(part.at(name, x, y), whole.at(name, x + r.crop_x, y + r.crop_y))
              << name << " " << x << ", " << y << " of " << width;
  }
}

TEST(GuidedPicture, AovsAreTheFineCanvass) {
  const Painting p;
  ShadeRequest r = request(192, 144, {"height", "albedo"});
  const WholePicture guided = p.guided(r);
  r.edges = EdgeCells::kCovered;
  const WholePicture alone = p.alone(p.fine, r);
  EXPECT_EQ(guided.planes.size(), alone.planes.size());
  for (const char* name : {"height.Y", "albedo.R", "albedo.G", "albedo.B"})
    EXPECT_EQ(guided.planes.at(name), alone.planes.at(name)) << name;
  EXPECT_NE(guided.planes.at("R"), alone.planes.at("R"));
}

TEST(GuidedPicture, RefusesWhatAShaderRefuses) {
  const Painting p;
  const auto error = [&](const ShadeRequest& r) {
    WholePicture none;
    const auto done = p.show(r, none);
    EXPECT_FALSE(done);
    EXPECT_EQ(none.rows, 0);
    return done ? Error{} : done.error();
  };
  ShadeRequest outside = request(192, 144);
  outside.crop_x = 190;
  outside.crop_width = 3;
  outside.crop_height = 5;
  EXPECT_EQ(error(outside).code, ErrorCode::kUsage);
  EXPECT_EQ(error(outside).message, "the crop lies outside the picture");
  EXPECT_EQ(error(request(192, 0)).code, ErrorCode::kUsage);
  EXPECT_NE(error(request(192, 144, {"shine"})).message.find("unknown AOV 'shine'"),
            std::string::npos);
}

}  // namespace
}  // namespace pentimento
