#include <algorithm>
#include <new>
#include <utility>

#include "core/check.h"
#include "import/format_table.h"
#include "import/refusal.h"

namespace cutaway {

using namespace reading;

namespace {

/// Fractions that only grow, and stages that only advance, whatever a reader reports.
class MonotoneProgress {
 public:
  explicit MonotoneProgress(const ProgressSink& sink) : sink_(sink) {}

  void report(LoadStage stage, double fraction) {
    const std::pair now(stage, std::clamp(fraction, 0.0, 1.0));
    if (!sink_ || now <= last_) return;
    if (stage != last_.first && last_.second < 1.0) sink_(last_.first, 1.0);
    last_ = now;
    sink_(stage, now.second);
  }

 private:
  const ProgressSink& sink_;
  std::pair<LoadStage, double> last_{LoadStage::read, -1.0};
};

RawVolume read_raw(const VolumeSource& source, const ReadContext& context) {
  const Format* format = format_named(source.description.format);
  if (format) return format->read(source, context);
  refuse(source.files.front(), "no reader for this format", formats_in_words(),
         source.description.format);
}

}  // namespace

Volume read_volume(const VolumeSource& source, const ImportLimits& limits,
                   const ProgressSink& progress, std::stop_token stop) {
  check(!source.files.empty(), "a source has files");
  MonotoneProgress monotone(progress);
  const auto sink = [&](LoadStage stage, double fraction) { monotone.report(stage, fraction); };
  sink(LoadStage::read, 0.0);
  try {
    Volume volume = finish_volume(read_raw(source, {limits, sink, std::move(stop)}));
    sink(LoadStage::decode, 1.0);
    return volume;
  } catch (const Error& error) {
    Error::Detail detail = error.detail();
    if (!detail.field.empty()) throw;
    detail.field = source.files.front().string();
    throw Error(detail);
  } catch (const std::bad_alloc&) {
    refuse(source.files.front(), "there is not enough memory for the volume");
  }
}

}  // namespace cutaway
