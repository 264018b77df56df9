#include "volume/prepared/preparation.h"

#include "volume/prepared/body_edits.h"
#include "volume/prepared/islands.h"

namespace cutaway {

std::shared_ptr<const LoadedVolume> prepare(const LoadedVolume& measured,
                                            const VolumePreparation& preparation,
                                            const std::stop_token& stop) {
  auto prepared = std::make_shared<LoadedVolume>(measured);
  Volume& volume = prepared->volume;
  if (const BodyMask* mask = measured.findings.body.get()) {
    const double air = measured.findings.robust.range.minimum;
    if (preparation.hide_couch) hide_couch(volume, *mask, air, stop);
    if (preparation.filled_with) fill_body(volume, *mask, *preparation.filled_with, stop);
  }
  for (const auto& limit : preparation.islands) {
    if (limit) drop_islands(volume, *limit, stop);
  }
  prepared->pyramid = build_pyramid(volume, stop);
  prepared->min_max = build_min_max_grid(volume, measured.min_max.brick_size, {}, stop);
  return prepared;
}

}  // namespace cutaway
