#include "replay/play/fine_canvas.h"

#include <utility>

#include "core/optics/paints/paint_maker.h"

namespace pentimento {

namespace {
RefinementSetup setup_of(const Simulation& simulation, int factor) {
  const CanvasState& state = simulation.state();
  RefinementSetup setup;
  setup.guide = state.geometry;
  setup.factor = factor;
  setup.layers = state.layers;
  setup.channels = state.channels;
  setup.bands = state.bands;
  const auto& amount = simulation.basis().amount;
  setup.amount.assign(amount.begin(), amount.end());
  return setup;
}
}  // namespace

Result<std::unique_ptr<FineCanvas>> FineCanvas::follow(Simulation& simulation,
                                                       const FineSetup& setup,
                                                       const log::PaperSpec& paper, LogFiles& files,
                                                       const Threads& threads) {
  const DetailLayout layout(simulation.state().geometry, setup.factor);
  const CanvasGeometry fine = layout.fine();
  Result<std::unique_ptr<PaperRows>> rows = paper_rows(paper, fine, files);
  if (!rows) return rows.error();
  const log::Rgb& rgb = paper.reflectance;
  auto ground = std::make_unique<FineGround>(
      std::move(*rows),
      PaintMaker(simulation.model())
          .ground(
              {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])}),
      fine);
  const auto side = static_cast<std::size_t>(layout.side());
  Result<std::unique_ptr<TileStore>> store =
      TileStore::open({side * side, setup.scratch, setup.resident_bytes});
  if (!store) return store.error();
  std::unique_ptr<FineCanvas> canvas(
      new FineCanvas(simulation, setup.factor, std::move(ground), std::move(*store), threads));
  simulation.set_follower(&canvas->refinement_);
  if (!setup.start) {
    canvas->refinement_.restored(simulation.state());
    return canvas;
  }
  const FineStart& start = *setup.start;
  canvas->refinement_.resume(*start.canvas, start.notes, simulation.state());
  if (Result<void> read = start.canvas->status(); !read) return read.error();
  return canvas;
}

FineCanvas::FineCanvas(Simulation& simulation, int factor, std::unique_ptr<FineGround> ground,
                       std::unique_ptr<TileStore> store, const Threads& threads)
    : simulation_(simulation),
      ground_(std::move(ground)),
      store_(std::move(store)),
      refinement_(setup_of(simulation, factor), *ground_, *store_, threads),
      source_(refinement_.canvas(), simulation.state()) {}

FineCanvas::~FineCanvas() {
  simulation_.set_follower(nullptr);
}

}  // namespace pentimento
