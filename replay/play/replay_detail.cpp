#include "replay/play/replay_detail.h"

#include <utility>

#include "core/optics/paints/paint_maker.h"

namespace pentimento {

namespace {
DetailFollowerSetup setup_of(const Simulation& simulation, int factor) {
  const CanvasState& state = simulation.state();
  DetailFollowerSetup setup;
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

Result<std::unique_ptr<ReplayDetail>> ReplayDetail::follow(Simulation& simulation,
                                                           const ReplayDetailSetup& setup,
                                                           const log::PaperSpec& paper,
                                                           LogFiles& files,
                                                           const Threads& threads) {
  const DetailLayout layout(simulation.state().geometry, setup.factor);
  const CanvasGeometry fine = layout.fine();
  Result<std::unique_ptr<PaperRows>> rows = paper_rows(paper, fine, files);
  if (!rows) return rows.error();
  const log::Rgb& rgb = paper.reflectance;
  auto substrate = std::make_unique<ReplaySubstrate>(
      std::move(*rows),
      PaintMaker(simulation.model())
          .substrate(
              {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])}),
      fine);
  const auto side = static_cast<std::size_t>(layout.side());
  Result<std::unique_ptr<TileStore>> store =
      TileStore::open({side * side, setup.scratch, setup.resident_bytes});
  if (!store) return store.error();
  std::unique_ptr<ReplayDetail> canvas(
      new ReplayDetail(simulation, setup.factor, std::move(substrate), std::move(*store), threads));
  simulation.set_listener(&canvas->follower_);
  if (!setup.start) {
    canvas->follower_.restored(simulation.state());
    return canvas;
  }
  const DetailStart& start = *setup.start;
  canvas->follower_.resume(*start.canvas, start.checkpoint, simulation.state());
  if (Result<void> read = start.canvas->status(); !read) return read.error();
  return canvas;
}

ReplayDetail::ReplayDetail(Simulation& simulation, int factor,
                           std::unique_ptr<ReplaySubstrate> substrate,
                           std::unique_ptr<TileStore> store, const Threads& threads)
    : simulation_(simulation),
      substrate_(std::move(substrate)),
      store_(std::move(store)),
      follower_(setup_of(simulation, factor), *substrate_, *store_, threads),
      source_(follower_.canvas(), simulation.state()) {}

ReplayDetail::~ReplayDetail() {
  simulation_.set_listener(nullptr);
}

}  // namespace pentimento
