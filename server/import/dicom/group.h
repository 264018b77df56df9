// Planes that belong together, and what is done with such sets.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/dicom/frame.h"

namespace cutaway::reading {

/// Planes of one volume, ascending along the normal (row axis x column axis) once they are sorted.
struct DicomGroup {
  std::vector<DicomFrame> frames;
  std::string part;  ///< "" where the series is one volume; else what parts it: "echo-2", "coronal"
  std::string label;  ///< the same for people: "echo 2"
  std::vector<std::string> warnings;
};

/// Numbers by their size, other text in natural order.
struct KeyOrder {
  bool operator()(const std::string& a, const std::string& b) const;
};

/// Sets of planes that have something in common, by what that is.
using FramesByKey = std::map<std::string, std::vector<DicomFrame>, KeyOrder>;

/// `frames` of `whole` as a group of their own, whose name and value say what parts it.
DicomGroup part_of(const DicomGroup& whole, std::vector<DicomFrame> frames, const std::string& name,
                   const std::string& value);

/// The group itself where there is but one key.
std::vector<DicomGroup> split(const DicomGroup& whole, FramesByKey&& by_key,
                              const std::string& name);
std::vector<DicomGroup> split_by_key(const DicomGroup& whole, PlaneKey key);

void sort_along_normal(std::vector<DicomFrame>& frames);

/// Of frames sorted along their normal: the number of the place at which each lies.
std::vector<std::size_t> places_of(const std::vector<DicomFrame>& frames);
bool has_coinciding(const std::vector<DicomFrame>& frames);

/// Each of them two planes or more, at places of their own. Sorts them.
bool are_stacks(std::vector<DicomGroup>& groups);

}  // namespace cutaway::reading
