#include "core/shading/shader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/canvas/set_base.h"
#include "tests/reference/painted_scene.h"
#include "tests/reference/shading.h"
#include "tests/reference/whole_picture.h"

namespace pentimento {
namespace {

using reference::Pixel;
using reference::ShadingReference;
using reference::WholePicture;

std::unique_ptr<Shader> open(GlBackend backend = GlBackend::kAuto) {
  auto shader = Shader::open(backend, 2);
  EXPECT_TRUE(shader) << shader.error().message;
  return shader ? std::move(*shader) : nullptr;
}

/// One scene with everything a picture depends on.
struct Scene {
  ChannelBasis basis = palette_channels(painted::palette());
  CanvasState state;
  Model model;
  Lighting lighting;
  explicit Scene(int width = 64, int height = 48) : state(painted::scene(basis, width, height)) {}

  WholePicture shade(Shader& shader, const ShadeRequest& request) const {
    WholePicture picture;
    const auto done = shader.shade(StateSource(state), basis, model, lighting, request, {&picture});
    EXPECT_TRUE(done) << done.error().message;
    return picture;
  }
};

ShadeRequest request_of(int width, int height, std::vector<std::string> aovs = {}) {
  ShadeRequest r;
  r.width = width;
  r.height = height;
  r.aovs = std::move(aovs);
  return r;
}

const std::vector<std::string> kAllAovs = {"albedo",   "normal",     "height", "depth",  "diffuse",
                                           "specular", "reflection", "wet",    "pigment"};

/// Largest difference between the shader and its twin, over colours and light.
double difference_to_reference(const Scene& scene, const WholePicture& picture, int height,
                               int slopes = 2) {
  const ShadingReference twin(scene.state, scene.basis, scene.model, scene.lighting, picture.width,
                              height, slopes);
  double largest = 0;
  const auto compare = [&](const char* group, const reference::Rgb& expected, int x, int y) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::string name = std::string(group) + "RGB"[c];
      largest =
          std::max(largest, std::abs(static_cast<double>(picture.at(name, x, y)) - expected[c]));
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Pixel p = twin.pixel(x, y);
      compare("", p.picture, x, y);
      compare("albedo.", p.albedo, x, y);
      compare("diffuse.", p.diffuse, x, y);
      compare("specular.", p.specular, x, y);
      compare("reflection.", p.reflection, x, y);
      EXPECT_NEAR(picture.at("height.Y", x, y), p.height, 1e-8);  // metres; float of millimetres
      EXPECT_NEAR(picture.at("depth.Y", x, y), p.depth, 1e-8);
      EXPECT_NEAR(picture.at("wet.Y", x, y), p.wet, 1e-4);
    }
  }
  return largest;
}

// A tenth of the 1/255 that pictures may differ by across machines.
constexpr double kTwin = 0.1 / 255;

TEST(Shader, EqualsItsTwinAtTheGridsSize) {
  const auto shader = open();
  const Scene scene;
  EXPECT_LT(difference_to_reference(scene, scene.shade(*shader, request_of(64, 48, kAllAovs)), 48),
            kTwin);
}

// As posters are shaded. Where nothing is occluded, the window has no border for the horizon.
TEST(Shader, EqualsItsTwinWithOneSlopeACell) {
  const auto shader = open();
  for (const float occlusion : {0.0f, 1.0f}) {
    Scene scene;
    scene.lighting.occlusion = occlusion;
    scene.lighting.relief_scale = 2;
    ShadeRequest request = request_of(64, 48, kAllAovs);
    request.relief_samples = 1;
    request.tile = 20;
    EXPECT_LT(difference_to_reference(scene, scene.shade(*shader, request), 48, 1), kTwin)
        << occlusion;
  }
}

TEST(Shader, EqualsItsTwinEnlarged) {
  const auto shader = open();
  const Scene scene(32, 24);
  EXPECT_LT(difference_to_reference(scene, scene.shade(*shader, request_of(80, 60, kAllAovs)), 60),
            kTwin);
}

TEST(Shader, EqualsItsTwinReduced) {
  const auto shader = open();
  const Scene scene(100, 75);
  EXPECT_LT(difference_to_reference(scene, scene.shade(*shader, request_of(40, 30, kAllAovs)), 30),
            kTwin);
}

/// A state of noise: any number of layers and channels, empty layers, bare cells, any lamp.
Scene random_scene(std::uint32_t seed) {
  std::minstd_rand noise(seed);
  const auto uniform = [&] { return static_cast<float>(noise() % 10007) / 10007.0f; };
  Scene scene;
  const int layers = 1 + static_cast<int>(seed % 3), pigments = 2 + static_cast<int>(seed % 7);
  std::vector<Pigment> palette;
  for (int i = 0; i < pigments; ++i) {
    palette.push_back({std::to_string(i), Eigen::Vector3d(uniform(), uniform(), uniform()),
                       Eigen::Vector3d(uniform(), uniform(), uniform())});
  }
  scene.basis = palette_channels(palette);
  scene.state = make_canvas_state({40, 30, 0.2, 0.12}, layers, pigments, 3, 0);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      for (GroundPlane& band : scene.state.reflectance) band.set(x, y, uniform());
      const float paper_m = 0.0005f * uniform();
      set_base(scene.state, x, y, paper_m + 0.001f * uniform());
      scene.state.paper.set(x, y, scene.state.base_m(x, y), paper_m);
      scene.state.depth_m(x, y) = uniform() < 0.3f ? 0 : 0.002f * uniform();
      for (Field<float>& plane : scene.state.pigment) {
        plane(x, y) = uniform() < 0.4f ? 0 : 0.05f * uniform();
      }
    }
  }
  const float tilt = 1.4f * uniform(), turn = 6.28f * uniform();
  scene.lighting.lamps[0].direction = {std::sin(tilt) * std::cos(turn),
                                       std::sin(tilt) * std::sin(turn), std::cos(tilt)};
  return scene;
}

TEST(Shader, EqualsItsTwinOnNoise) {
  const auto shader = open();
  const Scene few = random_scene(1), many = random_scene(6);  // 2 and 1 layers, 3 and 8 pigments
  EXPECT_LT(difference_to_reference(few, few.shade(*shader, request_of(53, 47, kAllAovs)), 47),
            kTwin);
  EXPECT_LT(difference_to_reference(many, many.shade(*shader, request_of(40, 30, kAllAovs)), 30),
            kTwin);
}

TEST(Shader, EqualsItsTwinByDepthWithCameraAndExposure) {
  const auto shader = open();
  Scene scene;
  scene.model.optical_thickness = OpticalThickness::kDepth;
  scene.lighting.exposure_ev = 0.5f;
  scene.lighting.relief_scale = 0.5f;
  for (std::size_t c = 0; c < 3; ++c) {
    scene.lighting.reflection.rgb[c] = Field<float>(16, 9);
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 16; ++x) {
        scene.lighting.reflection.rgb[c](x, y) = static_cast<float>((x * (c + 1) + y) % 5) * 0.3f;
      }
    }
  }
  // Texture filters keep 8 bits of the fraction between texels: 1/256 of a reflection of 4 %.
  EXPECT_LT(difference_to_reference(scene, scene.shade(*shader, request_of(64, 48, kAllAovs)), 48),
            1 / 255.0);
}

LightProbe striped_probe() {
  LightProbe probe;
  for (std::size_t c = 0; c < 3; ++c) {
    probe[c] = Field<float>(128, 64);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 128; ++x)
        probe[c](x, y) = (x / 16 + y / 16) % 2 == 0 ? 0.2f : 1.0f + static_cast<float>(c);
    }
  }
  return probe;
}

TEST(Shader, EqualsItsTwinInTheLightOfAProbe) {
  const auto shader = open();
  Scene scene(16, 12);
  scene.lighting.probe = striped_probe();
  // The table: normals 3.6 degrees of mirrored direction apart, halves of the probe, and 8 bits of
  // the fraction between texels; 2 % of a reflection of 4 % of light up to 3.
  EXPECT_LT(difference_to_reference(scene, scene.shade(*shader, request_of(16, 12, kAllAovs)), 12),
            0.02 * 0.04 * 3);
}

/// Everything that light can do at once: near and far lamps, shadows, varnish, a warm white.
Scene fully_lit_scene(int width, int height) {
  Scene scene(width, height);
  Lamp near, low, dark;
  near.position_m = {0.1f, -0.06f, 0.08f};
  near.color = {0.2f, 0.5f, 1.0f};
  near.intensity = 0.4f;
  low.direction = {0.96f, 0, 0.28f};
  dark.intensity = 0;
  scene.lighting.lamps = {Lamp{}, dark, near, low, near, low};
  scene.lighting.lamps[4].position_m = {-0.09f, 0.01f, 0.02f};
  scene.lighting.lamps[5].direction = {0, -0.8f, 0.6f};
  scene.lighting.varnish = 0.3f;
  scene.lighting.occlusion = 0.9f;
  scene.lighting.white_xy = {0.38f, 0.38f};
  scene.lighting.exposure_ev = -0.7f;
  return scene;
}

TEST(Shader, EqualsItsTwinWithSeveralLampsAndVarnish) {
  const auto shader = open();
  const Scene scene = fully_lit_scene(64, 48), enlarged = fully_lit_scene(40, 30);
  EXPECT_LT(difference_to_reference(scene, scene.shade(*shader, request_of(64, 48, kAllAovs)), 48),
            kTwin);
  EXPECT_LT(
      difference_to_reference(enlarged, enlarged.shade(*shader, request_of(70, 50, kAllAovs)), 50),
      kTwin);
}

TEST(Shader, TilesAreSeamlessWithShadowsAndNearLamps) {
  const auto shader = open();
  Scene scene = fully_lit_scene(300, 225);
  scene.lighting.probe = striped_probe();
  for (const int width : {100, 300, 470}) {
    ShadeRequest one = request_of(width, width * 3 / 4, kAllAovs), many = one;
    many.tile = 37;
    EXPECT_EQ(scene.shade(*shader, one).planes, scene.shade(*shader, many).planes) << width;
  }
}

TEST(Shader, ARidgeShadesWhatLiesBehindIt) {
  const auto shader = open();
  Scene scene;
  scene.state = make_canvas_state({60, 20, 0.06, 0.02}, 1, 4, 3, 0.5f);
  for (int y = 0; y < 20; ++y) {
    for (int x = 28; x < 32; ++x) set_base(scene.state, x, y, 0.002f);
  }
  scene.lighting.environment = {};
  scene.lighting.lamps[0].direction = {-0.8f, 0, 0.6f};  // 2 mm high: the shadow is 2.7 mm long
  const WholePicture shaded = scene.shade(*shader, request_of(60, 20));
  scene.lighting.occlusion = 0;
  const WholePicture open_sky = scene.shade(*shader, request_of(60, 20));
  EXPECT_LT(shaded.at("G", 33, 10), 0.2f * open_sky.at("G", 33, 10));
  EXPECT_EQ(shaded.at("G", 45, 10), open_sky.at("G", 45, 10));
  EXPECT_EQ(shaded.at("G", 20, 10), open_sky.at("G", 20, 10));
}

TEST(Shader, OnAPlaneNothingIsHiddenHoweverItLeans) {
  const auto shader = open();
  Scene scene;
  scene.state = make_canvas_state({40, 40, 0.04, 0.04}, 1, 4, 3, 0.5f);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) set_base(scene.state, x, y, 0.0003f * static_cast<float>(x));
  }
  const WholePicture hidden = scene.shade(*shader, request_of(40, 40));
  scene.lighting.occlusion = 0;
  const WholePicture open_sky = scene.shade(*shader, request_of(40, 40));
  // Heights of a centimetre in floats: slopes are exact to 1e-6.
  EXPECT_NEAR(hidden.at("G", 20, 20), open_sky.at("G", 20, 20), 1e-5f);
}

TEST(Shader, WetPaintGleamsAndDryPaintIsDullUntilItIsVarnished) {
  const auto shader = open();
  const auto brightest = [&](float wet_share, float varnish) {
    Scene scene;
    scene.state = make_canvas_state({60, 60, 0.06, 0.06}, 1, 4, 3, 0.1f);
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 60; ++x) {  // a round ridge of 4 mm along y
        const float across = (static_cast<float>(x) - 30) / 12;
        const float film = 0.004f * std::max(1 - across * across, 0.0f) + 0.003f;
        scene.state.depth_m(x, y) = film * wet_share;
        set_base(scene.state, x, y, film * (1 - wet_share));
      }
    }
    scene.lighting.lamps[0].direction = {-0.768f, 0, 0.64f};  // across the ridge
    scene.lighting.varnish = varnish;
    const WholePicture p = scene.shade(*shader, request_of(60, 60, {"specular"}));
    float most = 0;
    for (const float v : p.planes.at("specular.G")) most = std::max(most, v);
    return most;
  };
  const float wet = brightest(1, 0), dry = brightest(0, 0), varnished = brightest(0, 1);
  EXPECT_GT(wet, 3 * dry);
  EXPECT_NEAR(varnished, wet, 0.1f * wet);
}

TEST(Shader, LightAovsSumToThePicture) {
  const auto shader = open();
  const Scene scene;
  const WholePicture p = scene.shade(*shader, request_of(64, 48, kAllAovs));
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const float sum =
          p.at("diffuse.G", x, y) + p.at("specular.G", x, y) + p.at("reflection.G", x, y);
      EXPECT_NEAR(p.at("G", x, y), sum, 1e-6f);  // float rounding
    }
  }
}

TEST(Shader, PigmentAovIsTheSumOverLayers) {
  const auto shader = open();
  const Scene scene;
  const WholePicture p = scene.shade(*shader, request_of(64, 48, {"pigment"}));
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      EXPECT_FLOAT_EQ(p.at("pigment.Cadmium Red", x, y),
                      scene.state.channel(0, 1)(x, y) + scene.state.channel(1, 1)(x, y));
    }
  }
}

TEST(Shader, TilesAreSeamlessToTheBit) {
  const auto shader = open();
  const Scene scene(320, 192);
  ShadeRequest one = request_of(5000, 3000), many = one;
  one.tile = 8192;
  many.tile = 512;
  const WholePicture whole = scene.shade(*shader, one), tiled = scene.shade(*shader, many);
  EXPECT_EQ(whole.strips, 1);
  EXPECT_EQ(tiled.strips, 6);
  for (const char* plane : {"R", "G", "B"})
    EXPECT_EQ(whole.planes.at(plane), tiled.planes.at(plane));
}

TEST(Shader, TilesOfEveryAovAreSeamlessAlsoWhenReduced) {
  const auto shader = open();
  const Scene scene(200, 150);
  ShadeRequest one = request_of(67, 50, kAllAovs), many = one;
  many.tile = 13;
  EXPECT_EQ(scene.shade(*shader, one).planes, scene.shade(*shader, many).planes);
}

TEST(Shader, ACropIsThePartOfTheWhole) {
  const auto shader = open();
  const Scene scene;
  const WholePicture whole = scene.shade(*shader, request_of(200, 150));
  ShadeRequest crop = request_of(200, 150);
  crop.crop_x = 61;
  crop.crop_y = 33;
  crop.crop_width = 50;
  crop.crop_height = 117;
  const WholePicture part = scene.shade(*shader, crop);
  ASSERT_EQ(part.width, 50);
  ASSERT_EQ(part.rows, 117);
  for (int y = 0; y < 117; ++y) {
    for (int x = 0; x < 50; ++x) EXPECT_EQ(part.at("R", x, y), whole.at("R", x + 61, y + 33));
  }
}

/// Mesa has no texture wider than 16384: only what a tile needs is uploaded.
TEST(Shader, ShadesStatesWiderThanAnyTexture) {
  const auto shader = open();
  Scene wide(20000, 3);
  ShadeRequest r = request_of(20000, 3);
  r.tile = 4000;
  const WholePicture picture = wide.shade(*shader, r);
  const ShadingReference twin(wide.state, wide.basis, wide.model, wide.lighting, 20000, 3);
  for (const int x : {0, 3999, 4000, 4001, 15999, 16384, 19999}) {
    EXPECT_NEAR(picture.at("R", x, 1), twin.pixel(x, 1).picture[0], kTwin) << x;
  }
}

TEST(Shader, StripsComeInOrderAndAFailingSinkEndsIt) {
  struct Failing : PictureSink {
    int calls = 0;
    Result<void> write(const PictureStrip&) override {
      ++calls;
      return Error{ErrorCode::kIo, "full"};
    }
  };
  const auto shader = open();
  const Scene scene;
  ShadeRequest r = request_of(64, 48);
  r.tile = 10;
  const WholePicture p = scene.shade(*shader, r);
  EXPECT_TRUE(p.in_order);
  EXPECT_EQ(p.rows, 48);
  EXPECT_EQ(p.strips, 5);
  Failing failing;
  const auto done = shader->shade(StateSource(scene.state), scene.basis, scene.model,
                                  scene.lighting, r, {&failing});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "full");
  EXPECT_EQ(failing.calls, 1);
}

TEST(Shader, PaletteAndOpticalChannelsGiveTheSamePicture) {
  const auto shader = open();
  const Scene palette;
  Scene optical;
  optical.basis = optical_channels(painted::palette());
  optical.state = painted::scene(optical.basis, 64, 48);
  const WholePicture a = palette.shade(*shader, request_of(90, 70));
  const WholePicture b = optical.shade(*shader, request_of(90, 70));
  for (const char* plane : {"R", "G", "B"}) {
    for (int y = 0; y < 70; ++y) {
      // 1e-5: sums of K and S in another order, a few float roundings.
      for (int x = 0; x < 90; ++x) EXPECT_NEAR(a.at(plane, x, y), b.at(plane, x, y), 1e-5);
    }
  }
}

TEST(Shader, AReducedPictureIsTheAreaMeanOfTheFullOne) {
  const auto shader = open();
  const Scene scene;
  const WholePicture full = scene.shade(*shader, request_of(64, 48));
  const WholePicture half = scene.shade(*shader, request_of(32, 24));
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 32; ++x) {
      const float mean = (full.at("B", 2 * x, 2 * y) + full.at("B", 2 * x + 1, 2 * y) +
                          full.at("B", 2 * x, 2 * y + 1) + full.at("B", 2 * x + 1, 2 * y + 1)) /
                         4;
      EXPECT_NEAR(half.at("B", x, y), mean, 1e-6f);  // float rounding
    }
  }
}

TEST(Shader, NormalsArePhysicalWhateverTheGridAndThePicture) {
  const auto shader = open();
  for (const int cells : {20, 77}) {
    Scene scene(cells, cells);
    CanvasState& s = scene.state;
    s.geometry.width_m = 0.5;
    s.geometry.height_m = 0.25;
    s = make_canvas_state(s.geometry, 2, 4, 3, 0.9f);
    for (int y = 0; y < cells; ++y) {
      for (int x = 0; x < cells; ++x) {  // rises 0.5 m/m to the right, 0.25 m/m downwards
        set_base(s, x, y,
                 0.5f * static_cast<float>(x) * s.geometry.dx_m() +
                     0.25f * static_cast<float>(y) * s.geometry.dy_m());
      }
    }
    const float length = std::sqrt(1 + 0.25f + 0.0625f);
    for (const int pixels : {cells, 50, 9}) {
      const WholePicture p = scene.shade(*shader, request_of(pixels, pixels, {"normal"}));
      const int middle = pixels / 2;
      EXPECT_NEAR(p.at("normal.X", middle, middle), -0.5f / length, 1e-4f);  // float of slopes
      EXPECT_NEAR(p.at("normal.Y", middle, middle), 0.25f / length, 1e-4f);  // y up: faces the top
      EXPECT_NEAR(p.at("normal.Z", middle, middle), 1 / length, 1e-4f);
    }
  }
}

TEST(Shader, AWhiteFurnaceSendsBackNoMoreThanItGets) {
  const auto shader = open();
  Scene scene;
  for (GroundPlane& band : scene.state.reflectance) band.fill(1);
  scene.lighting.lamps[0].intensity = 0;
  scene.lighting.environment = {};
  scene.lighting.environment.L[0].fill(3.5449077f);  // radiance 1 all around
  const WholePicture p = scene.shade(*shader, request_of(64, 48));
  for (const char* plane : {"R", "G", "B"}) {
    for (const float v : p.planes.at(plane)) EXPECT_LE(v, 1 + 1e-5f);
  }
  EXPECT_NEAR(p.at("R", 1, 47), 1, 1e-5f);  // bare canvas: all of it, whatever the weave
}

TEST(Shader, BareLinenIsLinenWhiteUnderTheDefaultLight) {
  const auto shader = open();
  Scene scene;
  scene.state = make_canvas_state({32, 24, 0.25, 0.19}, 2, 4, 3, 0.9f);
  const WholePicture p = scene.shade(*shader, request_of(32, 24));
  for (const char* plane : {"R", "G", "B"}) {
    const float linear = p.at(plane, 16, 12);
    const float srgb = 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
    EXPECT_GT(srgb, 0.82f);
    EXPECT_LT(srgb, 0.92f);
  }
}

TEST(Shader, TheCameraSeesTheViewersRightInItsLeftHalf) {
  const auto shader = open();
  for (const bool mirror : {true, false}) {
    Scene scene;
    scene.state = make_canvas_state({32, 32, 0.1, 0.1}, 1, 4, 3, 0.5f);
    for (int y = 0; y < 32; ++y) {
      for (int x = 0; x < 32; ++x) {  // paint that falls off to the right reflects what is there
        scene.state.depth_m(x, y) = 0.05f - 0.15f * static_cast<float>(x) * 0.003125f;
      }
    }
    for (std::size_t c = 0; c < 3; ++c) scene.lighting.reflection.rgb[c] = Field<float>(8, 8);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 4; ++x) scene.lighting.reflection.rgb[0](x, y) = 1;  // left half red
    }
    scene.lighting.reflection.mirror = mirror;
    const WholePicture p = scene.shade(*shader, request_of(32, 32, {"reflection"}));
    EXPECT_EQ(p.at("reflection.R", 16, 16) > 0, mirror);
  }
}

// Mesa 25.1 dropped OSMesa, so it may be missing; EGL must be there.
TEST(Shader, EglGivesTheSameBitsAsOsmesa) {
  const auto egl = open(GlBackend::kEgl);
  ASSERT_TRUE(egl);
  const auto osmesa = Shader::open(GlBackend::kOsmesa, 2);
  if (!osmesa) GTEST_SKIP() << osmesa.error().message;
  const Scene scene;
  EXPECT_EQ(scene.shade(**osmesa, request_of(150, 110, kAllAovs)).planes,
            scene.shade(*egl, request_of(150, 110, kAllAovs)).planes);
}

TEST(Shader, SaysWhatItRunsOn) {
  EXPECT_EQ(open(GlBackend::kEgl)->description().rfind("EGL, ", 0), 0u);
}

TEST(Shader, ShadesUnpaintedCanvasWithoutPigments) {
  const auto shader = open();
  Scene scene;
  scene.basis = ChannelBasis{};
  scene.basis.K = scene.basis.S = Eigen::MatrixXd(3, 0);
  scene.state = make_canvas_state({8, 8, 0.1, 0.1}, 1, 0, 3, 0.9f);
  EXPECT_GT(scene.shade(*shader, request_of(8, 8)).at("G", 4, 4), 0.5f);
}

TEST(Shader, RefusesWhatItCannotShade) {
  const auto shader = open();
  Scene scene;
  WholePicture p;
  const auto error = [&](const ShadeRequest& r) {
    const auto done =
        shader->shade(StateSource(scene.state), scene.basis, scene.model, scene.lighting, r, {&p});
    return done ? std::string() : done.error().message;
  };
  ShadeRequest outside = request_of(64, 48);
  outside.crop_x = 60;
  outside.crop_width = 5;
  outside.crop_height = 5;
  EXPECT_EQ(error(outside), "the crop lies outside the picture");
  EXPECT_NE(error(request_of(64, 48, {"shine"})).find("unknown AOV 'shine'"), std::string::npos);
  scene.state.bands = 8;
  EXPECT_NE(error(request_of(64, 48)).find("three bands"), std::string::npos);
}

TEST(AovChannels, AreNamedAsTheDocumentationSays) {
  const ChannelBasis basis = palette_channels(painted::palette());
  const auto names = aov_channels({"height", "normal", "pigment", "height"}, basis);
  ASSERT_TRUE(names);
  EXPECT_EQ(*names, (std::vector<std::string>{"height.Y", "normal.X", "normal.Y", "normal.Z",
                                              "pigment.Ultramarine Blue", "pigment.Cadmium Red",
                                              "pigment.Hansa Yellow", "pigment.Titanium White"}));
  EXPECT_FALSE(aov_channels({"colour"}, basis));
}

}  // namespace
}  // namespace pentimento
