// What the published fluid loses and makes: short scripted sessions on 256 x 192 cells of Table 1,
// with the drift of medium and pigment (percent of what was laid) as counters. Brush speed and
// tilt are arguments where they matter.

#include <benchmark/benchmark.h>

#include "core/base/approx.h"
#include "core/base/random.h"
#include "core/simulation/make_scheme.h"

namespace pentimento {
namespace {

constexpr int kWidth = 256, kHeight = 192;
constexpr float kDt_s = 1.0f / 45;
constexpr float kDegree = 3.14159265f / 180;

double total(const Field<float>& f) {
  double sum = 0;
  for (int y = 0; y < f.height(); ++y)
    for (int x = 0; x < f.width(); ++x) sum += f(x, y);
  return sum;
}

/// A canvas with a weave of 0.3 mm, and an account of what is laid on it.
class Session {
 public:
  Session() {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        state_.base_m(x, y) =
            3e-4f * random_uniform(RandomPurpose::kPaperRelief, static_cast<unsigned>(x),
                                   static_cast<unsigned>(y));
  }

  void lay(int x, int y, float depth_m, float pigment) {
    state_.depth_m(x, y) += depth_m;
    state_.channel(0, 0)(x, y) += pigment;
    laid_m_ += depth_m;
    laid_pigment_ += pigment;
  }

  /// One stroke from left to right along row `y`, 24 cells wide, laying a film once on its way.
  void stroke(int y, float speed_m_s, float depth_m, float pigment) {
    const float cells = speed_m_s * kDt_s * 1024;
    for (float end = 40 + cells; end < 200; end += cells) {
      const int x0 = static_cast<int>(end - cells), x1 = static_cast<int>(end);
      for (int j = y - 12; j < y + 12; ++j) {
        for (int x = x0 + 12; x < x1 + 12; ++x) lay(x, j, depth_m, pigment);
        for (int x = x0 - 12; x < x1 + 12; ++x) {
          contact_.weight(x, j) = 1;
          contact_.velocity_x_m_s(x, j) = speed_m_s;
        }
      }
      contact_.touch(x0 - 12, x1 + 12, y - 12, y + 12);
      steps(1);
      clear(contact_);
    }
  }

  void tilt(float degrees) {
    gravity_ = {0, -9.81f * approx::sin(degrees * kDegree), 9.81f * approx::cos(degrees * kDegree)};
  }

  void steps(int n) {
    for (int i = 0; i < n; ++i)
      scheme_->step(state_, {model_, gravity_, kDt_s, contact_, amount_, threads_});
  }

  void report(benchmark::State& run) const {
    run.counters["medium_drift_percent"] = 100 * (total(state_.depth_m) / laid_m_ - 1);
    run.counters["pigment_drift_percent"] = 100 * (total(state_.channel(0, 0)) / laid_pigment_ - 1);
    run.counters["max_speed_m_s"] = scheme_->statistics()[0].second;
  }

 private:
  Model model_;
  Vec3f gravity_{0, 0, 9.81f};
  Threads threads_{1};
  std::vector<float> amount_ = {1.0f};
  BrushContact contact_ = make_brush_contact(kWidth, kHeight);
  CanvasState state_ =
      make_canvas_state({kWidth, kHeight, kWidth / 1024.0, kHeight / 768.0}, 2, 1, 3, 0.9f);
  std::unique_ptr<FluidScheme> scheme_ = make_scheme(SchemeKind::kPaper, state_.geometry, 2, 1);
  double laid_m_ = 0, laid_pigment_ = 0;
};

void lay_patch(Session& session, float depth_m, float pigment) {
  for (int y = 20; y < 80; ++y)
    for (int x = 60; x < 200; ++x) session.lay(x, y, depth_m, pigment);
}

/// A patch of thin paint (theta 2) lies for 90 steps on a flat tablet.
void BM_PatchLiesFlat(benchmark::State& run) {
  for (auto _ : run) {
    Session session;
    lay_patch(session, 0.002f, 0.004f);
    session.steps(90);
    session.report(run);
  }
}

/// The same on a tablet tilted by range(0) degrees, for range(1) steps.
void BM_PatchRuns(benchmark::State& run) {
  for (auto _ : run) {
    Session session;
    lay_patch(session, 0.002f, 0.004f);
    session.tilt(static_cast<float>(run.range(0)));
    session.steps(static_cast<int>(run.range(1)));
    session.report(run);
  }
}

/// Three strokes at range(0) mm/s, thin (theta 2) or stiff (theta 20), and 20 steps after.
void BM_Strokes(benchmark::State& run) {
  const float speed = static_cast<float>(run.range(0)) * 1e-3f;
  const float pigment = run.range(1) != 0 ? 0.02f : 0.002f;
  for (auto _ : run) {
    Session session;
    for (int y : {50, 100, 150}) session.stroke(y, speed, 0.001f, pigment);
    session.steps(20);
    session.report(run);
  }
}

BENCHMARK(BM_PatchLiesFlat)->Iterations(1);
BENCHMARK(BM_PatchRuns)
    ->Args({8, 20})
    ->Args({8, 45})
    ->Args({45, 10})
    ->Args({90, 10})
    ->Iterations(1);
BENCHMARK(BM_Strokes)
    ->Args({50, 0})
    ->Args({50, 1})
    ->Args({300, 0})
    ->Args({300, 1})
    ->Args({1000, 1})
    ->Iterations(1);

}  // namespace
}  // namespace pentimento
