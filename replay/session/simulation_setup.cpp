#include "replay/session/simulation_setup.h"

#include "core/optics/paints/paint_maker.h"
#include "replay/job/step_clock.h"

namespace pentimento {

SimulationSetup simulation_setup(const log::Header& header, const Model& model) {
  SimulationSetup setup;
  setup.geometry = {header.grid_width, header.grid_height, header.canvas_width_m,
                    header.canvas_height_m};
  setup.model = model;
  setup.dt_s = StepClock(header.steps_per_second).dt_s();
  const log::Rgb& paper = header.paper.reflectance;
  setup.paper_reflectance = PaintMaker(model).substrate(
      {static_cast<float>(paper[0]), static_cast<float>(paper[1]), static_cast<float>(paper[2])});
  return setup;
}

}  // namespace pentimento
