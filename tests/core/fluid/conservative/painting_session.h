#pragma once
// A painter at work for as long as asked: strokes of changing colour, medium and speed on a tablet
// held in the hand, through the whole simulation. For drift, not for looks.

#include <cmath>
#include <vector>

#include "core/brush/builtin_brushes.h"
#include "core/brush/stroke_path.h"
#include "core/simulation/simulation.h"
#include "tests/core/three_pigments.h"

namespace pentimento::conservative {

class PaintingSession {
 public:
  PaintingSession(int width, const Threads& threads) : sim_(setup(width), threads) {}

  /// One stroke of a second, step by step, then half a second of rest.
  void stroke() {
    const int k = strokes_++;
    BrushSettings settings;
    settings.medium_frac = 0.2f + 0.15f * static_cast<float>(k % 5);
    settings.pigment_frac = 0.1f + 0.3f * static_cast<float>(k % 4);
    settings.size_m = 0.02f;
    sim_.set_settings(settings);
    sim_.set_color(k % 3);
    sim_.begin_stroke(0, static_cast<std::uint32_t>(k + 1));
    const std::vector<Stamp> stamps = path(k);
    std::size_t next = 0;
    for (int i = 0; i < 67; ++i) {
      const double tilt = 0.3 * std::sin(0.001 * steps_);
      sim_.set_gravity({static_cast<float>(9.81 * tilt), static_cast<float>(-3 * tilt),
                        static_cast<float>(9.81 * std::sqrt(1 - tilt * tilt))});
      for (; next < stamps.size() && stamps[next].time_s <= (i + 1) / 45.0; ++next)
        sim_.stamp(0, stamps[next]);
      sim_.step();
      ++steps_;
    }
    sim_.end_stroke(0);
    if (k % 100 == 99) sim_.dry();
  }

  int steps() const { return steps_; }
  const Simulation& simulation() const { return sim_; }

  /// |deposited - picked up - dried - wet| / deposited: of the medium, then of each channel.
  std::vector<double> drifts() const {
    const PaintAccount& a = sim_.account();
    const PaintFlow wet = sim_.wet();
    std::vector<double> out{std::abs(a.deposited.medium_m3 - a.picked_up.medium_m3 -
                                     a.dried.medium_m3 - wet.medium_m3) /
                            a.deposited.medium_m3};
    for (std::size_t c = 0; c < wet.channel.size(); ++c)
      out.push_back(std::abs(a.deposited.channel[c] - a.picked_up.channel[c] - a.dried.channel[c] -
                             wet.channel[c]) /
                    a.deposited.channel[c]);
    return out;
  }

 private:
  static SimulationSetup setup(int width) {
    SimulationSetup s;
    s.geometry = {width, width * 3 / 4, 0.2, 0.15};
    s.model.scheme = SchemeKind::kConservative;
    s.basis = palette_channels(test::three_pigments());
    return s;
  }

  // A wavy line across the canvas.
  static std::vector<Stamp> path(int k) {
    StrokePath path(0.05, 0.2, 0.15);
    std::vector<Stamp> out;
    const double y = 0.02 + 0.11 * ((k * 7) % 10) / 10;
    for (int i = 0; i <= 20; ++i) {
      TouchSample s;
      s.time_s = i / 20.0;
      s.x_m = k % 2 == 0 ? 0.02 + 0.008 * i : 0.18 - 0.008 * i;
      s.y_m = y + 0.01 * std::sin(0.7 * i + k);
      s.diameter_m = 0.02f;
      if (i == 0)
        path.begin(s);
      else
        path.add(s, out);
    }
    path.finish(out);
    return out;
  }

  Simulation sim_;
  int strokes_ = 0;
  int steps_ = 0;
};

}  // namespace pentimento::conservative
