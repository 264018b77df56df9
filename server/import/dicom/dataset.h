// Typed look-ups in a GDCM data set; included only by the files that speak to GDCM.
#pragma once

#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cutaway::reading {

/// The element's text, printable and trimmed; empty where it is absent.
std::string text_at(const gdcm::DataSet& data, std::uint16_t group, std::uint16_t element);

/// The numbers of a decimal or integer string; NaN for those that are none. Empty where absent.
std::vector<double> decimals_at(const gdcm::DataSet& data, std::uint16_t group,
                                std::uint16_t element);

/// Exactly `count` numbers, and all of them finite.
bool are_finite(const std::vector<double>& numbers, std::size_t count);

/// A number in binary (US, SS, UL, SL, FL, FD).
std::optional<double> binary_at(const gdcm::DataSet& data, std::uint16_t group,
                                std::uint16_t element);

/// The items of a sequence; empty where absent. The pointer keeps them alive.
gdcm::SmartPointer<gdcm::SequenceOfItems> sequence_at(const gdcm::DataSet& data,
                                                      std::uint16_t group, std::uint16_t element);

/// The only or first item of a sequence within `data`, nothing where absent.
std::optional<gdcm::DataSet> first_item_at(const gdcm::DataSet& data, std::uint16_t group,
                                           std::uint16_t element);

}  // namespace cutaway::reading
