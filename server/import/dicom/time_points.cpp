#include "import/dicom/time_points.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace cutaway::reading {

namespace {

/// For each plane, the moment that it belongs to; empty where there is no answer.
using MomentOfPlane = std::vector<std::size_t>;

struct Planes {
  const std::vector<DicomFrame>& frames;
  std::vector<std::size_t> places;
  std::size_t most_at_a_place = 0;
};

Planes planes_of(const std::vector<DicomFrame>& frames) {
  Planes planes{frames, places_of(frames)};
  std::vector<std::size_t> counts(planes.places.back() + 1);
  for (const std::size_t place : planes.places)
    planes.most_at_a_place = std::max(planes.most_at_a_place, ++counts[place]);
  return planes;
}

std::optional<double> moment_at(const DicomFrame& frame, Moment which) {
  return frame.moments.at(static_cast<std::size_t>(which));
}

/// All planes in the order of that moment, then of their numbers; empty where one has none.
std::vector<std::size_t> order_by(const Planes& planes, Moment which) {
  std::vector<std::size_t> order(planes.frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto& frames = planes.frames;
  if (!std::all_of(frames.begin(), frames.end(),
                   [&](const DicomFrame& frame) { return moment_at(frame, which).has_value(); }))
    return {};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) {
      return std::tuple(moment_at(frames[i], which), moment_at(frames[i], Moment::instance), i);
    };
    return key(a) < key(b);
  });
  return order;
}

/// The table runs through all places, then through all again.
MomentOfPlane by_runs(const Planes& planes, const std::vector<std::size_t>& order) {
  MomentOfPlane moments(planes.frames.size());
  std::size_t moment = 0;
  std::set<std::size_t> seen;
  for (const std::size_t i : order) {
    if (!seen.insert(planes.places[i]).second) {
      ++moment;
      seen = {planes.places[i]};
    }
    moments[i] = moment;
  }
  return moment + 1 == planes.most_at_a_place ? moments : MomentOfPlane();
}

/// The same number of planes at each place, told apart by the moment itself.
MomentOfPlane by_rank(const Planes& planes, const std::vector<std::size_t>& order, Moment which) {
  MomentOfPlane moments(planes.frames.size());
  std::vector<std::vector<std::size_t>> at_place(planes.places.back() + 1);
  for (const std::size_t i : order) {
    auto& here = at_place[planes.places[i]];
    const bool is_later = here.empty() || moment_at(planes.frames[i], which) >
                                              moment_at(planes.frames[here.back()], which);
    if (!is_later) return {};
    moments[i] = here.size();
    here.push_back(i);
  }
  const bool are_even = std::all_of(at_place.begin(), at_place.end(), [&](const auto& here) {
    return here.size() == planes.most_at_a_place;
  });
  return are_even ? moments : MomentOfPlane();
}

std::vector<DicomGroup> parts_of(const DicomGroup& group, const MomentOfPlane& moments) {
  if (moments.empty()) return {};
  FramesByKey by_number;
  for (std::size_t i = 0; i < moments.size(); ++i)
    by_number[std::to_string(moments[i] + 1)].push_back(group.frames[i]);
  std::vector<DicomGroup> parts = split(group, std::move(by_number), "time");
  return parts.size() > 1 && are_stacks(parts) ? parts : std::vector<DicomGroup>();
}

}  // namespace

std::vector<DicomGroup> split_by_moments(const DicomGroup& group) {
  const Planes planes = planes_of(group.frames);
  for (std::size_t i = 0; i < kMoments; ++i) {
    const auto which = static_cast<Moment>(i);
    const auto order = order_by(planes, which);
    if (order.empty()) continue;
    for (const auto& moments : {by_runs(planes, order), by_rank(planes, order, which)}) {
      if (auto parts = parts_of(group, moments); !parts.empty()) return parts;
    }
  }
  return {};
}

}  // namespace cutaway::reading
