// Documents that are nearly right, and text that is nearly JSON: refused in words or accepted,
// nothing else.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>

#include "core/error.h"
#include "scene/json_text.h"
#include "scene/resolve.h"
#include "scene/schema.h"
#include "scene/schema_violation.h"
#include "unit/scene/fixtures.h"
#include "unit/scene/schema_judge.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

constexpr int kDocuments = 20000;
constexpr int kTexts = 20000;

using Generator = std::mt19937;

std::size_t below(Generator& generator, std::size_t limit) { return generator() % limit; }

Json random_value(Generator& generator) {
  static const Json values =
      Json::parse(R"([null, true, false, 0, -1, 1, 0.5, 3, 1e5, -1e300, 4294967296,
      "", "tone", "sobel", "scene", "x", [], [0, 0, 1], [1, 2, 3, 4], {}, {"name": "phong"},
      {"name": "kuwahara", "radius": 1}, {"type": "ack"}, [{"name": "sobel"}],
       18446744073709551615])");
  return values.at(below(generator, values.size()));
}

/// A random place in the document, itself included.
Json& random_place(Json& document, Generator& generator) {
  Json* place = &document;
  while (place->is_structured() && !place->empty() && below(generator, 4) != 0) {
    auto child = place->begin();
    std::advance(child, static_cast<std::ptrdiff_t>(below(generator, place->size())));
    place = &*child;
  }
  return *place;
}

void mutate(Json& document, Generator& generator) {
  static const std::string keys[] = {"name",  "lens",     "radius_mm", "extra",  "filters",
                                     "input", "clock_ms", "shading",   "eye_mm", ""};
  Json& place = random_place(document, generator);
  switch (below(generator, 3)) {
    case 0:
      place = random_value(generator);
      break;
    case 1:
      if (place.is_structured() && !place.empty()) place.erase(place.begin());
      break;
    default:
      if (place.is_object())
        place[keys[below(generator, std::size(keys))]] = random_value(generator);
      else if (place.is_array())
        place.push_back(random_value(generator));
  }
}

/// Whether it was accepted; anything but Error ends the test.
bool try_to(const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (const Error& error) {
    EXPECT_FALSE(code_word(error.detail().code).empty());
    EXPECT_FALSE(error.detail().message.empty());
    return false;
  }
}

TEST(Fuzz, MutatedDocumentsAreAcceptedOrRefusedInWords) {
  Generator generator(20240601);
  const std::vector<Fixture> fixtures = valid_fixtures();
  int accepted = 0;
  for (int i = 0; i < kDocuments; ++i) {
    const Fixture& fixture = fixtures[below(generator, fixtures.size())];
    Json document = Json::parse(fixture.text);
    for (std::size_t changes = 1 + below(generator, 3); changes > 0; --changes)
      mutate(document, generator);
    accepted += try_to([&] { accept(fixture.schema, document.dump()); }) ? 1 : 0;
  }
  EXPECT_GT(accepted, kDocuments / 100);
  EXPECT_LT(accepted, kDocuments * 9 / 10);
}

TEST(Fuzz, OurCheckerAgreesWithValijson) {
  Generator generator(77);
  const std::vector<Fixture> fixtures = valid_fixtures();
  std::map<std::string, SchemaJudge> judges;
  for (const Fixture& fixture : fixtures)
    judges.try_emplace(fixture.schema, schema(fixture.schema));
  for (int i = 0; i < kDocuments; ++i) {
    const Fixture& fixture = fixtures[below(generator, fixtures.size())];
    Json document = Json::parse(fixture.text);
    mutate(document, generator);
    document = parse_json(document.dump());
    const bool accepted = judges.at(fixture.schema).accepts(document);
    const auto violation = first_violation(schema(fixture.schema), document);
    ASSERT_EQ(accepted, !violation) << fixture.schema << " " << document.dump();
  }
}

TEST(Fuzz, MutatedPatchesLeaveALegalScene) {
  Generator generator(5);
  Json state = scene_document(resolve_scene(Json::object(), ball_facts(), {64, 64}));
  for (int i = 0; i < kDocuments / 4; ++i) {
    Json change = state;
    mutate(change, generator);
    mutate(change, generator);
    try_to([&] {
      const Json next = patch_scene_document(state, change);
      state = scene_document(resolve_scene(next, ball_facts(), {64, 64}));
    });
    ASSERT_NO_THROW(validate_scene_document(state));
  }
}

TEST(Fuzz, DamagedTextIsAcceptedOrRefusedInWords) {
  Generator generator(99);
  const std::vector<Fixture> fixtures = valid_fixtures();
  for (int i = 0; i < kTexts; ++i) {
    const Fixture& fixture = fixtures[below(generator, fixtures.size())];
    std::string text = fixture.text;
    for (std::size_t changes = 1 + below(generator, 4); changes > 0 && !text.empty(); --changes) {
      const std::size_t position = below(generator, text.size());
      if (below(generator, 4) == 0)
        text.resize(position);
      else
        text[position] = static_cast<char>(generator());
    }
    try_to([&] { accept(fixture.schema, text); });
  }
}

}  // namespace
}  // namespace cutaway
