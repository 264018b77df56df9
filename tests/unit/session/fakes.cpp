#include "unit/session/fakes.h"

#include <cmath>

namespace cutaway::testing {

namespace {

constexpr double kHalfEdge = 200.0;

/// First point of a ray inside of a ball around the origin.
std::optional<glm::dvec3> enter_ball(glm::dvec3 origin, glm::dvec3 direction, double radius) {
  if (radius < 0.0) return std::nullopt;
  if (glm::length(origin) <= radius) return origin;
  const double along = glm::dot(origin, direction);
  const double discriminant = (along * along) - glm::dot(origin, origin) + (radius * radius);
  if (discriminant < 0.0 || along > 0.0) return std::nullopt;
  return origin + ((-along - std::sqrt(discriminant)) * direction);
}

class Ticket final : public OpenTicket {
 public:
  explicit Ticket(std::function<void()> withdraw) : withdraw_(std::move(withdraw)) {}
  ~Ticket() override { withdraw_(); }
  Ticket(const Ticket&) = delete;
  Ticket& operator=(const Ticket&) = delete;

 private:
  std::function<void()> withdraw_;
};

}  // namespace

BallVolume::BallVolume(std::string id, double centre_value, std::string first_style)
    : centre_value_(centre_value) {
  facts_.first_style = std::move(first_style);
  facts_.id = std::move(id);
  facts_.bounds_minimum_mm = glm::dvec3(-kHalfEdge);
  facts_.bounds_maximum_mm = glm::dvec3(kHalfEdge);
  facts_.diagonal_mm = glm::length(glm::dvec3(2.0 * kHalfEdge));
  facts_.grid_half_axes_mm = glm::dmat3(kHalfEdge);
  facts_.window_width = 400.0;
  facts_.minimum_value = centre_value - (std::sqrt(3.0) * kHalfEdge);
  facts_.maximum_value = centre_value;
  facts_.outer_iso_value = centre_value - 100.0;
  facts_.inner_iso_value = centre_value - 50.0;
  facts_.first_surface_mm = [centre_value](glm::dvec3 origin, glm::dvec3 direction,
                                           const ValueBand& band) {
    return enter_ball(origin, direction, centre_value - band.lower);
  };
  summary_ = {{"id", facts_.id}};
}

std::optional<double> BallVolume::value_at(glm::dvec3 position_mm) const {
  const glm::dvec3 size = glm::abs(position_mm);
  if (std::max({size.x, size.y, size.z}) > kHalfEdge) return std::nullopt;
  return centre_value_ - glm::length(position_mm);
}

std::unique_ptr<OpenTicket> FakeLibrary::watch(std::function<void()> changed) {
  *changed_ = std::move(changed);
  return std::make_unique<Ticket>([changed_here = changed_] { *changed_here = nullptr; });
}

std::unique_ptr<OpenTicket> FakeLibrary::open(const std::string& id, ProgressSink progress,
                                              std::function<void(OpenOutcome)> done) {
  wishes.push_back(std::make_shared<Wish>(Wish{id, std::move(progress), std::move(done)}));
  return std::make_unique<Ticket>([wish = wishes.back()] { wish->withdrawn = true; });
}

std::unique_ptr<OpenTicket> FakeLibrary::prepare(const Scene& scene, std::function<void()> ready) {
  if (!prepares) return nullptr;
  preparing.push_back(std::make_shared<Preparing>(Preparing{scene, std::move(ready)}));
  return std::make_unique<Ticket>([wish = preparing.back()] { wish->withdrawn = true; });
}

void FakeLibrary::finish() {
  const auto& wish = wishes.back();
  wish->done(std::make_shared<const BallVolume>(wish->id, centre_value, first_style));
}

void FakeLibrary::fail(const Error& error) { wishes.back()->done(error); }

void FakeLibrary::change_listing(Json listing) {
  listing_ = std::move(listing);
  if (*changed_) (*changed_)();
}

std::vector<Json> FakeClient::of_type(const std::string& type) const {
  std::vector<Json> found;
  for (const Json& text : texts) {
    if (text["type"] == type) found.push_back(text);
  }
  return found;
}

Json FakeClient::last(const std::string& type) const {
  const std::vector<Json> found = of_type(type);
  return found.empty() ? Json() : found.back();
}

}  // namespace cutaway::testing
