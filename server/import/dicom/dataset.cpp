#include "import/dicom/dataset.h"

#include <gdcmByteValue.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "import/data_root.h"
#include "import/text_header.h"

namespace cutaway::reading {

namespace {

const gdcm::ByteValue* bytes_at(const gdcm::DataSet& data, std::uint16_t group,
                                std::uint16_t element) {
  const gdcm::Tag tag(group, element);
  return data.FindDataElement(tag) ? data.GetDataElement(tag).GetByteValue() : nullptr;
}

template <typename T>
std::optional<double> number_in(const gdcm::ByteValue& bytes) {
  if (bytes.GetLength() < sizeof(T)) return std::nullopt;
  T value;
  std::memcpy(&value, bytes.GetPointer(), sizeof(T));
  return static_cast<double>(value);
}

}  // namespace

std::string text_at(const gdcm::DataSet& data, std::uint16_t group, std::uint16_t element) {
  const gdcm::ByteValue* bytes = bytes_at(data, group, element);
  if (!bytes || bytes->GetLength() == 0) return {};
  return printable({bytes->GetPointer(), bytes->GetLength()});
}

std::vector<double> decimals_at(const gdcm::DataSet& data, std::uint16_t group,
                                std::uint16_t element) {
  std::string text = text_at(data, group, element);
  std::vector<double> numbers;
  while (!text.empty()) {
    const std::size_t end = text.find('\\');
    const auto number = real_of(trimmed(std::string_view(text).substr(0, end)));
    numbers.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    text = end == std::string::npos ? std::string() : text.substr(end + 1);
  }
  return numbers;
}

bool are_finite(const std::vector<double>& numbers, std::size_t count) {
  return numbers.size() == count &&
         std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
}

std::optional<double> binary_at(const gdcm::DataSet& data, std::uint16_t group,
                                std::uint16_t element) {
  const gdcm::ByteValue* bytes = bytes_at(data, group, element);
  if (!bytes) return std::nullopt;
  const gdcm::VR vr = data.GetDataElement(gdcm::Tag(group, element)).GetVR();
  if (vr == gdcm::VR::FL) return number_in<float>(*bytes);
  if (vr == gdcm::VR::FD) return number_in<double>(*bytes);
  if (vr == gdcm::VR::SS) return number_in<std::int16_t>(*bytes);
  if (vr == gdcm::VR::SL) return number_in<std::int32_t>(*bytes);
  // Implicit VR leaves only the length to tell.
  if (bytes->GetLength() == 2) return number_in<std::uint16_t>(*bytes);
  if (bytes->GetLength() == 4) return number_in<std::uint32_t>(*bytes);
  if (bytes->GetLength() == 8) return number_in<double>(*bytes);
  return std::nullopt;
}

gdcm::SmartPointer<gdcm::SequenceOfItems> sequence_at(const gdcm::DataSet& data,
                                                      std::uint16_t group, std::uint16_t element) {
  const gdcm::Tag tag(group, element);
  gdcm::SmartPointer<gdcm::SequenceOfItems> items;
  if (data.FindDataElement(tag)) items = data.GetDataElement(tag).GetValueAsSQ();
  if (!items) items = new gdcm::SequenceOfItems;
  return items;
}

std::optional<gdcm::DataSet> first_item_at(const gdcm::DataSet& data, std::uint16_t group,
                                           std::uint16_t element) {
  const auto items = sequence_at(data, group, element);
  if (items->GetNumberOfItems() == 0) return std::nullopt;
  return items->GetItem(1).GetNestedDataSet();
}

}  // namespace cutaway::reading
