#include "core/shading/picture_job.h"

#include <algorithm>
#include <optional>

#include "core/shading/cell_slopes.h"
#include "core/shading/horizon.h"
#include "core/shading/lamp_uniforms.h"
#include "core/shading/state_window.h"
#include "core/shading/strip_writer.h"

namespace pentimento {
namespace {

PixelRun crop_run(int first, int count, int whole) {
  return count == 0 ? PixelRun{0, whole} : PixelRun{first, count};
}

/// The textures that hold the part of the canvas that a picture tile shows. They are as large as
/// the largest tile needs.
class TileTextures {
 public:
  TileTextures(const GlFunctions& gl, const PictureLayout& layout, const ShadeScene& scene,
               const Threads& threads)
      : canvas_(scene.canvas),
        threads_(threads),
        optics_(make_albedo_optics(scene.basis, scene.model)),
        edges_(layout.edges),
        width_(layout.x.most_cells(layout.tiles.width)),
        height_(layout.y.most_cells(layout.tiles.height)),
        border_(layout.border),
        per_cell_(relief_per_cell(scene.lighting, scene.canvas.geometry())),
        ground_(gl, TexelFormat::kRgba, width_, height_),
        amount_planes_(layout.variant.amount_planes()) {
    if (layout.variant.interpolate) {
      columns_.emplace(gl, TexelFormat::kRg, layout.tiles.width * layout.x.per_pixel, 1);
      rows_.emplace(gl, TexelFormat::kRg, layout.tiles.height * layout.y.per_pixel, 1);
    }
    if (layout.variant.slopes_ready())
      slopes_.emplace(gl, TexelFormat::kRgba, width_, height_);
    else
      relief_.emplace(gl, TexelFormat::kRg, width_ + 2 * border_, height_ + 2 * border_);
    if (amount_planes_ > 0)
      amounts_.emplace(gl, TexelFormat::kRgba, width_, height_, amount_planes_);
  }

  /// Uploads the cells of a picture tile. Returns the window that was uploaded, without the
  /// relief's border.
  CellWindow upload(const AxisWindow& x, const AxisWindow& y) {
    // Which cells each column and row of samples reads.
    if (columns_) columns_->upload(static_cast<int>(x.table.size() / 2), 1, x.table.data());
    if (rows_) rows_->upload(static_cast<int>(y.table.size() / 2), 1, y.table.data());
    // Albedo of the paint.
    const CellWindow window{x.first_cell, y.first_cell, x.cells, y.cells};
    pack_albedo(canvas_, optics_, edges_, window, threads_, texels_);
    ground_.upload(window.width, window.height, texels_.data());
    // Relief, with a border for slopes and occlusion.
    const CellWindow wider{window.x - border_, window.y - border_, window.width + 2 * border_,
                           window.height + 2 * border_};
    pack_relief(canvas_, wider, threads_, relief_texels_);
    if (relief_) relief_->upload(wider.width, wider.height, relief_texels_.data());
    if (slopes_) {
      pack_slopes({relief_texels_, window, border_}, per_cell_, threads_, texels_);
      slopes_->upload(window.width, window.height, texels_.data());
    }
    // Amounts of the pigments, where an AOV asks for them.
    for (int plane = 0; plane < amount_planes_; ++plane) {
      pack_amounts(canvas_, plane, window, threads_, texels_);
      amounts_->upload(window.width, window.height, texels_.data(), plane);
    }
    return window;
  }

  /// Result of pack_relief() for the window that was uploaded last, with its border.
  const std::vector<float>& relief_texels() const { return relief_texels_; }

  void bind() const {
    ground_.bind(kGround);
    if (columns_) columns_->bind(kColumns);
    if (rows_) rows_->bind(kRows);
    if (relief_) relief_->bind(kRelief);
    if (slopes_) slopes_->bind(kSlopes);
    if (amounts_) amounts_->bind(kAmounts);
  }

 private:
  const CanvasSource& canvas_;
  const Threads& threads_;
  AlbedoOptics optics_;
  EdgeCells edges_;
  int width_;
  int height_;
  int border_;
  std::array<float, 2> per_cell_;
  GlTexture ground_;
  std::optional<GlTexture> columns_, rows_;   // where samples lie between cells
  std::optional<GlTexture> relief_, slopes_;  // one of the two
  int amount_planes_;
  std::optional<GlTexture> amounts_;  // for the pigments' AOVs
  std::vector<float> texels_, relief_texels_;
};

/// Occlusion as textures: what the relief leaves of sky and lamps in a tile's window. It is
/// searched before the tile is drawn.
class HorizonTextures {
 public:
  HorizonTextures(const GlFunctions& gl, const ShadeScene& scene, const PictureLayout& layout,
                  const Threads& threads)
      : search_(scene.canvas.geometry(), scene.lighting, threads) {
    for (int i = 0; i < layout.variant.occlusion_planes(); ++i) {
      planes_.emplace_back(gl, TexelFormat::kRgba, layout.x.most_cells(layout.tiles.width),
                           layout.y.most_cells(layout.tiles.height));
    }
  }

  /// `relief`: as HorizonSearch::search() takes it.
  void upload(const std::vector<float>& relief, const CellWindow& window) {
    const std::vector<std::vector<float>>& seen = search_.search(relief, window);
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      planes_[i].upload(window.width, window.height, seen[i].data());
    }
  }

  void bind() const {
    for (std::size_t i = 0; i < planes_.size(); ++i)
      planes_[i].bind(kSeenFirst + static_cast<int>(i));
  }

 private:
  HorizonSearch search_;
  std::vector<GlTexture> planes_;
};

/// The camera's picture as a texture; nothing if there is no picture.
std::optional<GlTexture> reflection_texture(const GlFunctions& gl, const ReflectionMap& map) {
  const int width = map.rgb[0].width(), height = map.rgb[0].height();
  if (map.rgb[0].empty()) return std::nullopt;
  std::vector<float> texels;
  texels.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const Field<float>& plane : map.rgb) texels.push_back(plane(x, y));
    }
  }
  GlTexture texture(gl, TexelFormat::kRgb, width, height, 0, true);
  texture.upload(width, height, texels.data());
  return texture;
}

std::optional<GlTexture> gloss_texture(const GlFunctions& gl, const GlossTable* table) {
  if (table == nullptr) return std::nullopt;
  constexpr int kSide = GlossTable::kSide;
  GlTexture texture(gl, TexelFormat::kRgb, kSide, kSide, GlossTable::kLevels, true);
  for (int level = 0; level < GlossTable::kLevels; ++level) {
    texture.upload(kSide, kSide, table->rgb.data() + std::ptrdiff_t{3} * kSide * kSide * level,
                   level);
  }
  return texture;
}

}  // namespace

PictureLayout lay_out(const ShadeScene& scene, const ShadeRequest& request,
                      const std::vector<PlaneSource>& planes) {
  const CanvasGeometry& grid = scene.canvas.geometry();
  PictureLayout out;
  // As many samples per pixel along both axes as the one that needs more.
  const int samples = std::max(samples_per_pixel(grid.width, request.width),
                               samples_per_pixel(grid.height, request.height));
  out.x = {grid.width, request.width, samples};
  out.y = {grid.height, request.height, samples};
  // What the shader must be able to do for this scene; it is compiled for just that.
  ShadeVariant& variant = out.variant;
  variant.channels = std::max(scene.canvas.channels(), 1);
  variant.samples_per_pixel = samples;
  variant.interpolate = !out.x.on_cells() || !out.y.on_cells();
  variant.relief_samples = variant.interpolate ? 1 : request.relief_samples;
  out.edges = request.edges;
  variant.reflection_map = !scene.lighting.reflection.rgb[0].empty();
  variant.probe = !scene.lighting.probe[0].empty();
  variant.lamps = static_cast<int>(shining(scene.lighting).size());
  variant.occlusion = scene.lighting.occlusion > 0;
  out.border = variant.occlusion ? horizon_border(grid) : variant.slopes_ready() ? 1 : 0;
  // Which target each plane is drawn to, and how the picture is cut into tiles.
  assign_targets(planes, variant);
  out.tiles = plan_tiles({out.x, out.y, crop_run(request.crop_x, request.crop_width, request.width),
                          crop_run(request.crop_y, request.crop_height, request.height),
                          request.tile, 1 + variant.amount_planes(), out.border, variant.targets,
                          static_cast<int>(planes.size())});
  return out;
}

Result<void> shade_picture(const ShadeTools& tools, const ShadeScene& scene,
                           const PictureLayout& layout, const std::vector<PlaneSource>& planes,
                           const std::vector<PictureSink*>& sinks) {
  const GlFunctions& gl = tools.gl;
  const TilePlan& tiles = layout.tiles;
  const auto out_of_memory = [] {
    return Error{ErrorCode::kLimit, "OpenGL has no memory for a tile; try a smaller one"};
  };
  // Memory on the device, all of it before the first tile.
  TileTextures textures(gl, layout, scene, tools.threads);
  GlTargets targets(gl, tiles.width, tiles.height, layout.variant.targets);
  const std::optional<GlTexture> reflection = reflection_texture(gl, scene.lighting.reflection);
  const std::optional<GlTexture> gloss = gloss_texture(gl, tools.gloss);
  std::optional<HorizonTextures> horizon;
  if (layout.variant.occlusion) horizon.emplace(gl, scene, layout, tools.threads);
  if (!targets.complete() || gl.GetError() != GL_NO_ERROR) return out_of_memory();
  // What is the same for all tiles.
  tools.program.use();
  set_shade_uniforms(tools.program, {scene.lighting, scene.canvas.geometry(), layout.border});

  const int left = tiles.columns.front().first, top = tiles.rows.front().first;
  const int width = tiles.columns.back().first + tiles.columns.back().count - left;
  StripWriter writer({planes, layout.variant}, width, tiles.height, sinks,
                     tools.threads.count() > 1);
  std::vector<float> texels(4 * static_cast<std::size_t>(tiles.width) *
                            static_cast<std::size_t>(tiles.height));
  // Tile by tile: upload the cells, draw, read the targets; a row of tiles makes a strip.
  for (const PixelRun& row : tiles.rows) {
    const AxisWindow y = axis_window(layout.y, row.first, row.count);
    for (const PixelRun& column : tiles.columns) {
      const CellWindow window =
          textures.upload(axis_window(layout.x, column.first, column.count), y);
      if (horizon) horizon->upload(textures.relief_texels(), window);
      // Uploading binds to whichever unit is active, so all is bound only now.
      textures.bind();
      if (horizon) horizon->bind();
      set_first_cell(tools.program, window.x, window.y);
      if (reflection) reflection->bind(kReflectionMap);
      if (gloss) gloss->bind(kGloss);
      targets.draw(column.count, row.count);
      for (int t = 0; t < layout.variant.targets; ++t) {
        targets.read(t, column.count, row.count, texels.data());
        writer.take(t, {column.first - left, column.count}, row.count, texels);
      }
    }
    if (gl.GetError() != GL_NO_ERROR) return out_of_memory();
    // The finished strip goes to every output, while the next is drawn.
    if (auto written = writer.hand_on(row.first - top, row.count); !written) return written;
  }
  return writer.finish();
}

}  // namespace pentimento
